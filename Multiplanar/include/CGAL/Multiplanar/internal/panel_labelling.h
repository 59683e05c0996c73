// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_LABELLING_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_LABELLING_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Distinct labels in ascending order.
using Label_set = boost::container::small_vector<int, 4>;

inline bool contains(const Label_set& s, int label) { return std::find(s.begin(), s.end(), label) != s.end(); }

/// How many labels two sets have in common.
inline int common_labels(const Label_set& a, const Label_set& b)
{
  int n = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();)
    if (*i < *j) ++i;
    else if (*j < *i) ++j;
    else ++n, ++i, ++j;
  return n;
}

/// A labelling of the faces that can be changed, taken back, and asked at any moment how far it is from panels that can
/// be flat. Notation: S(v) is the set of labels around vertex v. Once panels are planes and P and Q are in S(v), v lies
/// on the line P n Q; with a third panel it lies on the point P n Q n R. So the local obstructions are
/// - *touches*: a label forms more than one run around a vertex;
/// - *chords*: an edge vw inside panel P with another label common to S(v) and S(w): it would lie on the line. No
///   triangle has all its vertices on one line unless one of its edges is a chord or a panel is repeated at corners;
/// - *repeated corners*: two vertices with three labels in common: they would coincide.
/// Their numbers are kept up to date in time proportional to the number of vertices touched by a change.
class Panel_labelling
{
public:
  /// \pre labels >= 0. A label may be unused.
  Panel_labelling(const Connectivity& c, std::vector<int> labels) : c(&c), face_labels(std::move(labels))
  {
    CGAL_precondition(int(face_labels.size()) == c.number_of_faces());
    int count = 0;
    for (int p : face_labels) count = (std::max)(count, p + 1);
    panel_faces.resize(count);
    change_count.assign(count, 0);
    position.resize(face_labels.size());
    for (int f = 0; f < c.number_of_faces(); ++f) append(f, face_labels[f]);
  }

  const Connectivity& connectivity() const { return *c; }
  const std::vector<int>& labels() const { return face_labels; }
  int label(int f) const { return face_labels[f]; }
  /// The faces of a label, in no particular order.
  const std::vector<int>& faces(int p) const { return panel_faces[p]; }
  /// The place of a face among the faces of its label.
  int place(int f) const { return position[f]; }
  /// Labels are 0 .. number_of_labels() - 1; some of them may be unused.
  int number_of_labels() const { return int(panel_faces.size()); }
  int number_of_panels() const { return used; }
  /// Grows whenever a face joins or leaves the label.
  std::int64_t changes(int p) const { return change_count[p]; }

  /// A label without faces.
  int unused_label()
  {
    for (int p = 0; p < number_of_labels(); ++p)
      if (panel_faces[p].empty()) return p;
    panel_faces.emplace_back();
    change_count.push_back(0);
    return number_of_labels() - 1;
  }

  /// From now on the local obstructions are known.
  void start_watching()
  {
    CGAL_precondition(number_of_labels() < 1 << 21);
    around.resize(c->number_of_vertices());
    touches_at.assign(c->number_of_vertices(), 0);
    stamp.assign(c->number_of_vertices(), 0);
    watching = true;
    for (int v = 0; v < c->number_of_vertices(); ++v) {
      look_around(v);
      touches += touches_at[v];
      count_corner(v, 1);
    }
    for (int v = 0; v < c->number_of_vertices(); ++v) for_each_chord(v, [&](int w) { chords += v < w; });
  }

  /// \pre `start_watching()` was called
  const Label_set& labels_at(int v) const { return around[v]; }
  int touches_of(int v) const { return touches_at[v]; }
  int number_of_touches() const { return touches; }
  int number_of_chords() const { return chords; }
  int number_of_repeated_corners() const { return repeated; }
  int number_of_local_problems() const { return touches + chords + repeated; }

  /// Whether the three labels meet at more than one vertex.
  bool is_repeated(int p, int q, int r) const
  {
    const auto found = corners.find(key(p, q, r));
    return found != corners.end() && found->second > 1;
  }

  /// Calls `f(w)` for each chord vw.
  template <class F>
  void for_each_chord(int v, F f) const
  {
    if (around[v].size() < 2) return;
    const auto star = c->star(v);
    for (std::size_t i = 0; i < star.size(); ++i) {
      const int g = star[i], h = star[i + 1 < star.size() ? i + 1 : 0];
      if (face_labels[g] != face_labels[h]) continue;
      const int w = c->triangles[g][(c->corner_of(g, v) + 2) % 3]; // the edge wv parts g from h
      if (common_labels(around[v], around[w]) >= 2) f(w);
    }
  }

  /// Gives faces a label. They may have any labels now, but each occurs once.
  void relabel(const std::vector<int>& faces, int p)
  {
    CGAL_precondition(p >= 0 && p < number_of_labels());
    assign(
        faces, [p](std::size_t) { return p; }, true);
  }

