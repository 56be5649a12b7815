// Joins a rotor and its support, and finds the equilibrium of both.

#include "engine/small_motions/steady/supported_model.h"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>
#include <numbers>
#include <sstream>

#include "models/error.h"
#include "models/space/rotation_vector.h"

namespace spoke::steady {
namespace {

using Eigen::Matrix3d;

/// Returns a wrench along other axes, into which `turn` takes it.
HubVector turn_parts(const Matrix3d& turn, const HubVector& wrench) {
  HubVector turned(6);
  turned << turn * wrench.head<3>(), turn * wrench.tail<3>();
  return turned;
}

/// Returns what the subsystems and the hub itself exert on the hub, in its frame.
HubVector sum_forces(const Equilibrium& equilibrium, const HubOffset& hub, SteadyModel& model) {
  HubVector sum = model.hub_force(hub);
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    SubsystemResponse response;
    model.evaluate(i, make_state(equilibrium, i), hub, response);
    sum += response.hub_force;
  }
  return sum;
}

void evaluate_initial(SteadyModel& support) {
  SubsystemResponse response;
  support.evaluate(0, make_state(support.initial(0)), support.no_offset(), response);
}

}  // namespace

SupportedModel::SupportedModel(SupportedParts parts, double speed) : parts_(std::move(parts)) {
  speed_ = speed;
  support_ = parts_.support(HubVector::Zero(6));
  evaluate_initial(*support_);
  move_rotor(hub_place().axes);
  other_sensors_ = rotor_->other_sensors();
  const std::vector<std::string>& more = support_->other_sensors();
  other_sensors_.insert(other_sensors_.end(), more.begin(), more.end());
}

NodePlace SupportedModel::hub_place() const { return support_->places(0).back(); }

std::unique_ptr<SteadyModel> SupportedModel::move_rotor(const Matrix3d& axes) {
  axes_ = parts_.base * axes;
  return std::exchange(rotor_, parts_.rotor(axes_, DeadLoads::steady));
}

std::unique_ptr<SteadyModel> SupportedModel::load_support(const HubVector& wrench) {
  wrench_ = turn_parts(axes_, wrench);
  return std::exchange(support_, parts_.support(wrench_));
}

void SupportedModel::stand_like(const SupportedModel& other) {
  axes_ = other.axes_;
  wrench_ = other.wrench_;
  rotor_ = parts_.rotor(axes_, DeadLoads::steady);
  support_ = parts_.support(wrench_);
}

void SupportedModel::turn_rotor(double azimuth) {
  const Eigen::AngleAxisd about(azimuth, Eigen::Vector3d::UnitZ());
  rotor_ = parts_.rotor(axes_ * about.matrix(), DeadLoads::all);
}

void SupportedModel::set_share(double share) {
  rotor_->set_share(share);
  support_->set_share(share);
}

HubVector SupportedModel::mean_wrench(const Equilibrium& equilibrium, const HubVector& turn,
                                      DeadLoads loads) const {
  HubVector mean = HubVector::Zero(6);
  // What turns with the rotor, or once against it, is opposite at opposite azimuths.
  const std::vector<double> azimuths =
      parts_.averages ? std::vector<double>{0.0, std::numbers::pi} : std::vector<double>{0.0};
  for (const double azimuth : azimuths) {
    const Matrix3d about = Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()).matrix();
    const std::unique_ptr<SteadyModel> model = parts_.rotor(axes_ * about, loads);
    for (std::size_t i = 0; i < model->subsystems(); ++i)
      model->settle_at(i, rotor_->absolute(i, equilibrium.q[i]));
    HubOffset offset = model->no_offset();
    offset.turn = turn_parts(about.transpose(), turn);
    const Matrix3d turned = space::exponential(Eigen::Vector3d(turn.tail<3>())).axes * about;
    mean += turn_parts(turned, sum_forces(equilibrium, offset, *model)) /
            static_cast<double>(azimuths.size());
  }
  return mean;
}

SupportedEquilibrium split(const Equilibrium& all, const SupportedModel& model) {
  const std::size_t count = model.support_index();
  assert(all.q.size() == count + 1);
  SupportedEquilibrium parts{all, all};
  const auto divide = [count](auto& rotor, auto& support) {
    support = {rotor[count]};
    rotor.pop_back();
  };
  divide(parts.rotor.q, parts.support.q);
  divide(parts.rotor.multipliers, parts.support.multipliers);
  divide(parts.rotor.rows, parts.support.rows);
  parts.rotor.alike.pop_back();
  parts.support.alike = {0};
  parts.rotor.wrench = -sum_forces(parts.rotor, model.rotor().no_offset(), model.rotor());
  parts.support.wrench = -sum_forces(parts.support, model.support().no_offset(), model.support());
  return parts;
}

