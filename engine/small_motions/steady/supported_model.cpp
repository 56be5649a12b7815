// Joins rotors and their support, and finds the equilibrium of all.

#include "engine/small_motions/steady/supported_model.h"

#include <Eigen/Geometry>
#include <algorithm>
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

SupportedModel::SupportedModel(SupportedParts parts) : parts_(std::move(parts)) {
  speed_ = parts_.rotors.front().speed;
  std::size_t count = 0;
  for (const RotorParts& rotor : parts_.rotors) count += rotor.subsystems.size();
  places_.resize(count);
  for (std::size_t r = 0; r < rotors(); ++r)
    for (std::size_t own = 0; own < parts_.rotors[r].subsystems.size(); ++own)
      places_[parts_.rotors[r].subsystems[own]] = {r, own};
  support_ = parts_.support(std::vector<HubVector>(rotors(), HubVector::Zero(6)));
  evaluate_initial(*support_);
  rotors_.resize(rotors());
  axes_.resize(rotors());
  wrenches_.assign(rotors(), HubVector::Zero(6));
  const auto add = [this](const std::vector<std::string>& more) {
    other_sensors_.insert(other_sensors_.end(), more.begin(), more.end());
  };
  for (std::size_t r = 0; r < rotors(); ++r) {
    move_rotor(r, hub_place(r).axes);
    add(rotor(r).other_sensors());
  }
  add(support_->other_sensors());
}

bool SupportedModel::turns() const {
  return std::any_of(parts_.rotors.begin(), parts_.rotors.end(),
                     [](const RotorParts& rotor) { return rotor.speed != 0.0; });
}

std::vector<SubsystemPart> SupportedModel::members(std::size_t i) {
  std::vector<SubsystemPart> members = of(i).members(in(i));
  for (SubsystemPart& part : members) {
    part.number = stands(i) ? parts_.trees : parts(rotor_of(i)).trees[part.number];
    part.rotor = stands(i) ? 0 : static_cast<int>(rotor_of(i));
    part.is_carried = !stands(i);
  }
  return members;
}

std::vector<CarriedHub> SupportedModel::carried_hubs(const std::vector<HubVector>& wrenches) const {
  assert(wrenches.size() == rotors());
  std::vector<CarriedHub> hubs;
  for (std::size_t r = 0; r < rotors(); ++r)
    hubs.push_back(
        {parts(r).name, parts(r).speed, hub_place(r), wrenches[r], parts_.trees, parts(r).body});
  return hubs;
}

std::string SupportedModel::name_rotors(const std::vector<double>& motions) const {
  constexpr double kAlike = 0.5;  // of the largest
  if (rotors() == 1 || motions.empty()) return {};
  const double most = *std::max_element(motions.begin(), motions.end());
  std::string names;
  for (std::size_t r = 0; r < motions.size(); ++r)
    if (motions[r] > 0.0 && motions[r] >= kAlike * most)
      names += (names.empty() ? "" : " + ") + parts(r).name;
  return names.empty() ? names : names + ": ";
}

NodePlace SupportedModel::hub_place(std::size_t r) const {
  const std::vector<NodePlace> places = support_->places(0);
  const auto hub = std::find_if(places.begin(), places.end(), [&](const NodePlace& place) {
    return place.body == parts(r).body;
  });
  assert(hub != places.end());
  return *hub;
}

std::unique_ptr<SteadyModel> SupportedModel::move_rotor(std::size_t r, const Matrix3d& axes) {
  axes_[r] = parts_.base * axes;
  return std::exchange(rotors_[r], parts(r).make(axes_[r], DeadLoads::steady));
}

std::unique_ptr<SteadyModel> SupportedModel::load_support(const std::vector<HubVector>& wrenches) {
  for (std::size_t r = 0; r < rotors(); ++r) wrenches_[r] = turn_parts(axes_[r], wrenches[r]);
  return std::exchange(support_, parts_.support(wrenches_));
}

