// Collects frames, of every few nodes where there are many.

#include "program/run_report/animation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/scene/make_scene.h"
#include "program/run_report/scene_data.h"

namespace spoke::run_report {
namespace {

/// Counts the 16-bit numbers of a frame, or half of its single-precision ones; 1 for a hub alone,
/// which has none.
std::size_t count_numbers(const scene::Scene& scene) {
  const std::size_t per_node = scene.is_planar ? 3 : 6;
  const std::size_t count = per_node * scene.nodes.size() + 2 * scene.element_count() +
                            14 * static_cast<std::size_t>(scene.groups - 1);
  return std::max<std::size_t>(count, 1);
}

}  // namespace

Animation::Animation(const Simulation& simulation)
    : scene_(scene::make_scene(simulation.scenario(), kMostNodes)),
      reader_(scene_),
      is_free_in_space_(simulation.scenario().space &&
                        simulation.scenario().space->hub.support == HubSupport::free),
      most_frames_(std::clamp(kMostNumbers / count_numbers(scene_), kFewestFrames, kMostFrames)) {}

void Animation::add(const Simulation& simulation) {
  if (!times_.empty() && times_.back() == simulation.time()) return;
  reader_.read(simulation, frame_);
  const std::array<std::vector<float>*, 6> all = {&hub_,       &groups_,       &displacements_,
                                                  &rotations_, &axial_forces_, &bending_moments_};
  std::array<std::size_t, 6> before{};
  for (std::size_t i = 0; i < all.size(); ++i) before[i] = all[i]->size();
  append();
  bool is_finite = true;
  for (std::size_t i = 0; i < all.size(); ++i)
    is_finite = is_finite && std::all_of(all[i]->begin() + static_cast<std::ptrdiff_t>(before[i]),
                                         all[i]->end(), [](float x) { return std::isfinite(x); });
  if (is_finite) {
    times_.push_back(simulation.time());
  } else {
    for (std::size_t i = 0; i < all.size(); ++i) all[i]->resize(before[i]);
  }
}

void Animation::append() {
  if (is_free_in_space_) {
    append_pose({frame_.hub.position, frame_.hub.rotation}, hub_);
  } else {
    for (const double x : frame_.hub.position) hub_.push_back(static_cast<float>(x));
    hub_.push_back(static_cast<float>(frame_.hub_angle));
  }
  for (std::size_t g = 1; g < frame_.groups.size(); ++g) append_pose(frame_.groups[g], groups_);
  for (const scene::Vector& u : frame_.displacements)
    for (int c = 0; c < (scene_.is_planar ? 2 : 3); ++c)
      displacements_.push_back(static_cast<float>(u[c]));
  for (const scene::Vector& rotation : frame_.rotations)
    for (int c = scene_.is_planar ? 2 : 0; c < 3; ++c)
      rotations_.push_back(static_cast<float>(rotation[c]));
  for (const double force : frame_.axial_forces) axial_forces_.push_back(static_cast<float>(force));
  for (const double moment : frame_.bending_moments)
    bending_moments_.push_back(static_cast<float>(moment));
}

}  // namespace spoke::run_report
