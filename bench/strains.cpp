// What do strains of second order cost? Whole steps of rotors, on which beams may have linear ones,
// serial: with linear strains as the models are, in four bodies of four elements a blade (the
// drone: three); with nonlinear ones as they are, and in one body of eight elements, which is as
// accurate (docs/formulation.md, section 16); all in turns. What one body is to a blade with
// hinges, it is to each of its parts. The ratio of evaluations says what of that is one of passes.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr int kSteps = 200;
constexpr double kMostCost = 1.3;

struct StrainModel {
  const char* name;
  double begin;  ///< time from which steps are taken [s]
};
constexpr StrainModel kModels[] = {{"nrel_5mw_rotor", 2.0},
                                   {"articulated_rotor", 2.0},
                                   {"spatial_wu_haug", 8.0},
                                   {"drone_rotor", 0.3}};

struct StrainWay {
  const char* name;
  spatial::BeamStrain strain;
  bool is_one_body;
};
constexpr StrainWay kWays[] = {{"linear", spatial::BeamStrain::linear, false},
                               {"nonlinear", spatial::BeamStrain::nonlinear, false},
                               {"nonlinear, one body", spatial::BeamStrain::nonlinear, true}};

std::shared_ptr<RepeatedSteps> make_steps(const StrainModel& model, const StrainWay& way) {
  show_progress(std::string(model.name) + ", " + way.name + ": building");
  Scenario scenario =
      read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / (std::string(model.name) + ".toml"));
  scenario.sensors.clear();
  for (spatial::Blade& blade : scenario.space->blades) {
    blade.beam.strain = way.strain;
    if (!way.is_one_body) continue;
    blade.beam.bodies = 1;
    blade.beam.elements = 8;
  }
  return std::make_shared<RepeatedSteps>(
      scenario, SimulationOptions{Formulation::structured, ExecutorKind::serial, 1}, model.begin,
      kSteps);
}

}  // namespace

void measure_strains(const QuestionOptions& options, Report& report) {
  Table table{"Strains of second order beside linear ones, whole steps on one thread; in turns",
              {"model, strains", "evaluations", "a step", "/ linear", "rounds"},
              {}};
  for (const StrainModel& model : kModels) {
    std::vector<std::shared_ptr<RepeatedSteps>> steps;
    std::vector<Alternative> alternatives;
    for (const StrainWay& way : kWays) {
      steps.push_back(make_steps(model, way));
      alternatives.push_back(
          RepeatedSteps::alternative(std::string(model.name) + ", " + way.name, steps.back(), 0));
    }
    const std::vector<Timing> timings =
        measure(alternatives, options.quick ? Effort{3, 0.0, 1.0} : Effort{31, 0.0, 10.0});
    for (std::size_t k = 0; k < timings.size(); ++k) {
      table.rows.push_back({timings[k].name, figure(steps[k]->evaluations_per_step()),
                            graph::duration_text(timings[k].least),
                            k == 0 ? "" : ratio_with_spread(timings[k]),
                            std::to_string(timings[k].rounds)});
      report.add_timing(model.name, timings[k]);
    }
    report.add_target(at_most(
        std::string(model.name) + ": nonlinear strains in one body / linear ones, a step, times",
        timings.back().ratio, kMostCost));
  }
  report.add_table(table);
}

}  // namespace spoke::bench