void SupportedModel::stand_like(const SupportedModel& other) {
  axes_ = other.axes_;
  wrenches_ = other.wrenches_;
  for (std::size_t r = 0; r < rotors(); ++r)
    rotors_[r] = parts(r).make(axes_[r], DeadLoads::steady);
  support_ = parts_.support(wrenches_);
}

void SupportedModel::turn_rotors(double azimuth) {
  const Eigen::AngleAxisd about(azimuth, Eigen::Vector3d::UnitZ());
  for (std::size_t r = 0; r < rotors(); ++r)
    rotors_[r] = parts(r).make(axes_[r] * about.matrix(), DeadLoads::all);
}

void SupportedModel::set_share(double share) {
  for (const auto& rotor : rotors_) rotor->set_share(share);
  support_->set_share(share);
}

HubVector SupportedModel::mean_wrench(std::size_t r, const Equilibrium& equilibrium,
                                      const HubVector& turn, DeadLoads loads) const {
  HubVector mean = HubVector::Zero(6);
  // What turns with the rotor, or once against it, is opposite at opposite azimuths.
  const std::vector<double> azimuths =
      parts(r).averages ? std::vector<double>{0.0, std::numbers::pi} : std::vector<double>{0.0};
  for (const double azimuth : azimuths) {
    const Matrix3d about = Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()).matrix();
    const std::unique_ptr<SteadyModel> model = parts(r).make(axes_[r] * about, loads);
    for (std::size_t i = 0; i < model->subsystems(); ++i)
      model->settle_at(i, rotor(r).absolute(i, equilibrium.q[i]));
    HubOffset offset = model->no_offset();
    offset.turn = turn_parts(about.transpose(), turn);
    const Matrix3d turned = space::exponential(Eigen::Vector3d(turn.tail<3>())).axes * about;
    mean += turn_parts(turned, sum_forces(equilibrium, offset, *model)) /
            static_cast<double>(azimuths.size());
  }
  return mean;
}

namespace {

/// Returns the equilibrium of some subsystems of one of all.
Equilibrium choose(const Equilibrium& all, const std::vector<std::size_t>& subsystems) {
  Equilibrium own = all;
  own.q.clear();
  own.multipliers.clear();
  own.rows.clear();
  own.alike.clear();
  for (const std::size_t i : subsystems) {
    own.q.push_back(all.q[i]);
    own.multipliers.push_back(all.multipliers[i]);
    own.rows.push_back(all.rows[i]);
    const auto first = std::find(subsystems.begin(), subsystems.end(), all.alike[i]);
    own.alike.push_back(static_cast<std::size_t>(first - subsystems.begin()));
  }
  return own;
}

/// Puts the equilibrium of some subsystems into one of all.
void put(const Equilibrium& own, const std::vector<std::size_t>& subsystems, Equilibrium& all) {
  for (std::size_t k = 0; k < subsystems.size(); ++k) {
    all.q[subsystems[k]] = own.q[k];
    all.multipliers[subsystems[k]] = own.multipliers[k];
    all.rows[subsystems[k]] = own.rows[k];
    all.alike[subsystems[k]] = subsystems[own.alike[k]];
  }
}

}  // namespace

SupportedEquilibrium split(const Equilibrium& all, const SupportedModel& model) {
  assert(all.q.size() == model.subsystems());
  SupportedEquilibrium parts;
  for (std::size_t r = 0; r < model.rotors(); ++r) {
    const SteadyModel& rotor = model.rotor(r);
    Equilibrium& own = parts.rotors.emplace_back(choose(all, model.parts(r).subsystems));
    own.wrench = -sum_forces(own, rotor.no_offset(), model.rotor(r));
  }
  parts.support = choose(all, {model.support_index()});
  parts.support.wrench = -sum_forces(parts.support, model.support().no_offset(), model.support());
  return parts;
}

