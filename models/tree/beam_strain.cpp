#include "models/tree/beam_strain.h"

#include <algorithm>
#include <variant>

#include "models/tree/space_beam.h"

namespace spoke::spatial {
namespace {

/// Share of the square of a section's radius of gyration that the square of an offset stays below:
/// torsional frequencies are then off by some thousandths at most.
constexpr double kMostOffset = 0.1;

/// Returns whether a drive turns a hub; one that coasts from rest does not.
bool turns_hub(const Hub& hub) {
  if (hub.support == HubSupport::free || std::holds_alternative<FixedDrive>(hub.drive))
    return false;
  const auto* coasting = std::get_if<FreeDrive>(&hub.drive);
  return !coasting || coasting->initial_speed != 0.0;
}

const TreeBody* find_moving(const Tree& tree) {
  const auto at = std::find_if(tree.bodies.begin(), tree.bodies.end(), [](const TreeBody& body) {
    return !body.is_hub && count_coordinates(body.joint.kind) > 0;
  });
  return at == tree.bodies.end() ? nullptr : &*at;
}

}  // namespace

std::string find_unknown_tension(const Model& model, const Tree& tree) {
  if (!turns_hub(model.hub)) return "no drive turns the hub";
  if (std::any_of(tree.bodies.begin(), tree.bodies.end(),
                  [](const TreeBody& body) { return body.is_hub; }))
    return "the hub does not turn it";
  if (const TreeBody* moving = find_moving(tree))
    return moving->joint.name.empty() ? "the joint of \"" + moving->name + "\" moves it"
                                      : "joint \"" + moving->joint.name + "\" moves it";
  if (!tree.loops.empty()) return "loop \"" + tree.loops.front().loop.name + "\" acts on it";
  return {};
}

bool has_axis_beside(const Beam& beam) {
  const space::Beam made = make_space_beam(beam);
  return std::any_of(made.station.begin(), made.station.end(), [&made](double x) {
    const space::SectionMatrices section = made.section(x);
    const space::TensionCentre tension = find_tension_centre(section);
    const space::Position mass = section.mass.first / section.mass.mass;
    const double square = std::max(tension.y * tension.y + tension.z * tension.z,
                                   mass.y() * mass.y() + mass.z() * mass.z());
    return square > kMostOffset * tension.gyration;
  });
}

void choose_strains(const Model& model, Tree& tree) {
  const bool is_unknown = !find_unknown_tension(model, tree).empty();
  for (Beam& beam : tree.beams) {
    if (beam.strain != BeamStrain::automatic) continue;
    const bool is_nonlinear = beam.geometric_stiffening && (is_unknown || has_axis_beside(beam));
    beam.strain = is_nonlinear ? BeamStrain::nonlinear : BeamStrain::linear;
  }
}

}  // namespace spoke::spatial
