// Places stations, evaluates the air on them, and resolves its forces in the frames of the bodies.

#include "engine/bodies/act/air/air_on_blades.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <limits>
#include <string>

#include "engine/bodies/act/marker_parts.h"
#include "engine/bodies/air/rotor_coefficients.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/kernels/wind_at.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

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

std::unique_ptr<AirData> place_on(const BladeAirModel& model, std::size_t i,
                                  SubsystemData<Space>& data) {
  const std::size_t stations = model.places.size();
  auto placed = std::make_unique<AirData>();
  AirData& made = *placed;
  made.blade = std::make_shared<const air::BladeAir>(model.aerodynamics, *model.air, model.blades,
                                                     model.hub_radius, model.aerodynamics.station,
                                                     model.polars);
  for (const BladeAirModel::Place& place : model.places)
    made.markers.push_back(place_station(place, i, data));
  made.wrenches = ArenaVector<SectionWrench<Space>>(stations, *data.arena);
  made.stations = ArenaVector<air::StationAir>(stations, air::StationAir{}, *data.arena);
  made.part = data.part_maker.cover("air", Mark::none, made.wrenches, made.stations, made.sum);
  made.states = &add_states("air states", static_cast<std::size_t>(made.blade->state_size()), data);
  data.saved.push_back(doubles(made.stations[0], stations));  // sensors show them
  data.saved.push_back(doubles(made.sum));
  made.motions.resize(stations);
  made.sections.resize(stations);
  made.winds.resize(stations, Eigen::Vector3d::Zero());
  made.forces.resize(stations);
  for (std::size_t k = 0; k < stations; ++k)
    data.bodies[static_cast<std::size_t>(made.markers[k].body)].applied.push_back(
        {&made.markers[k].section, &made.wrenches[k], &made.sections[k]});
  return placed;
}

TowerBeside place_tower(const DragModel::Tower& model, std::size_t support,
                        const SubsystemData<Space>& data) {
  TowerBeside made;
  made.model = &model;
  for (const DragModel::Tower::Point& point : model.points) {
    made.markers.push_back(place_station({point.body, point.station}, support, data));
    made.axis.push_back({.diameter = point.diameter, .coefficient = point.coefficient});
  }
  made.motions.resize(model.points.size());
  made.sections.resize(model.points.size());
  return made;
}

/// Returns all towers of a system.
std::vector<TowerBeside> place_towers(const System<Space>& system, const StepData<Space>& data) {
  std::vector<TowerBeside> towers;
  for (std::size_t i = 0; i < system.subsystems.size(); ++i)
    if (const DragModel* drag = system.subsystems[i].drag.get())
      for (const DragModel::Tower& tower : drag->towers)
        towers.push_back(place_tower(tower, i, data.subsystems[i]));
  return towers;
}

}  // namespace

AirOnBlades::AirOnBlades(const System<Space>& system, StepData<Space>& data)
    : system_(system), data_(data), blades_(system.subsystems.size()) {
  assert(system.wind || !acts(system));
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const Subsystem<Space>& subsystem = system.subsystems[i];
    if (!subsystem.air) continue;
    blades_[i] = place_on(*subsystem.air, i, data.subsystems[i]);
    blades_[i]->towers = place_towers(system, data);
    if (std::find(rotors_.begin(), rotors_.end(), subsystem.rotor) == rotors_.end())
      rotors_.push_back(subsystem.rotor);
  }
}

bool AirOnBlades::acts(const System<Space>& system) {
  return std::any_of(system.subsystems.begin(), system.subsystems.end(),
                     [](const Subsystem<Space>& subsystem) { return subsystem.air != nullptr; });
}

void AirOnBlades::add_nodes(const PassNodes& pass, PassPlace place, int i) const {
  const auto index = static_cast<std::size_t>(i);
  if (place != PassPlace::on_motion || !blades_[index]) return;
  const AirData& own = *blades_[index];
  const StepProgress& progress = *data_.subsystems[index].progress;
  PartList inputs = marker_inputs(data_, {i}, own.markers), scratch;
  for (const TowerBeside& tower : own.towers) {
    graph::add_to(inputs, marker_inputs(data_, {tower.markers.front().subsystem}, tower.markers));
    graph::add_to(scratch, marker_scratch(data_, tower.markers));
  }
  pass.builder.add_node(
      pass.label(stage(), i), graph::reads(inputs, own.states->kept_part),
      graph::updates(own.states->reached_part, scratch), graph::writes(own.part),
      unless_halted(progress, [this, &progress, index, h = pass.step]() noexcept {
        const bool is_between = progress.control.is_between_steps();
        const double begin = static_cast<double>(progress.step - (is_between ? 0 : 1)) * h;
        const double t = progress.control.time;
        evaluate(index, t, std::max(0.0, t - begin), progress.control.continues_iteration());
      }));
}

void AirOnBlades::list_parts_on(int i, int j, PartList& parts) const {
  const AirData* const own = on(static_cast<std::size_t>(i));
  if (own && std::any_of(own->markers.begin(), own->markers.end(),
                         [j](const PlacedMarker<Space>& marker) { return marker.body == j; }))
    parts.push_back(own->part);
}

void AirOnBlades::list_shown(int i, PartList& parts) const {
  if (const AirData* const own = on(static_cast<std::size_t>(i))) parts.push_back(own->part);
}

void AirOnBlades::advance(std::size_t i, double elapsed) noexcept {
  if (blades_[i]) evaluate(i, 0.0, elapsed, false);
}

