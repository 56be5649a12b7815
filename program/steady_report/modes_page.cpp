// Makes pages of modes: markup and data for program/report/modes_page.js.

#include "program/steady_report/modes_page.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "engine/support/plain_zero.h"
#include "program/report/modes_script.h"
#include "program/report/scene_markup.h"
#include "program/steady_report/campbell_files.h"
#include "program/steady_report/critical_files.h"
#include "program/steady_report/mode_files.h"
#include "program/steady_report/steady_scene.h"

namespace spoke::steady_report {
namespace {

constexpr std::size_t kMostNodes = 400;  // nodes of a scene whose page holds many shapes

constexpr const char* kDiagram = R"(<div class="controls">
<button type="button" id="campbell-in">Zoom in</button>
<button type="button" id="campbell-out">Zoom out</button>
<button type="button" id="campbell-reset" disabled>Reset</button>
<button type="button" id="campbell-all">All frequencies</button>
<span class="hint" id="campbell-keys">Point at a mode to read it, click to see its shape below. Drag a rectangle to zoom, scroll to zoom about the pointer, double-click to reset. With the keyboard: left and right go from speed to speed, up and down from mode to mode, + and &#8722; zoom, 0 resets.</span>
</div>
)";
/// Returns the markup of one of the plots, called `id`.
std::string make_plot(const std::string& id, const std::string& title, const std::string& more,
                      const std::string& label) {
  return "<figure><figcaption><strong>" + title + "</strong>" + more +
         "</figcaption><canvas id=\"" + id +
         "\" tabindex=\"0\" role=\"application\" aria-label=\"" + label +
         "\" aria-describedby=\"campbell-keys\"></canvas></figure>\n";
}

constexpr const char* kLegend =
    R"(<div class="legend" id="campbell-legend" role="group" aria-label="Modes"></div>
</div>
)";

/// `over`: what states differ by, "Speed".
std::string make_mode_markup(const std::string& over = "Speed") {
  return R"(<div class="animation">
<p id="mode-text"></p>
<div class="views">
<figure class="whole">)" +
         report::scene_canvas("mode", "view", "The model moving in the chosen mode") + R"(</figure>
</div>
<div class="controls">
<button type="button" id="mode-play" class="primary">Play</button>
<label><span>Mode</span><select id="mode-mode"></select></label>
<label><span>)" +
         over + R"(</span><select id="mode-speed"></select></label>
<label><span>Amplitude</span><input type="range" id="mode-amplitude" min="0" max="40" value="12"><output id="mode-share"></output></label>
<label><input type="checkbox" id="mode-outline" checked> undeformed</label>
)" +
         report::scene_controls("mode",
                                "A mode of any frequency takes two seconds here. Its amplitude is "
                                "a share of the model's size. ") +
         R"(</div>
</div>
<div class="unseen" id="spoken" role="status" aria-live="polite"></div>
<noscript><p class="note warning">Drawings and animation need JavaScript.</p></noscript>
)";
}

Json describe_state(const ModesResult& state, const SteadyScene& scene) {
  Json modes = Json::array();
  for (const Mode& mode : state.modes) modes.push_back(scene.describe(mode, state.equilibrium));
  Json described = scene.describe(state.equilibrium);
  described.set("modes", modes);
  return described;
}

/// Describes a branch for each mode.
Json describe_branches(const ModesResult& result) {
  Json branches = Json::array();
  for (std::size_t k = 0; k < result.modes.size(); ++k)
    branches.push_back({{"name", result.modes[k].name},
                        {"of", result.modes[k].of},
                        {"modes", std::vector<int>{static_cast<int>(k)}}});
  return branches;
}

Json describe_branches(const std::vector<CampbellBranch>& followed) {
  Json branches = Json::array();
  for (const CampbellBranch& branch : followed) {
    Json modes = Json::array();
    for (const std::optional<std::size_t>& mode : branch.modes)
      modes.push_back(mode ? Json(*mode) : Json());
    branches.push_back({{"name", branch.name}, {"of", branch.of}, {"modes", modes}});
  }
  return branches;
}

/// Returns the frequency up to which the diagram first shows modes [Hz]: it covers those that
/// excitation lines come near, and the lowest three branches. With all modes, lines would be
/// crowded at the bottom.
double highest_shown(const CampbellResult& result, int harmonics) {
  std::vector<double> peaks;
  for (const CampbellBranch& branch : result.branches) {
    double peak = 0.0;
    for (std::size_t k = 0; k < branch.modes.size(); ++k)
      if (branch.modes[k])
        peak = std::max(peak, hertz(result.states[k].modes[*branch.modes[k]].frequency));
    peaks.push_back(peak);
  }
  if (peaks.empty()) return 0.0;
  std::sort(peaks.begin(), peaks.end());
  double speed = 0.0;
  for (const ModesResult& state : result.states)
    speed = std::max(speed, std::abs(state.equilibrium.speed));
  const double lowest = peaks[std::min<std::size_t>(peaks.size(), 3) - 1];
  const double excited = 1.25 * hertz(harmonics * speed);
  return harmonics == 0 ? peaks.back() : std::min(peaks.back(), std::max(lowest, excited));
}

/// Whether a mode is damped, or grows, by more than round-off.
bool is_damped(const CampbellResult& result) {
  for (const ModesResult& state : result.states)
    for (const Mode& mode : state.modes)
      if (damping_of(mode) != 0.0) return true;
  return false;
}

