#pragma once

// The depth-first order of a graph.

#include <cstddef>
#include <vector>

#include "graph/structure/index_of.h"

namespace spoke::graph {

/// Returns the `count` nodes of any graph, each after its predecessors, depth first: the one made
/// ready last comes next; among those made ready together, the first in the list of successors, or,
/// of those without predecessors, the lowest. For an `Id` (an int or a NodeId), `predecessors` and
/// `successors` give the list of its neighbours.
template <class Id, class Predecessors, class Successors>
std::vector<Id> depth_first_order(int count, Predecessors predecessors, Successors successors) {
  std::vector<Id> order, ready;
  order.reserve(index_of(count));
  std::vector<std::size_t> waiting_for(index_of(count));
  for (int i = count; i-- > 0;) {
    waiting_for[index_of(i)] = predecessors(Id{i}).size();
    if (waiting_for[index_of(i)] == 0) ready.push_back(Id{i});
  }
  while (!ready.empty()) {
    order.push_back(ready.back());
    ready.pop_back();
    const auto next = successors(order.back());
    for (auto successor = next.rbegin(); successor != next.rend(); ++successor) {
      if (--waiting_for[index_of(*successor)] == 0) ready.push_back(*successor);
    }
  }
  return order;
}

}  // namespace spoke::graph
