// Keeps extremes of stretches of rows, which become longer as more rows come.

#include "program/run_report/curves.h"

#include <algorithm>
#include <cmath>
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

/// Plots the displacements of the tips in the direction that is turned by `turn` from the blade's.
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

/// Adds for a model in space a plot for each sensor that trees have, with a curve for each tree, in
/// the order of the sensors.
void add_plots_of_trees(const Simulation& simulation, std::vector<Plot>& plots) {
  const std::vector<std::string>& names = simulation.sensor_names();
  const std::size_t first = plots.size();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t dot = names[k].find('.');
    const std::string tree = names[k].substr(0, dot), sensor = names[k].substr(dot + 1);
    if (tree == "energy" || names[k] == "hub.speed" || names[k] == "hub.torque") continue;
    if (names[k].starts_with(kMomentumResidual)) continue;
    const std::string title = tree == "hub" ? "Hub: " + sensor : sensor;
    const auto same = std::find_if(plots.begin() + static_cast<std::ptrdiff_t>(first), plots.end(),
                                   [&](const Plot& plot) { return plot.title == title; });
    Plot& plot = same != plots.end()
                     ? *same
                     : plots.emplace_back(Plot{title, simulation.sensor_units()[k], {}});
    plot.channels.push_back({tree, k});
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

void Curves::Extremes::add(Sample sample) {
  if (is_empty || sample.value < low.value) low = sample;
  if (is_empty || sample.value > high.value) high = sample;
  is_empty = false;
}

void Curves::Extremes::add(const Extremes& other) {
  if (other.is_empty) return;
  add(other.low);
  add(other.high);
}

Curves::Curves(std::size_t curves)
    : curves_(curves),
      most_buckets_(
          std::clamp<std::size_t>(kMostInAll / std::max<std::size_t>(1, curves), 50, kMostBuckets)),
      last_(curves) {}

void Curves::add(double t, std::span<const double> values) {
  if (buckets_.empty() || rows_in_last_ == rows_per_bucket_) {
    if (buckets_.size() == most_buckets_ * curves_) merge_pairs();
    buckets_.resize(buckets_.size() + curves_);
    rows_in_last_ = 0;
  }
  ++rows_in_last_;
  for (std::size_t i = 0; i < curves_; ++i) {
    if (!std::isfinite(values[i])) continue;
    last_[i] = {t, values[i]};
    buckets_[buckets_.size() - curves_ + i].add(last_[i]);
  }
}

void Curves::merge_pairs() {
  const std::size_t buckets = most_buckets_ / 2;
  for (std::size_t b = 0; b < buckets; ++b)
    for (std::size_t i = 0; i < curves_; ++i) {
      Extremes both = buckets_[2 * b * curves_ + i];
      both.add(buckets_[(2 * b + 1) * curves_ + i]);
      buckets_[b * curves_ + i] = both;
    }
  // The last one of an odd number stays by itself.
  for (std::size_t i = 0; i < most_buckets_ % 2 * curves_; ++i)
    buckets_[buckets * curves_ + i] = buckets_[2 * buckets * curves_ + i];
  buckets_.resize((buckets + most_buckets_ % 2) * curves_);
  rows_per_bucket_ *= 2;
}

std::vector<Sample> Curves::curve(std::size_t index) const {
  std::vector<Sample> samples;
  for (std::size_t at = index; at < buckets_.size(); at += curves_) {
    const Extremes& bucket = buckets_[at];
    if (bucket.is_empty) continue;
    const bool is_rising = bucket.low.t <= bucket.high.t;
    samples.push_back(is_rising ? bucket.low : bucket.high);
    if (bucket.low.t != bucket.high.t) samples.push_back(is_rising ? bucket.high : bucket.low);
  }
  if (!samples.empty() && samples.back().t < last_[index].t) samples.push_back(last_[index]);
  return samples;
}

}  // namespace spoke::run_report
