// The page report.html: warnings, tiles, pictures, plots and facts.

#include "program/run_report/html_file.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "engine/support/machine.h"
#include "models/count_text.h"
#include "program/report/markup.h"
#include "program/report/page.h"
#include "program/report/run_script.h"
#include "program/report/scene_markup.h"
#include "program/run_report/energy_residual.h"
#include "program/run_report/row_statistics.h"
#include "program/run_report/sensor_range.h"

namespace spoke::run_report {
namespace {

std::string make_animation_markup() {
  return R"(<div class="animation">
<div class="views">
<figure><figcaption><strong>In the hub's frame</strong></figcaption>
)" + report::scene_canvas("animation", "hub", "The model, seen from its hub") +
         R"(</figure>
<figure><figcaption><strong>In the inertial frame</strong><span id="animation-inertial-note"></span></figcaption>
)" + report::scene_canvas("animation", "inertial", "The moving model") +
         R"(</figure>
</div>
<div id="animation-colors" class="colors" hidden></div>
<div class="controls">
<button type="button" id="animation-play" class="primary">Play</button>
<label class="grow"><span>Time</span><input type="range" id="animation-time" value="0"><output id="animation-now"></output></label>
<label><span>Speed</span><select id="animation-speed"><option value="0.001">0.001 &#215;</option><option value="0.01">0.01 &#215;</option><option value="0.1">0.1 &#215;</option><option value="0.25">0.25 &#215;</option><option value="0.5">0.5 &#215;</option><option value="1" selected>1 &#215;</option><option value="2">2 &#215;</option><option value="5">5 &#215;</option><option value="10">10 &#215;</option></select></label>
<label><span>Deflections</span><input type="range" id="animation-scale" min="0" max="200" value="0"><output id="animation-times"></output></label>
</div>
<div class="controls">
<label><span>Colour</span><select id="animation-color"><option value="tree">by blade or subsystem</option><option value="axial">axial force</option><option value="bending">bending moment</option><option value="displacement">displacement</option><option value="von_mises">von Mises stress</option></select></label>
<label><input type="checkbox" id="animation-outline"> undeformed</label>
<label><input type="checkbox" id="animation-trails"> trails</label>
<label><input type="checkbox" id="animation-joints"> joints</label>
<label><input type="checkbox" id="animation-loads"> loads</label>
<label><input type="checkbox" id="animation-names"> names</label>
)" + report::scene_controls("animation") +
         R"(</div>
</div>
)";
}

/// Returns the markup above the plots; `has_animation`: whether there is one that they can move.
std::string plots_markup(bool has_animation) {
  return fmt::format(R"(<div class="controls">
<span>Shown: <output id="plots-shown"></output></span>
<button type="button" id="plots-reset" disabled>Whole time</button>
<span class="hint" id="plot-keys">Drag to zoom, double-click to reset{}. With the keyboard: arrows move the cursor, + and &#8722; zoom, page keys pan, 0 resets{}.</span>
</div>
<div id="plots" class="plots"></div>
<div id="spoken" class="unseen" role="status" aria-live="polite"></div>
<noscript><p class="note warning">Plots and animation need JavaScript.</p></noscript>
)",
                     has_animation ? ", click to move the animation there" : "",
                     has_animation ? ", Enter moves the animation" : "");
}

std::string number(double value) { return fmt::format("{:.6g}", value); }

/// Returns the value of largest magnitude, and its time.
Sample largest(const SensorRange& range) {
  if (std::abs(range.min) > std::abs(range.max)) return {range.t_min, range.min};
  return {range.t_max, range.max};
}

std::vector<report::Tile> make_tiles(const Simulation& simulation,
                                     const SensorStatistics& statistics, const RunOutcome& outcome,
                                     const TipSummary& tips, const RunStatistics& rows) {
  std::vector<report::Tile> tiles = make_mean_tiles(simulation, rows);
  const bool is_in_space = simulation.scenario().space.has_value();
  if (!tips.when.empty())
    tiles.push_back({is_in_space ? "Largest tip displacement" : "Largest tip deflection",
                     report::quantity(tips.largest, "m", 5), tips.when});
  const auto at = [](const Sample& sample) { return fmt::format("at {} s", number(sample.t)); };
  const Sample speed = largest(range_of(simulation, statistics, "hub.speed"));
  tiles.push_back({"Largest hub speed", report::figure(speed.value, 4) + " rad/s", at(speed)});
  const Sample torque = largest(range_of(simulation, statistics, "hub.torque"));
  tiles.push_back({"Largest torque", report::quantity(torque.value, "N m", 4), at(torque)});
  const EnergyResidual residual = find_energy_residual(simulation, statistics);
  const std::string why = residual.explanation.empty() ? "" : ", " + residual.explanation;
  tiles.push_back({"Largest energy residual", report::quantity(residual.value, "J"),
                   report::figure(residual.share, 2) + " of the largest kinetic energy" + why,
                   residual.is_notable ? report::Tone::warning : report::Tone::plain});
  tiles.push_back(
      {"Computed in", report::figure(outcome.wall_time) + " s",
       report::figure(statistics.last_time() / outcome.wall_time) + " s simulated a second"});
  return tiles;
}

