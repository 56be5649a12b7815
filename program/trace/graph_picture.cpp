// Groups nodes into boxes where there are many, and writes boxes and edges for Graphviz.

#include "program/trace/graph_picture.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "graph/machine/duration_text.h"
#include "graph/structure/index_of.h"
#include "models/count_text.h"
#include "program/trace/statistics.h"

namespace spoke::trace {
namespace {

using graph::index_of;

constexpr int kMostNodes = 1000;

/// ColorBrewer's "Blues", light to dark: told apart by lightness, so by any eye.
constexpr std::array kShades{"#f7fbff", "#deebf7", "#c6dbef", "#9ecae1", "#6baed6",
                             "#4292c6", "#2171b5", "#08519c", "#08306b"};
constexpr std::size_t kFirstDark = 5;  // shade from which on letters are white
/// Okabe and Ito's vermilion, against the blues.
constexpr const char* kCritical = "#d55e00";

/// A box of the picture, which stands for one node or several.
struct Box {
  std::string label;
  double cost = 0.0;   ///< mean time of all its nodes in a pass [s]
  double share = 0.0;  ///< fraction of the time of all nodes
  int nodes = 0;
};

/// The boxes, and the box of each node.
struct Boxes {
  std::vector<Box> all;
  std::vector<int> of_node;
  std::string unit;  ///< name of the unit that a box is
};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// Puts together the nodes of equal keys, in the order in which keys appear.
template <class KeyOf>
Boxes group(const TracedGraph& graph, std::string unit, KeyOf key_of) {
  Boxes boxes;
  boxes.unit = std::move(unit);
  std::map<decltype(key_of(0)), int> numbers;
  for (int node = 0; node < graph.node_count(); ++node) {
    const auto [place, is_new] =
        numbers.try_emplace(key_of(node), static_cast<int>(boxes.all.size()));
    if (is_new) boxes.all.emplace_back();
    boxes.of_node.push_back(place->second);
  }
  return boxes;
}

Boxes boxes_of_nodes(const TracedGraph& graph) {
  Boxes boxes = group(graph, "node", [](int node) { return node; });
  for (int node = 0; node < graph.node_count(); ++node) {
    const graph::NodeLabel& label = graph.labels[index_of(node)];
    const std::string& name = graph.names[index_of(node)];
    std::string& text = boxes.all[index_of(node)].label;
    text = name;
    if (label.subsystem < 0) continue;
    constexpr std::string_view between = " / ";
    text.replace(graph.name_of_subsystem(label.subsystem).size(), between.size(), "\n");
  }
  return boxes;
}

/// Returns by node the cluster in which it ran in the first pass of the middle step; -1: in none.
std::vector<int> clusters_of_nodes(const StepTrace& trace) {
  std::vector<int> clusters(trace.graph.labels.size(), -1);
  for (const NodeSlice& slice : trace.slices_of(middle_step(trace).step))
    if (slice.pass == 0) clusters[index_of(slice.node)] = slice.cluster;
  return clusters;
}

Boxes boxes_of_clusters(const StepTrace& trace) {
  const std::vector<int> clusters = clusters_of_nodes(trace);
  Boxes boxes = group(trace.graph, "cluster", [&](int node) {
    // A node that did not run in that pass stays alone.
    return clusters[index_of(node)] >= 0 ? std::pair(0, clusters[index_of(node)])
                                         : std::pair(1, node);
  });
  std::vector<std::set<std::string>> stages(boxes.all.size());
  for (int node = 0; node < trace.graph.node_count(); ++node) {
    const int box = boxes.of_node[index_of(node)];
    boxes.all[index_of(box)].label = fmt::format("cluster {}", clusters[index_of(node)]);
    stages[index_of(box)].insert(trace.graph.labels[index_of(node)].stage);
  }
  constexpr std::size_t most_stages = 3;
  for (std::size_t box = 0; box < boxes.all.size(); ++box) {
    if (stages[box].size() > most_stages) continue;
    std::string list;
    for (const std::string& stage : stages[box]) list += (list.empty() ? "\n" : ", ") + stage;
    boxes.all[box].label += list;
  }
  return boxes;
}

Boxes boxes_of_stages(const TracedGraph& graph, bool by_subsystem) {
  Boxes boxes =
      group(graph, by_subsystem ? graph.subsystem_word + " and stage" : "stage", [&](int node) {
        const graph::NodeLabel& label = graph.labels[index_of(node)];
        return std::pair(by_subsystem ? label.subsystem : -1, label.stage);
      });
  for (int node = 0; node < graph.node_count(); ++node) {
    const graph::NodeLabel& label = graph.labels[index_of(node)];
    std::string& text = boxes.all[index_of(boxes.of_node[index_of(node)])].label;
    text = by_subsystem && label.subsystem >= 0
               ? graph.name_of_subsystem(label.subsystem) + "\n" + label.stage
               : label.stage;
  }
  return boxes;
}

Boxes make_boxes(const StepTrace& trace) {
  const auto is_small = [](const Boxes& boxes) { return boxes.all.size() <= kMostNodes; };
  if (trace.graph.node_count() <= kMostNodes) return boxes_of_nodes(trace.graph);
  const std::vector<int> clusters = clusters_of_nodes(trace);
  if (std::all_of(clusters.begin(), clusters.end(), [](int cluster) { return cluster >= 0; })) {
    Boxes by_cluster = boxes_of_clusters(trace);
    if (is_small(by_cluster)) return by_cluster;
  }
  Boxes by_stage = boxes_of_stages(trace.graph, true);
  return is_small(by_stage) ? by_stage : boxes_of_stages(trace.graph, false);
}

void add_costs(const StepTrace& trace, Boxes& boxes) {
  const std::vector<double> costs = mean_costs(trace), shares = time_shares(trace);
  for (std::size_t node = 0; node < costs.size(); ++node) {
    Box& box = boxes.all[index_of(boxes.of_node[node])];
    box.cost += costs[node];
    box.share += shares[node];
    ++box.nodes;
  }
}

std::vector<NodeEdge> edges_between(const TracedGraph& graph, const Boxes& boxes) {
  std::set<std::pair<int, int>> pairs;
  for (const NodeEdge& edge : graph.edges) {
    const int from = boxes.of_node[index_of(edge.from)], to = boxes.of_node[index_of(edge.to)];
    if (from != to) pairs.emplace(from, to);
  }
  std::vector<NodeEdge> edges;
  for (const auto& [from, to] : pairs) edges.push_back({from, to});
  return edges;
}

std::string in_dot(std::string text) {
  std::string lines;
  for (const char c : escaped(text)) lines += c == '\n' ? std::string("\\n") : std::string(1, c);
  return lines;
}

void write_box(fmt::memory_buffer& text, std::size_t number, const Box& box, double largest,
               bool is_critical) {
  const double relative = largest > 0.0 ? box.share / largest : 0.0;
  const auto shade = std::min(
      kShades.size() - 1, static_cast<std::size_t>(relative * static_cast<double>(kShades.size())));
  std::string label = box.label;
  if (box.nodes > 1) label += fmt::format("\n{} nodes", box.nodes);
  label += fmt::format("\n{}, {:.2g} %", graph::duration_text(box.cost), 100.0 * box.share);
  fmt::format_to(std::back_inserter(text), "  n{} [label=\"{}\", fillcolor=\"{}\"", number,
                 in_dot(label), kShades[shade]);
  if (shade >= kFirstDark) fmt::format_to(std::back_inserter(text), ", fontcolor=\"white\"");
  if (is_critical)
    fmt::format_to(std::back_inserter(text), ", color=\"{}\", penwidth=3", kCritical);
  fmt::format_to(std::back_inserter(text), "]\n");
}

void write_edges(fmt::memory_buffer& text, const std::vector<NodeEdge>& edges,
                 const std::vector<int>& path) {
  std::set<std::pair<int, int>> critical;
  for (std::size_t k = 1; k < path.size(); ++k) critical.emplace(path[k - 1], path[k]);
  for (const NodeEdge& edge : edges) {
    const bool is_critical = critical.count({edge.from, edge.to}) > 0;
    fmt::format_to(std::back_inserter(text), "  n{} -> n{}{}\n", edge.from, edge.to,
                   is_critical ? fmt::format(" [color=\"{}\", penwidth=3]", kCritical) : "");
  }
}

}  // namespace

std::string make_dot(const Trace& trace) {
  assert(!trace.steps.steps.empty());
  Boxes boxes = make_boxes(trace.steps);
  add_costs(trace.steps, boxes);
  const std::vector<NodeEdge> edges = edges_between(trace.steps.graph, boxes);
  std::vector<double> costs;
  double largest = 0.0;
  for (const Box& box : boxes.all) {
    costs.push_back(box.cost);
    largest = std::max(largest, box.share);
  }
  const std::vector<int> path = longest_path(edges, costs);
  fmt::memory_buffer text;
  fmt::format_to(
      std::back_inserter(text),
      "digraph step {{\n"
      "  label=\"{}\\none pass of a step, a box for each {}; mean of {} on {}\\n"
      "darker: larger share of the time; framed: longest path, {}\"\n"
      "  labelloc=\"t\"; fontname=\"sans-serif\"; bgcolor=\"white\"; rankdir=\"LR\"\n"
      "  node [shape=\"box\", style=\"filled,rounded\", fontname=\"sans-serif\", fontsize=11]\n"
      "  edge [color=\"#555555\"]\n",
      in_dot(trace.title), in_dot(boxes.unit), counted(std::ssize(trace.steps.steps), "step"),
      in_dot(trace.steps.executor), graph::duration_text([&] {
        double sum = 0.0;
        for (const int box : path) sum += costs[index_of(box)];
        return sum;
      }()));
  for (std::size_t box = 0; box < boxes.all.size(); ++box)
    write_box(text, box, boxes.all[box], largest,
              std::find(path.begin(), path.end(), static_cast<int>(box)) != path.end());
  write_edges(text, edges, path);
  fmt::format_to(std::back_inserter(text), "}}\n");
  return fmt::to_string(text);
}

}  // namespace spoke::trace
