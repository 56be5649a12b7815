// Puts the members of groups together, and takes their coordinates and rows apart.

#include "engine/small_motions/steady/tied_model.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <utility>

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kTwist = 6;

template <class T>
void append(std::vector<T> more, std::vector<T>& list) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

}  // namespace

TiedModel::TiedModel(std::unique_ptr<SteadySystem<Space>> base, std::vector<std::string> rotors)
    : base_(std::move(base)), rotors_(std::move(rotors)) {
  assert(rotors_.size() == base_->system().rotors.size());
  speed_ = base_->speed();
  for (const std::vector<std::size_t>& subsystems : group_subsystems(base_->system()))
    groups_.push_back(make_group(subsystems));
}

TiedModel::Group TiedModel::make_group(const std::vector<std::size_t>& subsystems) const {
  Group group;
  group.subsystems = subsystems;
  std::vector<std::string> names;
  for (const std::size_t i : subsystems) names.push_back(base_->name_of(i));
  group.name = is_standing_machine() ? "all" : join_names(names);
  const bool is_alone = subsystems.size() == 1;
  group.starts.push_back(0);
  group.body_starts.push_back(0);
  for (const std::size_t i : subsystems) {
    const std::string of = is_alone ? "" : base_->name_of(i) + " / ";
    for (SubsystemCoordinate coordinate : base_->coordinates(i)) {
      coordinate.name = of + coordinate.name;
      coordinate.body += static_cast<int>(group.bodies.size());
      group.coordinates.push_back(std::move(coordinate));
    }
    for (const std::string& body : base_->body_names(i)) group.bodies.push_back(of + body);
    append(base_->outputs(i), group.outputs);
    group.starts.push_back(std::ssize(group.coordinates));
    group.body_starts.push_back(group.bodies.size());
  }
  for (std::size_t m = 0; m < subsystems.size(); ++m) add_rows(m, group);
  take_rows(group);
  return group;
}

/// Adds the rows of the loops of a member that are not shares of others, each with its shares.
void TiedModel::add_rows(std::size_t member, Group& group) const {
  const auto member_at = [&group](const LoopAt& at) {
    const auto subsystem = static_cast<std::size_t>(at.subsystem);
    const auto found = std::find(group.subsystems.begin(), group.subsystems.end(), subsystem);
    assert(found != group.subsystems.end());
    return static_cast<std::size_t>(found - group.subsystems.begin());
  };
  const Subsystem<Space>& subsystem = base_->system().subsystems[group.subsystems[member]];
  Index row = 0;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
    const Index count = std::ssize(loop.rows), first = std::exchange(row, row + count);
    if (loop.is_share) continue;
    group.loops.push_back({member, static_cast<Index>(k)});
    for (Index r = 0; r < count; ++r) {
      std::vector<RowAt>& places = group.rows.emplace_back();
      places.push_back({member, first + r});
      if (!loop.is_shared()) continue;
      for (const LoopAt& end :
           base_->system().shared_loops[static_cast<std::size_t>(loop.shared)].ends) {
        const std::size_t at = member_at(end);
        const Subsystem<Space>& other = base_->system().subsystems[group.subsystems[at]];
        Index before = 0;
        for (int l = 0; l < end.loop; ++l)
          before += std::ssize(other.loops[static_cast<std::size_t>(l)].rows);
        places.push_back({at, before + r});
      }
    }
  }
}

/// Takes over what the base says of the rows now: bearings have the stiffness of their speeds.
void TiedModel::take_rows(Group& group) const {
  group.closure_rows.clear();
  for (const std::vector<RowAt>& places : group.rows) {
    const RowAt own = places.front();
    ClosureRow row =
        base_->closure_rows(group.subsystems[own.member])[static_cast<std::size_t>(own.row)];
    const auto loop = std::find_if(group.loops.begin(), group.loops.end(), [&](const RowAt& at) {
      return at.member == own.member && std::cmp_equal(at.row, row.loop);
    });
    row.loop = static_cast<std::size_t>(loop - group.loops.begin());
    group.closure_rows.push_back(row);
  }
}

