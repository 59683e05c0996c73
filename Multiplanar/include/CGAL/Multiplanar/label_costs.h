// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_LABEL_COSTS_H
#define CGAL_MULTIPLANAR_LABEL_COSTS_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Plane.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The weights of eqs. 1 and 2. They are meant for meshes of unit bounding-box diagonal.
struct Labelling_weights
{
  double normal_distance = 10; ///< w_n, of the distance between a face and a plane against that of their normals
  double smoothness = 0.05;    ///< w_V, of the boundaries between labels
};

/// The saliency weights w_t = W (1 - s) of eq. 4, low where the user wants more panels.
/// \param saliency s in 0..1 per face; empty for none
/// \param scale W >= 0; at W = 0 saliency has no effect
/// \throws std::invalid_argument if a saliency is not in 0..1 (with the face's index) or W is negative or not finite
inline std::vector<double> saliency_weights(const std::vector<double>& saliency, double scale)
{
  if (!(scale >= 0) || !std::isfinite(scale)) throw std::invalid_argument("the saliency weight must be a number >= 0");
  std::vector<double> weights;
  weights.reserve(saliency.size());
  for (double s : saliency) {
    if (!(0 <= s && s <= 1))
      throw std::invalid_argument("the saliency of face " + std::to_string(weights.size()) + " is not in 0..1");
    weights.push_back(scale * (1 - s));
  }
  return weights;
}

class Plane_costs;

/// What the labelling of the faces of a mesh costs (eqs. 1 - 4), for the present positions of its vertices.
///
/// Notation: A_p, n_p, c_p area, unit outer normal and centroid of face p; (n_f, d_f) the plane of label f;
/// |.|_1 the sum of the absolute coordinates; F the number of faces.
class Label_costs
{
public:
  /// \param points vertex positions, in coordinates in which the mesh has a bounding box of diagonal about 1
  /// \param saliency_weight w_t per face (see `saliency_weights()`), empty for 0 everywhere
  /// \pre `points` has a point for each vertex, `saliency_weight` is empty or has a value >= 0 for each face.
  /// A face of zero area has normal 0 and costs nothing. Linear time.
  Label_costs(const internal::Connectivity& connectivity, const Points& points, const Labelling_weights& weights = {},
              std::vector<double> saliency_weight = {})
      : connectivity(&connectivity), label_weights(weights), saliency(std::move(saliency_weight))
  {
    CGAL_precondition(points.size() == std::size_t(connectivity.number_of_vertices()));
    CGAL_precondition(saliency.empty() || saliency.size() == std::size_t(connectivity.number_of_faces()));
    CGAL_precondition(weights.normal_distance >= 0 && weights.smoothness >= 0);
    const std::size_t faces = connectivity.number_of_faces();
    for (std::vector<double>* column : {&areas, &nx, &ny, &nz, &cx, &cy, &cz}) column->resize(faces);
    for (std::size_t f = 0; f < faces; ++f) set_face(int(f), points);
  }

  int faces() const { return int(areas.size()); }
  double area(int face) const { return areas[face]; }
  Vector_3 normal(int face) const { return Vector_3(nx[face], ny[face], nz[face]); }
  Point_3 centroid(int face) const { return Point_3(cx[face], cy[face], cz[face]); }
  const Labelling_weights& weights() const { return label_weights; }

  /// The plane of face p: n_p, and d = c_p . n_p.
  Plane plane_of(int face) const
  {
    return {normal(face), cx[face] * nx[face] + cy[face] * ny[face] + cz[face] * nz[face]};
  }

  /// D_p(f) = A_p (|n_f - n_p|_1 + w_n |d_f - c_p . n_f|), eq. 2.
  double data_cost(int face, const Plane& plane) const
  {
    double cost;
    data_costs(plane, face, face + 1, &cost);
    return cost;
  }

