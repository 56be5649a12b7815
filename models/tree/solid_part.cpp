// Finds what the loads of a model say of its solids.

#include "models/tree/solid_part.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <variant>

namespace spoke::spatial {

solid::MadeConstants find_constants(const SolidPart& part, const solid::Control& control,
                                    bool anew) {
  solid::Control named = control;
  if (control.progress)
    named.progress = [&](const std::string& step, double done) {
      control.progress(part.name + ": " + step, done);
    };
  return solid::find_constants(*part.kept, part.sets, part.key, named, anew);
}

std::optional<NodeChoice> find_loaded_set(const PointLoad& load, const SolidBody& body) {
  if (load.nodes) return load.nodes;
  if (!load.traction) return std::nullopt;
  const std::optional<std::size_t> interface = find_interface(body, load.interface);
  assert(interface);
  return body.interfaces[*interface].nodes;
}

std::size_t find_loaded_place(const PointLoad& load, const SolidPart& part) {
  const SolidBody& body = part.body();
  const std::optional<NodeChoice> set = find_loaded_set(load, body);
  if (!set) return find_interface(body, load.interface).value();
  const auto at = std::find(part.sets.begin(), part.sets.end(), *set);
  assert(at != part.sets.end());
  return body.interfaces.size() + static_cast<std::size_t>(at - part.sets.begin());
}

const SolidBody* find_loaded_solid(const PointLoad& load, const Model& model) {
  for (const Subsystem& subsystem : model.subsystems)
    if (subsystem.name == load.place.subsystem)
      for (const Body& body : subsystem.bodies)
        if (body.name == load.place.body) return std::get_if<SolidBody>(&body.shape);
  return nullptr;
}

SolidParts::SolidParts(const Model& model) {
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    for (std::size_t j = 0; j < model.subsystems[i].bodies.size(); ++j) {
      const auto* solid = std::get_if<SolidBody>(&model.subsystems[i].bodies[j].shape);
      if (!solid || find(*solid) < parts_.size()) continue;
      described_.push_back(solid);
      parts_.push_back({solid::find_geometry(*solid),
                        {},
                        key_of_subsystem(model, i) + ".body." + std::to_string(j + 1),
                        model.subsystems[i].name + " / " + model.subsystems[i].bodies[j].name});
    }
  for (const PointLoad& load : model.loads) {
    const SolidBody* solid = find_loaded_solid(load, model);
    if (!solid) continue;
    solid::LoadedSets& sets = parts_[find(*solid)].sets;
    const std::optional<NodeChoice> set = find_loaded_set(load, *solid);
    if (set && std::find(sets.begin(), sets.end(), *set) == sets.end()) sets.push_back(*set);
  }
}

std::size_t SolidParts::find(const SolidBody& body) const {
  const auto at =
      std::find_if(described_.begin(), described_.end(),
                   [&](const SolidBody* described) { return is_same_solid(*described, body); });
  return static_cast<std::size_t>(at - described_.begin());
}

const SolidPart& SolidParts::of(const SolidBody& body) const {
  assert(find(body) < parts_.size());
  return parts_[find(body)];
}

void SolidParts::make_constants(const solid::Control& control) const {
  for (const SolidPart& part : parts_) find_constants(part, control);
}

std::int64_t count_coordinates(const SolidPart& part) {
  const SolidBody& body = part.body();
  const auto interfaces = std::ssize(body.interfaces);
  const std::int64_t of_interfaces =
      6 * (body.frame == SolidFrame::mean_axis ? interfaces : interfaces - 1);
  if (body.coordinates == SolidCoordinates::reduced)
    return (body.up_to ? 0 : body.modes.value_or(kUsualModes)) + of_interfaces;
  std::int64_t count = 3 * std::ssize(part.geometry().mesh->nodes);
  for (std::size_t i = 0; i < body.interfaces.size(); ++i)
    if (body.interfaces[i].kind == InterfaceKind::rigid)
      count += (i == 0 ? 0 : 6) - 3 * std::ssize(part.geometry().interfaces[i].nodes);
    else if (i == 0)
      count -= 6;  // which follow from the others
  return count;
}

}  // namespace spoke::spatial