void add_warnings(report::Page& page, const Simulation& simulation,
                  const SensorStatistics& statistics, const RunOutcome& outcome) {
  if (!outcome.divergence.empty()) {
    page.add_notes(
        {outcome.divergence, fmt::format("The page shows what came before, up to {} s of {} s.",
                                         number(statistics.last_time()),
                                         number(simulation.scenario().integration.duration))},
        report::Tone::bad);
  }
  for (const Warning& warning : simulation.warnings())
    page.add_note(warning.text + ".", report::Tone::warning);
}

int count_elements(const Simulation& simulation) {
  int elements = 0;
  for (const Blade& blade : simulation.scenario().rotor.blades)
    elements += blade.bodies * blade.elements;
  return elements;
}

std::string describe_hub(const Scenario& scenario) {
  if (scenario.space && scenario.space->support)
    return scenario.space->support->from == spatial::SupportBase::free
               ? "on a fuselage that is free in space"
               : "on a support";
  if (scenario.space)
    return scenario.space->hub.support == HubSupport::free ? "free in space" : "on an axle";
  return scenario.rotor.hub.support == HubSupport::free ? "free in the plane" : "on an axle";
}

/// Adds closed loops and couplings of joints, if there are any.
report::FactGroup with_loops(const ModelSize& size, report::FactGroup group) {
  if (size.loops + size.couplings == 0) return group;
  if (size.loops > 0) group.facts.push_back({"closed loops", std::to_string(size.loops)});
  if (size.couplings > 0) group.facts.push_back({"couplings", std::to_string(size.couplings)});
  group.facts.push_back({"freedoms", std::to_string(size.freedoms)});
  return group;
}

report::FactGroup spatial_facts(const Simulation& simulation) {
  const ModelSize size = simulation.size();
  return {
      "Model",
      {{"trees", std::to_string(size.subsystems)},
       {"bodies", std::to_string(size.bodies)},
       {"coordinates", std::to_string(size.coordinates)},
       {"joints", std::to_string(size.joints)},
       {"hub", describe_hub(simulation.scenario())},
       {"step graph", counted(size.graph_nodes, "node") + ", " + counted(size.graph_edges, "edge")},
       {"memory of the model", fmt::format("{} kB", (size.memory_bytes + 999) / 1000)}}};
}

report::FactGroup model_facts(const Simulation& simulation) {
  const ModelSize size = simulation.size();
  if (simulation.scenario().space) return with_loops(size, spatial_facts(simulation));
  return with_loops(
      size, {"Model",
             {{"blades", std::to_string(size.subsystems)},
              {"flexible bodies", std::to_string(size.bodies)},
              {"beam elements", std::to_string(count_elements(simulation))},
              {"coordinates", std::to_string(size.coordinates)},
              {"joints", std::to_string(size.joints)},
              {"hub", describe_hub(simulation.scenario())},
              {"step graph",
               counted(size.graph_nodes, "node") + ", " + counted(size.graph_edges, "edge")},
              {"memory of the model", fmt::format("{} kB", (size.memory_bytes + 999) / 1000)}}});
}

/// Describes the iterations of generalized_alpha in a step.
std::string describe_iterations(const Integration& integration) {
  if (integration.iterations > 0) return std::to_string(integration.iterations);
  if (goal_of(integration) == IterationGoal::error) return "to a share of the step's error";
  return "to " + report::figure(integration.tolerance);
}

