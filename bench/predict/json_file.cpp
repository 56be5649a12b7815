// The fields of predict.json.

#include <spdlog/fmt/fmt.h>

#include "bench/predict/conclusion.h"
#include "bench/predict/files.h"
#include "engine/support/machine_json.h"
#include "models/reader/scenario_json.h"

namespace spoke::predict {
namespace {

Json describe(const Quartiles& quartiles) {
  return Json::array({quartiles.low, quartiles.median, quartiles.high});
}

/// Returns the costs of the runtimes; a schedule's missing ones are 0.
Json describe_runtime(const graph::RuntimeCosts& runtime) {
  return {{"flow_graph_per_node_s", runtime.flow_graph.per_node},
          {"flow_graph_per_cluster_s", runtime.flow_graph.per_cluster},
          {"flow_graph_contention_s", 0.0},
          {"flow_graph_counting_s", 0.0},
          {"flow_graph_keeping_s", 0.0},
          {"flow_graph_among_many_s", 0.0},
          {"flow_graph_handover_s", runtime.flow_graph.handover},
          {"flow_graph_run_s", 0.0},
          {"flow_graph_run_among_threads_s", 0.0},
          {"openmp_barrier_s", runtime.barrier > 0.0 ? Json(runtime.barrier) : Json()},
          {"openmp_barrier_alone_s", runtime.barrier > 0.0 ? Json(runtime.barrier_alone) : Json()},
          {"transfer_s", 0.0},
          {"transfer_s_per_byte", 0.0}};
}

Json describe_model(const Prediction& prediction) {
  return {{"formulation", name_of(prediction.formulation)},
          {"integrator", name_of(prediction.scenario.integration.method)},
          {"step_size_s", prediction.step_size},
          {"window_steps", prediction.run.window},
          {"subsystems", prediction.size.subsystems},
          {"bodies", prediction.size.bodies},
          {"coordinates", prediction.size.coordinates},
          {"run_nodes", prediction.run.node_count},
          {"run_edges", prediction.run.edge_count},
          {"memory_bytes", prediction.size.memory_bytes}};
}

Json describe_nodes(const Nodes& nodes) {
  return {{"steps", nodes.steps},
          {"runs_per_step", nodes.serial.runs_per_step},
          {"between_runs_s", nodes.serial.between_runs},
          {"spread", Json::array({nodes.spread.low, nodes.spread.high})},
          {"costs_s", nodes.serial.costs},
          {"level_costs_s", nullptr}};
}

Json describe_window(const RunGraph& run) {
  return {{"window_steps", run.window},
          {"run_nodes", run.node_count},
          {"run_edges", run.edge_count},
          {"nodes", describe_nodes(run.nodes)},
          {"work_s", run.work},
          {"span_s", run.span},
          {"parallelism", run.parallelism()}};
}

Json describe_point(const Prediction& prediction, ExecutorKind executor, const Point& point) {
  Json json{
      {"executor", graph::name_of(executor)},    {"threads", point.threads},
      {"predicted_s", point.step.expected},      {"optimistic_s", point.step.optimistic},
      {"pessimistic_s", point.step.pessimistic}, {"predicted_speedup", prediction.speedup(point)},
      {"clusters", point.step.clusters},         {"window_steps", point.window},
      {"bound_at_capacity_s", nullptr},          {"measured", nullptr}};
  if (const auto bound = bound_at_capacity(prediction, executor, point))
    json.set("bound_at_capacity_s", *bound);
  if (point.measured)
    json.set("measured", {{"step_quartiles_s", describe(point.measured->step)},
                          {"speedup_quartiles", describe(point.measured->speedup)},
                          {"error", *point.error()}});
  return json;
}

Json list_ranks(const Prediction& prediction) {
  if (prediction.ranks.empty()) return nullptr;
  Json points = Json::array();
  for (const RankPoint& point : prediction.ranks)
    points.push_back({{"ranks", point.ranks},
                      {"predicted_s", point.step()},
                      {"network_s", point.telling},
                      {"predicted_speedup", prediction.speedup(point)}});
  return {{"latency_s", prediction.network.latency},
          {"is_measured", prediction.network.is_measured},
          {"points", points}};
}

Json list_left_out() {
  Json names = Json::array();
  for (const ExecutorKind kind : left_out_executors()) names.push_back(graph::name_of(kind));
  return names;
}

}  // namespace

std::string make_json(const Prediction& prediction) {
  Json points = Json::array();
  points.push_back(describe_point(prediction, ExecutorKind::serial, prediction.serial));
  for (const Series& series : prediction.series)
    for (const Point& point : series.points)
      points.push_back(describe_point(prediction, series.executor, point));
  const Json json{
      {"version", SPOKE_VERSION},
      {"kind", "predict"},
      {"conclusion", make_conclusion(prediction)},
      {"scenario", scenario_to_json(prediction.scenario)},
      {"machine", describe_machine(prediction.machine)},
      {"load_average",
       {{"before", load_or_null(prediction.load_before)},
        {"after", load_or_null(prediction.load_after)}}},
      {"capacity", spoke::describe(prediction.capacity)},
      {"model", describe_model(prediction)},
      {"runtime_costs", describe_runtime(prediction.runtime)},
      {"nodes", describe_nodes(prediction.run.nodes)},
      {"work_s", prediction.run.work},
      {"span_s", prediction.run.span},
      {"parallelism", prediction.run.parallelism()},
      {"auto_window", prediction.auto_run ? describe_window(*prediction.auto_run) : Json(nullptr)},
      {"not_predicted", list_left_out()},
      {"rounds", prediction.rounds},
      {"points", points},
      {"processes", list_ranks(prediction)}};
  return json.dump_lines();
}

}  // namespace spoke::predict
