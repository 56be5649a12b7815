// Writes the fields of docs/trace.md, slices as columns.

#include "program/trace/page_data.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "engine/support/machine_json.h"
#include "models/support/json.h"

namespace spoke::trace {
namespace {

Json describe_settings(const Trace& trace) {
  return {{"executor", name_of(trace.options.executor)},
          {"description", trace.steps.executor},
          {"threads", trace.threads},
          {"formulation", name_of(trace.options.formulation)},
          {"integrator", name_of(trace.integrator)},
          {"step_s", trace.step_size},
          {"window_steps", trace.steps.window_steps}};
}

Json describe_machine(const Trace& trace) {
  return {{"processor", trace.machine.cpu},       {"cores", trace.machine.cores},
          {"memory_bytes", trace.machine.memory}, {"os", trace.machine.os},
          {"compiler", trace.machine.compiler},   {"load", load_or_null(trace.load)},
          {"capacity", describe(trace.capacity)}};
}

Json describe_edges(const std::vector<NodeEdge>& edges) {
  std::vector<int> from, to;
  for (const NodeEdge& edge : edges) {
    from.push_back(edge.from);
    to.push_back(edge.to);
  }
  return {{"from", from}, {"to", to}};
}

/// Finds the stages in the order of the algorithm.
std::vector<std::string> find_stages(const TracedGraph& graph) {
  std::vector<std::string> stages;
  for (const graph::NodeLabel& label : graph.labels)
    if (std::find(stages.begin(), stages.end(), label.stage) == stages.end())
      stages.push_back(label.stage);
  return stages;
}

Json describe_graph(const TracedGraph& graph, const std::vector<std::string>& stages) {
  std::vector<int> stage, subsystem, body;
  for (const graph::NodeLabel& label : graph.labels) {
    const auto found = std::find(stages.begin(), stages.end(), label.stage);
    stage.push_back(static_cast<int>(found - stages.begin()));
    subsystem.push_back(label.subsystem);
    body.push_back(label.body);
  }
  return {{"stage", stage},
          {"subsystem", subsystem},
          {"body", body},
          {"name", graph.names},
          {"edges", describe_edges(graph.edges)},
          {"next_pass_edges", describe_edges(graph.next_pass_edges)}};
}

Json describe_steps(const StepTrace& trace) {
  Json steps = Json::array();
  for (const TracedStep& step : trace.steps)
    steps.push_back({{"step", step.step}, {"time_s", step.time}, {"passes", step.passes}});
  return steps;
}

Json describe_more_threads(const std::optional<MoreThreads>& more) {
  if (!more) return nullptr;
  Json rows = Json::array();
  for (const StepOnThreads& row : more->rows)
    rows.push_back({{"threads", row.threads},
                    {"scheduled_s", row.scheduled},
                    {"scheduled_speedup", more->work / row.scheduled},
                    {"auto_s", row.by_auto},
                    {"auto_speedup", more->work / row.by_auto},
                    {"auto_clusters", row.clusters}});
  return {{"window_steps", more->window_steps},
          {"passes_per_run", more->passes},
          {"work_s", more->work},
          {"span_s", more->span},
          {"bound", more->bound()},
          {"predictions", rows}};
}

/// Adds a column, without the comma behind it.
template <class Append>
void add_column(fmt::memory_buffer& text, std::string_view name,
                const std::vector<NodeSlice>& slices, Append append) {
  fmt::format_to(std::back_inserter(text), "\"{}\":[", name);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    if (k > 0) text.push_back(',');
    append(slices[k]);
  }
  text.push_back(']');
}

void add_slices(fmt::memory_buffer& text, const std::vector<NodeSlice>& slices) {
  const auto add_whole = [&](std::string_view name, auto member) {
    add_column(text, name, slices, [&](const NodeSlice& slice) {
      fmt::format_to(std::back_inserter(text), "{}", slice.*member);
    });
    text.push_back(',');
  };
  const auto add_us = [&](std::int64_t ns) {
    fmt::format_to(std::back_inserter(text), "{}.{:03}", ns / 1000, ns % 1000);
  };
  text.push_back('{');
  add_whole("node", &NodeSlice::node);
  add_whole("step", &NodeSlice::step);
  add_whole("pass", &NodeSlice::pass);
  add_whole("cluster", &NodeSlice::cluster);
  add_whole("thread", &NodeSlice::thread);
  add_column(text, "begin_us", slices, [&](const NodeSlice& slice) { add_us(slice.begin); });
  text.push_back(',');
  add_column(text, "duration_us", slices,
             [&](const NodeSlice& slice) { add_us(slice.end - slice.begin); });
  text.push_back('}');
}

}  // namespace

std::string make_description(const Trace& trace) {
  const std::vector<std::string> stages = find_stages(trace.steps.graph);
  std::vector<std::string> threads;
  for (int k = 0; k < trace.steps.threads; ++k) threads.push_back(name_of_thread(k));
  const Json json{{"format", "spoke-trace"},
                  {"version", 1},
                  {"program", "Spoke " SPOKE_VERSION},
                  {"created", trace.created},
                  {"scenario", trace.scenario},
                  {"title", trace.title},
                  {"settings", describe_settings(trace)},
                  {"notes", trace.notes},
                  {"machine", describe_machine(trace)},
                  {"subsystem_word", trace.steps.graph.subsystem_word},
                  {"subsystems", trace.steps.graph.subsystems},
                  {"stages", stages},
                  {"graph", describe_graph(trace.steps.graph, stages)},
                  {"threads", threads},
                  {"steps", describe_steps(trace.steps)},
                  {"dropped_steps", trace.steps.dropped_steps},
                  {"recording_cost_s", trace.steps.recording_cost},
                  {"more_threads", describe_more_threads(trace.more_threads)}};
  return json.dump();
}

std::string make_page_data(const Trace& trace) {
  std::string description = make_description(trace);
  description.pop_back();  // without the closing brace
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{},\"slices\":", description);
  add_slices(text, trace.steps.slices);
  text.push_back('}');
  return fmt::to_string(text);
}

std::string make_trace_page(std::string_view page, std::string_view json) {
  constexpr std::string_view begin = "<script type=\"application/json\" id=\"spoke-trace\">";
  constexpr std::string_view nothing = "null";
  const std::size_t place = page.find(begin);
  const std::size_t data = place + begin.size();
  if (place == std::string_view::npos || page.substr(data, nothing.size()) != nothing ||
      page.find(begin, data) != std::string_view::npos)
    throw std::invalid_argument("the page has no single place for the data of a trace");
  std::string text(page.substr(0, data));
  text.reserve(page.size() + json.size());
  for (const char c : json) {
    // In JSON this stands within texts only; in the page it could end or begin an element.
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text.append(page.substr(data + nothing.size()));
}

}  // namespace spoke::trace
