// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_GUARD_BRUTE_FORCE_H
#define MULTIPLANAR_TEST_GUARD_BRUTE_FORCE_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <boost/container/static_vector.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/// The slow and obvious twin of guarded motion: positions at sampled times, every pair of triangles, CGAL's own
/// do_intersect. Knows nothing of swept tetrahedra or wedges.
namespace Multiplanar_test {

using CGAL::Multiplanar::Point_3;
using CGAL::Multiplanar::Points;
using CGAL::Multiplanar::internal::Connectivity;

/// Do the faces f and g, of positive area, meet in their shared simplex only?
template <class K>
bool meet_properly(const Connectivity& c, const std::vector<typename K::Point_3>& x, int f, int g)
{
  using Triangle = typename K::Triangle_3;
  using Segment = typename K::Segment_3;
  boost::container::static_vector<int, 3> shared, of_f, of_g;
  const auto holds = [&](int h, int v) {
    const auto& t = c.triangles[h];
    return t[0] == v || t[1] == v || t[2] == v;
  };
  for (int v : c.triangles[f]) (holds(g, v) ? shared : of_f).push_back(v);
  for (int v : c.triangles[g])
    if (!holds(f, v)) of_g.push_back(v);
  const auto triangle = [&](int h) {
    const auto& t = c.triangles[h];
    return Triangle(x[t[0]], x[t[1]], x[t[2]]);
  };
  switch (shared.size()) {
  case 0:
    return !CGAL::do_intersect(triangle(f), triangle(g));
  case 1:
    return !CGAL::do_intersect(Segment(x[of_f[0]], x[of_f[1]]), triangle(g)) &&
           !CGAL::do_intersect(Segment(x[of_g[0]], x[of_g[1]]), triangle(f));
  case 2: // more than the edge in common: coplanar, on one side of it
    return !CGAL::coplanar(x[shared[0]], x[shared[1]], x[of_f[0]], x[of_g[0]]) ||
           CGAL::coplanar_orientation(x[shared[0]], x[shared[1]], x[of_f[0]], x[of_g[0]]) == CGAL::NEGATIVE;
  default:
    return false;
  }
}

template <class Points_of_kernel>
CGAL::Bbox_3 box_of(const Connectivity& c, const Points_of_kernel& x, int f)
{
  const auto& t = c.triangles[f];
  return x[t[0]].bbox() + x[t[1]].bbox() + x[t[2]].bbox();
}

/// The boxes of all faces.
template <class Points_of_kernel>
std::vector<CGAL::Bbox_3> boxes_of(const Connectivity& c, const Points_of_kernel& x)
{
  std::vector<CGAL::Bbox_3> boxes;
  for (int f = 0; f < c.number_of_faces(); ++f) boxes.push_back(box_of(c, x, f));
  return boxes;
}

/// Are the faces around `v` free of every other face and of each other, with positive areas? `boxes` are those of the
/// faces of a state that differs from `x` in the place of v only; those around v are brought up to date.
template <class K>
bool is_star_embedded(const Connectivity& c, const std::vector<typename K::Point_3>& x, int v,
                      std::vector<CGAL::Bbox_3>& boxes)
{
  for (int f : c.star(v)) {
    const auto& t = c.triangles[f];
    if (CGAL::collinear(x[t[0]], x[t[1]], x[t[2]])) return false;
    boxes[f] = box_of(c, x, f);
  }
  for (int f : c.star(v))
    for (int g = 0; g < c.number_of_faces(); ++g)
      if (g != f && CGAL::do_overlap(boxes[f], boxes[g]) && !meet_properly<K>(c, x, f, g)) return false;
  return true;
}

/// Samples of a move: times 1/samples, 2/samples, ..., 1.
constexpr int samples = 24;

/// Can the coordinates be multiplied by `samples`, and points between be formed, without rounding?
inline bool scales_exactly(const Points& x, const Point_3& to)
{
  const auto exact = [](double d) { return std::fma(d, double(samples), -(d * samples)) == 0; };
  for (const Point_3& p : x)
    for (int i = 0; i < 3; ++i)
      if (!exact(p[i])) return false;
  for (int i = 0; i < 3; ++i)
    if (!exact(to[i])) return false;
  return true;
}

/// The first sample k = 1 .. samples at which the mesh is not embedded while vertex v moves to `to`; 0 if it always is.
template <class K>
int first_contact_in(const Connectivity& c, const Points& x, int v, const Point_3& to)
{
  using FT = typename K::FT;
  std::vector<typename K::Point_3> scaled;
  for (const Point_3& p : x) scaled.emplace_back(FT(p.x()) * samples, FT(p.y()) * samples, FT(p.z()) * samples);
  std::vector<CGAL::Bbox_3> boxes = boxes_of(c, scaled);
  for (int k = 1; k <= samples; ++k) {
    const auto at = [&](int i) { return FT(x[v][i]) * (samples - k) + FT(to[i]) * k; };
    scaled[v] = typename K::Point_3(at(0), at(1), at(2));
    if (!is_star_embedded<K>(c, scaled, v, boxes)) return k;
  }
  return 0;
}

/// Are the points between those of `x[v]` and `to` at the sampled times exact in doubles? (They are sums of multiples
/// of one unit; the test is that nothing was rounded.)
inline bool interpolates_exactly(const Points& x, int v, const Point_3& to)
{
  for (int k = 1; k <= samples; ++k)
    for (int i = 0; i < 3; ++i) {
      const double a = x[v][i] * (samples - k), b = to[i] * k, sum = a + b;
      if (std::fma(x[v][i], double(samples - k), -a) != 0 || std::fma(to[i], double(k), -b) != 0) return false;
      const double part = sum - a; // two-sum: the rounding error of a + b
      if ((a - (sum - part)) + (b - part) != 0) return false;
    }
  return true;
}

/// The same with the fastest kernel that is exact here: doubles where nothing rounds, else exact constructions.
inline int first_contact(const Connectivity& c, const Points& x, int v, const Point_3& to)
{
  if (scales_exactly(x, to) && interpolates_exactly(x, v, to))
    return first_contact_in<CGAL::Multiplanar::Kernel>(c, x, v, to);
  return first_contact_in<CGAL::Exact_predicates_exact_constructions_kernel>(c, x, v, to);
}

/// Random numbers that are the same everywhere.
class Random_numbers
{
public:
  explicit Random_numbers(std::uint64_t seed) : engine_(seed) {}
  int below(int n) { return int(engine_() % std::uint64_t(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  double unit() { return double(engine_() >> 11) * 0x1p-53; }
  double signed_unit() { return 2 * unit() - 1; }

private:
  std::mt19937_64 engine_;
};

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_GUARD_BRUTE_FORCE_H