namespace {

Equilibrium join(const SupportedEquilibrium& parts) {
  Equilibrium all = parts.rotor;
  all.q.push_back(parts.support.q[0]);
  all.multipliers.push_back(parts.support.multipliers[0]);
  all.rows.push_back(parts.support.rows[0]);
  all.alike.push_back(all.alike.size());
  all.iterations += parts.support.iterations;
  all.load_steps = std::max(all.load_steps, parts.support.load_steps);
  all.last_change = std::max(all.last_change, parts.support.last_change);
  all.force_scale += parts.support.force_scale;
  if (all.loose.empty()) all.loose = parts.support.loose;
  return all;
}

/// Goes on from an equilibrium of another model of the same bodies, or searches anew.
Equilibrium go_on(const Equilibrium& at, const SteadyModel& before, SteadyModel& model,
                  Tangents* kept = nullptr) {
  std::optional<Equilibrium> found = continue_equilibrium(at, before, model, kept);
  Equilibrium result = found ? std::move(*found) : find_equilibrium(model);
  result.iterations += at.iterations;
  result.load_steps = std::max(result.load_steps, at.load_steps);
  return result;
}

/// Turns the wrench of the rotor and the place of the hub into one another until they agree.
Equilibrium iterate(SupportedEquilibrium parts, SupportedModel& model) {
  constexpr int kMost = 60;
  constexpr double kSettled = 1e-12;  // change of the hub's axes [rad]
  Matrix3d axes = model.hub_place().axes;
  double change = 0.0;
  Tangents of_rotor, of_support;
  for (int k = 0; k < kMost; ++k) {
    const std::unique_ptr<SteadyModel> rotor = model.move_rotor(axes);
    parts.rotor = go_on(parts.rotor, *rotor, model.rotor(), &of_rotor);
    const HubVector wrench = model.mean_wrench(parts.rotor, HubVector::Zero(6), DeadLoads::all);
    const std::unique_ptr<SteadyModel> support = model.load_support(wrench);
    parts.support = go_on(parts.support, *support, model.support(), &of_support);
    const Matrix3d next = model.hub_place().axes;
    change = space::logarithm(space::Rotation{next * axes.transpose()}).norm();
    if (change <= kSettled) {
      parts.rotor.wrench = -wrench;
      return join(parts);
    }
    axes = next;
  }
  std::ostringstream text;
  text << "no equilibrium found at " << model.speed()
       << " rad/s: rotor and support do not settle, the axle still turns by " << change
       << " rad between two trials; the support is too soft for the weight of the rotor and the "
          "loads on it";
  throw DivergenceError(text.str(),
                        {.subsystem = model.name_of(model.support_index()), .quantity = "axle"});
}

/// Throws if a torque acts on a rotor whose axle turns freely.
void require_free_axle(const SupportedModel& model, const Equilibrium& equilibrium) {
  if (!model.parts().turns_freely || model.has_torque_drive()) return;
  const double left = std::abs(equilibrium.wrench[5]);
  if (left <= 1e-6 * equilibrium.force_scale + 1e-9) return;
  std::ostringstream text;
  text << "the axle turns freely, and " << left << " N m act on the rotor at " << model.speed()
       << " rad/s: it has no steady motion there, expected forces that balance";
  throw InputError(text.str());
}

Equilibrium find_on_support(SupportedModel& model) {
  SupportedEquilibrium parts;
  parts.support = find_equilibrium(model.support());
  parts.rotor = find_equilibrium(model.rotor());
  return iterate(std::move(parts), model);
}

std::optional<Equilibrium> continue_on_support(const Equilibrium& at, const SupportedModel& before,
                                               SupportedModel& model) {
  SupportedEquilibrium parts = split(at, before);
  try {
    parts.support = go_on(parts.support, before.support(), model.support());
    parts.rotor = go_on(parts.rotor, before.rotor(), model.rotor());
    return iterate(std::move(parts), model);
  } catch (const DivergenceError&) {
    return std::nullopt;
  }
}

}  // namespace

Equilibrium find_machine_equilibrium(SteadyModel& model) {
  SupportedModel* machine = model.on_support();
  return machine ? find_on_support(*machine) : find_equilibrium(model);
}

std::optional<Equilibrium> continue_machine_equilibrium(const Equilibrium& at,
                                                        const SteadyModel& before,
                                                        SteadyModel& model) {
  SupportedModel* machine = model.on_support();
  return machine ? continue_on_support(at, *before.on_support(), *machine)
                 : continue_equilibrium(at, before, model);
}

void require_steady_machine(SteadyModel& model, const Equilibrium& equilibrium) {
  SupportedModel* machine = model.on_support();
  if (!machine) return require_steady_hub(model, equilibrium);
  require_free_axle(*machine, equilibrium);
  require_steady_hub(machine->support(), split(equilibrium, *machine).support);
}

}  // namespace spoke::steady
