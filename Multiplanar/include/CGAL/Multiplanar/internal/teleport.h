// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H
#define CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H

#include <CGAL/Multiplanar/internal/panel_edits.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <random>
#include <set>
#include <thread>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Calls f(0) .. f(n - 1), on several threads.
template <class F>
void for_each_parallel(int n, int threads, F f)
{
  std::atomic<int> next(0);
  const auto work = [&] {
    for (int i = next++; i < n; i = next++) f(i);
  };
  std::vector<std::thread> others;
  for (int t = 1; t < (std::min)(threads, n); ++t) others.emplace_back(work);
  work();
  for (std::thread& t : others) t.join();
}

/// Is `a` the better model: fewer faults, or as many, no more offences and a lower cost?
inline bool is_better(const Panel_model& a, const Panel_model& b, double factor = 1)
{
  if (a.faults != b.faults) return a.faults < b.faults;
  return a.offences <= b.offences && a.cost() < factor * b.cost();
}

/// The order of models to choose from.
inline bool ranks_before(const Panel_model& a, const Panel_model& b)
{
  if (a.faults != b.faults) return a.faults < b.faults;
  return a.cost() * (1 + 0.02 * a.offences) < b.cost() * (1 + 0.02 * b.offences);
}

/// Changes to the set of panels that keep what lowers the distance. At the places where the distance is largest, faces
/// are shared out anew, or a panel is added there and elsewhere the pair of neighbours merged that costs least. Each
/// attempt is followed by accuracy steps of the panels around; the best of a batch is kept. Batches are evaluated on
/// several threads and judged in order, so results do not depend on the number of threads.
class Teleport_search
{
public:
  Teleport_search(const Panel_modeller& modeller, int max_panels, int threads = 1)
      : modeller(modeller), edits(modeller, 1), max_panels(max_panels), threads(threads)
  {
  }

  Accuracy_options local_options;
  double work = 0; ///< done so far, in distances measured

  /// Asked, if given, of models that `improve_once()` would take, and may change them; those it refuses are not taken.
  std::function<bool(Panel_model&)> usable;

  /// All pairs of neighbours, cheapest first.
  std::vector<Merge_candidate> cheapest_merges(const Panel_model& m) const { return edits.merges(m); }

  /// Models in which panel `p` or its surroundings are different, whatever that does to the distance, without new
  /// faults: best first.
  std::vector<Panel_model> reworked(const Panel_model& m, int p)
  {
    edits.set_unit((std::max)(m.largest, 1e-9));
    std::vector<Label_edit> candidates{edits.dissolve(m, p), edits.share(m, with_neighbours(m, p))};
    for (int q : Panel_edits::neighbours(m, p)) {
      candidates.push_back(edits.merge(m, p, q));
      candidates.push_back(edits.divide_anew(m, p, q, m.panel_worst[p]));
      candidates.push_back(edits.dissolve(m, q));
    }
    add_flips(m, p, candidates);
    std::vector<Panel_model> results;
    std::vector<char> ok;
    attempt_all(m, candidates, local_options, results, ok);
    std::vector<Panel_model> good;
    for (int i = 0; i < int(results.size()); ++i)
      if (ok[i] && results[i].labels != m.labels) good.push_back(std::move(results[i]));
    add_split(m, p, good);
    std::stable_sort(good.begin(), good.end(), ranks_before);
    return good;
  }

  /// Tries edits at the worst places, and at the longest edges without room for a joint, until one lowers the cost.
  /// \return false if none does
  bool improve_once(Panel_model& m)
  {
    edits.set_unit((std::max)(m.largest, 1e-9));
    const std::vector<int> order = worst_first(m);
    const auto merges = edits.merges(m);
    for (int place = 0; place < 4 && place < m.panels(); ++place) {
      const int p = order[place];
      if (m.panel_error[p] < 0.8 * m.largest) break;
      if (improve_at(m, p, merges)) return true;
    }
    for (std::size_t i = 0; i < 2 && i < m.lack.edges.size(); ++i)
      for (int p : m.topology->edges[m.lack.edges[i]].panels)
        if (improve_at(m, p, merges)) return true;
    return share_all(m);
  }