std::string TiedModel::full_name(std::size_t g, const std::string& inner) const {
  return groups_[g].subsystems.size() == 1 ? SteadyModel::full_name(g, inner) : inner;
}

space::Pose TiedModel::pose_of_rotor(std::size_t rotor) const {
  const HubState<Space>& base = base_->table().hub;
  const HubState<Space>& hub = base_->table().rotors[rotor].hub;
  const space::Rotation back = base.R.inverse();
  return {back * space::Position(hub.p - base.p), back * hub.R};
}

space::Pose TiedModel::pose_of_hub(std::size_t subsystem) const {
  const int rotor = base_->table().subsystems[subsystem].rotor;
  return rotor < 0 ? space::Pose{} : pose_of_rotor(static_cast<std::size_t>(rotor));
}

std::vector<CarriedHub> TiedModel::carried_hubs(const std::vector<HubVector>&) const {
  std::vector<CarriedHub> hubs;
  for (std::size_t r = 0; r < rotors_.size(); ++r) {
    const SupportedRotor& rotor = base_->system().rotors[r];
    const space::Pose pose = pose_of_rotor(r);
    CarriedHub& hub = hubs.emplace_back();
    hub.name = rotors_[r];
    hub.place.p = pose.p;
    hub.place.axes = pose.R.axes;
    hub.carrier = static_cast<std::size_t>(rotor.subsystem);
    hub.body = rotor.body;
    const RootLoad load = base_->root_loads(hub.carrier)[static_cast<std::size_t>(rotor.body)];
    hub.wrench.resize(kTwist);
    hub.wrench << -load.force, -load.moment;
  }
  return hubs;
}

/// Goes outward from the system's hub.
std::vector<MatrixXd> TiedModel::hub_motions(const Group& group) {
  const System<Space>& system = base_->system();
  const Index n = group.starts.back();
  std::map<std::size_t, MatrixXd> by_subsystem;
  const auto find = [&](auto&& self, std::size_t i) -> const MatrixXd& {
    if (const auto known = by_subsystem.find(i); known != by_subsystem.end()) return known->second;
    const int number = system.subsystems[i].rotor;
    if (number < 0) return by_subsystem[i] = MatrixXd::Identity(kTwist, kTwist + n);
    const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(number)];
    const auto carrier = static_cast<std::size_t>(rotor.subsystem);
    const auto m = static_cast<std::size_t>(
        std::find(group.subsystems.begin(), group.subsystems.end(), carrier) -
        group.subsystems.begin());
    const MatrixXd own = base_->twists(carrier, rotor.body);
    MatrixXd J = own.leftCols(kTwist) * self(self, carrier);
    J.middleCols(kTwist + group.starts[m], size(group, m)) += own.rightCols(size(group, m));
    return by_subsystem[i] = J;
  };
  std::vector<MatrixXd> motions;
  for (const std::size_t i : group.subsystems) motions.push_back(find(find, i));
  return motions;
}

std::vector<SubsystemPart> TiedModel::members(std::size_t g) {
  const Group& group = groups_[g];
  std::vector<SubsystemPart> members;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    const std::size_t i = group.subsystems[m];
    SubsystemPart& own = members.emplace_back(SubsystemPart{base_.get(), i, i});
    const int rotor = base_->system().subsystems[i].rotor;
    own.rotor = std::max(rotor, 0);
    own.is_carried = rotor >= 0;
    own.first = group.starts[m];
    own.count = size(group, m);
    own.rows.resize(base_->closure_rows(i).size());
    for (std::size_t r = 0; r < group.rows.size(); ++r)
      for (const RowAt& at : group.rows[r])
        if (at.member == m) own.rows[static_cast<std::size_t>(at.row)] = static_cast<Index>(r);
  }
  return members;
}

std::size_t TiedModel::member_of(const Group& group, int body) const {
  const auto& starts = group.body_starts;
  const auto behind =
      std::upper_bound(starts.begin(), starts.end(), static_cast<std::size_t>(body));
  return static_cast<std::size_t>(behind - starts.begin()) - 1;
}

