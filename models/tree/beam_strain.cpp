#include "models/tree/beam_strain.h"

#include <algorithm>
#include <cassert>

#include "models/tree/axle_carrier.h"
#include "models/tree/space_beam.h"
#include "models/tree/tree.h"

namespace spoke::spatial {
namespace {

/// Share of the square of a section's radius of gyration that the square of an offset stays below:
/// torsional frequencies are then off by some thousandths at most.
constexpr double kMostOffset = 0.1;

constexpr const char* kNoDrive = "no drive turns the hub";

bool is_turned(const Hub& hub) { return hub.support == HubSupport::axle && turns_hub(hub.drive); }

std::string name_or(const std::string& kind, const std::string& name) {
  return name.empty() ? "a " + kind : kind + ' ' + name;
}

/// Returns what a joint or a loop does to the bodies of a tree; `others`: loops that end on it.
template <class TreeJoint>
std::string find_cause(const std::vector<TreeJoint>& joints, const std::vector<Loop>& loops,
                       const std::vector<LoopFromElsewhere>& others) {
  for (const TreeJoint& at : joints)
    if (count_coordinates(at.joint.kind) > 0) return name_or("joint", at.joint.name) + " moves it";
  if (loops.empty() && others.empty()) return "";
  const Loop& loop = loops.empty() ? *others.front().loop : loops.front();
  return name_or("loop", loop.name) + " pulls at it";
}

/// Return the loops of other trees that end on a blade or a subsystem of the model.
std::vector<LoopFromElsewhere> loops_on(const Model& model, const Blade& blade) {
  assert(&blade >= model.blades.data() && &blade < model.blades.data() + model.blades.size());
  return find_loops_from_elsewhere(model, static_cast<std::size_t>(&blade - model.blades.data()));
}
std::vector<LoopFromElsewhere> loops_on(const Model& model, const Subsystem& subsystem) {
  const Subsystem* const first = model.subsystems.data();
  assert(&subsystem >= first && &subsystem < first + model.subsystems.size());
  return find_loops_from_elsewhere(
      model, model.blades.size() + static_cast<std::size_t>(&subsystem - first));
}

}  // namespace

std::string find_unknown_tension(const Model& model, const Blade& blade) {
  if (const std::vector<int> rotors = find_rotors_on(model, blade); !rotors.empty())
    return "it carries rotor " + hub_of(model, rotors.front()).name;
  return is_turned(hub_of(model, blade.rotor))
             ? find_cause(blade.joints, blade.loops, loops_on(model, blade))
             : kNoDrive;
}

std::string find_unknown_tension(const Model& model, const Subsystem& subsystem) {
  if (is_support(model, subsystem)) return "the hub does not turn it";
  if (const std::vector<int> rotors = find_rotors_on(model, subsystem.name); !rotors.empty())
    return "it carries rotor " + hub_of(model, rotors.front()).name;
  return is_turned(hub_of(model, subsystem.rotor))
             ? find_cause(subsystem.joints, subsystem.loops, loops_on(model, subsystem))
             : kNoDrive;
}

std::string find_joint_or_loop(const Model& model, const Subsystem& subsystem,
                               const std::string& body) {
  std::vector<SubsystemJoint> inboard;
  const auto carrier_of = [&subsystem](const std::string& child) {
    return std::find_if(subsystem.joints.begin(), subsystem.joints.end(),
                        [&child](const SubsystemJoint& joint) { return joint.child == child; });
  };
  for (auto at = carrier_of(body); at != subsystem.joints.end(); at = carrier_of(at->parent))
    inboard.push_back(*at);
  return find_cause(inboard, subsystem.loops, loops_on(model, subsystem));
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

BeamStrain choose_strain(const Beam& beam, const std::string& unknown) {
  if (beam.strain != BeamStrain::automatic) return beam.strain;
  const bool is_nonlinear =
      beam.geometric_stiffening && (!unknown.empty() || has_axis_beside(beam));
  return is_nonlinear ? BeamStrain::nonlinear : BeamStrain::linear;
}

}  // namespace spoke::spatial
