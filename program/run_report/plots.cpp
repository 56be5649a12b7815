// Chooses the plots of report.html.

#include "program/run_report/plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace spoke::run_report {
namespace {

constexpr const char* kMomentumResidual = "momentum.residual.";

/// Adds plots of the momentum, for a free model on which no load acts.
void add_plots_of_momentum(const Simulation& simulation, std::vector<Plot>& plots) {
  const std::vector<std::string>& names = simulation.sensor_names();
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k].starts_with(kMomentumResidual)) {
      const bool is_angular = names[k].ends_with(".angular");
      plots.push_back({is_angular ? "Angular momentum residual" : "Momentum residual",
                       simulation.sensor_units()[k],
                       {{"residual", k}}});
    }
}

/// Plots the displacements of the tips across the undeformed blades, or along them.
Plot plot_of_tips(const Simulation& simulation, std::string title, bool is_across) {
  Plot plot{std::move(title), "m", {}};
  const auto& blades = simulation.scenario().rotor.blades;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const double c = std::cos(blades[i].azimuth), s = std::sin(blades[i].azimuth);
    plot.channels.push_back(
        {"blade " + number, simulation.sensor_index("blade" + number + ".tip.x"),
         is_across ? -s : c, simulation.sensor_index("blade" + number + ".tip.y"),
         is_across ? c : s});
  }
  return plot;
}

/// Plots a curve for each blade of a sensor that all have: "blade1" and what follows, ".root.x".
Plot plot_of_blades(const Simulation& simulation, std::string title, std::string unit,
                    const std::string& sensor) {
  Plot plot{std::move(title), std::move(unit), {}};
  for (std::size_t i = 1; i <= simulation.scenario().rotor.blades.size(); ++i) {
    const std::string number = std::to_string(i);
    plot.channels.push_back(
        {"blade " + number, simulation.sensor_index("blade" + number + sensor)});
  }
  return plot;
}

/// Adds the scenario's own sensors: a plot for each component, with a curve for each blade.
void add_plots_of_sensors(const Simulation& simulation, std::vector<Plot>& plots) {
  const Scenario& scenario = simulation.scenario();
  for (const Sensor& sensor : scenario.sensors) {
    const std::string name =
        sensor.name.empty() ? std::string(name_of(sensor.quantity)) : sensor.name;
    for (const SensorComponent& component : components_of(sensor.quantity)) {
      const std::string end = component.name.empty() ? "" : "." + std::string(component.name);
      const std::string unit(component.unit);
      if (!is_of_blade(sensor.quantity)) {
        plots.push_back({name + end, unit, {{name + end, simulation.sensor_index(name + end)}}});
      } else if (sensor.blade.is_all()) {
        plots.push_back(plot_of_blades(simulation, name + end, unit, "." + name + end));
      } else {
        plots.push_back(
            {name + end,
             unit,
             {{"blade " + std::to_string(sensor.blade.number()),
               simulation.sensor_index(prefix_of(sensor, sensor.blade.number() - 1) + end)}}});
      }
    }
  }
}

/// Curves of a sensor each, in one plot.
struct NamedPlot {
  const char* title;
  std::vector<std::pair<const char*, const char*>> curves;  ///< names, and sensors
};

/// Returns the plots of a rotor in air and of control of its pitch; a model has those of their
/// sensors that it has.
std::vector<NamedPlot> rotor_plots() {
  return {
      {"Wind at the hub along the axis", {{"wind", "air.wind"}}},
      {"Thrust of the air", {{"thrust", "air.thrust"}}},
      {"Power of the air", {{"power", "air.power"}}},
      {"Torque of the air", {{"torque", "air.torque"}}},
      {"Coefficients of thrust and power",
       {{"thrust", "air.thrust_coefficient"}, {"power", "air.power_coefficient"}}},
      {"Pitch by control", {{"angle", "control.pitch.angle"}, {"demand", "control.pitch.demand"}}},
      {"Rate of pitch by control", {{"rate", "control.pitch.rate"}}}};
}

