// Computes and measures each part of the paper's evaluation, and writes page and numbers.

#include "bench/programs/reproduce_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "bench/compare/probe.h"
#include "bench/programs/measure_child.h"
#include "bench/reproduce/files.h"
#include "bench/reproduce/inverse_part.h"
#include "bench/reproduce/tables.h"
#include "engine/results.h"
#include "models/paper_rotor.h"
#include "program/cli/interruption.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using reproduce::Reproduction;
using reproduce::Work;

constexpr double kExplicitStep = 8e-5;  // s; rk4 is stable up to 8.2e-5 s

/// Effort of the measurements.
struct Effort {
  int rounds;
  double sample_seconds;  ///< duration of a serial batch
  double most_seconds;    ///< limit per configuration
};
constexpr Effort kFull{15, 0.03, 3.0};
constexpr Effort kQuick{3, 0.008, 0.25};

void simulate(Reproduction& all) {
  constexpr double kFineStep = 0.002, kFinestStep = 0.005;  // s; errors below 1e-5 m
  constexpr int kDrivePoints = 400;
  const double duration = all.scenario.integration.duration;
  all.drive = reproduce::sample_drive(all.scenario.rotor.hub.drive, duration, kDrivePoints);
  const std::string stiffening = "blade.geometric_stiffening=true";
  const auto deflection = [](const char* name, const Overrides& overrides, double step) {
    show_progress(std::string("simulating: ") + name);
    return reproduce::simulate_deflection(name, paper_rotor(overrides), step);
  };
  all.paper = deflection("4x4 without stiffening (the paper)", {}, kFineStep);
  all.stiffened = deflection("4x4 with stiffening", {stiffening}, kFineStep);
  all.finest =
      deflection("finest: 16x4 with stiffening, chord frame",
                 {stiffening, "blade.bodies=16", "blade.reference_frame=chord"}, kFinestStep);
  all.implicit.lag = deflection("implicit, long step", {}, all.implicit.step).lag;
  all.implicit.error = std::abs(all.implicit.lag / all.paper.lag - 1.0);
}

/// Returns the number of steps in a batch of each formulation, such that the simulation has enough
/// for all rounds.
compare::BatchSize probe_batches(const Reproduction& all, const Effort& effort) {
  std::map<Formulation, std::int64_t> batches;
  const auto steps =
      std::llround(all.scenario.integration.duration / all.scenario.integration.step);
  constexpr std::int64_t kUnit = 1000;  // a batch for which the steps of all rounds are counted
  const std::int64_t most = kUnit * steps / compare::steps_of(kUnit, effort.rounds);
  for (const Formulation formulation :
       {Formulation::augmented, Formulation::subsystem, Formulation::structured}) {
    show_progress("probing: " + std::string(name_of(formulation)));
    const auto batch = compare::probe(all.scenario, formulation, effort.sample_seconds).batch;
    batches[formulation] = std::min(batch, most);
  }
  return [batches](Formulation formulation) { return batches.at(formulation); };
}

void measure(Work work, const Integration& integration, const compare::BatchSize& batch_size,
             const Effort& effort, Reproduction& all) {
  const ChildTask task{
      .scenario = "", .text = "", .overrides = {}, .integration = integration, .work = work};
  all.timings.set(
      work,
      compare::measure(
          configurations_of(work),
          [&](const compare::Configuration& configuration) {
            return make_child_command(task, configuration);
          },
          batch_size,
          {.rounds = effort.rounds, .most_seconds = effort.most_seconds, .shrinks_batches = true},
          show_progress));
}

void measure_all(const Effort& effort, Reproduction& all) {
  const Integration& integration = all.scenario.integration;
  const compare::BatchSize batches = probe_batches(all, effort);
  show_progress("timing the nodes of a step");
  all.inverse_share = reproduce::measure_inverse_share(all.scenario, Formulation::subsystem);
  measure(Work::steps, integration, batches, effort, all);
  measure(Work::inverse, integration, batches, effort, all);
  Integration implicit = paper_rotor().integration;
  implicit.step = all.implicit.step;
  const std::int64_t steps = std::llround(implicit.duration / implicit.step);
  measure(
      Work::run, implicit, [steps](Formulation) { return steps; }, effort, all);
}

}  // namespace

int reproduce(const Arguments& arguments, const ReproduceArguments& own) {
  const fs::path folder =
      arguments.out.empty() ? fs::path("results") / "reproduce" : fs::path(arguments.out);
  require_folder(folder, {"reproduce.json", "reproduce.html"});
  const ResultsFolder taken(folder);
  const Effort& effort = own.quick ? kQuick : kFull;
  Reproduction all{.scenario = paper_rotor(), .is_quick = own.quick};
  all.scenario.integration.method = IntegrationMethod::rk4;
  all.scenario.integration.step = kExplicitStep;
  all.rounds = effort.rounds;
  all.machine = this_machine();
  all.loads.before = load_average();
  simulate(all);
  measure_all(effort, all);
  all.loads.after = load_average();
  write_together([&] {
    write_file(folder / "reproduce.json", reproduce::make_json(all));
    write_file(folder / "reproduce.html", reproduce::make_html(all));
  });
  print_title(all.scenario.title);
  print_table(reproduce::method_table(all));
  print("\n");
  if (reproduce::is_disturbed(all)) print_line("note", reproduce::kDisturbed);
  print_line("written", (folder / "reproduce.html").string() + ", reproduce.json");
  return 0;
}

}  // namespace spoke::cli
