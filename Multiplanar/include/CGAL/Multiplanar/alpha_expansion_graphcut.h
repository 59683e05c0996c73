// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ALPHA_EXPANSION_GRAPHCUT_H
#define CGAL_MULTIPLANAR_ALPHA_EXPANSION_GRAPHCUT_H

#include <CGAL/Multiplanar/alpha_expansion.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// Regularises a partition of a graph by alpha-expansion. Takes what `CGAL::alpha_expansion_graphcut()` takes, gives
/// what that function gives with its Boost implementations, and needs a small part of its time.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` (default) or `CGAL::Parallel_tag`; the result is the same
/// \tparam InputGraph a model of `VertexAndEdgeListGraph`
/// \tparam EdgeCostMap a model of `ReadablePropertyMap`: edge descriptor -> `double`, >= 0
/// \tparam VertexLabelCostMap a model of `ReadablePropertyMap`: vertex descriptor -> `std::vector<double>`, the cost of
///   each label, all vectors of the same size. It is read once for each vertex.
/// \tparam VertexLabelMap a model of `ReadWritePropertyMap`: vertex descriptor -> an integer type
/// \param input_graph the graph
/// \param edge_cost_map what it costs if the ends of an edge have different labels
/// \param vertex_label_cost_map what each label costs at a vertex
/// \param vertex_label_map holds the initial labels and receives the final ones
/// \param np optional named parameters:
///   - `vertex_index_map(map)`: vertex descriptor -> 0 .. num_vertices - 1; default: as everywhere in the BGL package
///   - `number_of_iterations(n)`: sweeps over all labels at most; default: until nothing changes
/// \returns the energy of the final labelling, 0 for a graph without vertices
template <class ConcurrencyTag = Sequential_tag, class InputGraph, class EdgeCostMap, class VertexLabelCostMap,
          class VertexLabelMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
double alpha_expansion_graphcut(const InputGraph& input_graph, EdgeCostMap edge_cost_map,
                                VertexLabelCostMap vertex_label_cost_map, VertexLabelMap vertex_label_map,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Label = typename boost::property_traits<VertexLabelMap>::value_type;

  const auto index = CGAL::get_initialized_vertex_index_map(input_graph, np);
  std::vector<std::pair<int, int>> edge_list;
  std::vector<double> weights;
  for (auto e : CGAL::make_range(edges(input_graph))) {
    edge_list.emplace_back(int(get(index, source(e, input_graph))), int(get(index, target(e, input_graph))));
    weights.push_back(get(edge_cost_map, e));
  }
  const int nodes = int(num_vertices(input_graph));
  if (nodes == 0) return 0;
  Dense_data_cost cost{{}, 0};
  std::vector<int> labelling(nodes);
  for (auto v : CGAL::make_range(vertices(input_graph))) {
    const auto& costs = get(vertex_label_cost_map, v);
    if (cost.values.empty()) {
      cost.labels = int(costs.size());
      cost.values.resize(std::size_t(nodes) * costs.size());
    }
    CGAL_precondition(int(costs.size()) == cost.labels);
    const std::size_t i = get(index, v);
    std::copy(costs.begin(), costs.end(), cost.values.begin() + i * cost.labels);
    labelling[i] = int(get(vertex_label_map, v));
  }
  Alpha_expansion_options options;
  options.maximal_sweeps =
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), (std::numeric_limits<int>::max)());
  options.threads = std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? 0 : 1;
  const auto result =
      alpha_expansion(make_potts_graph(nodes, edge_list, weights), cost.labels, cost, labelling, options);
  for (auto v : CGAL::make_range(vertices(input_graph))) put(vertex_label_map, v, Label(labelling[get(index, v)]));
  return result.energy;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ALPHA_EXPANSION_GRAPHCUT_H