namespace {

Equilibrium join(const SupportedEquilibrium& parts, const SupportedModel& model) {
  Equilibrium all = parts.rotors.front();
  const std::size_t count = model.subsystems();
  all.wrenches.clear();
  all.q.resize(count);
  all.multipliers.resize(count);
  all.rows.resize(count);
  all.alike.resize(count);
  const auto add = [&all](const Equilibrium& more) {
    all.iterations += more.iterations;
    all.load_steps = std::max(all.load_steps, more.load_steps);
    all.last_change = std::max(all.last_change, more.last_change);
    all.force_scale += more.force_scale;
    if (all.loose.empty()) all.loose = more.loose;
  };
  for (std::size_t r = 0; r < model.rotors(); ++r) {
    put(parts.rotors[r], model.parts(r).subsystems, all);
    all.wrenches.push_back(parts.rotors[r].wrench);
    if (r > 0) add(parts.rotors[r]);
  }
  put(parts.support, {model.support_index()}, all);
  add(parts.support);
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

/// Turns the wrenches of the rotors and the places of the hubs into one another until they agree.
Equilibrium iterate(SupportedEquilibrium parts, SupportedModel& model) {
  constexpr int kMost = 60;
  constexpr double kSettled = 1e-12;  // change of a hub's axes [rad]
  const std::size_t count = model.rotors();
  std::vector<Matrix3d> axes;
  for (std::size_t r = 0; r < count; ++r) axes.push_back(model.hub_place(r).axes);
  double change = 0.0;
  std::vector<Tangents> of_rotors(count);
  Tangents of_support;
  for (int k = 0; k < kMost; ++k) {
    std::vector<HubVector> wrenches;
    for (std::size_t r = 0; r < count; ++r) {
      const std::unique_ptr<SteadyModel> before = model.move_rotor(r, axes[r]);
      Equilibrium& own = parts.rotors[r];
      own = go_on(own, *before, model.rotor(r), &of_rotors[r]);
      wrenches.push_back(model.mean_wrench(r, own, HubVector::Zero(6), DeadLoads::all));
    }
    const std::unique_ptr<SteadyModel> support = model.load_support(wrenches);
    parts.support = go_on(parts.support, *support, model.support(), &of_support);
    bool has_settled = true;
    for (std::size_t r = 0; r < count; ++r) {
      const Matrix3d next = model.hub_place(r).axes;
      const double turned = space::logarithm(space::Rotation{next * axes[r].transpose()}).norm();
      has_settled = has_settled && turned <= kSettled;
      change = r == 0 ? turned : std::max(change, turned);
      axes[r] = next;
    }
    if (!has_settled) continue;
    for (std::size_t r = 0; r < count; ++r) parts.rotors[r].wrench = -wrenches[r];
    return join(parts, model);
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
void require_free_axle(std::size_t r, const SupportedModel& model, const Equilibrium& equilibrium) {
  const RotorParts& rotor = model.parts(r);
  if (!rotor.turns_freely || rotor.has_torque) return;
  const double left = std::abs(equilibrium.wrenches[r][5]);
  if (left <= 1e-6 * equilibrium.force_scale + 1e-9) return;
  std::ostringstream text;
  text << "the axle " << (model.rotors() > 1 ? "of \"" + rotor.name + "\" " : "")
       << "turns freely, and " << left << " N m act on the rotor at " << rotor.speed
       << " rad/s: it has no steady motion there, expected forces that balance";
  throw InputError(text.str());
}

Equilibrium find_on_support(SupportedModel& model) {
  SupportedEquilibrium parts;
  parts.support = find_equilibrium(model.support());
  for (std::size_t r = 0; r < model.rotors(); ++r)
    parts.rotors.push_back(find_equilibrium(model.rotor(r)));
  return iterate(std::move(parts), model);
}

std::optional<Equilibrium> continue_on_support(const Equilibrium& at, const SupportedModel& before,
                                               SupportedModel& model) {
  SupportedEquilibrium parts = split(at, before);
  try {
    parts.support = go_on(parts.support, before.support(), model.support());
    for (std::size_t r = 0; r < model.rotors(); ++r)
      parts.rotors[r] = go_on(parts.rotors[r], before.rotor(r), model.rotor(r));
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
  for (std::size_t r = 0; r < machine->rotors(); ++r) require_free_axle(r, *machine, equilibrium);
  require_steady_hub(machine->support(), split(equilibrium, *machine).support);
}

}  // namespace spoke::steady