double TiedModel::azimuth(std::size_t g) const { return base_->azimuth(groups_[g].subsystems[0]); }

Eigen::Matrix3d TiedModel::root_axes(std::size_t g, int body) const {
  const Group& group = groups_[g];
  const std::size_t m = member_of(group, body);
  return pose_of_hub(group.subsystems[m]).R.axes *
         base_->root_axes(group.subsystems[m], body - static_cast<int>(group.body_starts[m]));
}

const std::string& TiedModel::standing_springs(std::size_t g) const {
  for (const std::size_t i : groups_[g].subsystems)
    if (!base_->standing_springs(i).empty()) return base_->standing_springs(i);
  return base_->standing_springs(groups_[g].subsystems[0]);
}

std::string TiedModel::loop_words(std::size_t g, std::size_t loop) const {
  const RowAt& at = groups_[g].loops[loop];
  return base_->loop_words(groups_[g].subsystems[at.member], static_cast<std::size_t>(at.row));
}

// States.

void TiedModel::hold_states(std::size_t g, bool holds) {
  for (const std::size_t i : groups_[g].subsystems) base_->hold_states(i, holds);
}

void TiedModel::hold_states_at(std::size_t g, std::span<const double> states) {
  for (const std::size_t i : groups_[g].subsystems) {
    const std::size_t count = base_->count_states(i);
    base_->hold_states_at(i, states.first(count));
    states = states.subspan(count);
  }
}

std::vector<double> TiedModel::advance_states(std::size_t g, double elapsed) {
  std::vector<double> states;
  for (const std::size_t i : groups_[g].subsystems)
    append(base_->advance_states(i, elapsed), states);
  return states;
}

std::vector<ForceState> TiedModel::force_states(std::size_t g) const {
  const Group& group = groups_[g];
  std::vector<ForceState> all;
  std::size_t first = 0;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    for (ForceState own : base_->force_states(group.subsystems[m])) {
      own.coordinate += group.starts[m];
      own.state += first;
      all.push_back(own);
    }
    first += base_->count_states(group.subsystems[m]);
  }
  return all;
}

VectorXd TiedModel::initial(std::size_t g) const {
  const Group& group = groups_[g];
  VectorXd q(group.starts.back());
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    part(group, m, q) = base_->initial(group.subsystems[m]);
  return q;
}

void TiedModel::settle(std::size_t g, VectorXd& q) {
  const Group& group = groups_[g];
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    VectorXd own = part(group, m, q);
    base_->settle(group.subsystems[m], own);
    part(group, m, q) = own;
  }
}

void TiedModel::settle_at(std::size_t g, const VectorXd& absolute) {
  const Group& group = groups_[g];
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    base_->settle_at(group.subsystems[m], part(group, m, absolute));
}

VectorXd TiedModel::absolute(std::size_t g, const VectorXd& q) const {
  const Group& group = groups_[g];
  VectorXd all(q.size());
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    part(group, m, all) = base_->absolute(group.subsystems[m], part(group, m, q));
  return all;
}

// Forces and matrices.

/// Returns the forces of the rows of a member by those of the group.
VectorXd TiedModel::forces_of(const Group& group, std::size_t member,
                              const VectorXd& multipliers) const {
  VectorXd forces = VectorXd::Zero(std::ssize(base_->closure_rows(group.subsystems[member])));
  for (std::size_t r = 0; r < group.rows.size(); ++r)
    for (const RowAt& at : group.rows[r])
      if (at.member == member) forces[at.row] = multipliers[static_cast<Index>(r)];
  return forces;
}

std::vector<SubsystemState> TiedModel::split(const Group& group,
                                             const SubsystemState& state) const {
  std::vector<SubsystemState> states;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    SubsystemState& own = states.emplace_back();
    own.q = part(group, m, state.q);
    own.v = part(group, m, state.v);
    own.q_elastic = part(group, m, state.q_elastic);
    own.v_elastic = part(group, m, state.v_elastic);
    own.holds_springs = state.holds_springs;
    if (state.multipliers.size() > 0) own.multipliers = forces_of(group, m, state.multipliers);
  }
  return states;
}