std::string make_data(const ModesResult& result, const Scenario& scenario) {
  const SteadyScene scene(scenario, result.equilibrium, kMostNodes);
  const Json data = {{"scene", scene.describe()},
                     {"states", Json::array({describe_state(result, scene)})},
                     {"branches", describe_branches(result)}};
  return data.dump();
}

/// Describes the states of a search with the real parts of roots and what is varied; the page
/// begins with the critical mode.
std::string make_data(const CriticalResult& result, const CriticalOptions& options,
                      const Scenario& scenario) {
  const SteadyScene scene(scenario, result.states[0].equilibrium, kMostNodes);
  Json states = Json::array();
  for (std::size_t k = 0; k < result.states.size(); ++k) {
    Json modes = Json::array();
    for (const Mode& mode : result.states[k].modes) {
      Json described = scene.describe(mode, result.states[k].equilibrium);
      described.set("growth", plain_zero(mode.eigenvalue.real()));
      modes.push_back(described);
    }
    Json described = scene.describe(result.states[k].equilibrium);
    described.set("value", result.values[k]);
    described.set("modes", modes);
    states.push_back(described);
  }
  const VariedQuantity varied = name_varied(options);
  Json data = {{"scene", scene.describe()},
               {"states", states},
               {"branches", describe_branches(result.branches)},
               {"harmonics", 0},
               {"varied", {{"name", varied.name}, {"unit", varied.unit}}}};
  if (!result.critical) return data.dump();
  const CriticalPoint& critical = *result.critical;
  Json chosen = {{"state", critical.state}};
  for (std::size_t b = 0; b < result.branches.size(); ++b)
    if (critical.mode && result.branches[b].modes[critical.state] == critical.mode)
      chosen.set("branch", b);
  data.set("critical", chosen);
  return data.dump();
}

std::string make_data(const CampbellResult& result, int harmonics, const Scenario& scenario) {
  const auto solved =
      std::find_if(result.states.begin(), result.states.end(),
                   [](const ModesResult& state) { return !state.equilibrium.blades.empty(); });
  const SteadyScene scene(scenario, solved->equilibrium, kMostNodes);
  Json states = Json::array();
  for (const ModesResult& state : result.states) states.push_back(describe_state(state, scene));
  const Json data = {{"scene", scene.describe()},
                     {"states", states},
                     {"branches", describe_branches(result.branches)},
                     {"harmonics", harmonics},
                     {"shown", 1.05 * highest_shown(result, harmonics)}};
  return data.dump();
}

}  // namespace

std::string make_html(const ModesResult& result, const Scenario& scenario,
                      const std::string& title) {
  report::Page page(title,
                    fmt::format("Vibration modes at {}, {}", describe_speeds(result.equilibrium),
                                describe(result.frame)));
  page.widen();
  if (const std::string growth = describe_growth(result); !growth.empty())
    page.add_note(growth + ".", report::Tone::bad);
  page.add_markup(make_mode_markup());
  page.add_table(make_mode_table(result));
  page.add_data("steady-data", make_data(result, scenario));
  page.add_script(report::modes_script());
  return page.html();
}

std::string make_html(const CampbellResult& result, int harmonics, const Scenario& scenario,
                      const std::string& title) {
  report::Page page(title, "Campbell diagram: frequencies " + describe(result.states[0].frame));
  page.widen();
  const bool has_damping = is_damped(result);
  page.add_markup(
      kDiagram + std::string("<div class=\"runs\">\n") +
      make_plot("campbell", "Frequencies over speed", " [Hz]; dashed: multiples of the speed",
                "Frequencies of the modes over speed") +
      (has_damping ? make_plot("campbell-damping", "Damping ratios over speed",
                               "; negative ones grow", "Damping ratios of the modes over speed")
                   : "") +
      kLegend);
  if (!has_damping) page.add_paragraph("No mode is damped, and none grows.");
  page.add_heading("The chosen mode");
  page.add_markup(make_mode_markup());
  page.add_table(make_crossing_table(result));
  if (!result.gaps.empty()) page.add_table(make_gap_table(result));
  page.add_table(make_branch_table(result));
  page.add_data("steady-data", make_data(result, harmonics, scenario));
  page.add_script(report::modes_script());
  return page.html();
}

std::string make_html(const CriticalResult& result, const CriticalOptions& options,
                      const Scenario& scenario, const std::string& title) {
  const VariedQuantity varied = name_varied(options);
  report::Page page(title,
                    "Stability over the " + varied.name + ", " + describe(result.states[0].frame));
  page.widen();
  page.add_note(describe_critical(result, options) + ".",
                result.critical ? report::Tone::bad : report::Tone::plain);
  const std::string over = " over the " + varied.name;
  page.add_markup(
      kDiagram + std::string("<div class=\"runs\">\n") +
      make_plot("campbell", "Frequencies" + over, " [Hz]", "Frequencies of the modes" + over) +
      make_plot("campbell-growth", "Growth" + over,
                ": real parts of the roots [1/s]; positive ones grow",
                "Real parts of the roots" + over) +
      kLegend);
  page.add_heading("The chosen mode");
  page.add_markup(make_mode_markup(varied.is_speed() ? "Speed" : "Factor"));
  page.add_table(make_branch_table(result, options));
  page.add_data("steady-data", make_data(result, options, scenario));
  page.add_script(report::modes_script());
  return page.html();
}

}  // namespace spoke::steady_report
