// Hands rows to curves and pictures, and writes both as the data of the page.

#include "program/run_report/recorder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/bodies/space/solid_output.h"
#include "models/support/json.h"
#include "program/run_report/base64.h"
#include "program/run_report/scene_data.h"

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

/// Returns the unit by which the largest of numbers becomes the largest 16-bit one; 1 without any.
float find_unit(const std::vector<float>& numbers) {
  constexpr float kMost = 32767.0F;
  float largest = 0.0F;
  for (const float number : numbers) largest = std::max(largest, std::abs(number));
  return largest > 0.0F ? largest / kMost : 1.0F;
}
/// Rounds to the nearest number; std::lround is a call for each.
std::int16_t round_share(float share) {
  return static_cast<std::int16_t>(share < 0.0F ? share - 0.5F : share + 0.5F);
}

/// Numbers as 16-bit fractions of the largest one, and the unit of these fractions.
struct Shares {
  float unit = 1.0F;
  std::string text;
};

Shares encode_shares(const std::vector<float>& numbers) {
  Shares shares;
  shares.unit = find_unit(numbers);
  std::vector<std::int16_t> rounded;
  rounded.reserve(numbers.size());
  for (const float number : numbers) rounded.push_back(round_share(number / shares.unit));
  shares.text = encode(rounded);
  return shares;
}

/// Describes the numbers of a solid over all frames: those of a nodal one by shares, of
/// displacements and of stresses.
Json describe_solid(const scene::Surface& surface, const std::vector<float>& numbers) {
  if (!surface.recovery || surface.recovery->is_reduced()) return {{"numbers", encode(numbers)}};
  const std::size_t per_frame = surface.frame_numbers(), moved = 3 * surface.nodes.size();
  std::vector<float> displacements, stresses;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    (i % per_frame < moved ? displacements : stresses).push_back(numbers[i]);
  const float units[] = {find_unit(displacements), find_unit(stresses)};
  std::vector<std::int16_t> shares;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    shares.push_back(round_share(numbers[i] / units[i % per_frame < moved ? 0 : 1]));
  return {{"shares", encode(shares)}, {"units", std::vector<double>{units[0], units[1]}}};
}

Json describe_solids(const Animation& animation) {
  Json solids = Json::array();
  const scene::Scene& scene = animation.scene();
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    solids.push_back(describe_solid(
        scene.surfaces[static_cast<std::size_t>(scene.meshes[m].surface)], animation.solids()[m]));
  return solids;
}

/// Describes an animation for program/report/model_animation.js.
Json describe_animation(const Animation& animation) {
  const Shares displacements = encode_shares(animation.displacements()),
               rotations = encode_shares(animation.rotations()),
               axial = encode_shares(animation.axial_forces()),
               bending = encode_shares(animation.bending_moments());
  return {{"times", encode(to_floats(animation.times()))},
          {"hub", encode(animation.hub())},
          {"groups", encode(animation.groups())},
          {"displacements", displacements.text},
          {"rotations", rotations.text},
          {"axial", axial.text},
          {"bending", bending.text},
          {"solids", describe_solids(animation)},
          {"largest", Json{{"displacement", animation.solid_extremes().displacement},
                           {"time", animation.solid_extremes().time},
                           {"vonMises", animation.solid_extremes().von_mises}}},
          {"units", Json{{"displacement", displacements.unit},
                         {"rotation", rotations.unit},
                         {"axial", axial.unit},
                         {"bending", bending.unit}}}};
}

/// Adds the events that have acted, in order of time.
void add_events(const std::vector<EventInRun>& events, Json& data) {
  std::vector<EventInRun> acted;
  std::copy_if(events.begin(), events.end(), std::back_inserter(acted),
               [](const EventInRun& event) { return event.time.has_value(); });
  std::stable_sort(acted.begin(), acted.end(),
                   [](const auto& a, const auto& b) { return *a.time < *b.time; });
  for (const EventInRun& event : acted)
    data.append("events", {{"name", event.name}, {"t", *event.time}});
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

std::string make_data(const Recorder& recorder, const std::vector<EventInRun>& events) {
  double end = 0.0;
  const auto samples = recorder.curves().curve(0);
  if (!samples.empty()) end = samples.back().t;
  if (!recorder.animation().times().empty())
    end = std::max(end, recorder.animation().times().back());
  Json data = {{"end", end > 0.0 ? end : 1.0}, {"plots", describe_plots(recorder)}};
  add_events(events, data);
  if (recorder.animation().times().size() > 1) {
    data.set("scene", describe_scene(recorder.animation().scene()));
    data.set("animation", describe_animation(recorder.animation()));
  }
  return data.dump();
}

}  // namespace spoke::run_report
