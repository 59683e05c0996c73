// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_LABEL_COSTS_H
#define CGAL_MULTIPLANAR_LABEL_COSTS_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Plane.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <array>
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
  /// \param connectivity of the mesh; a reference to it is kept
  /// \param points vertex positions, in coordinates in which the mesh has a bounding box of diagonal about 1
  /// \param saliency_weight w_t per face (see `saliency_weights()`), empty for 0 everywhere
  /// \param weights w_n and w_V
  /// \pre `points` has a point for each vertex, `saliency_weight` is empty or has a value >= 0 for each face.
  /// A face of zero area has normal 0 and costs nothing. Linear time.
  Label_costs(const internal::Connectivity& connectivity, const Points& points, const Labelling_weights& weights = {},
              std::vector<double> saliency_weight = {})
      : connectivity(&connectivity), label_weights(weights), saliency(std::move(saliency_weight))
  {
    CGAL_precondition(points.size() == std::size_t(connectivity.number_of_vertices()));
    CGAL_precondition(saliency.empty() || saliency.size() == std::size_t(connectivity.number_of_faces()));
    CGAL_precondition(weights.normal_distance >= 0 && weights.smoothness >= 0);
    face_data.reserve(connectivity.number_of_faces());
    for (int f = 0; f < connectivity.number_of_faces(); ++f) {
      face_data.push_back(make_face(f, points));
      if (saliency.empty()) continue;
      CGAL_precondition(saliency[f] >= 0);
      seed_weights.push_back(seed_density(f) * std::sqrt(seed_density(f)));
    }
    fill_columns();
  }

  int faces() const { return int(face_data.size()); }          ///< how many there are
  double area(int face) const { return face_data[face].area; } ///< in squared diagonals
  /// Of unit length.
  Vector_3 normal(int face) const { return Vector_3(face_data[face].nx, face_data[face].ny, face_data[face].nz); }
  /// In the unit frame.
  Point_3 centroid(int face) const { return Point_3(face_data[face].cx, face_data[face].cy, face_data[face].cz); }
  const Labelling_weights& weights() const { return label_weights; } ///< w_n, w_V and the saliency weight

  /// How dense labels should be seeded at a face, relative to a face with w_t = 0: 4 / (4 + w_t), in (0, 1]. That is
  /// what a boundary between faces of equal normals costs without saliency weights, against what it costs with (eq. 4).
  double seed_density(int face) const { return saliency.empty() ? 1 : 4 / (4 + saliency[face]); }

  /// How often the cost of a face counts where it is decided which labels are wanted: seed_density^(3/2), 1 without
  /// saliency weights. A label over the area A of a curved surface costs about A^(3/2) (eq. 2: the normals of its faces
  /// differ by A^(1/2)), so labels whose weighted costs are equal are as dense as `seed_density` says.
  double seed_weight(int face) const { return saliency.empty() ? 1 : seed_weights[face]; }

  /// The plane of face p: n_p, and d = c_p . n_p.
  Plane plane_of(int face) const
  {
    const Face& p = face_data[face];
    return {normal(face), p.cx * p.nx + p.cy * p.ny + p.cz * p.nz};
  }

  /// D_p(f) = A_p (|n_f - n_p|_1 + w_n |d_f - c_p . n_f|), eq. 2.
  double data_cost(int face, const Plane& plane) const
  {
    const Vector_3& n = plane.normal;
    const Face& p = face_data[face];
    return formula(p.area, p.nx, p.ny, p.nz, p.cx, p.cy, p.cz, n.x(), n.y(), n.z(), plane.offset,
                   label_weights.normal_distance);
  }

  /// Writes the data costs of faces `first` .. `last` - 1 for one plane to `out`.
  void data_costs(const Plane& plane, int first, int last, double* out) const
  {
    const double x = plane.normal.x(), y = plane.normal.y(), z = plane.normal.z(), d = plane.offset;
    const double w = label_weights.normal_distance;
    const double *a = areas.data() + first, *nx = normals[0].data() + first, *ny = normals[1].data() + first,
                 *nz = normals[2].data() + first, *cx = centroids[0].data() + first, *cy = centroids[1].data() + first,
                 *cz = centroids[2].data() + first;
    const int n = last - first;
    for (int i = 0; i < n; ++i) // without branches, so that compilers vectorise it
      out[i] = formula(a[i], nx[i], ny[i], nz[i], cx[i], cy[i], cz[i], x, y, z, d, w);
  }

  /// The data cost D_p(f) of the labels 0 .. planes.size() - 1 with these planes, as `alpha_expansion()` takes it.
  /// It refers to this object.
  Plane_costs data_cost(std::vector<Plane> planes) const;

  /// The price of a boundary between the neighbours p and q, without the factor w_V sqrt(F / 10^4):
  /// A_pq (4 - |n_p - n_q|_1 + w_t), eqs. 3 and 4, with the mean of the two areas and of the two saliency weights.
  double boundary_cost(int p, int q) const
  {
    const Face &a = face_data[p], &b = face_data[q];
    const double steps = std::abs(a.nx - b.nx) + std::abs(a.ny - b.ny) + std::abs(a.nz - b.nz);
    const double w_t = saliency.empty() ? 0 : (saliency[p] + saliency[q]) / 2;
    return (a.area + b.area) / 2 * (4 - steps + w_t);
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
  struct Face
  {
    double area, nx, ny, nz, cx, cy, cz;
  };

  // Eq. 2 for one face (a, n, c) and one plane (x, y, z, d).
  static double formula(double a, double nx, double ny, double nz, double cx, double cy, double cz, double x, double y,
                        double z, double d, double w)
  {
    return a * (std::abs(x - nx) + std::abs(y - ny) + std::abs(z - nz) + w * std::abs(d - (cx * x + cy * y + cz * z)));
  }

  Face make_face(int f, const Points& points) const
  {
    const auto& t = connectivity->triangles[f];
    const Point_3 &p = points[t[0]], &q = points[t[1]], &r = points[t[2]];
    const Vector_3 twice = internal::area_vector(*connectivity, points, f);
    const double length = std::sqrt(twice.squared_length());
    const Vector_3 n = length > 0 ? twice / length : Vector_3(0, 0, 0);
    return {length / 2,
            n.x(),
            n.y(),
            n.z(),
            (p.x() + q.x() + r.x()) / 3,
            (p.y() + q.y() + r.y()) / 3,
            (p.z() + q.z() + r.z()) / 3};
  }

  void fill_columns()
  {
    for (std::vector<double>* column :
         {&areas, &normals[0], &normals[1], &normals[2], &centroids[0], &centroids[1], &centroids[2]})
      column->reserve(face_data.size());
    for (const Face& f : face_data) {
      areas.push_back(f.area);
      normals[0].push_back(f.nx);
      normals[1].push_back(f.ny);
      normals[2].push_back(f.nz);
      centroids[0].push_back(f.cx);
      centroids[1].push_back(f.cy);
      centroids[2].push_back(f.cz);
    }
  }

  const internal::Connectivity* connectivity;
  Labelling_weights label_weights;
  std::vector<double> saliency; // w_t
  std::vector<double> seed_weights;
  // The same numbers twice: by face, where one face meets one plane; by column, where one plane meets many faces.
  std::vector<Face> face_data;
  std::vector<double> areas;
  std::array<std::vector<double>, 3> normals, centroids;
};

/// D_p(f) for labels with given planes: a data cost for `alpha_expansion()` and `cheapest_labels()`.
class Plane_costs
{
public:
  /// Keeps a reference to `costs`.
  Plane_costs(const Label_costs& costs, std::vector<Plane> planes) : costs(&costs), planes(std::move(planes)) {}

  int labels() const { return int(planes.size()); }                                              ///< one a plane
  double operator()(int face, int label) const { return costs->data_cost(face, planes[label]); } ///< D_p(f) of eq. 2
  /// Writes the costs of a label for faces first .. last - 1.
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
