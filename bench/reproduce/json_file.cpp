// The fields of reproduce.json.

#include "bench/reproduce/claims.h"
#include "bench/reproduce/files.h"
#include "bench/reproduce/paper.h"
#include "bench/reproduce/tables.h"
#include "engine/support/machine_json.h"
#include "models/reader/scenario_json.h"

namespace spoke::reproduce {
namespace {

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json describe(const Operations& operations) {
  return {{"multiplications", operations.multiplications},
          {"additions", operations.additions},
          {"others", operations.others},
          {"total", operations.total()}};
}

Json describe(const std::vector<Claim>& claims) {
  Json list = Json::array();
  for (const Claim& claim : claims) {
    const auto& ratio = claim.measured;
    list.push_back({{"what", claim.what},
                    {"paper", or_null(claim.paper)},
                    {"here", or_null(claim.here)},
                    {"quartiles", ratio ? Json::array({ratio->low, ratio->high}) : Json()},
                    {"holds_if", text_of(claim.condition)},
                    {"holds", or_null(claim.holds)}});
  }
  return list;
}

Json describe_counts() {
  Json printed = Json::array();
  for (const paper::Count& count : paper::table_2())
    printed.push_back({{"part", name_of(count.stage)},
                       {"formula", count.formula},
                       {"evaluated", count.value},
                       {"printed", count.printed}});
  Json here = Json::object();
  for (const Formulation formulation :
       {Formulation::augmented, Formulation::subsystem, Formulation::structured}) {
    Json parts = Json::object();
    for (const Stage stage : kStages)
      parts.set(name_of(stage), describe(count(formulation, stage)));
    parts.set("total", describe(count(formulation)));
    here.set(name_of(formulation), parts);
  }
  const paper::InverseSizes sizes = paper::inverse_sizes();
  return {{"claims", describe(claims_on_counts())},
          {"paper", printed},
          {"paper_total", paper::kTable2Total},
          {"inverse_by_n3_3",
           {{"as_printed_180", sizes.printed},
            {"whole_blade_60", sizes.blade},
            {"blocks_15", sizes.blocks}}},
          {"here", here}};
}

Json describe_drive(const Reproduction& all) {
  std::vector<double> t, angle, speed, acceleration;
  for (const DrivePoint& point : all.drive) {
    t.push_back(point.t);
    angle.push_back(point.motion.angle);
    speed.push_back(point.motion.speed);
    acceleration.push_back(point.motion.acceleration);
  }
  return {{"claims", describe(claims_on_drive(all))},
          {"t_s", t},
          {"angle_rad", angle},
          {"speed_rad_s", speed},
          {"acceleration_rad_s2", acceleration}};
}

Json describe_points(const std::vector<Deflection::Point>& points) {
  std::vector<double> t, y;
  for (const Deflection::Point& point : points) {
    t.push_back(point.t);
    y.push_back(point.y);
  }
  return {{"t_s", t}, {"tip_y_m", y}};
}

Json describe_deflections(const Reproduction& all) {
  Json models = Json::array();
  for (const Deflection* deflection : {&all.paper, &all.stiffened, &all.finest}) {
    Json model = {{"name", deflection->name},
                  {"largest_lag_m", deflection->lag},
                  {"at_s", deflection->lag_time},
                  {"largest_after_ramp_m", deflection->residual}};
    model.update(describe_points(deflection->points));
    models.push_back(model);
  }
  Json exact = {{"name", "Euler-Bernoulli beam, independent of Spoke"},
                {"largest_lag_m", exact::kLag},
                {"at_s", exact::kLagTime},
                {"largest_after_ramp_m", exact::kResidual}};
  exact.update(describe_points(exact::points()));
  return {{"models", models}, {"exact", exact}};
}

Json describe(const Reproduction& all, Work work, const compare::Measurement& measurement) {
  const compare::Configuration& configuration = measurement.configuration;
  const auto spread = all.timings.find(work, configuration);
  const auto speedup = all.timings.ratio(work, serial(configuration.formulation), configuration);
  Json json = {{"name", name_of(configuration)},
               {"formulation", name_of(configuration.formulation)},
               {"executor", name_of(configuration.executor)},
               {"outer_threads", configuration.threads.outer},
               {"inner_threads", configuration.threads.inner},
               {"status", name_of(measurement.status)},
               {"rounds", measurement.step_times.size()},
               {"median_s", spread ? Json(spread->median) : Json()},
               {"quartiles_s", spread ? Json::array({spread->low, spread->high}) : Json()},
               {"speedup_over_serial", speedup ? Json(speedup->median) : Json()},
               {"step_times_s", measurement.step_times}};
  if (!measurement.message.empty()) json.set("message", measurement.message);
  return json;
}

Json describe_timings(const Reproduction& all, Work work) {
  Json list = Json::array();
  for (const compare::Measurement& measurement : all.timings.all(work))
    list.push_back(describe(all, work, measurement));
  return list;
}

Json describe_methods(const Reproduction& all) {
  Json methods = Json::array();
  for (const MethodTime& time : method_times(all))
    methods.push_back({{"name", time.name},
                       {"here_as", time.how},
                       {"paper_ms", or_null(time.paper_ms)},
                       {"paper_ratio", or_null(time.paper_ratio)},
                       {"step_s", or_null(time.seconds)},
                       {"ratio", or_null(time.ratio)},
                       {"run_s", or_null(time.run)}});
  return {{"claims", describe(claims_on_methods(all))},
          {"methods", methods},
          {"implicit",
           {{"step_s", all.implicit.step},
            {"largest_lag_m", all.implicit.lag},
            {"error_of_lag", all.implicit.error}}}};
}

}  // namespace

std::string make_json(const Reproduction& all) {
  const Json json = {
      {"version", SPOKE_VERSION},
      {"kind", "reproduce"},
      {"paper", "doi 10.3795/KSME-A.2017.41.6.507"},
      {"paper_machine", paper::kMachine},
      {"quick", all.is_quick},
      {"machine", describe_machine(all.machine)},
      {"openmp", has_schemes()},
      {"load_average",
       {{"before", load_or_null(all.loads.before)}, {"after", load_or_null(all.loads.after)}}},
      {"rounds", all.rounds},
      {"warm_up_batches", compare::kWarmUpBatches},
      {"scenario", scenario_to_json(all.scenario)},
      {"table_2", describe_counts()},
      {"fig_8", describe_drive(all)},
      {"fig_9", describe_deflections(all)},
      {"fig_10", {{"claims", describe(claims_on_subsystem_threads(all))}}},
      {"fig_11", {{"claims", describe(claims_on_layers(all))}}},
      {"fig_12",
       {{"claims", describe(claims_on_inverse(all))}, {"inverse_share_serial", all.inverse_share}}},
      {"table_3", describe_methods(all)},
      {"timings",
       {{"steps", describe_timings(all, Work::steps)},
        {"inverse", describe_timings(all, Work::inverse)},
        {"implicit_run", describe_timings(all, Work::run)}}}};
  return json.dump_lines();
}

}  // namespace spoke::reproduce
