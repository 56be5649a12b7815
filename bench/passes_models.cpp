// Fast rotors, a slow one, hubs driven by torques and free ones. Shipped files are run unchanged
// unless the model says otherwise.
//
// The numbers before were measured by this question with the program of commit a861078, whose
// iteration had a constant matrix on its left without any term of rotation; it is in no program any
// more. Passes do not depend on the machine; times are relative to that of the yardstick
// (passes.cpp) in the same run.

#include "bench/passes_models.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

namespace spoke::bench {
namespace {

std::function<Scenario()> shipped(const std::string& file, const Overrides& overrides = {}) {
  return [=] { return read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / file, overrides); };
}

const std::vector<std::string> kPlanarTip{"blade1.tip.x", "blade1.tip.y"};
const std::vector<std::string> kTip{"blade1.tip.x", "blade1.tip.y", "blade1.tip.z"};

PassesModel whole_run(const std::string& name, std::function<Scenario()> scenario,
                      std::vector<std::string> sensors) {
  PassesModel model;
  model.name = name;
  model.scenario = std::move(scenario);
  model.sensors = std::move(sensors);
  model.spans = {{name, 0.0, {}}};
  return model;
}

PassesModel articulated_rotor() {
  PassesModel model = whole_run("articulated", shipped("articulated_rotor.toml"), kTip);
  model.duration = 25.0;
  model.reference_step = 2.5e-4;
  model.steps = {5e-4, 1e-3, 2e-3, 4e-3, 8e-3};
  model.spans.push_back({"articulated, full speed", 20.0, {2.00, 3.00, 4.87, 8.78, 14.28}});
  model.spans[0].before = {2.01, 2.86, 4.09, 6.35, 9.80};
  model.percent = {0.00282, 5.28, 78.6};
  model.permille = {0.000917, 2.85, 146};
  model.most_passes = 3.0;
  model.most_passes_from = 1e-3;
  model.least_speedup = 3.0;
  model.slow = true;
  return model;
}

/// The rotor driven by a motor that lets go at 36 rad/s and brakes beyond.
PassesModel articulated_by_torque() {
  PassesModel model =
      whole_run("articulated, motor",
                shipped("articulated_rotor.toml",
                        {"hub.drive={kind=\"torque_by_speed\", ramp=2.0,"
                         " speed=[0, 30, 36, 40], torque=[12000, 12000, 0, -8000]}"}),
                kTip);
  model.duration = 25.0;
  model.reference_step = 5e-4;
  model.steps = {2e-3, 4e-3, 8e-3};
  model.spans[0].before = {3.78, 6.43, 9.34};
  model.percent = {0.008, 9.34, 56};
  model.permille = {0.00428, 6.58, 73.7};
  model.most_passes = 3.5;
  model.slow = true;
  return model;
}

PassesModel drone_rotor() {
  PassesModel model = whole_run("drone rotor", shipped("drone_rotor.toml"), kTip);
  model.duration = 1.0;
  model.reference_step = 2.5e-6;
  model.steps = {1e-5, 2e-5, 4e-5, 8e-5, 1.6e-4, 3.2e-4};
  model.spans[0].before = {1.99, 1.99, 1.98, 2.00, 2.82, 3.69};
  model.percent = {4.04e-05, 1.98, 7.65};
  model.permille = {1.3e-05, 1.99, 21.8};
  model.most_passes = 2.5;
  model.slow = true;
  return model;
}

/// Blades with much more inertia than the hub that the motor turns.
PassesModel drone_rotor_by_torque() {
  PassesModel model =
      whole_run("drone rotor, motor",
                shipped("drone_rotor.toml", {"hub.drive={kind=\"torque_by_speed\", ramp=0.1,"
                                             " speed=[0, 628.3185], torque=[1.2, 0]}"}),
                kTip);
  model.duration = 1.0;
  model.reference_step = 2.5e-6;
  model.steps = {1e-5, 2e-5, 4e-5, 8e-5, 1.6e-4, 3.2e-4};
  model.spans[0].before = {1.99, 1.98, 1.98, 2.00, 2.93, 3.80};
  model.percent = {5.37e-05, 1.99, 5.48};
  model.permille = {1.71e-05, 1.98, 17.3};
  model.most_passes = 3.5;
  model.slow = true;
  return model;
}

/// The drone's blades on a free hub of 0.8 kg, spun up within half a second while their lift rises
/// to the weight.
PassesModel free_drone_rotor() {
  PassesModel model = whole_run(
      "drone rotor, free hub",
      shipped("drone_rotor.toml",
              {"hub.support=free", "hub.mass=0.8", "hub.inertia=[1e-5, 1e-5, 2e-5]",
               "hub.drive={kind=\"torque\", time=[0, 0.05, 0.45, 0.5], torque=[0, 0.4425, 0.4425, "
               "0]}",
               "gravity.ramp=0.5",
               "distributed_load=[{frame=\"section\", force_per_length=[0, 0, 24.0], ramp=0.5}]"}),
      kTip);
  model.duration = 1.0;
  model.reference_step = 1e-5;
  model.steps = {4e-5, 8e-5, 1.6e-4, 3.2e-4};
  model.spans[0].before = {1.99, 2.01, 2.21, 2.97};
  model.percent = {0.00032, 2.97, 5.89};
  model.permille = {6.49e-05, 2.00, 19.4};
  model.most_passes = 3.5;
  model.slow = true;
  return model;
}

constexpr const char* kQuadcopter = R"(
title = "Quadcopter"
world = "space"
[hub]
support = "free"
mass = 0.6
inertia = [3e-3, 3e-3, 5e-3]
[gravity]
acceleration = [0, 0, -9.81]
ramp = 0.5
[damping]
stiffness_factor = 1e-6
[integration]
duration = 0.8
)";

