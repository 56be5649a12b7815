// Chooses the world of a scenario's model.

#include <limits>
#include <memory>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/small_motions/steady/friction_at_rest.h"
#include "engine/small_motions/steady/mean_wind.h"
#include "engine/small_motions/steady/steady_mount.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/step/loops/loop_start.h"
#include "engine/step/model_memory.h"
#include "engine/support/memory.h"
#include "models/error.h"
#include "models/system/spatial_system.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

std::unique_ptr<SteadyModel> make_planar(const Scenario& scenario, const SteadyOptions& options) {
  const Rotor& rotor = scenario.rotor;
  const auto fill = [&rotor](System<Plane>& system) {
    system = make_system(rotor);
    require_memory(system, Formulation::structured);
  };
  const auto place = [&scenario](const System<Plane>&, StepData<Plane>& data) {
    return place_sensors(scenario.sensors, scenario.rotor, data);
  };
  return std::make_unique<SteadySystem<Plane>>(
      SystemMaker<Plane>{fill, place, make_loop_limits(scenario.integration)},
      name_subsystems(rotor), options);
}

/// The systems of a rotor and of its support, which many models copy.
struct Machine {
  System<Space> rotor, support;
  std::vector<spatial::Tree> rotor_trees, support_tree;
  Ballast ballast;
};

/// Returns a body for the hub of a support that stands without its rotor: without any mass there, a
/// carrier without mass would have no accelerations.
Ballast choose_ballast(const spatial::Hub& hub, const std::vector<spatial::Tree>& rotor) {
  constexpr double kShare = 1e-3;
  const spatial::MassProperties all = spatial::calc_mass_properties(hub, rotor);
  Ballast ballast;
  if (all.mass > 0.0) ballast.mass = kShare * all.mass;
  if (all.inertia.trace() > 0.0) ballast.inertia = kShare * all.inertia.trace();
  return ballast;
}

/// Lets the generators of a support spin, which stand in the tree, as a rotor of this speed turns
/// them.
void spin_generators(double speed, spatial::Tree& support) {
  for (spatial::TreeBody& body : support.bodies) {
    if (!body.is_generator()) continue;
    auto& generator = std::get<spatial::RigidBody>(body.shape);
    generator.spin.z() = generator.inertia(2, 2) * body.drive_ratio * speed;
  }
}

/// `at_places`: the wind at each place that stands; null: that of the model.
std::shared_ptr<const Machine> make_machine(const spatial::Model& model, const Wind* at_places,
                                            const SteadyOptions& options) {
  auto made = std::make_shared<Machine>();
  std::vector<spatial::Tree> trees = build_trees(model);
  made->support_tree = {trees.back()};
  made->rotor_trees.assign(trees.begin(), trees.end() - 1);
  made->ballast = choose_ballast(model.hub, made->rotor_trees);
  spin_generators(options.speed, trees.back());
  const solid::Control control{{}, available_memory()};
  made->support = make_support_alone(model, trees, made->ballast, control);
  if (made->support.wind && at_places) made->support.wind = make_wind(*at_places);
  hold_mount(made->support.hub, options.instant);
  made->rotor = make_system(without_support(model), made->rotor_trees, control);
  // All parts of a machine that is free fall alike.
  if (made->support.hub.support == HubSupport::free) made->rotor.gravity.setZero();
  require_memory(made->rotor, Formulation::structured);
  return made;
}

/// Returns the sensors that are on a support, or those that are not.
std::vector<Sensor> choose_sensors(const std::vector<Sensor>& sensors, bool on_support) {
  std::vector<Sensor> chosen;
  for (const Sensor& sensor : sensors)
    if ((sensor.subsystem == spatial::kSupportName) == on_support) chosen.push_back(sensor);
  return chosen;
}

/// Makes a model of a system, or of a part of a machine. `trees`: its own; `blades`: how many of
/// them are blades.
std::unique_ptr<SteadyModel> make_part(const System<Space>& system,
                                       const std::vector<Sensor>& sensors,
                                       const std::vector<spatial::Tree>& trees, std::size_t blades,
                                       const LoopLimits& loops, const SteadyOptions& options) {
  const auto fill = [&](System<Space>& copy) { copy = system; };
  const auto place = [&](const System<Space>& made, StepData<Space>& data) {
    std::vector<SensorColumn> columns = place_sensors(sensors, blades, trees, made, data);
    make_reading_rings(data);
    return columns;
  };
  return std::make_unique<SteadySystem<Space>>(SystemMaker<Space>{fill, place, loops},
                                               name_subsystems(trees), options);
}

