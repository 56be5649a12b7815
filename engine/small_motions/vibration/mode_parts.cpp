// Names, scales and weighs modes.

#include "engine/small_motions/vibration/mode_parts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/support/dense.h"

namespace spoke::vibration {

using steady::SteadyModel;
std::string name_subsystems(const std::vector<std::size_t>& subsystems, const SteadyModel& model) {
  std::vector<std::string> names;
  for (const std::size_t i : subsystems) names.push_back(model.name_of(i));
  return join_names(names);
}

std::vector<std::size_t> find_like(std::size_t i, const std::vector<std::size_t>& alike) {
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < alike.size(); ++k)
    if (alike[k] == i) list.push_back(k);
  return list;
}

Mode make_mode(const Root& root) {
  Mode mode;
  mode.eigenvalue = root.s;
  mode.frequency = std::abs(root.s.imag());
  const double size = std::abs(root.s);
  mode.damping_ratio = size > 0.0 ? 0.0 - root.s.real() / size : 0.0;
  return mode;
}

std::string kind_with_damping(const std::string& kind, std::complex<double> s, double rate) {
  constexpr double kCreeps = 0.05;  // at most of a vibration's rate, by the size of the root
  const bool is_overdamped = s.real() < 0.0 && rate <= kCreeps * std::hypot(s.real(), rate);
  return is_overdamped ? "overdamped " + kind : kind;
}

void normalise(Mode& mode) {
  std::complex<double> largest = 0.0;
  for (const auto& nodes : mode.shape)
    for (const Eigen::Vector3cd& p : nodes)
      for (int c = 0; c < 3; ++c)
        if (std::abs(p[c]) > std::abs(largest)) largest = p[c];
  if (largest == 0.0) return;
  for (auto* field : {&mode.shape, &mode.rotations})
    for (auto& nodes : *field)
      for (Eigen::Vector3cd& v : nodes) v /= largest;
  for (auto& solids : mode.solids)
    for (Eigen::VectorXcd& q : solids) q /= largest;
  mode.hub_displacement /= largest;
  mode.hub_rotation /= largest;
  for (HubShape& hub : mode.hubs) {
    hub.displacement /= largest;
    hub.rotation /= largest;
  }
}

Eigen::Index find_count(const ModeCount& count, Eigen::Index size, const std::string& of,
                        ModesResult& result) {
  if (count.asked > size)
    result.notes.push_back(std::to_string(count.asked) + " modes are asked for, " + of + " has " +
                           std::to_string(size));
  return std::min<Eigen::Index>(count.most, size);
}

bool is_rigid(const Mode& mode) { return mode.eigenvalue == 0.0; }

void set_hub_motion(const Eigen::VectorXcd& x, const Linearised& all, Mode& mode) {
  const std::optional<steady::LinearSupport>& support = all.linear.support;
  const Eigen::VectorXcd hub = support ? Eigen::VectorXcd(support->J * x) : x;
  const std::vector<int>& free = all.model.free_components();
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::complex<double> value = hub[static_cast<Eigen::Index>(k)];
    if (free[k] < all.model.first_rotation())
      mode.hub_displacement[free[k]] = value;
    else
      mode.hub_rotation[all.model.is_spatial() ? free[k] - 3 : 2] = value;
  }
  const steady::SupportedModel* machine = all.model.on_support();
  if (!machine || machine->rotors() == 1) return;
  for (Eigen::Index at = 0; at < hub.size(); at += 6)
    mode.hubs.push_back({hub.segment<3>(at), hub.segment<3>(at + 3)});
}

void add_shape(std::size_t subsystem, const SubsystemShape& shape, SteadyModel& model, Mode& mode) {
  const std::vector<steady::NodePlace> places = model.places(subsystem);
  auto& nodes = mode.shape.emplace_back(shape.nodes);
  auto& rotations = mode.rotations.emplace_back(shape.rotations);
  mode.solids.push_back(shape.solids);
  if (model.stands(subsystem)) return;
  const HubShape hub = mode.hubs.empty() ? HubShape{mode.hub_displacement, mode.hub_rotation}
                                         : mode.hubs[model.on_support()->rotor_of(subsystem)];
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::Vector3cd p = places[k].p.cast<std::complex<double>>();
    nodes[k] += hub.displacement + hub.rotation.cross(p);
    rotations[k] += hub.rotation;
  }
}

Eigen::MatrixXd calc_carried_mass(const steady::LinearModel& linear) {
  return linear.support ? Eigen::MatrixXd(linear.M - linear.support->M) : linear.M;
}

Features list_features(const SubsystemShape& shape) {
  return {shape.motions[2], shape.motions[1], shape.motions[3], shape.motions[0]};
}

std::string name_rotors(const std::vector<double>& motions, const SteadyModel& model) {
  const steady::SupportedModel* machine = model.on_support();
  if (!machine) return {};
  std::vector<double> by_rotor(machine->rotors());
  for (std::size_t i = 0; i < machine->support_index(); ++i)
    by_rotor[machine->rotor_of(i)] += motions[i];
  return machine->name_rotors(by_rotor);
}

namespace {

/// A part of the values of a subsystem that belong to one of the scenario.
struct Share {
  std::size_t subsystem = 0;
  std::ptrdiff_t first_node = 0, nodes = 0, first_solid = 0, solids = 0;
};

/// Lists the shares by the numbers of the scenario's subsystems.
std::map<std::size_t, Share> list_shares(SteadyModel& model) {
  std::map<std::size_t, Share> shares;
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    Share next{i};
    for (const steady::SubsystemPart& part : model.members(i)) {
      next.nodes = std::ssize(part.model->places(part.subsystem));
      next.solids = std::ssize(part.model->solids(part.subsystem));
      shares[part.number] = next;
      next.first_node += next.nodes;
      next.first_solid += next.solids;
    }
  }
  return shares;
}

