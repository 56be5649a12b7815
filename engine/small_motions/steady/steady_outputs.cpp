// Reads the table: places, tips, loads between bodies, and what sensors show.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

#include "engine/bodies/act/air/air_on_blades.h"
#include "engine/bodies/columns/spatial_columns.h"
#include "engine/bodies/kernels/deformation_limits.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/plane/section_balance.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/small_motions/steady/subsystem_access.h"
#include "engine/step/formulation/loops/loops.h"
#include "models/system/tip_body.h"

namespace spoke::steady {
namespace {

/// Returns the distance of the undeformed body from the root of its subsystem [m].
double station_of(const Subsystem<Plane>& subsystem, std::size_t j) {
  return subsystem.length * static_cast<double>(j) / static_cast<double>(subsystem.bodies.size());
}
double station_of(const Subsystem<Space>& subsystem, std::size_t j) {
  const TreeBody<Space>& body = subsystem.bodies[j];
  return kind_of(*body.body).station_of(body);
}

Eigen::Vector3d in_space(const Position& p) { return {p.x(), p.y(), 0.0}; }
Eigen::Vector3d in_space(const space::Position& p) { return p; }

}  // namespace

template <class World>
std::vector<SolidDeformation> SteadySystem<World>::solids(std::size_t subsystem) const {
  std::vector<SolidDeformation> solids;
  const SubsystemData<World>& own = data(subsystem);
  for (std::size_t j = 0; j < own.bodies.size(); ++j)
    if (auto solid = mesh_of(own.bodies[j]))
      solids.push_back({static_cast<int>(j), std::move(solid), {}});
  return solids;
}

template <class World>
std::vector<NodePlace> SteadySystem<World>::places(std::size_t subsystem) {
  assert(subsystem < subsystems());
  SubsystemData<World>& own = data(subsystem);
  calc_poses(context_.system.subsystems[subsystem], own, own.poses);
  std::vector<NodePlace> places;
  for (std::size_t j = 0; j < own.bodies.size(); ++j) add_places(own, static_cast<int>(j), places);
  return places;
}

template <class World>
TipMotion SteadySystem<World>::tip(std::size_t subsystem) {
  SubsystemData<World>& own = data(subsystem);
  calc_poses(context_.system.subsystems[subsystem], own, own.poses);
  const Eigen::Matrix3d turned =
      outer_axes(own, find_tip_body(context_.system, subsystem)) * tip_axes_[subsystem].transpose();
  const SubsystemSample<World> sample = calc_sample(context_.system, subsystem, data(subsystem));
  return {in_space(sample.tip), space::logarithm(space::Rotation{turned})};
}

template <class World>
std::optional<SubsystemAir> SteadySystem<World>::air(std::size_t subsystem) const {
  if constexpr (std::is_same_v<World, Space>)
    for (const auto& actor : context_.data.actors)
      if (const auto* air = dynamic_cast<const AirOnBlades*>(actor.get()))
        if (const AirData* own = air->on(subsystem))
          return SubsystemAir{own->sum.thrust,
                              own->sum.torque,
                              own->sum.wind,
                              own->blade->stations(),
                              {own->stations.begin(), own->stations.end()}};
  return std::nullopt;
}

template <class World>
std::vector<RootLoad> SteadySystem<World>::root_loads(std::size_t subsystem) const {
  assert(subsystem < subsystems());
  std::vector<RootLoad> loads;
  const SubsystemData<World>& own = data(subsystem);
  for (std::size_t j = 0; j < own.bodies.size(); ++j) {
    const TwistOf<World>& wrench = own.wrenches[j].inboard;
    const Eigen::Matrix3d to_section = inboard_axes(own.bodies[j]).transpose();
    loads.push_back({names_[subsystem].bodies[j],
                     station_of(context_.system.subsystems[subsystem], j),
                     -to_section * force_of(wrench), -to_section * moment_of(wrench)});
  }
  // As the sensor shows: in the plane the root has the moment of the tension on the hub.
  if constexpr (std::is_same_v<World, Plane>)
    loads.front().moment.z() += sum_stiffening<World>(own.bodies).moment;
  return loads;
}

template <class World>
std::vector<double> SteadySystem<World>::bending(std::size_t subsystem) const {
  std::vector<double> bending;
  for (const BodyData<World>& body : data(subsystem).bodies)
    bending.push_back(find_large_deflection(body));
  return bending;
}

/// Whether a sensor is constant in steady rotation, as are those whose frames turn with the hub; on
/// a support those of motions, whose frames may stand.
template <class World>
bool SteadySystem<World>::is_steady(const SensorColumn& column) const {
  if (is_support_)
    return (column.quantity == SensorQuantity::displacement ||
            column.quantity == SensorQuantity::velocity ||
            column.quantity == SensorQuantity::loop_opening) &&
           (column.frame != SensorFrame::inertial || hub_.support == HubSupport::axle);
  if (column.quantity == SensorQuantity::coupling_force) return true;
  const bool is_local =
      is_motion(column.quantity) || column.quantity == SensorQuantity::section_force ||
      column.quantity == SensorQuantity::joint_reaction || is_of_loop(column.quantity);
  return is_local && column.frame != SensorFrame::inertial;
}

template <class World>
void SteadySystem<World>::set_outputs(std::vector<SensorColumn> columns) {
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  columns_.resize(subsystems());
  for (std::size_t i = 0; i < subsystems(); ++i)
    for (int c = 0; c < World::kPosition; ++c)
      outputs_[i].push_back({names_[i].sensors + ".tip." + kAxes[c], "m"});
  for (SensorColumn& column : columns) {
    if (!is_steady(column)) {
      other_sensors_.push_back(column.name);
      continue;
    }
    outputs_[column.subsystem].push_back({column.name, column.unit});
    columns_[column.subsystem].push_back(std::move(column));
  }
}

template <class World>
Eigen::VectorXd SteadySystem<World>::measure(std::size_t subsystem) {
  assert(subsystem < subsystems());
  SubsystemData<World>& own = data(subsystem);
  keep_joint_loads(context_.system.subsystems[subsystem], own);
  if (!own.loops.is_empty()) keep_loop_loads(own);
  const Eigen::Vector3d displacement = tip(subsystem).displacement;
  calc_readings(context_.system, subsystem, 0, 0.0, context_.data);
  Eigen::VectorXd values(std::ssize(outputs_[subsystem]));
  const Eigen::Index tips = values.size() - std::ssize(columns_[subsystem]);
  values.head(tips) = displacement.head(tips);
  for (std::size_t k = 0; k < columns_[subsystem].size(); ++k)
    values[tips + static_cast<Eigen::Index>(k)] =
        value_of(columns_[subsystem][k], hub_, 0, context_.data);
  return values;
}

template <class World>
Eigen::MatrixXd SteadySystem<World>::turn_outputs(std::size_t subsystem, double angle) const {
  const Eigen::Index count = std::ssize(outputs_[subsystem]);
  const Eigen::Index tips = count - std::ssize(columns_[subsystem]);
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(count, count);
  const auto turn_pair = [&](Eigen::Index x) {
    const double c = std::cos(angle), s = std::sin(angle);
    turn.block<2, 2>(x, x) << c, s, -s, c;
  };
  turn_pair(0);
  for (std::size_t k = 0; k < columns_[subsystem].size(); ++k) {
    const SensorColumn& column = columns_[subsystem][k];
    // Of each three components the first two are across the axis; in the plane there are three.
    if (column.frame == SensorFrame::hub && column.component % 3 == 0)
      turn_pair(tips + static_cast<Eigen::Index>(k));
  }
  return turn;
}

template bool SteadySystem<Plane>::is_steady(const SensorColumn&) const;
template void SteadySystem<Plane>::set_outputs(std::vector<SensorColumn>);
template Eigen::VectorXd SteadySystem<Plane>::measure(std::size_t);
template Eigen::MatrixXd SteadySystem<Plane>::turn_outputs(std::size_t, double) const;
template std::vector<SolidDeformation> SteadySystem<Plane>::solids(std::size_t) const;
template std::vector<NodePlace> SteadySystem<Plane>::places(std::size_t);
template TipMotion SteadySystem<Plane>::tip(std::size_t);
template std::optional<SubsystemAir> SteadySystem<Plane>::air(std::size_t) const;
template std::vector<RootLoad> SteadySystem<Plane>::root_loads(std::size_t) const;
template std::vector<double> SteadySystem<Plane>::bending(std::size_t) const;
template bool SteadySystem<Space>::is_steady(const SensorColumn&) const;
template void SteadySystem<Space>::set_outputs(std::vector<SensorColumn>);
template Eigen::VectorXd SteadySystem<Space>::measure(std::size_t);
template Eigen::MatrixXd SteadySystem<Space>::turn_outputs(std::size_t, double) const;
template std::vector<SolidDeformation> SteadySystem<Space>::solids(std::size_t) const;
template std::vector<NodePlace> SteadySystem<Space>::places(std::size_t);
template TipMotion SteadySystem<Space>::tip(std::size_t);
template std::optional<SubsystemAir> SteadySystem<Space>::air(std::size_t) const;
template std::vector<RootLoad> SteadySystem<Space>::root_loads(std::size_t) const;
template std::vector<double> SteadySystem<Space>::bending(std::size_t) const;

}  // namespace spoke::steady
