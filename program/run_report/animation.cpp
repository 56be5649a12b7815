// Collects frames, of every few nodes where there are many.

#include "program/run_report/animation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/bodies/space/solid_output.h"
#include "engine/output/scene/deformed.h"
#include "engine/output/scene/make_scene.h"
#include "models/space/rotation_vector.h"
#include "program/run_report/scene_data.h"

namespace spoke::run_report {
namespace {

/// Counts the 16-bit numbers of a frame, or half of its single-precision ones; 1 for a hub alone,
/// which has none.
std::size_t count_numbers(const scene::Scene& scene) {
  const std::size_t per_node = scene.is_planar ? 3 : 6;
  std::size_t count = per_node * scene.nodes.size() + 2 * scene.element_count() +
                      14 * static_cast<std::size_t>(scene.groups - 1);
  for (const scene::MeshBody& mesh : scene.meshes) {
    const scene::Surface& surface = scene.surfaces[static_cast<std::size_t>(mesh.surface)];
    const bool is_reduced = surface.recovery && surface.recovery->is_reduced();
    count += (is_reduced ? 2 : 1) * surface.frame_numbers();
  }
  return std::max<std::size_t>(count, 1);
}

}  // namespace

Animation::Animation(const Simulation& simulation)
    : scene_(scene::make_scene(simulation, kMostNodes)),
      reader_(scene_),
      is_free_in_space_(simulation.scenario().space &&
                        simulation.scenario().space->hub.support == HubSupport::free),
      most_frames_(std::clamp(kMostNumbers / count_numbers(scene_), kFewestFrames, kMostFrames)),
      solids_(scene_.meshes.size()) {}

void Animation::add(const Simulation& simulation) {
  if (!times_.empty() && times_.back() == simulation.time()) return;
  reader_.read(simulation, frame_);
  std::vector<std::vector<float>*> all = {&hub_,       &groups_,       &displacements_,
                                          &rotations_, &axial_forces_, &bending_moments_};
  for (std::vector<float>& solid : solids_) all.push_back(&solid);
  std::vector<std::size_t> before(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) before[i] = all[i]->size();
  append();
  bool is_finite = true;
  for (std::size_t i = 0; i < all.size(); ++i)
    is_finite = is_finite && std::all_of(all[i]->begin() + static_cast<std::ptrdiff_t>(before[i]),
                                         all[i]->end(), [](float x) { return std::isfinite(x); });
  if (is_finite) {
    times_.push_back(simulation.time());
    observe_solids();
  } else {
    for (std::size_t i = 0; i < all.size(); ++i) all[i]->resize(before[i]);
  }
}

void Animation::append() {
  if (scene_.support >= 0) {
    turn_to_base();
    append_pose({frame_.hub.position, calc_standing_hub()}, hub_);
    hub_.push_back(static_cast<float>(frame_.hub_angle));
  } else if (is_free_in_space_) {
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
  append_solids();
  for (const double force : frame_.axial_forces) axial_forces_.push_back(static_cast<float>(force));
  for (const double moment : frame_.bending_moments)
    bending_moments_.push_back(static_cast<float>(moment));
}

/// Returns the orientation that the hub would have at an angle of 0.
spatial::Tensor Animation::calc_standing_hub() const {
  return frame_.hub.rotation * space::exponential(-frame_.hub_angle * scene_.axis).axes;
}

/// Takes what is on a support from the hub's frame to that of its base, whose own motion becomes
/// that in the inertial frame: neither turns with the rotor between two pictures.
void Animation::turn_to_base() {
  const auto first = static_cast<std::size_t>(scene_.base_group);
  const spatial::Placement base = frame_.groups[first];
  const spatial::Tensor back = base.rotation.transpose();
  const spatial::Placement to_base{-(back * base.position), back};
  frame_.groups[first] = spatial::Placement{frame_.hub.position, frame_.hub.rotation} * base;
  for (std::size_t g = first + 1; g < frame_.groups.size(); ++g)
    frame_.groups[g] = to_base * frame_.groups[g];
  for (std::size_t k = 0; k < scene_.nodes.size(); ++k)
    if (scene_.nodes[k].group >= scene_.base_group) {
      frame_.displacements[k] = back * frame_.displacements[k];
      frame_.rotations[k] = back * frame_.rotations[k];
    }
}

void Animation::append_solids() {
  for (std::size_t m = 0; m < solids_.size(); ++m)
    append_numbers(scene_.surfaces[static_cast<std::size_t>(scene_.meshes[m].surface)],
                   frame_.solids[m], solids_[m]);
}

/// Takes the extremes of the last frame.
void Animation::observe_solids() {
  if (solids_.empty()) return;
  const scene::Deformed deformed(scene_, frame_);
  for (std::size_t m = 0; m < solids_.size(); ++m) {
    const scene::MeshBody& mesh = scene_.meshes[m];
    const scene::Surface& surface = scene_.surfaces[static_cast<std::size_t>(mesh.surface)];
    if (!surface.recovery) continue;
    for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
      const double u = scene::displacement_of(scene_, frame_, deformed, m, k).norm();
      if (u > extremes_.displacement) {
        extremes_.displacement = u;
        extremes_.time = times_.back();
      }
    }
    if (surface.recovery->has_stress())
      extremes_.von_mises = std::max(
          extremes_.von_mises, surface.recovery->largest_von_mises(frame_.solids[m].data()).value);
  }
}

}  // namespace spoke::run_report