/// An arm at an azimuth [rad] with a motor on a shaft, which turns two blades by a torque.
constexpr const char* kArm = R"(
[[subsystem]]
name = "arm{number}"
[[subsystem.body]]
name = "arm"
kind = "beam"
length = 0.2
bodies = 1
[subsystem.body.sections]
mass_per_length = 0.1
axial_stiffness = 4e6
lag_stiffness = 60.0
flap_stiffness = 60.0
torsion_stiffness = 40.0
[[subsystem.body]]
name = "motor"
kind = "rigid"
mass = 0.02
center = [0, 0, 0.01]
inertia = [4e-6, 4e-6, 4e-6]
[[subsystem.joint]]
parent = "hub"
child = "arm"
kind = "fixed"
orientation = [0, 0, {azimuth}]
[[subsystem.joint]]
name = "shaft"
parent = "arm"
child = "motor"
kind = "revolute"
axis = [0, 0, {sense}]
torque = {{ time = [0, 0.02, 0.48, 0.5], value = [0, 0.10735, 0.10735, 0] }}
)";

/// A blade of the motor's, with lift that rises to an eighth of the weight.
constexpr const char* kBlade = R"(
[[subsystem.body]]
name = "blade{blade}"
kind = "beam"
length = 0.12
bodies = 1
[subsystem.body.sections]
mass_per_length = [0.1, 0.036]
axial_stiffness = [4.4e6, 1.575e6]
lag_stiffness = [210.0, 29.5]
flap_stiffness = [2.1, 0.295]
torsion_stiffness = [0.6, 0.084]
twist = [{root_twist}, {tip_twist}]
[[subsystem.joint]]
parent = "motor"
child = "blade{blade}"
kind = "fixed"
offset = [{offset}, 0, 0.02]
orientation = [0, 0, {azimuth}]
[[distributed_load]]
subsystem = "arm{number}"
body = "blade{blade}"
frame = "body"
force_per_length = [0, 0, 8.4333]
ramp = 0.5
)";

Scenario quadcopter_scenario() {
  std::string text = kQuadcopter;
  for (int number = 1; number <= 4; ++number) {
    const int sense = number % 2 == 0 ? -1 : 1;
    text += fmt::format(kArm, fmt::arg("number", number), fmt::arg("sense", sense),
                        fmt::arg("azimuth", 0.7853981634 * (2 * number - 1)));
    for (int blade = 1; blade <= 2; ++blade)
      text += fmt::format(kBlade, fmt::arg("number", number), fmt::arg("blade", blade),
                          fmt::arg("root_twist", 0.3 * sense), fmt::arg("tip_twist", 0.14 * sense),
                          fmt::arg("offset", blade == 1 ? 0.01 : -0.01),
                          fmt::arg("azimuth", blade == 1 ? 0.0 : 3.1415926536));
  }
  return parse_scenario(text, "quadcopter");
}

