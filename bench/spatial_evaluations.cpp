// What does one evaluation of the accelerations cost in space, against the plane? As in
// formulations.cpp, one pass that only evaluates is run by the serial executor, in the state
// reached at 5 s and then disturbed, with the structured formulation. Straight blades are those of
// the planar rotor, with a stiffness in the second plane. Twisted ones are these blades with a
// twist, so that their directions no longer decouple, and those of the wind turbine have sections
// that change by station.

#include <algorithm>
#include <string>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/evaluated_model.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "graph/machine/duration_text.h"
#include "models/support/instructions.h"
#include "models/system/spatial_system.h"

namespace spoke::bench {
namespace {

constexpr RotorSize kSmall{3, 4, 4};
constexpr RotorSize kLarge[] = {{3, 4, 16}, {3, 16, 4}, {3, 4, 64}, {24, 8, 8}};

const std::vector<std::string> kTwist{"blade.sections.station=[0,8]",
                                      "blade.sections.twist=[0.2,0.02]"};

template <class World>
Alternative make_alternative(std::string name, const System<World>& system, int reference) {
  show_progress(name + ": building");
  const ModelPointer<World> model = make_models(system, {Formulation::structured}).front();
  return {std::move(name), [model] { model->evaluate(); }, {}, 1.0, reference};
}

Alternative in_plane(const RotorSize& size, bool stiffening, int reference) {
  return make_alternative(stiffening ? "plane, stiffening" : "plane",
                          make_system(paper_rotor(size, stiffening).rotor), reference);
}

Alternative in_space(const std::string& name, const std::string& file, const RotorSize& size,
                     bool stiffening, int reference,
                     const std::vector<std::string>& assignments = {}) {
  const Scenario scenario = sized_rotor(file, size, stiffening, assignments);
  return make_alternative(name, make_system(*scenario.space), reference);
}

constexpr const char* kStraight = "spatial_wu_haug.toml";

/// Compares a cost in space with the plane's.
void compare_with_plane(const Effort& effort, Report& report) {
  const std::vector<Alternative> alternatives{
      in_plane(kSmall, false, 0),
      in_plane(kSmall, true, 1),
      in_space("straight", kStraight, kSmall, false, 0),
      in_space("straight, stiffening", kStraight, kSmall, true, 1),
      in_space("twisted, stiffening", kStraight, kSmall, true, 1, kTwist),
      in_space("wind turbine, stiffening", "nrel_5mw_rotor.toml", kSmall, true, 1)};
  const std::vector<Timing> timings = measure(alternatives, effort);
  Table table{"One evaluation of a rotor " + kSmall.name() + ", by world and blade; all in turns",
              {"model", "time", "/ plane", "rounds"},
              {}};
  for (const Timing& timing : timings) {
    table.rows.push_back({timing.name, graph::duration_text(timing.least),
                          ratio_with_spread(timing), std::to_string(timing.rounds)});
    report.add_timing(kSmall.name(), timing);
  }
  report.add_table(table);
  const std::string what = ", " + kSmall.name() + ", in space / in the plane, times";
  report.add_target(at_most("straight blades" + what, timings[2].ratio, 4.0));
  report.add_target(at_most("straight blades, stiffening" + what, timings[3].ratio, 4.0));
  report.add_target(at_most("general sections, stiffening" + what,
                            std::max(timings[4].ratio, timings[5].ratio), 10.0));
}

/// Compares kernels for wider vectors with the others, where the processor has them.
void compare_kernels(const Effort& effort, Report& report) {
  const Kernels before = use_kernels(Kernels::avx512);
  const Kernels last = kernels_in_use();
  if (last == Kernels::baseline) return;
  const std::vector<Alternative> models{
      in_plane(kSmall, true, 0), in_space("straight, stiffening", kStraight, kSmall, true, 0),
      in_space("twisted, stiffening", kStraight, kSmall, true, 0, kTwist),
      in_space("wind turbine, stiffening", "nrel_5mw_rotor.toml", kSmall, true, 0)};
  std::vector<Alternative> alternatives;
  for (const Alternative& model : models) {
    const int baseline = static_cast<int>(alternatives.size());
    for (const Kernels kernels : {Kernels::baseline, Kernels::avx2, Kernels::avx512}) {
      if (kernels > last) break;
      Alternative alternative = model;
      alternative.name += ", " + std::string(name_of(kernels));
      alternative.run = [run = model.run, kernels] {
        use_kernels(kernels);
        run();
      };
      alternative.reference = baseline;
      alternatives.push_back(std::move(alternative));
    }
  }
  Table table{"One evaluation of a rotor " + kSmall.name() + ", by instructions; all in turns",
              {"model, kernels", "time", "/ baseline"},
              {}};
  for (const Timing& timing : measure(alternatives, effort)) {
    table.rows.push_back(
        {timing.name, graph::duration_text(timing.least), ratio_with_spread(timing)});
    report.add_timing(kSmall.name() + ", by instructions", timing);
  }
  report.add_table(table);
  use_kernels(before);
}

void scale(const Effort& effort, Report& report) {
  std::vector<RotorSize> sizes{kSmall};
  sizes.insert(sizes.end(), std::begin(kLarge), std::end(kLarge));
  std::vector<Alternative> alternatives;
  for (const RotorSize& size : sizes)
    alternatives.push_back(in_space(size.name(), kStraight, size, false, 0));
  const std::vector<Timing> timings = measure(alternatives, effort);
  Table table{"Straight blades in space; all sizes in turns",
              {"(N,M,E)", "elements", "time", "per element", "/ " + kSmall.name()},
              {}};
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const int elements = sizes[k].total_elements();
    const double ratio = timings[k].ratio * kSmall.total_elements() / elements;
    table.rows.push_back({sizes[k].name(), std::to_string(elements),
                          graph::duration_text(timings[k].least),
                          figure(timings[k].least / elements * 1e9) + " ns", figure(ratio)});
    report.add_timing(sizes[k].name() + ", in space", timings[k]);
    if (k > 0)
      report.add_target(at_most(
          "in space, cost per element, " + sizes[k].name() + " / " + kSmall.name() + ", times",
          ratio, 1.5));
  }
  report.add_table(table);
}

}  // namespace

void measure_spatial_evaluations(const QuestionOptions& options, Report& report) {
  compare_with_plane(options.quick ? Effort{5, 1e-3, 1.0} : Effort{101, 1e-3, 8.0}, report);
  compare_kernels(options.quick ? Effort{5, 1e-3, 1.0} : Effort{51, 1e-3, 8.0}, report);
  scale(options.quick ? Effort{5, 1e-3, 1.0} : Effort{51, 1e-3, 8.0}, report);
}

}  // namespace spoke::bench
