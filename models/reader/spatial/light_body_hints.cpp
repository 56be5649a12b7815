#include "models/reader/spatial/light_body_hints.h"

#include <Eigen/LU>
#include <algorithm>
#include <sstream>
#include <variant>

namespace spoke {
namespace {

/// Of double precision the square of this ratio leaves some six digits.
constexpr double kMostRatio = 1e5;

bool turns(const spatial::Joint& joint) {
  for (int i = 0; i < count_coordinates(joint.kind); ++i)
    if (!slides(joint.kind, i)) return true;
  return false;
}

/// Returns about the largest ratio, over all axes through the joint, of the moment of inertia that
/// the mass at its centre makes to that about the centre.
double find_ratio(const spatial::RigidBody& body) {
  const spatial::Vector& c = body.center;
  const spatial::Tensor of_mass =
      body.mass * (c.squaredNorm() * spatial::Tensor::Identity() - c * c.transpose());
  return (body.inertia.inverse() * of_mass).trace();
}

std::string make_hint(const std::string& name, const spatial::RigidBody& body, double ratio,
                      const std::string& joint) {
  std::ostringstream text;
  text << "the inertia of " << name << " about its centre of mass is " << 1.0 / ratio
       << " of mass times distance from joint " << joint
       << " squared: with formulation \"structured\" a subsystem that has flexible bodies, too, "
          "loses digits below "
       << 1.0 / kMostRatio << "; give an inertia of "
       << body.mass * body.center.squaredNorm() / kMostRatio
       << " kg m^2 or more, or take formulation \"augmented\"";
  return text.str();
}

void look(const spatial::Subsystem& subsystem, std::vector<std::string>& hints) {
  const auto is_rigid = [](const spatial::Body& body) {
    return std::holds_alternative<spatial::RigidBody>(body.shape);
  };
  if (std::all_of(subsystem.bodies.begin(), subsystem.bodies.end(), is_rigid)) return;
  for (const spatial::SubsystemJoint& joint : subsystem.joints) {
    const auto child =
        std::find_if(subsystem.bodies.begin(), subsystem.bodies.end(),
                     [&](const spatial::Body& body) { return body.name == joint.child; });
    if (!turns(joint.joint) || child == subsystem.bodies.end() || !is_rigid(*child)) continue;
    const auto& body = std::get<spatial::RigidBody>(child->shape);
    if (const double ratio = find_ratio(body); ratio > kMostRatio)
      hints.push_back(
          make_hint(subsystem.name + " / " + child->name, body, ratio,
                    joint.joint.name.empty() ? "to " + joint.parent : joint.joint.name));
  }
}

}  // namespace

std::vector<std::string> find_light_body_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  if (scenario.space)
    for (const spatial::Subsystem& subsystem : scenario.space->subsystems) look(subsystem, hints);
  return hints;
}

}  // namespace spoke
