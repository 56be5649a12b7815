// Takes a machine apart into its rotors and its support.

#include "engine/small_motions/steady/make_supported.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/small_motions/steady/steady_mount.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/steady/tied_model.h"
#include "engine/step/model_memory.h"
#include "engine/support/memory.h"
#include "models/system/single_rotor.h"
#include "models/system/spatial_system.h"

namespace spoke::steady {
namespace {

/// The system of a rotor, which many models copy.
struct MachineRotor {
  System<Space> system;
  std::vector<spatial::Tree> trees;
  std::vector<std::size_t> numbers;              ///< of these among all trees
  std::vector<std::vector<std::size_t>> groups;  ///< of these, by group_subsystems()
  std::size_t blades = 0;                        ///< how many of the trees are blades
  Ballast ballast;
};

/// The systems of rotors and of their support.
struct Machine {
  std::vector<MachineRotor> rotors;
  System<Space> support;
  std::vector<spatial::Tree> support_tree;
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

/// Lets the generators of a support spin, which stand in the tree, as rotors of these speeds turn
/// them.
void spin_generators(const SteadyOptions& options, spatial::Tree& support) {
  for (spatial::TreeBody& body : support.bodies) {
    if (!body.is_generator()) continue;
    auto& generator = std::get<spatial::RigidBody>(body.shape);
    generator.spin.z() =
        generator.inertia(2, 2) * body.drive_ratio * options.speed_of(body.driven_by);
  }
}

MachineRotor make_machine_rotor(const spatial::Model& model, int number,
                                const std::vector<spatial::Tree>& trees, const SteadyWinds& winds,
                                const solid::Control& control) {
  MachineRotor rotor;
  rotor.trees = take_trees(trees, number);
  rotor.numbers = list_trees(trees, number);
  spatial::Model taken = without_support(model, number);
  if (!winds.of_rotors.empty()) taken.air->wind = winds.of_rotors[static_cast<std::size_t>(number)];
  rotor.blades = taken.blades.size();
  rotor.ballast = choose_ballast(taken.hub, rotor.trees);
  rotor.system = make_system(taken, rotor.trees, control);
  // All parts of a machine that is free fall alike.
  if (model.support->from == spatial::SupportBase::free) rotor.system.gravity.setZero();
  rotor.groups = group_subsystems(rotor.system);
  require_memory(rotor.system, Formulation::structured);
  return rotor;
}

std::shared_ptr<const Machine> make_machine(const spatial::Model& model, const SteadyWinds& winds,
                                            const SteadyOptions& options) {
  auto made = std::make_shared<Machine>();
  std::vector<spatial::Tree> trees = build_trees(model);
  trees.back().ends.clear();  // of loops that pass through hubs, but are the rotors' own
  made->support_tree = {trees.back()};
  const solid::Control control{{}, available_memory()};
  std::vector<Ballast> ballasts;
  for (int r = 0; r < count_rotors(model); ++r) {
    made->rotors.push_back(make_machine_rotor(model, r, trees, winds, control));
    ballasts.push_back(made->rotors.back().ballast);
  }
  spin_generators(options, trees.back());
  made->support = make_support_alone(model, trees, ballasts, control);
  if (made->support.wind && winds.at_places) made->support.wind = make_wind(*winds.at_places);
  hold_mount(made->support.hub, options.instant);
  return made;
}

std::vector<Sensor> choose_support_sensors(const std::vector<Sensor>& sensors) {
  std::vector<Sensor> chosen;
  for (const Sensor& sensor : sensors)
    if (sensor.subsystem == spatial::kSupportName) chosen.push_back(sensor);
  return chosen;
}

/// Lets a wrench act on a hub of a support, less the weight of its ballast.
void load_hub(const HubVector& wrench, const Ballast& ballast, int hub, System<Space>& support) {
  const bool falls = support.hub.support == HubSupport::free;
  BodyLoad<Space> load{{},
                       spatial::LoadFrame::inertial,
                       wrench.head<3>(),
                       wrench.tail<3>(),
                       std::make_shared<LoadCourse>(LoadCourse{Curve(1.0)})};
  if (!falls) load.force -= ballast.mass * support.gravity;
  load.points.push_back({.element = 0, .s = 0.0, .weight = 1.0});
  support.subsystems[0].bodies[static_cast<std::size_t>(hub)].loads.push_back(std::move(load));
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

/// Makes the model of a rotor of a machine, whose hub has these axes.
std::unique_ptr<SteadyModel> make_rotor(const MachineRotor& rotor, const Eigen::Matrix3d& axes,
                                        const std::vector<Sensor>& sensors, const LoopLimits& loops,
                                        const SteadyOptions& options) {
  System<Space> placed = rotor.system;
  placed.hub.orientation = make_quaternion(space::Rotation{axes});
  placed.hub.drive = ConstantSpeed{options.speed};
  return make_part(placed, sensors, rotor.trees, rotor.blades, loops, options);
}

/// Returns a rotor of a machine as a supported model has it.
RotorParts describe_rotor(const Scenario& scenario, int number,
                          const std::shared_ptr<const Machine>& machine,
                          const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  const auto at = static_cast<std::size_t>(number);
  SteadyOptions own = options;
  own.speed = options.speed_of(number);
  RotorParts parts;
  parts.make = [=, sensors = take_sensors(scenario.sensors, model, number),
                loops = make_loop_limits(scenario.integration)](const Eigen::Matrix3d& axes,
                                                                DeadLoads loads) {
    SteadyOptions whole = own;
    whole.is_whole = loads == DeadLoads::all;
    return make_rotor(machine->rotors[at], axes, sensors, loops, whole);
  };
  const Drive& drive = hub_of(model, number).drive;
  parts.name = hub_of(model, number).name;
  parts.prefix = prefix_of_rotor(model, number);
  parts.trees = machine->rotors[at].numbers;
  parts.body = static_cast<int>(find_hub(machine->support_tree.front(), number));
  parts.speed = own.speed;
  parts.ballast = mass_of(machine->rotors[at].ballast);
  parts.averages = own.speed != 0.0 || options.is_axial;
  parts.train = axle_of(model, number).train;
  parts.turns_freely = !is_hub_prescribed(model, number);
  parts.has_torque = parts.turns_freely && !std::holds_alternative<FreeDrive>(drive);
  if (!prescribes_motion(drive)) parts.torque_slope = find_torque_slope(drive, own.speed);
  return parts;
}

/// Numbers the subsystems of all rotors as their first trees are in the scenario.
void number_subsystems(const Machine& machine, SupportedParts& parts) {
  std::vector<std::size_t> firsts;
  for (const MachineRotor& rotor : machine.rotors)
    for (const std::vector<std::size_t>& group : rotor.groups)
      firsts.push_back(rotor.numbers[group.front()]);
  std::sort(firsts.begin(), firsts.end());
  for (std::size_t r = 0; r < machine.rotors.size(); ++r) {
    const MachineRotor& rotor = machine.rotors[r];
    parts.trees += rotor.trees.size();
    for (const std::vector<std::size_t>& group : rotor.groups) {
      const auto at = std::lower_bound(firsts.begin(), firsts.end(), rotor.numbers[group.front()]);
      parts.rotors[r].subsystems.push_back(static_cast<std::size_t>(at - firsts.begin()));
    }
  }
}

}  // namespace

std::unique_ptr<SteadySystem<Space>> make_space(const System<Space>& system,
                                                const std::vector<Sensor>& sensors,
                                                const std::vector<spatial::Tree>& trees,
                                                std::size_t blades, const LoopLimits& loops,
                                                const SteadyOptions& options) {
  const auto fill = [&](System<Space>& copy) { copy = system; };
  const auto place = [&](const System<Space>& made, StepData<Space>& data) {
    std::vector<SensorColumn> columns = place_sensors(sensors, blades, trees, made, data);
    make_reading_rings(data);
    return columns;
  };
  return std::make_unique<SteadySystem<Space>>(SystemMaker<Space>{fill, place, loops},
                                               name_subsystems(trees), options);
}

std::unique_ptr<SteadyModel> make_part(const System<Space>& system,
                                       const std::vector<Sensor>& sensors,
                                       const std::vector<spatial::Tree>& trees, std::size_t blades,
                                       const LoopLimits& loops, const SteadyOptions& options) {
  auto made = make_space(system, sensors, trees, blades, loops, options);
  if (system.shared_loops.empty()) return made;
  return std::make_unique<TiedModel>(std::move(made));
}

std::unique_ptr<SteadyModel> make_supported(const Scenario& scenario, const SteadyWinds& winds,
                                            const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  const std::shared_ptr<const Machine> machine = make_machine(model, winds, options);
  SupportedParts parts;
  for (int r = 0; r < count_rotors(model); ++r)
    parts.rotors.push_back(describe_rotor(scenario, r, machine, options));
  number_subsystems(*machine, parts);
  parts.support =
      [=, hubs = parts.rotors, sensors = choose_support_sensors(scenario.sensors),
       loops = make_loop_limits(scenario.integration)](const std::vector<HubVector>& wrenches) {
        System<Space> loaded = machine->support;
        for (std::size_t r = 0; r < wrenches.size(); ++r)
          load_hub(wrenches[r], machine->rotors[r].ballast, hubs[r].body, loaded);
        return make_part(loaded, sensors, machine->support_tree, 0, loops,
                         {.instant = options.instant,
                          .has_outputs = options.has_outputs,
                          .is_support = true,
                          .holds_forces = options.holds_forces});
      };
  parts.base = make_rotation(machine->support.hub.orientation).axes;
  return std::make_unique<SupportedModel>(std::move(parts));
}

std::unique_ptr<SteadyModel> make_single_rotor(const Scenario& scenario, int rotor,
                                               const SteadyOptions& options) {
  const std::shared_ptr<const Machine> machine = make_machine(*scenario.space, {}, options);
  const spatial::Tree& support = machine->support_tree.front();
  const spatial::Placement hub = calc_placements(support)[find_hub(support, rotor)];
  const space::Rotation base = make_rotation(machine->support.hub.orientation);
  return make_rotor(machine->rotors[static_cast<std::size_t>(rotor)],
                    (base * space::Rotation{hub.rotation}).axes,
                    take_sensors(scenario.sensors, *scenario.space, rotor),
                    make_loop_limits(scenario.integration), options);
}

}  // namespace spoke::steady