void TiedModel::evaluate(std::size_t g, const SubsystemState& state, const HubOffset& hub,
                         SubsystemResponse& response) {
  Group& group = groups_[g];
  std::vector<SubsystemResponse> own;
  base_->evaluate_tied(group.subsystems, split(group, state), hub, own);
  if (!state.holds_springs) take_rows(group);
  response.force.resize(group.starts.back());
  response.hub_force = HubVector::Zero(kTwist);
  response.is_valid = true;
  for (std::size_t m = 0; m < own.size(); ++m) {
    part(group, m, response.force) = own[m].force;
    response.hub_force += own[m].hub_force;
    response.is_valid = response.is_valid && own[m].is_valid;
  }
  response.openings.resize(std::ssize(group.rows));
  response.multipliers.resize(std::ssize(group.rows));
  for (std::size_t r = 0; r < group.rows.size(); ++r) {
    const RowAt& at = group.rows[r].front();
    response.openings[static_cast<Index>(r)] = own[at.member].openings[at.row];
    response.multipliers[static_cast<Index>(r)] = own[at.member].multipliers[at.row];
  }
}

const MatrixXd& TiedModel::stiffness(std::size_t g) {
  Group& group = groups_[g];
  group.stiffness = MatrixXd::Zero(group.starts.back(), group.starts.back());
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    group.stiffness.block(group.starts[m], group.starts[m], size(group, m), size(group, m)) =
        base_->stiffness(group.subsystems[m]);
  return group.stiffness;
}

VectorXd TiedModel::accelerations(std::size_t g) {
  const Group& group = groups_[g];
  const std::vector<VectorXd> own = base_->accelerations_tied(group.subsystems);
  VectorXd a(group.starts.back());
  for (std::size_t m = 0; m < own.size(); ++m) part(group, m, a) = own[m];
  return a;
}

SubsystemMatrices TiedModel::matrices(std::size_t g) {
  const Group& group = groups_[g];
  const Index n = group.starts.back();
  SubsystemMatrices all{MatrixXd::Zero(kTwist + n, kTwist + n), MatrixXd::Zero(n, n)};
  const std::vector<MatrixXd> J = hub_motions(group);
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    const SubsystemMatrices own = base_->matrices(group.subsystems[m]);
    const Index at = group.starts[m], count = size(group, m);
    all.mass += J[m].transpose() * own.mass.topLeftCorner(kTwist, kTwist) * J[m];
    all.mass.middleCols(kTwist + at, count) +=
        J[m].transpose() * own.mass.topRightCorner(kTwist, count);
    all.mass.middleRows(kTwist + at, count) += own.mass.bottomLeftCorner(count, kTwist) * J[m];
    all.mass.block(kTwist + at, kTwist + at, count, count) +=
        own.mass.bottomRightCorner(count, count);
    all.damping.block(at, at, count, count) = own.damping;
  }
  return all;
}

MatrixXd TiedModel::twists(std::size_t g, int body) {
  const Group& group = groups_[g];
  const std::size_t m = member_of(group, body);
  const MatrixXd own =
      base_->twists(group.subsystems[m], body - static_cast<int>(group.body_starts[m]));
  MatrixXd all = own.leftCols(kTwist) * hub_motions(group)[m];
  all.middleCols(kTwist + group.starts[m], size(group, m)) += own.rightCols(size(group, m));
  return all;
}

VectorXd TiedModel::momenta(std::size_t g, const VectorXd& v) {
  const Group& group = groups_[g];
  // At orbits alone, of models whose hub nothing carries.
  assert(base_->system().rotors.empty());
  VectorXd all = VectorXd::Zero(kTwist + group.starts.back());
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    const VectorXd own = base_->momenta(group.subsystems[m], part(group, m, v));
    all.head(kTwist) += own.head(kTwist);
    all.segment(kTwist + group.starts[m], size(group, m)) = own.tail(size(group, m));
  }
  return all;
}