/// Lets a wrench act on the hub of a support, less the weight of its ballast.
void load_hub(const HubVector& wrench, const Ballast& ballast, System<Space>& support) {
  const bool falls = support.hub.support == HubSupport::free;
  BodyLoad<Space> load{{},
                       spatial::LoadFrame::inertial,
                       wrench.head<3>(),
                       wrench.tail<3>(),
                       std::make_shared<LoadCourse>(LoadCourse{Curve(1.0)})};
  if (!falls) load.force -= ballast.mass * support.gravity;
  load.points.push_back({.element = 0, .s = 0.0, .weight = 1.0});
  support.subsystems[0].bodies.back().loads.push_back(std::move(load));
}

Eigen::MatrixXd mass_of(const Ballast& ballast) {
  Eigen::VectorXd diagonal(6);
  diagonal << Eigen::Vector3d::Constant(ballast.mass), Eigen::Vector3d::Constant(ballast.inertia);
  return diagonal.asDiagonal();
}

/// Returns the slope of a drive's torque at a speed [N m s/rad].
double find_torque_slope(const Drive& drive, double speed) {
  constexpr double kStep = 1e-6, kLate = std::numeric_limits<double>::max();
  const double step = kStep * std::max(1.0, std::abs(speed));
  return (calc_torque(drive, kLate, speed + step) - calc_torque(drive, kLate, speed - step)) /
         (2.0 * step);
}

/// Makes the model of the rotor of a machine, whose hub has these axes. `blades`: their number.
std::unique_ptr<SteadyModel> make_rotor(const Machine& machine, const Eigen::Matrix3d& axes,
                                        const std::vector<Sensor>& sensors, std::size_t blades,
                                        const LoopLimits& loops, const SteadyOptions& options) {
  System<Space> placed = machine.rotor;
  placed.hub.orientation = make_quaternion(space::Rotation{axes});
  placed.hub.drive = ConstantSpeed{options.speed};
  return make_part(placed, sensors, machine.rotor_trees, blades, loops, options);
}

std::unique_ptr<SteadyModel> make_supported(const Scenario& scenario, const Wind* at_places,
                                            const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  const std::shared_ptr<const Machine> machine = make_machine(model, at_places, options);
  const LoopLimits loops = make_loop_limits(scenario.integration);
  SupportedParts parts;
  parts.rotor = [=, sensors = choose_sensors(scenario.sensors, false),
                 blades = model.blades.size()](const Eigen::Matrix3d& axes, DeadLoads loads) {
    SteadyOptions own = options;
    own.is_whole = loads == DeadLoads::all;
    return make_rotor(*machine, axes, sensors, blades, loops, own);
  };
  parts.support = [=, sensors = choose_sensors(scenario.sensors, true)](const HubVector& wrench) {
    System<Space> loaded = machine->support;
    load_hub(wrench, machine->ballast, loaded);
    return make_part(
        loaded, sensors, machine->support_tree, 0, loops,
        {.instant = options.instant, .has_outputs = options.has_outputs, .is_support = true});
  };
  parts.base = make_rotation(machine->support.hub.orientation).axes;
  parts.ballast = mass_of(machine->ballast);
  parts.averages = options.speed != 0.0 || options.is_axial;
  const Drive& drive = model.hub.drive;
  parts.train = model.support->axle.train;
  parts.turns_freely = !is_hub_prescribed(model, 0);
  parts.has_torque = parts.turns_freely && !std::holds_alternative<FreeDrive>(drive);
  if (!prescribes_motion(drive)) parts.torque_slope = find_torque_slope(drive, options.speed);
  return std::make_unique<SupportedModel>(std::move(parts), options.speed);
}

/// Refuses models whose rotors turn each at its own speed, about axes of their own: a steady model
/// stands in the turning frame of one.
void require_one_rotor(const spatial::Model& model) {
  if (model.rotors.empty()) return;
  throw InputError("rotor: there are " + std::to_string(count_rotors(model)) +
                   ", expected one: a steady state is found in the frame that turns with the "
                   "rotor; several are simulated");
}

