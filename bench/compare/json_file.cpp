// The fields of compare.json.

#include <spdlog/fmt/fmt.h>

#include "bench/compare/conclusion.h"
#include "bench/compare/files.h"
#include "engine/support/machine_json.h"
#include "models/reader/scenario_json.h"

namespace spoke::compare {
namespace {

Json describe_model(const Model& model) {
  return {{"formulation", name_of(model.formulation)},
          {"subsystems", model.size.subsystems},
          {"bodies", model.size.bodies},
          {"coordinates", model.size.coordinates},
          {"graph_nodes", model.size.graph_nodes},
          {"graph_edges", model.size.graph_edges},
          {"memory_bytes", model.size.memory_bytes},
          {"steps_per_sample", model.batch},
          {"pass_work_s", model.pass.work},
          {"pass_span_s", model.pass.span},
          {"serial_step_s", model.serial_step},
          {"span_step_s", model.span_step}};
}

Json describe_figures(const std::optional<Figures>& figures) {
  if (!figures) return nullptr;
  return {{"mean_s", figures->mean},
          {"standard_deviation_s", figures->deviation ? Json(*figures->deviation) : Json()},
          {"median_s", figures->median},
          {"speedup", figures->speedup},
          {"speedup_quartiles", Json::array({figures->speedup_low, figures->speedup_high})},
          {"bound_s", figures->bound},
          {"ratio_to_bound", figures->ratio_to_bound},
          {"bound_at_capacity_s",
           figures->bound_at_capacity ? Json(*figures->bound_at_capacity) : Json()}};
}

Json describe_result(const Result& result) {
  const Measurement& measurement = result.measurement;
  const Configuration& configuration = measurement.configuration;
  Json hashes = Json::array();
  for (const std::uint64_t hash : measurement.hashes)
    hashes.push_back(fmt::format("0x{:016x}", hash));
  Json json = {{"name", name_of(configuration)},
               {"formulation", name_of(configuration.formulation)},
               {"executor", name_of(configuration.executor)},
               {"threads", configuration.threads.total()},
               {"outer_threads", configuration.threads.outer},
               {"inner_threads", configuration.threads.inner},
               {"wait", name_of(configuration.wait)},
               {"spin", name_of(configuration.spin)},
               {"bind", configuration.bind},
               {"oversubscribed", result.oversubscribed},
               {"status", name_of(measurement.status)}};
  if (!measurement.message.empty()) json.set("message", measurement.message);
  json.update({{"rounds", measurement.step_times.size()},
               {"hash_equal", result.hash_equal},
               {"figures", describe_figures(result.figures)},
               {"step_times_s", measurement.step_times},
               {"speedups", result.speedups},
               {"state_hashes", hashes}});
  return json;
}

}  // namespace

std::string make_json(const Comparison& comparison) {
  Json models = Json::array();
  for (const Model& model : comparison.models) models.push_back(describe_model(model));
  Json results = Json::array();
  for (const Result& result : comparison.results) results.push_back(describe_result(result));
  const Json json = {{"version", SPOKE_VERSION},
                     {"kind", "compare"},
                     {"conclusion", make_conclusion(comparison)},
                     {"scenario", scenario_to_json(comparison.scenario)},
                     {"machine", describe_machine(comparison.machine)},
                     {"load_average",
                      {{"before", load_or_null(comparison.loads.before)},
                       {"after", load_or_null(comparison.loads.after)}}},
                     {"capacity", describe(comparison.capacity)},
                     {"integrator", name_of(comparison.scenario.integration.method)},
                     {"step_size_s", comparison.step_size},
                     {"rounds", comparison.rounds},
                     {"warm_up_batches", kWarmUpBatches},
                     {"models", models},
                     {"configurations", results}};
  return json.dump_lines();
}

}  // namespace spoke::compare