/// Takes a part of the values of a subsystem; of one that does not move there are none.
template <class T>
std::vector<T> take(const std::vector<T>& all, std::ptrdiff_t first, std::ptrdiff_t count) {
  if (all.empty()) return {};
  return {all.begin() + first, all.begin() + first + count};
}

/// Takes shapes of a machine as a whole, which are along the axes of its base, to those of the hubs
/// that carry them, and sets the motions of these.
void turn_to_hubs(SteadyModel& model, ModesResult& result) {
  std::map<std::size_t, int> rotors;  // of what a hub carries
  for (const steady::SubsystemPart& part : model.members(0))
    if (part.is_carried) rotors[part.number] = part.rotor;
  const std::vector<steady::CarriedHub> hubs = model.carried_hubs({});
  for (Mode& mode : result.modes) {
    std::vector<HubShape> shapes;
    for (const steady::CarriedHub& hub : hubs) {
      const std::vector<int>& bodies = result.equilibrium.blades[hub.carrier].bodies;
      const auto at = static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), hub.body) -
                                               bodies.begin());
      const Eigen::Matrix3cd back = hub.place.axes.transpose().cast<std::complex<double>>();
      shapes.push_back(
          {back * mode.shape[hub.carrier][at], back * mode.rotations[hub.carrier][at]});
    }
    for (const auto& [number, rotor] : rotors) {
      const Eigen::Matrix3cd back =
          hubs[static_cast<std::size_t>(rotor)].place.axes.transpose().cast<std::complex<double>>();
      for (auto* field : {&mode.shape[number], &mode.rotations[number]})
        for (Eigen::Vector3cd& v : *field) v = (back * v).eval();
    }
    if (hubs.empty()) continue;
    mode.hub_displacement = shapes.front().displacement;
    mode.hub_rotation = shapes.front().rotation;
    if (shapes.size() > 1) mode.hubs = std::move(shapes);
  }
}

}  // namespace

void split_shapes(SteadyModel& model, ModesResult& result) {
  const std::map<std::size_t, Share> shares = list_shares(model);
  if (shares.size() == model.subsystems()) return;
  for (Mode& mode : result.modes) {
    const auto split = [&shares](auto& field, auto first, auto count) {
      auto whole = std::exchange(field, {});
      for (const auto& [number, share] : shares)
        field.push_back(take(whole[share.subsystem], share.*first, share.*count));
    };
    split(mode.shape, &Share::first_node, &Share::nodes);
    split(mode.rotations, &Share::first_node, &Share::nodes);
    split(mode.solids, &Share::first_solid, &Share::solids);
  }
  if (model.is_standing_machine()) turn_to_hubs(model, result);
}

std::vector<std::string> list_bodies(const Linearised& all) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    if (all.linear.alike[i] != i) continue;
    const std::vector<std::size_t> like = find_like(i, all.linear.alike);
    const std::string of = name_subsystems(like, all.model);
    for (const std::string& body : all.model.body_names(i))
      names.push_back(like.size() == 1 ? all.model.full_name(i, body) : of + " / " + body);
  }
  return names;
}

EnergySum::EnergySum(const Linearised& all) : model_(all.model), starts_(all.model.subsystems()) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const std::size_t first = all.linear.alike[i];
    starts_[i] = first == i ? count : starts_[first];
    if (first == i) count += all.model.body_names(i).size();
  }
  sum_.bodies.resize(count);
}

void EnergySum::add(std::size_t subsystem, const SubsystemShape& shape) {
  if (model_.stands(subsystem)) {
    sum_.support += shape.total();
  } else {
    sum_.axial += shape.energies[0];
    sum_.lag += shape.energies[1];
    sum_.flap += shape.energies[2];
    sum_.torsion += shape.energies[3];
  }
  weighed_.conservativeResize(weighed_.size() + shape.weighed.size());
  weighed_.tail(shape.weighed.size()) = shape.weighed;
  for (std::size_t k = 0; k < shape.bodies.size(); ++k) {
    double& own = sum_.bodies[starts_[subsystem] + static_cast<std::size_t>(shape.bodies[k])];
    for (const Eigen::VectorXcd& motion : shape.motions)
      own += std::norm(motion[static_cast<Eigen::Index>(k)]);
  }
}

ModeEnergy EnergySum::share_out(double of_hub) const {
  ModeEnergy shares = sum_;
  shares.hub = of_hub;
  const double all = sum_.flap + sum_.lag + sum_.axial + sum_.torsion + sum_.support + of_hub;
  if (!(all > 0.0)) return shares;
  for (double* share :
       {&shares.flap, &shares.lag, &shares.axial, &shares.torsion, &shares.hub, &shares.support})
    *share /= all;
  for (double& share : shares.bodies) share /= all;
  return shares;
}

Eigen::VectorXcd EnergySum::weigh(const Eigen::VectorXcd& hub,
                                  const Eigen::MatrixXd& carried) const {
  if (hub.size() == 0) return weighed_;
  const SymmetricEigen mass = solve_symmetric(carried);
  const Eigen::VectorXd roots = mass.values.cwiseMax(0.0).cwiseSqrt();
  Eigen::VectorXcd list(weighed_.size() + hub.size());
  list << weighed_, mass.vectors * roots.asDiagonal() * (mass.vectors.transpose() * hub);
  return list;
}

}  // namespace spoke::vibration