  std::size_t mark() const { return journal.size(); }
  /// The faces relabelled since `mark`; a face may occur several times.
  std::vector<int> changed_faces(std::size_t mark) const
  {
    std::vector<int> faces;
    for (std::size_t i = mark; i < journal.size(); ++i) faces.push_back(journal[i].first);
    return faces;
  }
  /// Takes back everything since `mark`.
  void roll_back(std::size_t mark)
  {
    if (journal.size() == mark) return;
    // The first entry of a face holds the label it goes back to.
    std::vector<std::pair<int, int>> first(journal.begin() + mark, journal.end());
    std::stable_sort(first.begin(), first.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    first.erase(
        std::unique(first.begin(), first.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
        first.end());
    std::vector<int> faces(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) faces[i] = first[i].first;
    assign(
        faces, [&](std::size_t i) { return first[i].second; }, false);
    journal.resize(mark);
  }
  /// Forgets the way here: nothing before can be taken back.
  void commit() { journal.clear(); }

private:
  void append(int f, int p)
  {
    used += panel_faces[p].empty();
    position[f] = int(panel_faces[p].size());
    panel_faces[p].push_back(f);
    ++change_count[p];
  }

  void move(int f, int p)
  {
    const int old = face_labels[f], last = panel_faces[old].back();
    panel_faces[old][position[f]] = last;
    position[last] = position[f];
    panel_faces[old].pop_back();
    used -= panel_faces[old].empty();
    ++change_count[old];
    face_labels[f] = p;
    append(f, p);
  }

  template <class LabelOf>
  void assign(const std::vector<int>& faces, LabelOf label_of, bool remember)
  {
    const auto change = [&] {
      for (std::size_t i = 0; i < faces.size(); ++i) {
        const int f = faces[i], p = label_of(i);
        if (face_labels[f] == p) continue;
        if (remember) journal.emplace_back(f, face_labels[f]);
        move(f, p);
      }
    };
    if (!watching) return change();
    std::vector<int> vertices = stamped_vertices(faces);
    count_problems(vertices, -1);
    change();
    for (int v : vertices) look_around(v);
    count_problems(vertices, 1);
  }

  /// The vertices of the faces, each once, and marked with the current stamp.
  std::vector<int> stamped_vertices(const std::vector<int>& faces)
  {
    ++current_stamp;
    std::vector<int> vertices;
    for (int f : faces)
      for (int v : c->triangles[f])
        if (stamp[v] != current_stamp) stamp[v] = current_stamp, vertices.push_back(v);
    return vertices;
  }

  /// Adds (sign 1) or takes off (-1) what is counted at stamped vertices and at the edges that leave them.
  void count_problems(const std::vector<int>& vertices, int sign)
  {
    for (int v : vertices) {
      touches += sign * touches_at[v];
      count_corner(v, sign);
      for_each_chord(v, [&](int w) {
        if (stamp[w] != current_stamp || v < w) chords += sign;
      });
    }
  }

  void look_around(int v)
  {
    Label_set& set = around[v];
    set.clear();
    int runs = 0;
    const auto star = c->star(v);
    int previous = face_labels[*(star.end() - 1)];
    for (int f : star) {
      const int p = face_labels[f];
      if (p == previous && !set.empty()) continue;
      runs += p != previous;
      previous = p;
      const auto place = std::lower_bound(set.begin(), set.end(), p);
      if (place == set.end() || *place != p) set.insert(place, p);
    }
    touches_at[v] = runs == 0 ? 0 : runs - int(set.size());
  }

  static std::uint64_t key(int p, int q, int r)
  {
    if (p > q) std::swap(p, q);
    if (q > r) std::swap(q, r);
    if (p > q) std::swap(p, q);
    return (std::uint64_t(p) << 42) | (std::uint64_t(q) << 21) | std::uint64_t(r);
  }

  void count_corner(int v, int sign)
  {
    const Label_set& s = around[v];
    for (std::size_t i = 0; i + 2 < s.size(); ++i)
      for (std::size_t j = i + 1; j + 1 < s.size(); ++j)
        for (std::size_t k = j + 1; k < s.size(); ++k) {
          int& n = corners[key(s[i], s[j], s[k])];
          repeated -= n > 1 ? n - 1 : 0;
          n += sign;
          repeated += n > 1 ? n - 1 : 0;
        }
  }

  const Connectivity* c;
  std::vector<int> face_labels;
  std::vector<std::vector<int>> panel_faces;
  std::vector<std::int64_t> change_count;
  std::vector<int> position; // of a face among the faces of its label
  int used = 0;
  std::vector<std::pair<int, int>> journal;

  bool watching = false;
  std::vector<Label_set> around;                  // S(v)
  std::vector<int> touches_at;                    // runs around v beyond one for each label
  std::unordered_map<std::uint64_t, int> corners; // vertices at which three labels meet
  int touches = 0, chords = 0, repeated = 0;
  std::vector<int> stamp;
  int current_stamp = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_LABELLING_H
