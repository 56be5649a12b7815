// Names of choices, and the sizes of joints.

#include "models/spatial_model.h"

#include <cassert>
#include <utility>

namespace spoke::spatial {

int count_coordinates(JointKind kind) {
  switch (kind) {
    case JointKind::fixed:
      return 0;
    case JointKind::revolute:
    case JointKind::prismatic:
      return 1;
    case JointKind::universal:
    case JointKind::cylindrical:
      return 2;
    case JointKind::bushing:
      return 6;
    case JointKind::spherical:
      break;
  }
  return 3;
}

int count_axes(JointKind kind) {
  if (kind == JointKind::universal) return 2;
  const bool has_none =
      kind == JointKind::fixed || kind == JointKind::spherical || kind == JointKind::bushing;
  return has_none ? 0 : 1;
}

std::string_view name_of(JointKind kind) {
  switch (kind) {
    case JointKind::fixed:
      return "fixed";
    case JointKind::revolute:
      return "revolute";
    case JointKind::universal:
      return "universal";
    case JointKind::spherical:
      return "spherical";
    case JointKind::prismatic:
      return "prismatic";
    case JointKind::cylindrical:
      return "cylindrical";
    case JointKind::bushing:
      break;
  }
  return "bushing";
}

bool slides(JointKind kind, int coordinate) {
  return kind == JointKind::prismatic || (kind == JointKind::cylindrical && coordinate == 1) ||
         (kind == JointKind::bushing && coordinate < 3);
}

std::string_view base_name(SupportBase base) {
  return base == SupportBase::ground ? "ground" : "fuselage";
}

int count_rotors(const Model& model) { return 1 + static_cast<int>(model.rotors.size()); }

const Hub& hub_of(const Model& model, int rotor) {
  assert(rotor >= 0 && rotor < count_rotors(model));
  return rotor == 0 ? model.hub : model.rotors[static_cast<std::size_t>(rotor) - 1].hub;
}

const Axle& axle_of(const Model& model, int rotor) {
  assert(rotor >= 0 && rotor < count_rotors(model) && model.support);
  return rotor == 0 ? model.support->axle : model.rotors[static_cast<std::size_t>(rotor) - 1].axle;
}

std::string prefix_of_rotor(const Model& model, int rotor) {
  return rotor == 0 ? "" : hub_of(model, rotor).name + '.';
}

bool is_hub_prescribed(const Model& model, int rotor) {
  return prescribes_motion(hub_of(model, rotor).drive) &&
         !(model.support && axle_of(model, rotor).train);
}

bool is_support(const Model& model, const Subsystem& subsystem) {
  return model.support && &subsystem == &model.subsystems.back();
}

std::vector<int> find_rotors_on(const Model& model, const std::string& subsystem) {
  std::vector<int> rotors;
  for (int r = 0; model.support && r < count_rotors(model); ++r) {
    const std::string& carrier = axle_of(model, r).subsystem;
    if ((carrier.empty() ? kSupportName : carrier) == subsystem) rotors.push_back(r);
  }
  return rotors;
}

std::string key_of_subsystem(const Model& model, std::size_t index) {
  assert(index < model.subsystems.size());
  if (is_support(model, model.subsystems[index])) return std::string(kSupportName);
  return "subsystem." + std::to_string(index + 1);
}

void suspend(const Suspension& suspension, Model& model) {
  assert(!model.support);
  Subsystem tree;
  tree.name = kSupportName;
  tree.bodies.push_back(
      {"carrier", RigidBody{suspension.mass, suspension.center, suspension.inertia}});
  SubsystemJoint& joint = tree.joints.emplace_back();
  joint.parent = base_name(SupportBase::ground);
  joint.child = "carrier";
  joint.joint.name = "suspension";
  joint.joint.kind = JointKind::bushing;
  joint.joint.coordinates.resize(suspension.stiffness.size());
  for (std::size_t c = 0; c < suspension.stiffness.size(); ++c) {
    JointCoordinate& coordinate = joint.joint.coordinates[c];
    if (!suspension.moves(c)) {
      coordinate.motion = MotionTable{};
      continue;
    }
    coordinate.stiffness = suspension.stiffness[c];
    coordinate.damping = suspension.damping[c];
  }
  model.subsystems.push_back(std::move(tree));
  model.support = Support{};
  model.support->axle.body = "carrier";
}

std::string_view name_of(SupportBase base) {
  return base == SupportBase::ground ? "ground" : "free";
}

std::string_view name_of(LoadFrame frame) {
  switch (frame) {
    case LoadFrame::inertial:
      return "inertial";
    case LoadFrame::hub:
      return "hub";
    case LoadFrame::body:
      return "body";
    case LoadFrame::section:
      break;
  }
  return "section";
}

}  // namespace spoke::spatial