MatrixXd TiedModel::closures(std::size_t g) {
  const Group& group = groups_[g];
  MatrixXd all = MatrixXd::Zero(std::ssize(group.rows), kTwist + group.starts.back());
  if (group.rows.empty()) return all;
  const std::vector<MatrixXd> J = hub_motions(group);
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    const MatrixXd own = base_->closures(group.subsystems[m]);
    for (std::size_t r = 0; r < group.rows.size(); ++r)
      for (const RowAt& at : group.rows[r]) {
        if (at.member != m) continue;
        auto row = all.row(static_cast<Index>(r));
        row += own.row(at.row).head(kTwist) * J[m];
        row.segment(kTwist + group.starts[m], size(group, m)) +=
            own.row(at.row).tail(size(group, m));
      }
  }
  return all;
}

std::vector<LoopLoad> TiedModel::loop_loads(std::size_t g, const VectorXd& multipliers) const {
  const Group& group = groups_[g];
  std::vector<LoopLoad> loads;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    append(base_->loop_loads(group.subsystems[m], forces_of(group, m, multipliers)), loads);
  return loads;
}

// What is shown.

std::vector<SolidDeformation> TiedModel::solids(std::size_t g) const {
  const Group& group = groups_[g];
  std::vector<SolidDeformation> solids;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    for (SolidDeformation solid : base_->solids(group.subsystems[m])) {
      solid.body += static_cast<int>(group.body_starts[m]);
      solids.push_back(std::move(solid));
    }
  return solids;
}

std::vector<NodePlace> TiedModel::places(std::size_t g) {
  const Group& group = groups_[g];
  std::vector<NodePlace> places;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m)
    for (NodePlace place : base_->places(group.subsystems[m])) {
      const space::Pose hub = pose_of_hub(group.subsystems[m]);
      place.p = hub.p + hub.R * space::Position(place.p);
      place.centre = hub.p + hub.R * space::Position(place.centre);
      place.axes = hub.R.axes * place.axes;
      place.body += static_cast<int>(group.body_starts[m]);
      places.push_back(place);
    }
  return places;
}

std::optional<SubsystemAir> TiedModel::air(std::size_t g) const {
  std::optional<SubsystemAir> all;
  for (const std::size_t i : groups_[g].subsystems) {
    const std::optional<SubsystemAir> own = base_->air(i);
    if (!own) continue;
    if (!all) {
      all = own;
      continue;
    }
    all->thrust += own->thrust;
    all->torque += own->torque;
    append(own->places, all->places);
    append(own->stations, all->stations);
  }
  return all;
}

std::vector<RootLoad> TiedModel::root_loads(std::size_t g) const {
  const Group& group = groups_[g];
  std::vector<RootLoad> loads;
  for (std::size_t m = 0; m < group.subsystems.size(); ++m) {
    std::vector<RootLoad> own = base_->root_loads(group.subsystems[m]);
    for (std::size_t j = 0; j < own.size(); ++j)
      own[j].body = group.bodies[group.body_starts[m] + j];
    append(std::move(own), loads);
  }
  return loads;
}

std::vector<double> TiedModel::bending(std::size_t g) const {
  std::vector<double> bending;
  for (const std::size_t i : groups_[g].subsystems) append(base_->bending(i), bending);
  return bending;
}

MatrixXd TiedModel::turn_outputs(std::size_t g, double angle) const {
  const Index count = std::ssize(groups_[g].outputs);
  MatrixXd turn = MatrixXd::Zero(count, count);
  Index at = 0;
  for (const std::size_t i : groups_[g].subsystems) {
    const MatrixXd own = base_->turn_outputs(i, angle);
    turn.block(at, at, own.rows(), own.cols()) = own;
    at += own.rows();
  }
  return turn;
}

VectorXd TiedModel::measure(std::size_t g) {
  VectorXd values(std::ssize(groups_[g].outputs));
  Index at = 0;
  for (const std::size_t i : groups_[g].subsystems) {
    const VectorXd own = base_->measure(i);
    values.segment(at, own.size()) = own;
    at += own.size();
  }
  return values;
}

}  // namespace spoke::steady
