// Finds vibrations by the linear model, and displaces runs.

#include "tests/engine/laws/vibrations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/modes.h"
#include "engine/simulation/simulation_core.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/choose_frame.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"
#include "tests/engine/serial.h"

namespace spoke::test {
namespace {

using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr int kRigid = 6;  ///< most rigid motions of a model

/// Whether it is more than a rigid motion, whose eigenvalue is zero.
bool vibrates(Complex rate) { return std::abs(rate) > 1e-6; }

/// The linear model of a scenario.
struct Linear {
  Linear(const Scenario& scenario, bool is_axial)
      : model(steady::make_steady_model(
            scenario,
            steady::at_speeds(steady::find_steady_speeds(scenario, {}), {.is_axial = is_axial}))),
        equilibrium(steady::find_machine_equilibrium(*model)),
        linear(steady::linearize_machine(equilibrium, *model)) {}

  std::unique_ptr<steady::SteadyModel> model;
  steady::Equilibrium equilibrium;
  steady::LinearModel linear;
};

void append(const VectorXcd& part, VectorXcd& motion) {
  motion.conservativeResize(motion.size() + part.size());
  motion.tail(part.size()) = part;
}

/// Returns the motion of a rotor that is seen from outside, at an azimuth of its hub [rad].
VectorXcd move_rotor(const Linear& all, const vibration::FixedFrame& frame, const VectorXcd& x,
                     double azimuth) {
  VectorXcd motion = x.head(all.linear.M.rows());
  for (std::size_t i = 0; i < all.model->subsystems(); ++i)
    append(all.linear.motion_of(i, frame.motion_of(i, x, azimuth), x.head(all.linear.M.rows())),
           motion);
  return motion;
}

/// Returns the azimuth of a rotor on a support at the start: a shaft is twisted against a drive
/// that is held [rad].
double start_azimuth(std::size_t r, const Linear& all, const Scenario& scenario) {
  const auto& train = all.model->on_support()->parts(r).train;
  const bool is_held = prescribes_motion(hub_of(*scenario.space, static_cast<int>(r)).drive);
  return train && is_held ? -all.equilibrium.wrenches[r][5] / train->stiffness : 0.0;
}

/// Returns the motion of rotors on a support that are seen from outside, at a time [s]: of a base
/// that is free, of rotors, of the support and of axles.
VectorXcd move_machine(const Linear& all, const Scenario& scenario,
                       const vibration::FixedFrame& frame, const VectorXcd& x, double t) {
  const steady::LinearSupport& support = *all.linear.support;
  const VectorXcd z = x.head(support.J.cols());
  const steady::SupportedModel& machine = *all.model->on_support();
  VectorXcd motion(0);
  if (all.model->is_hub_free()) append(support.base * z, motion);
  for (std::size_t i = 0; i < machine.support_index(); ++i) {
    const std::size_t r = machine.rotor_of(i);
    const double azimuth = start_azimuth(r, all, scenario) + machine.parts(r).speed * t;
    append(frame.motion_of(i, x, azimuth), motion);
  }
  append(support.motion * z, motion);
  for (const auto& axle : support.axles)
    if (axle) append(z.segment(*axle, 1), motion);
  return motion;
}

/// Lists those of a rotor that is seen from outside, by roots in that frame.
std::vector<Vibration> list_from_outside(const Scenario& scenario, std::size_t count) {
  const double speed = steady_speed(scenario);
  const auto all = std::make_shared<const Linear>(scenario, true);
  const auto frame = std::make_shared<const vibration::FixedFrame>(
      vibration::see_from_outside({*all->model, all->equilibrium, all->linear}));
  std::vector<Vibration> list;
  for (const vibration::Root& root :
       vibration::find_fixed_roots(*frame, static_cast<Eigen::Index>(count) + kRigid)) {
    if (!vibrates(root.s) || list.size() == count) continue;
    list.push_back({"root " + std::to_string(list.size() + 1), root.s,
                    [all, frame, root, speed, scenario](double t) {
                      const VectorXcd x = root.x * std::exp(root.s * t);
                      return all->linear.support ? move_machine(*all, scenario, *frame, x, t)
                                                 : move_rotor(*all, *frame, x, speed * t);
                    }});
  }
  return list;
}

/// Returns the motion of all subsystems in a mode of one kind of them that does not couple.
VectorXcd spread(const Linear& all, const Mode& mode) {
  VectorXcd motion(0);
  for (std::size_t i = 0; i < all.model->subsystems(); ++i) {
    const bool moves = !mode.shape[all.linear.alike[i]].empty();
    append(moves ? mode.coordinates : VectorXcd::Zero(std::ssize(all.model->coordinates(i))),
           motion);
  }
  return motion;
}

/// Lists those seen from a hub, by their modes.
std::vector<Vibration> list_of_hub(const Scenario& scenario, std::size_t count) {
  const double speed = steady_speed(scenario);
  const ModesResult modes = solve_modes(scenario, {.count = static_cast<int>(count) + kRigid});
  const Linear all(scenario, false);
  // The place of a free hub in the plane is along axes that stand.
  const bool stands = !scenario.space && scenario.rotor.hub.support == HubSupport::free;
  std::vector<Vibration> list;
  for (const Mode& mode : modes.modes) {
    if (!vibrates(mode.eigenvalue) || list.size() == count) continue;
    const VectorXcd x = modes.are_blades_coupled ? mode.coordinates : spread(all, mode);
    list.push_back(
        {mode.name, mode.eigenvalue, [x, rate = mode.eigenvalue, speed, stands](double t) {
           VectorXcd motion = x * std::exp(rate * t);
           if (stands) motion.head<2>() = Eigen::Rotation2Dd(speed * t).matrix() * motion.head<2>();
           return motion;
         }});
  }
  return list;
}

}  // namespace

VectorXd Vibration::start_velocities() const {
  const double step = 1e-4 / std::abs(rate);
  return (motion(step) - motion(-step)).real() / (2.0 * step);
}

double steady_speed(const Scenario& scenario) {
  return steady::find_steady_speed(scenario, 0, std::nullopt);
}

std::vector<Vibration> list_vibrations(const Scenario& scenario, std::size_t count) {
  if (vibration::choose_frame(scenario, std::nullopt) == ModeFrame::fixed)
    return list_from_outside(scenario, count);
  return list_of_hub(scenario, count);
}

void Displaced::add_place(const CoordinateBlock& block, int at) {
  places_.push_back({block.q + at, block.v + at});
}

void Displaced::add_joint(const BodyData<Plane>&) {}
void Displaced::add_joint(const BodyData<Space>& body) {
  for (int k = 0; k < body.joint.coordinates.size; ++k) add_place(body.joint.coordinates, k);
}

template <class World>
void Displaced::find_places(SystemContext<World>& context) {
  for (int c = 0; c < World::kTwist; ++c)
    if (!is_prescribed(context.system.hub, c)) add_place(context.data.hub_coordinates, c);
  for (const SubsystemData<World>& subsystem : context.data.subsystems)
    for (const BodyData<World>& body : subsystem.bodies) {
      add_joint(body);
      const int count = body.model->body->coordinates();
      for (int k = 0; k < count; ++k) add_place(body.coordinates, body.layout.offset(k));
    }
}

Displaced::Displaced(const Scenario& scenario)
    : simulation_(scenario, kSerial),
      start_(simulation_.save()),
      turns_in_space_(scenario.space && scenario.space->hub.support == HubSupport::free) {
  SimulatedModel& model = *core_of(simulation_).model;
  if (scenario.space && scenario.space->support &&
      scenario.space->support->from == spatial::SupportBase::free)
    flying_ = &model.space()->data;
  if (scenario.space)
    find_places(*model.space());
  else
    find_places(*model.plane());
}

VectorXd Displaced::take() const {
  VectorXd values(std::ssize(places_));
  std::transform(places_.begin(), places_.end(), values.begin(),
                 [](const Place& place) { return *place.q; });
  if (turns_in_space_ || flying_) {
    const Eigen::AngleAxisd turn(flying_ ? Eigen::Matrix3d(calc_hub_state(*flying_).R.axes)
                                         : simulation_.hub_pose().rotation);
    values.segment<3>(3) = turn.angle() * turn.axis();
  }
  return values;
}

std::vector<VectorXd> Displaced::run(const VectorXd& displacement, const VectorXd& velocities,
                                     int steps) {
  assert(displacement.size() == std::ssize(places_));
  simulation_.restore(start_);
  for (Eigen::Index k = 0; k < displacement.size(); ++k) {
    *places_[static_cast<std::size_t>(k)].q += displacement[k];
    *places_[static_cast<std::size_t>(k)].v += velocities[k];
  }
  core_of(simulation_).renew();
  std::vector<VectorXd> history{take()};
  for (int step = 0; step < steps; ++step) {
    simulation_.step();
    history.push_back(take());
  }
  return history;
}

}  // namespace spoke::test