  /// A random change that need not improve anything: a panel is added at one of the bad places and a cheap pair merged.
  /// \return false if none was possible
  bool kick(Panel_model& m, std::mt19937_64& random)
  {
    edits.set_unit((std::max)(m.largest, 1e-9));
    const std::vector<int> order = worst_first(m);
    const auto merges = edits.merges(m);
    for (int attempt = 0; attempt < 6; ++attempt) {
      const int p = order[random() % std::uint64_t((std::min)(m.panels(), 4 + m.panels() / 4))];
      const auto& pair = merges[random() % std::uint64_t((std::min)(int(merges.size()), 4 + m.panels() / 4))];
      if (pair.p == p || pair.q == p) continue;
      Panel_model smaller, result;
      if (!attempt_edit(m, edits.merge(m, pair.p, pair.q), local_options, smaller)) continue;
      const int worst = order_position(smaller, m, p);
      const int face = smaller.panel_worst[worst];
      if (!attempt_edit(smaller, edits.split(smaller, worst, face), local_options, result)) continue;
      m = std::move(result);
      return true;
    }
    return false;
  }

  /// Edits that lower the number of faults: the best of all near the first of the panels concerned that has one.
  /// \return false if there is none
  bool repair_once(Panel_model& m)
  {
    std::set<int> bad;
    for (int p = 0; p < m.panels(); ++p)
      if (!m.surface->is_simple(p)) bad.insert(p);
    for (const auto& pair : m.contacts) bad.insert(pair[0]), bad.insert(pair[1]);
    edits.set_unit(0.02);
    const std::vector<int> order(bad.begin(), bad.end());
    for (std::size_t first = 0; first < order.size(); first += repaired_at_once) {
      const std::size_t last = (std::min)(order.size(), first + repaired_at_once);
      if (repair_near(m, {order.begin() + std::ptrdiff_t(first), order.begin() + std::ptrdiff_t(last)})) return true;
    }
    return false;
  }

  /// Removes short edges and narrow panels: the best of the edits near one that lower their number. \return false if
  /// there is none
  bool tidy_once(Panel_model& m)
  {
    edits.set_unit((std::max)(m.largest, 1e-9));
    std::set<int> concerned;
    std::set<std::pair<int, int>> pairs;
    for (const auto& e : m.topology->edges) {
      if (!modeller.is_short(m, e)) continue;
      for (int x : e.corners)
        for (int p : m.topology->corner_panels[x]) concerned.insert(p);
    }
    for (int p = 0; p < m.panels(); ++p)
      if (modeller.is_narrow(m, p)) concerned.insert(p);
    std::vector<Label_edit> candidates;
    for (int p : concerned) {
      candidates.push_back(edits.share(m, with_neighbours(m, p)));
      candidates.push_back(edits.dissolve(m, p));
      for (int q : Panel_edits::neighbours(m, p))
        if (pairs.insert(std::minmax({p, q})).second) candidates.push_back(edits.merge(m, p, q));
    }
    std::vector<Panel_model> results;
    std::vector<char> ok;
    attempt_all(m, candidates, local_options, results, ok);
    int best = -1;
    for (int i = 0; i < int(results.size()); ++i)
      if (ok[i] && results[i].offences < m.offences && (best < 0 || results[i].cost() < results[best].cost())) best = i;
    if (best < 0) return false;
    m = std::move(results[best]);
    return true;
  }

private:
  bool repair_near(Panel_model& m, const std::vector<int>& bad)
  {
    std::vector<Label_edit> candidates;
    std::set<std::pair<int, int>> pairs;
    for (int p : bad) {
      candidates.push_back(edits.share(m, with_neighbours(m, p)));
      candidates.push_back(edits.dissolve(m, p));
      for (int q : Panel_edits::neighbours(m, p)) pairs.insert(std::minmax({p, q}));
    }
    for (const auto& pq : pairs) candidates.push_back(edits.merge(m, pq.first, pq.second));
    std::vector<Panel_model> results(candidates.size());
    std::vector<char> ok(candidates.size(), 0);
    for_each_parallel(int(candidates.size()), threads, [&](int i) {
      std::vector<char> touched;
      clip_ears(modeller.connectivity(), candidates[i].labels);
      ok[i] = modeller.rebuild(&m, candidates[i], results[i], touched) && results[i].faults < m.faults;
      if (ok[i]) modeller.measure(results[i], touched);
    });
    int best = -1;
    for (int i = 0; i < int(results.size()); ++i)
      if (ok[i] && (best < 0 || ranks_before(results[i], results[best]))) best = i;
    if (best < 0) return false;
    m = std::move(results[best]);
    return true;
  }

