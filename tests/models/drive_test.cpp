#include "models/drive.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using doctest::Approx;
using namespace spoke;

namespace {

/// Checks speed and acceleration against central differences of angle and speed.
void check_derivatives(const Drive& drive, double begin, double end) {
  const double e = 1e-4;
  for (double t = begin; t < end; t += 0.173) {
    const DriveMotion before = calc_motion(drive, t - e);
    const DriveMotion after = calc_motion(drive, t + e);
    const DriveMotion motion = calc_motion(drive, t);
    CAPTURE(t);
    CHECK(std::abs(motion.speed - (after.angle - before.angle) / (2.0 * e)) < 1e-6);
    CHECK(std::abs(motion.acceleration - (after.speed - before.speed) / (2.0 * e)) < 1e-6);
  }
}

}  // namespace

TEST_CASE("spin-up to 4 rad/s passes the reference checkpoints") {
  struct Checkpoint {
    double t, angle, speed, acceleration;
  };
  const std::vector<Checkpoint> checkpoints = {{2.5, 0.073424456, 0.11533777, 0.13333333},
                                               {5.0, 1.0536067, 0.78200444, 0.4},
                                               {7.5, 4.4603645, 2.0, 0.53333333},
                                               {10.0, 11.053607, 3.2179956, 0.4},
                                               {12.5, 20.073424, 3.8846622, 0.13333333},
                                               {15.0, 30.0, 4.0, 0.0},
                                               {20.0, 50.0, 4.0, 0.0}};
  const Drive drive = SpinUp{4.0, 15.0};
  for (const Checkpoint& c : checkpoints) {
    const DriveMotion motion = calc_motion(drive, c.t);
    CAPTURE(c.t);
    CHECK(motion.angle == Approx(c.angle).epsilon(1e-7));
    CHECK(motion.speed == Approx(c.speed).epsilon(1e-7));
    CHECK(std::abs(motion.acceleration - c.acceleration) < 1e-8);
  }
}

TEST_CASE("spin-up rests before its start and is exactly at speed after its ramp") {
  const Drive drive = SpinUp{-6.0, 15.0};
  CHECK(calc_motion(drive, -1.0).angle == 0.0);
  CHECK(calc_motion(drive, 0.0).speed == 0.0);
  CHECK(calc_motion(drive, 15.0).speed == -6.0);
  CHECK(calc_motion(drive, 15.0).angle == Approx(-45.0));
  CHECK(calc_motion(drive, 17.0).angle == Approx(-57.0));
}

TEST_CASE("speed and acceleration are the derivatives of the angle for every prescribed motion") {
  check_derivatives(SpinUp{4.0, 15.0}, -0.5, 20.0);
  check_derivatives(SpinUpHoldSpinDown{4.0, 15.0, 5.0, 10.0}, -0.5, 40.0);
  check_derivatives(SpeedTable{Curve({0.0, 4.0, 9.0, 12.0}, {0.0, 3.0, 3.0, -1.0})}, 0.01, 11.9);
}

TEST_CASE("spin-up hold spin-down mirrors its ramp and comes to rest") {
  const Drive drive = SpinUpHoldSpinDown{4.0, 15.0, 5.0, 15.0};
  CHECK(calc_motion(drive, 15.0).angle == Approx(30.0));
  CHECK(calc_motion(drive, 20.0).angle == Approx(50.0));
  CHECK(calc_motion(drive, 20.0).speed == Approx(4.0));
  CHECK(calc_motion(drive, 35.0).angle == Approx(80.0));
  CHECK(calc_motion(drive, 40.0).angle == Approx(80.0));
  CHECK(calc_motion(drive, 40.0).speed == 0.0);
  CHECK(calc_motion(drive, 40.0).acceleration == 0.0);
  for (const double t : {0.5, 3.0, 7.5, 14.0}) {
    const DriveMotion up = calc_motion(drive, t);
    const DriveMotion down = calc_motion(drive, 35.0 - t);
    CHECK(down.speed == Approx(up.speed));
    CHECK(down.acceleration == Approx(-up.acceleration));
    CHECK(80.0 - down.angle == Approx(up.angle));
  }
}

TEST_CASE("the angle of spin-up hold spin-down is continuous at every change of phase") {
  const Drive drive = SpinUpHoldSpinDown{3.0, 2.0, 0.0, 7.0};
  for (const double t : {2.0, 9.0}) {
    const double jump = calc_motion(drive, t + 1e-9).angle - calc_motion(drive, t - 1e-9).angle;
    CHECK(std::abs(jump) < 1e-8);
  }
  CHECK(calc_motion(drive, 9.0).angle == Approx(3.0 * (1.0 + 3.5)));
}

TEST_CASE("a speed table gives its speeds and their integral") {
  const Drive drive = SpeedTable{Curve({0.0, 2.0}, {1.0, 5.0})};
  CHECK(prescribes_motion(drive));
  CHECK(calc_initial_speed(drive) == 1.0);
  CHECK(calc_motion(drive, 1.0).speed == Approx(3.0));
  CHECK(calc_motion(drive, 2.0).angle == Approx(6.0));
  CHECK(calc_motion(drive, 3.0).angle == Approx(11.0));
}

TEST_CASE("torque and free drives leave the motion open") {
  const Drive torque = TorqueDrive{Curve({0.0, 10.0}, {0.0, 20.0}), 1.5};
  CHECK_FALSE(prescribes_motion(torque));
  CHECK(calc_torque(torque, 5.0, 0.0) == Approx(10.0));
  CHECK(calc_initial_speed(torque) == 1.5);
  const Drive free = FreeDrive{-2.0};
  CHECK_FALSE(prescribes_motion(free));
  CHECK(calc_torque(free, 5.0, 0.0) == 0.0);
  CHECK(calc_initial_speed(free) == -2.0);
  CHECK(calc_torque(SpinUp{4.0, 15.0}, 5.0, 0.0) == 0.0);
}

TEST_CASE("drives are named as in scenario files") {
  CHECK(name_of(Drive(SpinUp{})) == "spin_up");
  CHECK(name_of(Drive(SpinUpHoldSpinDown{})) == "spin_up_hold_spin_down");
  CHECK(name_of(Drive(SpeedTable{})) == "table");
  CHECK(name_of(Drive(TorqueDrive{})) == "torque");
  CHECK(name_of(Drive(FreeDrive{})) == "free");
}