void add_plots_of_rotor(const Simulation& simulation, std::vector<Plot>& plots) {
  const std::vector<std::string>& names = simulation.sensor_names();
  for (const NamedPlot& named : rotor_plots()) {
    Plot plot{named.title, "", {}};
    for (const auto& [name, sensor] : named.curves) {
      const auto found = std::find(names.begin(), names.end(), sensor);
      if (found == names.end()) continue;
      const auto k = static_cast<std::size_t>(found - names.begin());
      plot.unit = simulation.sensor_units()[k];
      plot.channels.push_back({name, k});
    }
    if (!plot.channels.empty()) plots.push_back(std::move(plot));
  }
}

/// Returns the sensors of `plots`.
std::vector<bool> find_shown(const Simulation& simulation, const std::vector<Plot>& plots) {
  std::vector<bool> is_shown(simulation.sensor_names().size(), false);
  for (const Plot& plot : plots)
    for (const Channel& channel : plot.channels) is_shown[channel.first] = true;
  return is_shown;
}

/// Returns the name of a tree in legends, "blade 1" of "blade1": the page joins such names.
std::string legend_of(const std::string& tree) {
  constexpr std::string_view kBlade = "blade";
  const bool is_blade = tree.starts_with(kBlade) && tree.size() > kBlade.size() &&
                        std::all_of(tree.begin() + kBlade.size(), tree.end(),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_blade ? "blade " + tree.substr(kBlade.size()) : tree;
}

/// Returns the title of the plot of a tree's sensor. Hub and support have plots of their own: other
/// trees have other axes, and loads of another size.
std::string title_of(const std::string& tree, const std::string& sensor) {
  if (tree == "hub") return "Hub: " + sensor;
  return tree == "support" ? "Support: " + sensor : sensor;
}

/// Adds for a model in space a plot for each sensor that trees have, with a curve for each tree, in
/// the order of the sensors; not of sensors that have a plot.
void add_plots_of_trees(const Simulation& simulation, std::vector<Plot>& plots) {
  const std::vector<std::string>& names = simulation.sensor_names();
  const std::vector<bool> is_shown = find_shown(simulation, plots);
  const std::size_t first = plots.size();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (is_shown[k]) continue;
    const std::size_t dot = names[k].find('.');
    const std::string tree = names[k].substr(0, dot), sensor = names[k].substr(dot + 1);
    const std::string title = title_of(tree, sensor);
    const auto same = std::find_if(plots.begin() + static_cast<std::ptrdiff_t>(first), plots.end(),
                                   [&](const Plot& plot) { return plot.title == title; });
    Plot& plot = same != plots.end()
                     ? *same
                     : plots.emplace_back(Plot{title, simulation.sensor_units()[k], {}});
    plot.channels.push_back({legend_of(tree), k});
  }
}

}  // namespace

std::vector<Plot> make_plots(const Simulation& simulation) {
  const auto one = [&](const char* name, const std::string& sensor) {
    return Channel{name, simulation.sensor_index(sensor)};
  };
  std::vector<Plot> plots;
  const bool is_in_space = simulation.scenario().space.has_value();
  if (!is_in_space) {
    plots.push_back(plot_of_tips(simulation, "Tip deflection across the blade", true));
    plots.push_back(plot_of_tips(simulation, "Tip displacement along the blade", false));
  }
  plots.push_back({"Hub speed", "rad/s", {one("speed", "hub.speed")}});
  plots.push_back({"Torque on the hub", "N m", {one("torque", "hub.torque")}});
  add_plots_of_rotor(simulation, plots);
  if (simulation.scenario().rotor.hub.support == HubSupport::free)
    plots.push_back({"Place of the hub", "m", {one("x", "hub.x"), one("y", "hub.y")}});
  plots.push_back({"Energies",
                   "J",
                   {one("kinetic", "energy.kinetic"), one("strain", "energy.strain"),
                    one("work", "energy.work"), one("dissipated", "energy.dissipated")}});
  plots.push_back({"Energy residual", "J", {one("residual", "energy.residual")}});
  add_plots_of_momentum(simulation, plots);
  if (is_in_space) {
    add_plots_of_trees(simulation, plots);
    return plots;
  }
  plots.push_back(plot_of_blades(simulation, "Axial force at the root", "N", ".root.x"));
  plots.push_back(plot_of_blades(simulation, "Bending moment at the root", "N m", ".root.moment"));
  add_plots_of_sensors(simulation, plots);
  return plots;
}

}  // namespace spoke::run_report
