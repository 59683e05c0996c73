// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_FIT_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_FIT_H

#include <CGAL/Multiplanar/internal/panel_labelling.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/planes.h>

#include <cmath>
#include <cstdint>
#include <vector>

// Planes of panels and what panels cost under them: C(P) = sum over f in P of D_f(plane of P) (eq. 2), the plane being
// refitted to P as `estimate_planes()` does.

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline void add_sums(Plane_sums& a, const Plane_sums& b, const Label_costs& costs)
{
  a.area += b.area;
  a.normal = a.normal + b.normal;
  a.centroid = a.centroid + b.centroid;
  if (a.largest_face == -1 || (b.largest_face != -1 && costs.area(b.largest_face) > costs.area(a.largest_face)))
    a.largest_face = b.largest_face;
}

inline Plane_sums plane_sums(const Label_costs& costs, const std::vector<int>& faces)
{
  Plane_sums sums;
  for (int f : faces) sums.add(costs, f);
  return sums;
}

/// The plane of faces with these sums. \pre there is at least one face
inline Plane fitted_plane(const Label_costs& costs, const Plane_sums& sums)
{
  if (!(sums.area > 0)) return costs.plane_of(sums.largest_face);
  const double length = std::sqrt(sums.normal.squared_length());
  return plane_through_centroid(length > 1e-6 * sums.area ? sums.normal / length : costs.normal(sums.largest_face),
                                sums);
}

/// What faces cost under a plane: eq. 2 summed.
inline double faces_cost(const Label_costs& costs, const std::vector<int>& faces, const Plane& plane)
{
  double sum = 0;
  for (int f : faces) sum += costs.data_cost(f, plane);
  return sum;
}

/// The planes and costs of panels, refitted when a panel has changed by more than a tenth of its faces since: they
/// guide choices, and a few faces more or less do not matter. Here a face counts `seed_weight` times, so that panels
/// are merged where saliency is low and split where it is high.
class Panel_fits
{
public:
  Panel_fits(const Label_costs& costs, const Panel_labelling& panels) : label_costs(&costs), panels(&panels) {}

  const Label_costs& costs() const { return *label_costs; }
  Plane plane(int p) { return fit(p).plane; }
  Plane_sums sums(int p) { return fit(p).sums; }
  double cost(int p) { return fit(p).cost; }
  /// Faces counted `seed_weight` times, as in the costs.
  double weighted_area(int p) { return fit(p).area; }

  /// C(P and Q together) - C(P) - C(Q).
  double merge_cost(int p, int q)
  {
    Plane_sums sums = this->sums(p);
    add_sums(sums, this->sums(q), *label_costs);
    const Plane plane = fitted_plane(*label_costs, sums);
    return weighted_cost(p, plane) + weighted_cost(q, plane) - cost(p) - cost(q);
  }

  /// The data cost of all panels, each one that changed at all refitted.
  double total()
  {
    double sum = 0;
    for (int p = 0; p < panels->number_of_labels(); ++p)
      if (!panels->faces(p).empty()) sum += fit(p, 0).cost;
    return sum;
  }

private:
  struct Fit
  {
    Plane plane;
    Plane_sums sums;
    double cost = 0, area = 0;
    std::int64_t changes = -1;
  };

  double weighted_cost(int p, const Plane& plane) const
  {
    double sum = 0;
    for (int f : panels->faces(p)) sum += label_costs->seed_weight(f) * label_costs->data_cost(f, plane);
    return sum;
  }

  /// \param tolerance the share of a panel's faces that may have changed since the last fit
  Fit& fit(int p, double tolerance = 0.1)
  {
    if (int(fits.size()) <= p) fits.resize(panels->number_of_labels());
    Fit& fit = fits[p];
    if (fit.changes < 0 || double(panels->changes(p) - fit.changes) > tolerance * double(panels->faces(p).size())) {
      fit.sums = plane_sums(*label_costs, panels->faces(p));
      fit.plane = fitted_plane(*label_costs, fit.sums);
      fit.cost = weighted_cost(p, fit.plane);
      fit.area = 0;
      for (int f : panels->faces(p)) fit.area += label_costs->seed_weight(f) * label_costs->area(f);
      fit.changes = panels->changes(p);
    }
    return fit;
  }

  const Label_costs* label_costs;
  const Panel_labelling* panels;
  std::vector<Fit> fits;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_FIT_H