  static std::vector<int> worst_first(const Panel_model& m)
  {
    std::vector<int> order(m.panels());
    for (int p = 0; p < m.panels(); ++p) order[p] = p;
    std::stable_sort(order.begin(), order.end(), [&](int p, int q) { return m.panel_error[p] > m.panel_error[q]; });
    return order;
  }

  static std::vector<int> with_neighbours(const Panel_model& m, int p)
  {
    std::vector<int> result = Panel_edits::neighbours(m, p);
    result.push_back(p);
    return result;
  }

  /// The model with panel `p` split, and a cheap pair merged elsewhere if that makes too many.
  void add_split(const Panel_model& m, int p, std::vector<Panel_model>& good)
  {
    Panel_model larger, result;
    if (!attempt_edit(m, edits.split(m, p, m.panel_worst[p]), local_options, larger)) return;
    if (larger.panels() <= max_panels) return good.push_back(std::move(larger));
    int attempts = 0;
    for (const auto& pair : edits.merges(m)) { // the numbers of m are those of `larger`, whose new panel is the last
      if (pair.p == p || pair.q == p) continue;
      if (++attempts > 6) return;
      if (!attempt_edit(larger, edits.merge(larger, pair.p, pair.q), local_options, result)) continue;
      if (result.panels() > max_panels) continue;
      return good.push_back(std::move(result));
    }
  }

  /// The panel of `now` that holds the worst face of panel `p` of `before`.
  static int order_position(const Panel_model& now, const Panel_model& before, int p)
  {
    return now.labels[before.panel_worst[p]];
  }

  /// All faces go to the panels that they are nearest to now.
  bool share_all(Panel_model& m)
  {
    std::vector<int> all(m.panels());
    for (int p = 0; p < m.panels(); ++p) all[p] = p;
    Panel_model result;
    if (!attempt_edit(m, edits.share(m, all), options_to_beat(m), result) || !is_better(result, m, least_gain) ||
        !is_usable(result))
      return false;
    m = std::move(result);
    return true;
  }

  bool improve_at(Panel_model& m, int p, const std::vector<Merge_candidate>& merges)
  {
    const int face = m.panel_worst[p];
    std::vector<Label_edit> candidates{edits.share(m, with_neighbours(m, p)), edits.split(m, p, face),
                                       edits.share_with_fresh(m, with_neighbours(m, p), face)};
    for (int q : Panel_edits::neighbours(m, p)) candidates.push_back(edits.divide_anew(m, p, q, face));
    add_flips(m, p, candidates);
    std::vector<Panel_model> results;
    std::vector<char> ok;
    attempt_all(m, candidates, options_to_beat(m), results, ok);
    if (take_best(m, results, ok)) return true;
    for (int i = 0; i < int(results.size()); ++i)
      if (ok[i] && results[i].panels() > max_panels && is_better(results[i], m, least_gain) &&
          merge_back(m, p, results[i], merges))
        return true;
    return false;
  }