std::size_t AirOnBlades::count_values(const Subsystem<Space>& subsystem) {
  return subsystem.air ? sizeof(AirSum) / sizeof(double) : 0;
}

std::size_t AirOnBlades::count_values(std::size_t i) const {
  return count_values(system_.subsystems[i]);
}

void AirOnBlades::keep_values(std::size_t i, double /*t*/, double* into) const noexcept {
  if (!blades_[i]) return;
  const std::span<double> sum = doubles(blades_[i]->sum);
  std::copy(sum.begin(), sum.end(), into);
}

std::vector<ActorColumn> AirOnBlades::columns(ColumnPlace place) const {
  if (place != ColumnPlace::last) return {};
  std::vector<ActorColumn> columns;
  for (const int r : rotors_) {
    const std::string name =
        (r < 0 ? "" : system_.rotors[static_cast<std::size_t>(r)].prefix) + "air.";
    columns.insert(columns.end(), {{name + "wind", "m/s"},
                                   {name + "thrust", "N"},
                                   {name + "torque", "N m"},
                                   {name + "power", "W"},
                                   {name + "thrust_coefficient", ""},
                                   {name + "power_coefficient", ""}});
  }
  return columns;
}

void AirOnBlades::append_values(ColumnPlace place, std::int64_t step,
                                std::span<const double* const> kept,
                                std::vector<double>& values) const {
  if (place != ColumnPlace::last) return;
  for (const int r : rotors_) {
    const double speed = r < 0 ? of_step(data_.records, step).velocity[Space::kAxial]
                               : of_step(data_.rotors[static_cast<std::size_t>(r)].records, step)
                                     .velocity[Space::kAxial];
    double wind = 0.0;
    air::RotorLoads rotor{0.0, 0.0, speed, 0.0, 0.0};
    for (std::size_t i = 0; i < blades_.size(); ++i) {
      const Subsystem<Space>& subsystem = system_.subsystems[i];
      const BladeAirModel* model = subsystem.air.get();
      if (!model || subsystem.rotor != r) continue;
      AirSum own;
      std::copy_n(kept[i], count_values(i), doubles(own).begin());
      rotor.thrust += own.thrust;
      rotor.torque += own.torque;
      wind = own.wind;
      rotor.radius = model->tip_radius;
      rotor.density = model->air->density;
    }
    const air::RotorCoefficients coefficients = calc_wind_coefficients(rotor, wind);
    values.insert(values.end(), {wind, rotor.thrust, rotor.torque, rotor.torque * speed,
                                 coefficients.thrust, coefficients.power});
  }
}

std::optional<space::Twist> AirOnBlades::read(std::size_t i,
                                              const Reading<Space>& asked) const noexcept {
  const bool is_flow = asked.quantity == SensorQuantity::air_flow;
  if (!is_flow && asked.quantity != SensorQuantity::air_load) return std::nullopt;
  assert(blades_[i]);
  const auto values = [&own = *blades_[i], is_flow](std::size_t k) -> space::Twist {
    const air::StationAir& s = own.stations[k];
    if (is_flow)
      return {s.attack, s.relative_speed, s.axial_induction, s.tangential_induction, 0.0, 0.0};
    return {s.lift, s.drag, s.moment, s.axial_force, s.tangential_force, s.pitching_moment};
  };
  const auto k = static_cast<std::size_t>(asked.along);
  const double share = asked.along - static_cast<double>(k);
  if (share == 0.0) return values(k);
  return (1.0 - share) * values(k) + share * values(k + 1);
}

void AirOnBlades::disturb(AirData& own) const noexcept {
  if (own.towers.empty()) return;
  for (TowerBeside& tower : own.towers) {
    const auto support = static_cast<std::size_t>(tower.markers.front().subsystem);
    calc_load_motions(system_.subsystems[support], data_.subsystems[support], tower.markers,
                      tower.motions, tower.sections);
    for (std::size_t k = 0; k < tower.axis.size(); ++k) {
      tower.axis[k].position = tower.motions[k].position;
      tower.axis[k].velocity = tower.motions[k].velocity;
    }
  }
  // Each adds to the undisturbed wind.
  for (std::size_t k = 0; k < own.winds.size(); ++k) {
    Eigen::Vector3d added = Eigen::Vector3d::Zero();
    for (const TowerBeside& tower : own.towers)
      added += air::calc_tower_flow({tower.model->potential, tower.model->shadow}, tower.axis,
                                    own.motions[k].position, own.winds[k]);
    own.winds[k] += added;
  }
}

void AirOnBlades::evaluate(std::size_t i, double t, double elapsed, bool iterates) const noexcept {
  assert(blades_[i] && elapsed >= 0.0);
  AirData& own = *blades_[i];
  const Subsystem<Space>& subsystem = system_.subsystems[i];
  const SubsystemData<Space>& data = data_.subsystems[i];
  calc_load_motions(subsystem, data, own.markers, own.motions, own.sections);
  for (std::size_t k = 0; k < own.markers.size(); ++k)
    own.winds[k] = find_wind(*system_.wind, own.motions[k].position, t);
  disturb(own);
  std::fill(own.forces.begin(), own.forces.end(), Wrench{});
  const air::RotorPlace rotor = place_rotor(t, *data.hub, *system_.wind);
  StatePair& states = *own.states;
  own.blade->evaluate(rotor, own.motions, own.winds,
                      states.has_begun() ? elapsed : std::numeric_limits<double>::infinity(),
                      states.kept.data(), states.reached.data(), own.forces,
                      {own.stations.data(), own.stations.size()}, iterates);
  states.reached.back() = 1.0;
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

}  // namespace spoke
