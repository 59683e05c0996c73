// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_PARTITION_PROBLEMS_H
#define CGAL_MULTIPLANAR_PANEL_PARTITION_PROBLEMS_H

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// Why labels do not make panels that can be flat. The checks share nothing with what `make_panels()` keeps count of
/// while it works: they are slow and obvious.
struct Partition_problem
{
  /// What is wrong.
  enum Kind
  {
    bad_label,       ///< a label is out of range
    empty_panel,     ///< a label has no face
    disconnected,    ///< a label has several connected pieces
    self_touch,      ///< a label has several runs around a vertex
    complex_problem, ///< one of `panel_complex_problems()`
    chord,           ///< an edge inside a panel has both ends on one chain
    collinear_face   ///< all vertices of a face lie where its panel meets one other panel
  };
  Kind kind;   ///< which
  int panel;   ///< -1 if none
  int element; ///< a face (bad_label, collinear_face), a vertex (self_touch), a face at a chord, else -1
  std::string text; ///< the same in words
};

namespace internal {

inline int count_pieces(const Connectivity& c, const std::vector<int>& labels, int p)
{
  std::set<int> left;
  for (int f = 0; f < c.number_of_faces(); ++f)
    if (labels[f] == p) left.insert(f);
  int pieces = 0;
  for (; !left.empty(); ++pieces) {
    std::vector<int> stack{*left.begin()};
    left.erase(left.begin());
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int g : c.neighbours[f])
        if (left.erase(g)) stack.push_back(g);
    }
  }
  return pieces;
}

inline void find_self_touches(const Connectivity& c, const std::vector<int>& labels,
                              std::vector<Partition_problem>& out)
{
  for (int v = 0; v < c.number_of_vertices(); ++v) {
    const std::vector<int> star(c.star(v).begin(), c.star(v).end());
    std::map<int, int> runs;
    for (std::size_t i = 0; i < star.size(); ++i)
      if (labels[star[i]] != labels[star[(i + 1) % star.size()]]) ++runs[labels[star[i]]];
    for (const auto& run : runs)
      if (run.second > 1) out.push_back({Partition_problem::self_touch, run.first, v, "a panel touches itself"});
  }
}

inline void find_chords(const Connectivity& c, const std::vector<int>& labels, const Panel_complex& complex,
                        std::vector<Partition_problem>& out)
{
  std::vector<std::set<int>> chains_at(c.number_of_vertices()); // edges of the complex whose chain passes the vertex
  for (int e = 0; e < complex.number_of_edges(); ++e)
    for (int v : complex.edges[e].chain) chains_at[v].insert(e);
  for (int f = 0; f < c.number_of_faces(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (labels[f] != labels[c.neighbours[f][i]] || f > c.neighbours[f][i]) continue;
      const int v = c.triangles[f][i], w = c.triangles[f][(i + 1) % 3];
      for (int e : chains_at[v])
        if (chains_at[w].count(e)) out.push_back({Partition_problem::chord, labels[f], f, "an inner edge is a chord"});
    }
}

inline void find_collinear_faces(const Connectivity& c, const Panel_complex& complex,
                                 std::vector<Partition_problem>& out)
{
  std::map<std::pair<int, int>, std::set<int>> line; // vertices on all chains between two panels
  for (const auto& e : complex.edges)
    line[std::minmax(e.panels[0], e.panels[1])].insert(e.chain.begin(), e.chain.end());
  for (int p = 0; p < complex.number_of_panels(); ++p)
    for (int q : complex.neighbours(p)) {
      const std::set<int>& on = line[std::minmax(p, q)];
      for (int f : complex.panels[p].faces) {
        const auto& t = c.triangles[f];
        if (on.count(t[0]) && on.count(t[1]) && on.count(t[2]))
          out.push_back({Partition_problem::collinear_face, p, f, "all vertices of a face lie on one line"});
      }
    }
}

} // namespace internal

/// All reasons why the panels 0 .. `panels` - 1 given by `labels` cannot be flat polygons with area, the mesh keeping
/// its connectivity; empty if `labels` keeps what `make_panels()` promises.
inline std::vector<Partition_problem> partition_problems(const internal::Connectivity& c, const Points& points,
                                                         const std::vector<int>& labels, int panels)
{
  std::vector<Partition_problem> out;
  for (int f = 0; f < c.number_of_faces(); ++f)
    if (labels[f] < 0 || labels[f] >= panels)
      out.push_back({Partition_problem::bad_label, -1, f, "label out of range"});
  if (!out.empty()) return out;
  for (int p = 0; p < panels; ++p) {
    const int pieces = internal::count_pieces(c, labels, p);
    if (pieces == 0) out.push_back({Partition_problem::empty_panel, p, -1, "a panel has no face"});
    if (pieces > 1) out.push_back({Partition_problem::disconnected, p, -1, "a panel is not connected"});
  }
  internal::find_self_touches(c, labels, out);
  if (!out.empty()) return out;
  const Panel_complex complex = make_panel_complex(c, points, labels, panels);
  for (const auto& problem : panel_complex_problems(complex))
    out.push_back({Partition_problem::complex_problem, problem.panel, -1, to_string(problem.problem)});
  if (panels == 1) out.push_back({Partition_problem::complex_problem, 0, -1, "is the whole surface"});
  internal::find_chords(c, labels, complex, out);
  internal::find_collinear_faces(c, complex, out);
  return out;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_PARTITION_PROBLEMS_H
