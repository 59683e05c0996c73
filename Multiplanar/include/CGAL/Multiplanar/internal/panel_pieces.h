// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_PIECES_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_PIECES_H

#include <CGAL/Multiplanar/internal/panel_fit.h>
#include <CGAL/Multiplanar/internal/panel_labelling.h>

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

// From labels to connected pieces, and from many pieces to few at least cost, whatever their shape.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Gives each connected piece of a label a label of its own, in the order of their first faces.
/// \return the number of pieces
inline int label_connected_pieces(const Connectivity& c, std::vector<int>& labels)
{
  const int none = -1;
  std::vector<int> piece(labels.size(), none), stack;
  int pieces = 0;
  for (int seed = 0; seed < c.number_of_faces(); ++seed) {
    if (piece[seed] != none) continue;
    piece[seed] = pieces;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int g : c.neighbours[f])
        if (piece[g] == none && labels[g] == labels[f]) piece[g] = pieces, stack.push_back(g);
    }
    ++pieces;
  }
  labels.swap(piece);
  return pieces;
}

/// Renumbers the used labels 0, 1, ... in the order of their first faces.
inline int compress_labels(std::vector<int>& labels)
{
  std::vector<int> number;
  int count = 0;
  for (int& p : labels) {
    if (int(number.size()) <= p) number.resize(p + 1, -1);
    if (number[p] == -1) number[p] = count++;
    p = number[p];
  }
  return count;
}

/// The labels that share a mesh edge with label `p`, ascending.
inline std::vector<int> neighbouring_panels(const Panel_labelling& panels, int p)
{
  std::vector<int> result;
  const Connectivity& c = panels.connectivity();
  for (int f : panels.faces(p))
    for (int g : c.neighbours[f])
      if (panels.label(g) != p && (result.empty() || result.back() != panels.label(g)))
        result.push_back(panels.label(g));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Whether two distinct labels share a mesh edge.
inline bool are_neighbours(const Panel_labelling& panels, int p, int q)
{
  if (p == q) return false;
  if (panels.faces(p).size() > panels.faces(q).size()) std::swap(p, q);
  for (int f : panels.faces(p))
    for (int g : panels.connectivity().neighbours[f])
      if (panels.label(g) == q) return true;
  return false;
}

/// Joins two labels; the one with more faces keeps its name.
/// \return the label that remains
inline int join_panels(Panel_labelling& panels, int p, int q)
{
  if (panels.faces(p).size() < panels.faces(q).size()) std::swap(p, q);
  const std::vector<int> faces = panels.faces(q); // a copy: the list empties under way
  panels.relabel(faces, p);
  return p;
}

/// Gives small pieces to the neighbour whose plane suits them best, smallest area first, until `target` are left.
/// Cheaper than exact costs when there are thousands of pieces.
inline void absorb_small_pieces(Panel_labelling& panels, const Label_costs& costs, int target)
{
  std::vector<Plane_sums> sums(panels.number_of_labels());
  using Entry = std::pair<double, int>; // area, piece
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (int p = 0; p < panels.number_of_labels(); ++p) {
    if (panels.faces(p).empty()) continue;
    sums[p] = plane_sums(costs, panels.faces(p));
    queue.emplace(sums[p].area, p);
  }
  while (panels.number_of_panels() > target) {
    const Entry smallest = queue.top();
    queue.pop();
    const int p = smallest.second;
    if (panels.faces(p).empty() || smallest.first != sums[p].area) continue;
    int best = -1;
    double least = 0;
    for (int q : neighbouring_panels(panels, p)) {
      const double cost = faces_cost(costs, panels.faces(p), fitted_plane(costs, sums[q]));
      if (best == -1 || cost < least) best = q, least = cost;
    }
    const int kept = join_panels(panels, p, best), gone = kept == p ? best : p;
    add_sums(sums[kept], sums[gone], costs);
    queue.emplace(sums[kept].area, kept);
  }
}

/// A queue of pairs of neighbouring panels by what merging them costs (eq. 2, refitted planes).
class Merge_queue
{
public:
  Merge_queue(Panel_labelling& panels, Panel_fits& fits) : panels(&panels), fits(&fits)
  {
    versions.assign(panels.number_of_labels(), 0);
    for (int p = 0; p < panels.number_of_labels(); ++p)
      if (!panels.faces(p).empty()) push_pairs(p, true);
  }

  struct Pair
  {
    double cost;
    int p, q;
  };

  /// Takes out the cheapest pair. \return false if there is none left
  bool pop(Pair& pair)
  {
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      pair = {std::get<0>(e), std::get<1>(e), std::get<2>(e)};
      if (std::get<3>(e) == versions[pair.p] && std::get<4>(e) == versions[pair.q] && !panels->faces(pair.p).empty() &&
          !panels->faces(pair.q).empty())
        return true;
    }
    return false;
  }

  /// Panel `p` has changed: its pairs are priced again.
  void update(int p)
  {
    if (int(versions.size()) < panels->number_of_labels()) versions.resize(panels->number_of_labels(), 0);
    ++versions[p];
    if (!panels->faces(p).empty()) push_pairs(p, false);
  }

private:
  using Entry = std::tuple<double, int, int, int, int>; // cost, p < q, their versions

  void push_pairs(int p, bool only_above)
  {
    for (int q : neighbouring_panels(*panels, p)) {
      if (only_above && q < p) continue;
      const int a = (std::min)(p, q), b = (std::max)(p, q);
      queue.emplace(fits->merge_cost(a, b), a, b, versions[a], versions[b]);
    }
  }

  Panel_labelling* panels;
  Panel_fits* fits;
  std::vector<int> versions;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
};

/// Merges pieces at least cost until `target` are left. Thousands of pieces are thinned out first.
/// \return the number of merges
inline int merge_cheapest(Panel_labelling& panels, Panel_fits& fits, int target)
{
  const int before = panels.number_of_panels();
  absorb_small_pieces(panels, fits.costs(), (std::max)(target, 8 * target + 64));
  if (panels.number_of_panels() > target) {
    Merge_queue queue(panels, fits);
    Merge_queue::Pair pair;
    while (panels.number_of_panels() > target && queue.pop(pair)) queue.update(join_panels(panels, pair.p, pair.q));
  }
  CGAL_postcondition(panels.number_of_panels() <= (std::max)(target, 1));
  return before - panels.number_of_panels();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_PIECES_H
