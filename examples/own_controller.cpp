// A controller as an object, which the simulation calls every 20 ms: it holds the speed by the
// pitch of all blades, and the power by the torque. It says what it keeps, so that states can be
// saved.

#include <spoke/spoke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

namespace {

// Blades as plates, which a constant lift turns while their pitch is small.
const std::string kRotor = R"(
world = "space"
[hub]
inertia = [8.0, 8.0, 10.0]
drive = { kind = "torque", torque = -2.0, initial_speed = 1.5 }
[[subsystem]]
name = "vane"
count = 3
[[subsystem.body]]
name = "plate"
kind = "rigid"
mass = 0.5
inertia = 0.5
[[subsystem.joint]]
name = "pitch"
parent = "hub"
child = "plate"
kind = "revolute"
offset = [2.0, 0.0, 0.0]
axis = [1.0, 0.0, 0.0]
motion = { constant = 0.0 }
[[load]]
subsystem = "vane"
body = "plate"
frame = "body"
force = [0.0, 0.0, 3.0]
[control.program]
joint = "pitch"
initial = -0.4
period = 0.02
[integration]
step = 0.005
duration = 30.0
)";

constexpr double kTarget = 2.0;  // rad/s

class Governor final : public spoke::Controller {
 public:
  void control(const spoke::ControlRecord& record, spoke::ControlCommands& commands) override {
    constexpr double proportional = 0.8, integral = 0.4;  // s, rad/rad
    if (record.is_first) demand_ = commands.pitch[0];
    const double error = record.speed - kTarget;
    demand_ = std::clamp(demand_ + integral * record.period * error, -0.5, 0.5);
    const double angle = std::clamp(demand_ + proportional * error, -0.5, 0.5);
    std::fill(commands.pitch.begin(), commands.pitch.end(), angle);
    commands.torque = -4.0 / std::max(record.drive_speed, 1.0);  // a generator of 4 W
  }

  std::optional<std::string> save() const override {
    return std::string(reinterpret_cast<const char*>(&demand_), sizeof demand_);
  }
  void restore(const std::string& saved) override {
    if (saved.size() != sizeof demand_) throw spoke::InputError("the state of another controller");
    std::memcpy(&demand_, saved.data(), saved.size());
  }

 private:
  double demand_ = 0.0;  ///< integral part of the pitch [rad]
};

}  // namespace

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(kRotor, "own_controller");
  spoke::Simulation simulation(scenario, {.controller = std::make_shared<Governor>()});
  spoke::SavedState middle;
  while (!simulation.done()) {
    simulation.run_until(simulation.time() + 5.0);
    std::printf("t = %4.1f s: %.4f rad/s, pitch %+.4f rad, torque %.4f N m\n", simulation.time(),
                simulation.sensor("hub.speed"), simulation.sensor("vane1.pitch"),
                simulation.sensor("hub.torque"));
    if (simulation.time() < 16.0) middle = simulation.save();
  }
  // Another simulation, with a controller of its own, goes on from the middle to the same bits.
  spoke::Simulation second(scenario, {.controller = std::make_shared<Governor>()});
  second.restore(middle);
  second.run_until(scenario.integration.duration);
  if (second.state_hash() != simulation.state_hash()) return 1;
  return std::abs(simulation.sensor("hub.speed") - kTarget) < 0.02 * kTarget ? 0 : 1;
}