/// A body with four arms, each with a rotor on a shaft: the spin is that of joints. The
/// displacement compared is that of a blade's tip relative to the body, which includes the turn of
/// the shaft.
PassesModel quadcopter() {
  PassesModel model =
      whole_run("quadcopter", quadcopter_scenario, {"arm1.tip.x", "arm1.tip.y", "arm1.tip.z"});
  model.duration = 0.8;
  model.reference_step = 2e-5;
  model.steps = {8e-5, 1.6e-4, 3.2e-4, 6.4e-4};  // the last one is a fifteenth of a turn
  model.spans[0].before = {2.38, 3.00, 3.74, 4.66};
  model.percent = {0.00064, 4.66, 5.41};
  model.permille = {0.00064, 4.66, 5.31};
  model.most_passes = 3.5;
  model.slow = true;
  return model;
}

PassesModel wind_turbine() {
  PassesModel model = whole_run("NREL 5 MW", shipped("nrel_5mw_rotor.toml"), kTip);
  model.duration = 30.0;
  model.reference_step = 6.25e-4;
  model.steps = {2.5e-3, 5e-3, 0.01, 0.02, 0.04};
  model.spans[0].before = {2.03, 2.87, 3.03, 3.91, 4.59};
  model.percent = {0.0139, 3.10, 2.33};
  model.permille = {0.00436, 2.67, 6.33};
  model.most_passes = 2.5;
  return model;
}

/// A heavy rotor in the plane whose hub, of 1 kg m^2, a torque turns.
PassesModel planar_rotor_by_torque() {
  PassesModel model =
      whole_run("Wu & Haug, torque",
                shipped("wu_haug_rotor.toml", {"hub.drive={kind=\"torque\", time=[0, 3, 12, 15],"
                                               " torque=[0, 35, 35, 0]}"}),
                kPlanarTip);
  model.duration = 20.0;
  model.reference_step = 1.5625e-4;
  model.steps = {6.25e-4, 1.25e-3, 2.5e-3, 5e-3, 0.01, 0.02, 0.04};
  model.spans[0].before = {2.08, 2.47, 2.84, 3.05, 3.74, 4.29, 5.13};
  model.percent = {0.00645, 3.23, 0.544};
  model.permille = {0.00145, 2.57, 1.96};
  model.most_passes = 3.5;
  return model;
}

PassesModel planar_satellite() {
  PassesModel model = whole_run("satellite, plane", shipped("free_hub_satellite.toml"), kPlanarTip);
  model.duration = 60.0;
  model.reference_step = 1.25e-3;
  model.steps = {5e-3, 0.01, 0.02, 0.04, 0.08};
  model.spans[0].before = {2.00, 2.00, 2.00, 2.14, 2.33};
  model.percent = {0.024, 2.02, 0.155};
  model.permille = {0.00692, 2.00, 0.533};
  model.most_passes = 3.5;
  return model;
}

PassesModel satellite() {
  PassesModel model = whole_run("satellite, space", shipped("satellite_booms.toml"), kTip);
  model.duration = 60.0;
  model.reference_step = 1.25e-3;
  model.steps = {5e-3, 0.01, 0.02, 0.04, 0.08};
  model.spans[0].before = {2.00, 2.00, 2.34, 2.99, 3.02};
  model.percent = {0.0165, 2.08, 1.43};
  model.permille = {0.00495, 2.00, 4.77};
  model.most_passes = 3.5;
  return model;
}

PassesModel tree_of_bodies() {
  PassesModel model = whole_run("tree of bodies", shipped("tree_of_bodies.toml"),
                                {"appendage.tip.x", "appendage.tip.y", "appendage.tip.z"});
  model.duration = 40.0;
  model.reference_step = 2.5e-4;
  model.steps = {1e-3, 2e-3, 4e-3, 8e-3, 0.016};
  model.spans[0].before = {2.11, 2.28, 2.87, 3.06, 3.10};
  model.percent = {0.00753, 3.05, 1.25};
  model.permille = {0.00188, 2.25, 3.8};
  model.most_passes = 3.5;
  return model;
}

}  // namespace

std::vector<PassesModel> make_passes_models() {
  return {articulated_rotor(), articulated_by_torque(),
          drone_rotor(),       drone_rotor_by_torque(),
          free_drone_rotor(),  quadcopter(),
          wind_turbine(),      planar_rotor_by_torque(),
          planar_satellite(),  satellite(),
          tree_of_bodies()};
}

}  // namespace spoke::bench
