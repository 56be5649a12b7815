// Makes a model for each state, since speed and pitch are constants of it.

#include "engine/small_motions/steady/rotor_in_wind.h"

#include <algorithm>
#include <utility>

#include "models/error.h"

namespace spoke::steady {
namespace {

/// Holds the joints of a rotor by these names at an angle.
void hold(int rotor, const std::vector<std::string>& names, double angle, spatial::Model& model) {
  const auto hold_joint = [&](spatial::Joint& joint) {
    if (!joint.name.empty() && std::find(names.begin(), names.end(), joint.name) != names.end())
      joint.coordinates[0].motion = spatial::MotionTable{Curve(angle)};
  };
  for (spatial::Blade& blade : model.blades)
    if (blade.rotor == rotor)
      for (spatial::BladeJoint& joint : blade.joints) hold_joint(joint.joint);
  for (spatial::Subsystem& subsystem : model.subsystems)
    if (subsystem.rotor == rotor)
      for (spatial::SubsystemJoint& joint : subsystem.joints) hold_joint(joint.joint);
}

Eigen::Vector3d direction_of(const spatial::Model& model, int rotor) {
  const Eigen::Vector3d& velocity = model.air->wind.velocity;
  return velocity.isZero(0.0) ? Eigen::Vector3d(hub_of(model, rotor).axis.normalized())
                              : Eigen::Vector3d(velocity.normalized());
}

}  // namespace

RotorInWind::RotorInWind(const Scenario& scenario, int rotor,
                         const std::vector<std::string>& joints, bool is_rigid)
    : scenario_(scenario),
      rotor_(rotor),
      joints_(joints),
      is_rigid_(is_rigid),
      direction_(direction_of(*scenario.space, rotor)) {
  scenario_.sensors.clear();
  scenario_.space->pitch_control.reset();  // they would add their angle at the start
  scenario_.space->outer_control.reset();
  scenario_.space->events.clear();
}

/// Returns the state at which the rotor is evaluated; the model is left there.
Equilibrium RotorInWind::find_state(SteadyModel& model) {
  if (is_rigid_) {
    Equilibrium undeformed;
    for (std::size_t i = 0; i < model.subsystems(); ++i) {
      undeformed.q.push_back(model.initial(i));
      SubsystemResponse response;
      model.evaluate(i, make_state(undeformed.q.back()), model.no_offset(), response);
    }
    return undeformed;
  }
  if (at_)
    if (std::optional<Equilibrium> near = continue_equilibrium(*at_, *before_, model)) return *near;
  Equilibrium found = find_equilibrium(model);
  require_held(found);
  return found;
}

RotorAnswer RotorInWind::find(double wind, double speed, std::optional<double> angle) {
  scenario_.space->air->wind = Wind{};
  scenario_.space->air->wind.velocity = wind * direction_;
  if (angle) hold(rotor_, joints_, *angle, *scenario_.space);
  std::unique_ptr<SteadyModel> model =
      make_rotor_model(scenario_, rotor_, {.speed = speed, .is_axial = true});
  Equilibrium state = find_state(*model);
  RotorAnswer answer;
  for (std::size_t i = 0; i < model->subsystems(); ++i) {
    const std::optional<SubsystemAir> air = model->air(i);
    if (!air) continue;
    answer.thrust += air->thrust;
    answer.torque += air->torque;
  }
  answer.tip_displacement = is_rigid_ ? 0.0 : model->tip(0).displacement.z();
  if (!is_rigid_) {
    before_ = std::move(model);
    at_ = std::move(state);
  }
  return answer;
}

}  // namespace spoke::steady
