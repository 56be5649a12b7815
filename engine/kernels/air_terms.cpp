// Places the stations of blades, hands their motion and the wind to the kernel, and its forces on
// to the bodies.

#include "engine/kernels/air_terms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/kernels/kinematics.h"
#include "engine/kernels/marker_motion.h"
#include "engine/table/body_kind.h"

namespace spoke {
namespace {

/// Returns the wind; what is not finite, and ends the step, if the program's own throws.
Eigen::Vector3d find_wind(const WindField& wind, const Eigen::Vector3d& place, double t) noexcept {
  try {
    return wind.velocity(place, t);
  } catch (...) {
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

/// Returns the rotor as the subsystem's hub has it.
air::RotorPlace place_rotor(double t, const HubState<Space>& hub, const WindField& wind) {
  const space::Rotation& R = hub.R;
  air::RotorPlace rotor;
  rotor.center = hub.p;
  rotor.axis = R.axes.col(2);
  rotor.velocity = R * space::Position(linear(hub.twist));
  rotor.speed = angular(hub.twist)[2];
  rotor.wind = find_wind(wind, rotor.center, t);
  return rotor;
}

AirSum sum_up(const air::RotorPlace& rotor, const std::vector<MarkerMotion>& stations,
              const std::vector<Wrench>& forces) {
  AirSum sum;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Eigen::Vector3d arm = stations[k].position - rotor.center;
    sum.thrust += rotor.axis.dot(forces[k].force);
    sum.torque += rotor.axis.dot(arm.cross(forces[k].force) + forces[k].moment);
  }
  sum.wind = rotor.axis.dot(rotor.wind - rotor.velocity);
  return sum;
}

PlacedMarker<Space> place_station(const BladeAirModel::Place& place, std::size_t i,
                                  const SubsystemData<Space>& data) {
  const space::Body& body = *data.bodies[static_cast<std::size_t>(place.body)].model->body;
  return {static_cast<int>(i), place.body, kind_of(body).section_at(body, place.station)};
}

void place_on(const BladeAirModel& model, std::size_t i, SubsystemData<Space>& data) {
  const std::size_t stations = model.places.size();
  AirData<Space>& made = data.air.emplace();
  made.blade = std::make_shared<const air::BladeAir>(model.aerodynamics, *model.air, model.blades,
                                                     model.hub_radius, model.aerodynamics.station,
                                                     model.polars);
  for (const BladeAirModel::Place& place : model.places)
    made.markers.push_back(place_station(place, i, data));
  const std::size_t states = made.blade->state_size() + 1;
  made.wrenches = ArenaVector<SectionWrench<Space>>(stations, *data.arena);
  made.stations = ArenaVector<air::StationAir>(stations, air::StationAir{}, *data.arena);
  made.states = ArenaVector<double>(states, 0.0, *data.arena);
  made.reached = ArenaVector<double>(states, 0.0, *data.arena);
  const PartMaker& maker = data.part_maker;
  data.parts.air = maker.cover("air", Mark::none, made.wrenches, made.stations, made.sum);
  data.parts.air_reached = maker.cover("air states reached", Mark::none, made.reached);
  data.parts.air_states = maker.cover("air states", Mark::state, made.states);
  made.motions.resize(stations);
  made.sections.resize(stations);
  made.winds.resize(stations, Eigen::Vector3d::Zero());
  made.forces.resize(stations);
  for (std::size_t k = 0; k < stations; ++k)
    data.bodies[static_cast<std::size_t>(made.markers[k].body)].applied.push_back(
        {&made.markers[k].section, &made.wrenches[k], &made.sections[k]});
}

}  // namespace

void place_air(const System<Space>& system, StepData<Space>& data) {
  for (std::size_t i = 0; i < system.subsystems.size(); ++i)
    if (system.subsystems[i].air) {
      assert(system.wind);
      place_on(*system.subsystems[i].air, i, data.subsystems[i]);
    }
}

void evaluate_air(double t, double elapsed, bool iterates, const System<Space>& system,
                  std::size_t i, SubsystemData<Space>& data) noexcept {
  assert(data.air && system.wind && elapsed >= 0.0);
  AirData<Space>& own = *data.air;
  const Subsystem<Space>& subsystem = system.subsystems[i];
  calc_load_motions(subsystem, data, own.markers, own.motions, own.sections);
  for (std::size_t k = 0; k < own.markers.size(); ++k)
    own.winds[k] = find_wind(*system.wind, own.motions[k].position, t);
  std::fill(own.forces.begin(), own.forces.end(), Wrench{});
  const air::RotorPlace rotor = place_rotor(t, *data.hub, *system.wind);
  const bool has_begun = own.states.back() != 0.0;
  own.blade->evaluate(rotor, own.motions, own.winds,
                      has_begun ? elapsed : std::numeric_limits<double>::infinity(),
                      own.states.data(), own.reached.data(), own.forces,
                      {own.stations.data(), own.stations.size()}, iterates);
  own.reached.back() = 1.0;
  own.sum = sum_up(rotor, own.motions, own.forces);
  space::Rotation to_body;
  for (std::size_t k = 0; k < own.markers.size(); ++k) {
    const int body = own.markers[k].body;
    if (k == 0 || body != own.markers[k - 1].body)
      to_body = (data.hub->R * calc_rotation_to_hub(subsystem, data, body)).inverse();
    own.wrenches[k] = {to_body * space::Position(own.forces[k].force),
                       to_body * space::Angular(own.forces[k].moment)};
  }
}

template <class World>
void keep_air(SubsystemData<World>& data) noexcept {
  if (data.air)
    std::copy(data.air->reached.begin(), data.air->reached.end(), data.air->states.begin());
}

template void keep_air(SubsystemData<Plane>&) noexcept;
template void keep_air(SubsystemData<Space>&) noexcept;

}  // namespace spoke
