// Hands rows to curves and pictures, and writes both as the data of the page.

#include "engine/run_report/recorder.h"

#include <algorithm>
#include <cmath>

#include "engine/run_report/base64.h"
#include "engine/support/json.h"

namespace spoke::run_report {
namespace {

std::size_t count_channels(const std::vector<Plot>& plots) {
  std::size_t count = 0;
  for (const Plot& plot : plots) count += plot.channels.size();
  return count;
}

std::vector<float> to_floats(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

std::string encode_curve(const std::vector<Sample>& samples) {
  std::vector<float> numbers;
  for (const Sample& sample : samples) {
    numbers.push_back(static_cast<float>(sample.t));
    numbers.push_back(static_cast<float>(sample.value));
  }
  return encode(numbers);
}

Json describe_plots(const Recorder& recorder) {
  Json plots = Json::array();
  std::size_t index = 0;
  for (const Plot& plot : recorder.plots()) {
    Json curves = Json::array();
    for (const Channel& channel : plot.channels)
      curves.push_back(
          {{"name", channel.name}, {"samples", encode_curve(recorder.curves().curve(index++))}});
    plots.push_back({{"title", plot.title}, {"unit", plot.unit}, {"curves", curves}});
  }
  return plots;
}

/// Displacements as 16-bit shares of the largest one.
Json describe_animation(const Animation& animation, double hub_radius) {
  constexpr float kMost = 32767.0F;
  const float largest = animation.largest_displacement();
  const float unit = largest > 0.0F ? largest / kMost : 1.0F;
  std::vector<std::int16_t> displacements;
  displacements.reserve(animation.displacements().size());
  for (const float number : animation.displacements())
    displacements.push_back(static_cast<std::int16_t>(std::lround(number / unit)));
  Json blades = Json::array(), joints = Json::array();
  for (const Animation::Blade& blade : animation.blades()) {
    std::vector<float> places;
    for (const Position& p : blade.undeformed)
      places.insert(places.end(), {static_cast<float>(p.x()), static_cast<float>(p.y())});
    blades.push_back(encode(places));
    joints.push_back(blade.nodes_per_body);
  }
  return {{"times", encode(to_floats(animation.times()))},
          {"hub", encode(animation.hub())},
          {"hubRadius", hub_radius},
          {"blades", blades},
          {"joints", joints},
          {"unit", unit},
          {"displacements", encode(displacements)}};
}

}  // namespace

Recorder::Recorder(const Simulation& simulation)
    : plots_(make_plots(simulation)),
      values_(count_channels(plots_)),
      curves_(values_.size()),
      animation_(simulation) {}

void Recorder::add_row(double t, std::span<const double> sensors) {
  std::size_t at = 0;
  for (const Plot& plot : plots_)
    for (const Channel& channel : plot.channels) {
      double value = channel.first_factor * sensors[channel.first];
      if (channel.second_factor != 0.0) value += channel.second_factor * sensors[channel.second];
      values_[at++] = value;
    }
  curves_.add(t, values_);
}

std::string make_data(const Recorder& recorder, double hub_radius) {
  double end = 0.0;
  const auto samples = recorder.curves().curve(0);
  if (!samples.empty()) end = samples.back().t;
  if (!recorder.animation().times().empty())
    end = std::max(end, recorder.animation().times().back());
  Json data = {{"end", end > 0.0 ? end : 1.0}, {"plots", describe_plots(recorder)}};
  if (recorder.animation().times().size() > 1)
    data.set("film", describe_animation(recorder.animation(), hub_radius));
  return data.dump();
}

}  // namespace spoke::run_report