/// Refuses anchors beside the axle: of the rotor alone, which a steady model eliminates first,
/// their forces would be the hub's.
void require_hub_anchors(const spatial::Model& model) {
  for (std::size_t i = 0; i < model.anchors.size(); ++i)
    if (model.anchors[i].frame == Anchor::Frame::axle)
      throw InputError(
          "anchor." + std::to_string(i + 1) +
          ".frame: is \"axle\", expected \"hub\": a steady state takes the rotor apart "
          "from its support, and this anchor is on both; runs have it");
}

/// Refuses loops between subsystems, which a steady model takes one by one.
void require_own_loops(const spatial::Model& model) {
  const auto require = [](const std::vector<Loop>& loops, const std::string& key) {
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (loops[k].to.carrier == LoopPlace::Carrier::elsewhere)
        throw InputError(key + ".loop." + std::to_string(k + 1) +
                         ".to: is on another blade or subsystem, expected a place on its own: a "
                         "steady state takes them one by one; runs have it");
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    require(model.blades[i].loops, "blades." + std::to_string(i + 1));
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    require(model.subsystems[i].loops, key_of_subsystem(model, i));
}

/// Refuses couplings on the axle: their coordinates are of the rotor and of its support.
void require_free_axles(const spatial::Model& model) {
  if (!model.support) return;
  const std::vector<Coupling>& couplings = model.subsystems.back().couplings;
  const std::string axle = prefix_of_rotor(model, 0) + "axle";
  for (std::size_t k = 0; k < couplings.size(); ++k)
    for (const CoupledJoint& at : couplings[k].joints)
      if (at.joint == axle)
        throw InputError("support.coupling." + std::to_string(k + 1) + ": couples \"" + axle +
                         "\": a steady state takes the rotor apart from its support, and this is "
                         "on both; runs have it");
}

/// Pitch by the azimuth has a mean whether a drive or torque turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const Scenario& scenario, const Wind* at_places,
                                          const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  require_one_rotor(model);
  require_hub_anchors(model);
  require_free_axles(model);
  require_own_loops(model);
  if (model.support) return make_supported(scenario, at_places, options);
  const std::vector<spatial::Tree> trees = build_trees(model);
  System<Space> system = make_system(model, trees, {{}, available_memory()});
  hold_mount(system.hub, options.instant);
  require_memory(system, Formulation::structured);
  return make_part(system, scenario.sensors, trees, model.blades.size(),
                   make_loop_limits(scenario.integration), options);
}

}  // namespace

std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options) {
  if (!scenario.space) return make_planar(scenario, options);
  if (has_friction(scenario)) return make_steady_model(with_friction_at_rest(scenario), options);
  if (!has_changing_wind(scenario)) return make_spatial(scenario, nullptr, options);
  const Scenario of_places = in_mean_wind(scenario, options.instant, WindPlaces::all);
  const Wind& wind = of_places.space->air->wind;
  if (options.is_whole) return make_spatial(of_places, &wind, options);
  return make_spatial(in_mean_wind(scenario, options.instant, WindPlaces::hub), &wind, options);
}

std::unique_ptr<SteadyModel> make_rotor_model(const Scenario& scenario,
                                              const SteadyOptions& options) {
  assert(scenario.space);
  require_one_rotor(*scenario.space);
  require_hub_anchors(*scenario.space);
  require_free_axles(*scenario.space);
  if (has_friction(scenario)) return make_rotor_model(with_friction_at_rest(scenario), options);
  if (has_changing_wind(scenario))
    return make_rotor_model(in_mean_wind(scenario, options.instant, WindPlaces::hub), options);
  if (!scenario.space->support) return make_spatial(scenario, nullptr, options);
  const std::shared_ptr<const Machine> machine = make_machine(*scenario.space, nullptr, options);
  const spatial::Placement hub = calc_placements(machine->support_tree.front()).back();
  const space::Rotation base = make_rotation(machine->support.hub.orientation);
  return make_rotor(*machine, (base * space::Rotation{hub.rotation}).axes,
                    choose_sensors(scenario.sensors, false), scenario.space->blades.size(),
                    make_loop_limits(scenario.integration), options);
}

}  // namespace spoke::steady
