#pragma once

#include <cstddef>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

namespace detail {
inline std::size_t place_in_order(int index) { return static_cast<std::size_t>(index); }
inline std::size_t place_in_order(NodeId node) { return place_in_order(node.index); }
}  // namespace detail

/// The `count` nodes of any graph, each after its predecessors, depth first: the one made ready
/// last comes next; among those made ready together, the first in the list of successors, or, of
/// those without predecessors, the lowest. For an `Id` (an int or a NodeId), `predecessors` and
/// `successors` give the list of its neighbours.
template <class Id, class Predecessors, class Successors>
std::vector<Id> depth_first_order(int count, Predecessors predecessors, Successors successors) {
  using detail::place_in_order;
  std::vector<Id> order, ready;
  order.reserve(place_in_order(count));
  std::vector<std::size_t> waiting_for(place_in_order(count));
  for (int i = count; i-- > 0;) {
    waiting_for[place_in_order(i)] = predecessors(Id{i}).size();
    if (waiting_for[place_in_order(i)] == 0) ready.push_back(Id{i});
  }
  while (!ready.empty()) {
    order.push_back(ready.back());
    ready.pop_back();
    const auto next = successors(order.back());
    for (auto successor = next.rbegin(); successor != next.rend(); ++successor) {
      if (--waiting_for[place_in_order(*successor)] == 0) ready.push_back(*successor);
    }
  }
  return order;
}

}  // namespace spoke::graph