report::FactGroup setting_facts(const Simulation& simulation) {
  const Integration& integration = simulation.scenario().integration;
  std::vector<report::Fact> facts = {{"integrator", std::string(name_of(integration.method))}};
  if (integration.method == IntegrationMethod::generalized_alpha) {
    facts.emplace_back("spectral radius", report::figure(integration.spectral_radius));
    facts.emplace_back("iterations", describe_iterations(integration));
    const StepAccuracy accuracy = simulation.step_accuracy();
    if (!accuracy.place.empty())
      facts.emplace_back("largest error of a step",
                         fmt::format("{} in {} at {} s", report::figure(accuracy.error),
                                     accuracy.place, number(accuracy.time)));
  }
  facts.insert(facts.end(),
               {{"step", number(simulation.step_size()) + " s"},
                {"steps", std::to_string(simulation.steps())},
                {"evaluations", std::to_string(simulation.evaluations())},
                {"formulation", std::string(name_of(simulation.options().formulation))},
                {"executor", std::string(simulation.executor_name())},
                {"ran as", simulation.executor_description()},
                {"threads", name_of(simulation.threads())},
                {"state hash", fmt::format("{:#018x}", simulation.state_hash())}});
  return {"Settings", std::move(facts)};
}

report::FactGroup machine_facts() {
  const Machine machine = this_machine();
  return {"Machine",
          {{"processor", machine.cpu},
           {"processors available", std::to_string(machine.cores)},
           {"memory", fmt::format("{:.1f} GB", static_cast<double>(machine.memory) / 1e9)},
           {"system", machine.os},
           {"compiler", machine.compiler},
           {"spoke", SPOKE_VERSION}}};
}

report::Table extremes(const Simulation& simulation, const SensorStatistics& statistics) {
  using report::Align;
  report::Table table{"Over all steps, not only those of the plots.",
                      {{"sensor"},
                       {"unit"},
                       {"lowest", Align::number},
                       {"at [s]", Align::number},
                       {"highest", Align::number},
                       {"at [s]", Align::number},
                       {"at the end", Align::number}},
                      {}};
  for (std::size_t i = 0; i < statistics.ranges().size(); ++i) {
    const SensorRange& range = statistics.ranges()[i];
    table.rows.push_back(
        {{simulation.sensor_names()[i], simulation.sensor_units()[i], number(range.min),
          number(range.t_min), number(range.max), number(range.t_max), number(range.final)}});
  }
  return table;
}

std::string describe_data(const Recorder& recorder) {
  const std::size_t rows = recorder.curves().rows_per_bucket();
  std::string text = rows == 1
                         ? "The plots show every row of sensors.csv."
                         : fmt::format(
                               "The plots show, of each {} rows of sensors.csv, the lowest and the "
                               "highest value.",
                               rows);
  const std::vector<double>& times = recorder.animation().times();
  if (times.size() < 2) return text + " The run was too short for an animation.";
  return text + fmt::format(
                    " The animation has {}, {} s apart; in between it moves along "
                    "straight lines.",
                    counted(std::ssize(times), "picture"), number(times[1]));
}

}  // namespace

std::string make_html(const Simulation& simulation, const SensorStatistics& statistics,
                      const RunOutcome& outcome, const TipSummary& tips, const Recorder& recorder,
                      const RunStatistics& rows) {
  const Scenario& scenario = simulation.scenario();
  report::Page page(
      scenario.title.empty() ? scenario.name : scenario.title,
      fmt::format("{} s in {} of {} s", number(statistics.last_time()),
                  counted(simulation.steps(), "step"), number(simulation.step_size())));
  page.widen();
  add_warnings(page, simulation, statistics, outcome);
  page.add_tiles(make_tiles(simulation, statistics, outcome, tips, rows));
  const bool has_animation = recorder.animation().times().size() > 1;
  if (has_animation) {
    page.add_heading("Motion");
    page.add_markup(make_animation_markup());
  }
  page.add_heading("Over time");
  page.add_markup(plots_markup(has_animation));
  page.add_paragraph(describe_data(recorder));
  if (rows.rows() > 0 && !rows.series().empty()) {
    page.add_heading("Statistics");
    page.add_table(make_statistics_table(simulation, rows));
  }
  page.add_heading("What was run");
  page.add_fact_groups({model_facts(simulation), setting_facts(simulation), machine_facts()});
  page.add_heading("Extremes of the sensors");
  page.add_table(extremes(simulation, statistics));
  page.add_data("run-data", make_data(recorder, simulation.events()));
  page.add_script(report::run_script());
  return page.html();
}

}  // namespace spoke::run_report