  /// Flips of the shortest edges around panel `p`: where an edge wants to vanish, its neighbours may want to meet.
  void add_flips(const Panel_model& m, int p, std::vector<Label_edit>& candidates) const
  {
    std::vector<std::pair<double, int>> edges;
    for (int e = 0; e < int(m.topology->edges.size()); ++e) {
      const auto& edge = m.topology->edges[e];
      bool near = false;
      for (int x : edge.corners)
        for (int q : m.topology->corner_panels[x]) near = near || q == p;
      const double length = (m.state.corner[edge.corners[0]] - m.state.corner[edge.corners[1]]).norm();
      if (near && length < 4 * local_options.min_edge + m.largest) edges.emplace_back(length, e);
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size() && i < 4; ++i)
      for (int end = 0; end < 2; ++end) {
        Label_edit edit;
        if (edits.flip(m, edges[i].second, end, edit)) candidates.push_back(std::move(edit));
      }
  }

  /// `larger` is `m` with one panel more; keeps it if a pair far from `p` can be merged and the whole is an
  /// improvement.
  bool merge_back(Panel_model& m, int p, const Panel_model& larger, const std::vector<Merge_candidate>& merges)
  {
    std::vector<Label_edit> candidates;
    for (const auto& pair : merges) { // the numbers of m are those of `larger`, whose new panel is the last
      if (candidates.size() >= 6 || pair.error > 1.2 * m.largest) break;
      if (pair.p != p && pair.q != p) candidates.push_back(edits.merge(larger, pair.p, pair.q));
    }
    std::vector<Panel_model> results;
    std::vector<char> ok;
    attempt_all(larger, candidates, options_to_beat(m), results, ok);
    return take_best(m, results, ok);
  }

  /// Takes the best of the results that are better than `m`, not too many panels, and of use. \return false if none is
  bool take_best(Panel_model& m, std::vector<Panel_model>& results, std::vector<char>& ok) const
  {
    for (;;) {
      int best = -1;
      for (int i = 0; i < int(results.size()); ++i)
        if (ok[i] && results[i].panels() <= max_panels && is_better(results[i], m, least_gain) &&
            (best < 0 || ranks_before(results[i], results[best])))
          best = i;
      if (best < 0) return false;
      ok[best] = 0;
      if (!is_usable(results[best])) continue;
      m = std::move(results[best]);
      return true;
    }
  }

  bool is_usable(Panel_model& m) const { return !usable || usable(m); }

  /// Steps for edits that count only if the result is better than `m`.
  Accuracy_options options_to_beat(const Panel_model& m) const
  {
    Accuracy_options o = local_options;
    o.expected = m.cost();
    o.hopeless = 1.4 * m.cost();
    return o;
  }

  void attempt_all(const Panel_model& m, std::vector<Label_edit>& candidates, const Accuracy_options& options,
                   std::vector<Panel_model>& results, std::vector<char>& ok)
  {
    results.resize(candidates.size());
    ok.assign(candidates.size(), 0);
    for_each_parallel(int(candidates.size()), threads,
                      [&](int i) { ok[i] = evaluate(m, candidates[i], options, results[i]); });
    for (const Panel_model& r : results) work += r.work;
  }

  bool attempt_edit(const Panel_model& m, Label_edit edit, const Accuracy_options& options, Panel_model& result)
  {
    const bool ok = evaluate(m, edit, options, result);
    work += result.work;
    return ok;
  }

  /// The model after an edit and accuracy steps around it. \return false if that is not possible without new faults
  bool evaluate(const Panel_model& m, Label_edit& edit, const Accuracy_options& options, Panel_model& result) const
  {
    clip_ears(modeller.connectivity(), edit.labels);
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, result, touched) || result.faults > m.faults) return false;
    modeller.improve(result, touched, options);
    if (result.faults > m.faults) return false;
    if (result.cost() < promising * m.cost()) modeller.improve(result, with_ring(*result.topology, touched), options);
    return result.faults <= m.faults;
  }

  static constexpr double least_gain = 0.9995, promising = 1.1;
  static constexpr std::size_t repaired_at_once = 16; // panels; all of a few, some of many

  const Panel_modeller& modeller;
  Panel_edits edits;
  int max_panels, threads;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H