  /// Writes the data costs of faces `first` .. `last` - 1 for one plane to `out`.
  void data_costs(const Plane& plane, int first, int last, double* out) const
  {
    const double x = plane.normal.x(), y = plane.normal.y(), z = plane.normal.z(), d = plane.offset;
    const double w = label_weights.normal_distance;
    const double *a = areas.data() + first, *px = nx.data() + first, *py = ny.data() + first, *pz = nz.data() + first;
    const double *qx = cx.data() + first, *qy = cy.data() + first, *qz = cz.data() + first;
    const int n = last - first;
    for (int i = 0; i < n; ++i) // without branches, so that compilers vectorise it
      out[i] = a[i] * (std::abs(x - px[i]) + std::abs(y - py[i]) + std::abs(z - pz[i]) +
                       w * std::abs(d - (qx[i] * x + qy[i] * y + qz[i] * z)));
  }

  /// The data cost D_p(f) of the labels 0 .. planes.size() - 1 with these planes, as `alpha_expansion()` takes it.
  /// It refers to this object.
  Plane_costs data_cost(std::vector<Plane> planes) const;

  /// The price of a boundary between the neighbours p and q, without the factor w_V sqrt(F / 10^4):
  /// A_pq (4 - |n_p - n_q|_1 + w_t), eqs. 3 and 4, with the mean of the two areas and of the two saliency weights.
  double boundary_cost(int p, int q) const
  {
    const double steps = std::abs(nx[p] - nx[q]) + std::abs(ny[p] - ny[q]) + std::abs(nz[p] - nz[q]);
    const double w_t = saliency.empty() ? 0 : (saliency[p] + saliency[q]) / 2;
    return (areas[p] + areas[q]) / 2 * (4 - steps + w_t);
  }

  /// The faces as nodes, the mesh's edges with weights w_V V_pq.
  ///
  /// Eq. 3 multiplies the number of edges along a boundary (growing as F^(1/2)) by areas (shrinking as 1/F), so the
  /// same boundary would cost less and less on finer meshes. The factor sqrt(F / 10^4) makes up for it and leaves the
  /// paper's weights as they are at its typical 10^4 faces.
  Potts_graph potts_graph() const
  {
    const double scale = label_weights.smoothness * std::sqrt(faces() / 1e4);
    Potts_graph graph;
    graph.begin.resize(std::size_t(faces()) + 1);
    graph.adjacent.reserve(3 * std::size_t(faces()));
    graph.weight.reserve(3 * std::size_t(faces()));
    for (int p = 0; p < faces(); ++p) {
      for (int q : connectivity->neighbours[p]) {
        graph.adjacent.push_back(q);
        graph.weight.push_back(scale * boundary_cost(p, q));
      }
      graph.begin[p + 1] = int(graph.adjacent.size());
    }
    return graph;
  }

private:
  void set_face(int f, const Points& points)
  {
    const auto& t = connectivity->triangles[f];
    const Vector_3 twice = internal::area_vector(*connectivity, points, f);
    const double length = std::sqrt(twice.squared_length());
    const Vector_3 n = length > 0 ? twice / length : Vector_3(0, 0, 0);
    areas[f] = length / 2;
    nx[f] = n.x();
    ny[f] = n.y();
    nz[f] = n.z();
    cx[f] = (points[t[0]].x() + points[t[1]].x() + points[t[2]].x()) / 3;
    cy[f] = (points[t[0]].y() + points[t[1]].y() + points[t[2]].y()) / 3;
    cz[f] = (points[t[0]].z() + points[t[1]].z() + points[t[2]].z()) / 3;
    CGAL_precondition(saliency.empty() || saliency[f] >= 0);
  }

  const internal::Connectivity* connectivity;
  Labelling_weights label_weights;
  std::vector<double> saliency;                      // w_t
  std::vector<double> areas, nx, ny, nz, cx, cy, cz; // one column each, so that one plane meets many faces at a time
};

/// D_p(f) for labels with given planes: a data cost for `alpha_expansion()` and `cheapest_labels()`.
class Plane_costs
{
public:
  Plane_costs(const Label_costs& costs, std::vector<Plane> planes) : costs(&costs), planes(std::move(planes)) {}

  int labels() const { return int(planes.size()); }
  double operator()(int face, int label) const { return costs->data_cost(face, planes[label]); }
  void block(int label, int first, int last, double* out) const { costs->data_costs(planes[label], first, last, out); }

private:
  const Label_costs* costs;
  std::vector<Plane> planes;
};

inline Plane_costs Label_costs::data_cost(std::vector<Plane> planes) const
{
  return Plane_costs(*this, std::move(planes));
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_LABEL_COSTS_H
