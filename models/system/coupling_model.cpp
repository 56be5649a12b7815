#include "models/system/coupling_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <variant>

namespace spoke {
namespace {

/// Returns the value of a prescribed motion at t = 0, at the hub's angle 0.
double start_of(const spatial::Motion& motion, double azimuth) {
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion))
    return table->value.value(0.0);
  if (const auto* program = std::get_if<spatial::ProgramMotion>(&motion)) return program->initial;
  const auto& by_azimuth = std::get<spatial::AzimuthMotion>(motion);
  return by_azimuth.mean + by_azimuth.cosine * std::cos(azimuth) +
         by_azimuth.sine * std::sin(azimuth);
}

/// Finds a coordinate of a joint; adds c q_0 to `rest`.
CoupledCoordinate find_coordinate(const spatial::Tree& tree, const CoupledJoint& at, double& rest) {
  const auto body =
      std::find_if(tree.bodies.begin(), tree.bodies.end(),
                   [&at](const spatial::TreeBody& own) { return own.joint.name == at.joint; });
  assert(body != tree.bodies.end());
  const spatial::Joint& joint = body->joint;
  const auto c = static_cast<std::size_t>(at.coordinate - 1);
  const spatial::JointCoordinate& own = joint.coordinates[c];
  CoupledCoordinate made;
  made.body = static_cast<int>(body - tree.bodies.begin());
  made.is_driven = own.motion.has_value();
  made.slides = slides(joint.kind, at.coordinate - 1);
  made.ratio = at.ratio;
  for (std::size_t k = 0; k < c; ++k)
    made.component += joint.coordinates[k].motion.has_value() == made.is_driven;
  rest += at.ratio * (own.motion ? start_of(*own.motion, tree.azimuth) : own.initial);
  return made;
}

}  // namespace

LoopModel make_coupling_share(const spatial::Tree& tree, const Coupling& coupling) {
  LoopModel made;
  LoopRow row;
  row.kind = LoopRow::Kind::coupling;
  row.stiffness = coupling.stiffness;
  row.damping = coupling.damping;
  for (const CoupledJoint& at : coupling.joints)
    if (!at.is_elsewhere()) made.coupled.push_back(find_coordinate(tree, at, row.rest));
  made.rows.push_back(row);
  made.name = coupling.name;
  made.owner = tree.name;
  if (made.is_coupling()) made.from.body = made.coupled.front().body;
  made.to.carrier = LoopPlace::Carrier::hub;
  return made;
}

LoopModel make_coupling(const spatial::Tree& tree, std::size_t coupling) {
  assert(coupling < tree.couplings.size());
  LoopModel made = make_coupling_share(tree, tree.couplings[coupling]);
  made.key = tree.key + ".coupling." + std::to_string(coupling + 1);
  return made;
}

}  // namespace spoke
