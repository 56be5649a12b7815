// Parameters of ROSCO become the laws of [control.turbine]. The file is the tests' own.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

constexpr double kGear = 10.0;

/// Parameters of ROSCO for a small turbine.
const std::string& discon() { return samples().at("small_DISCON.IN"); }

foreign::Imported import_with(const std::string& parameters,
                              const std::string& main = "small_turbine.fst") {
  Texts texts = samples();
  texts["DISCON.IN"] = parameters;
  return import_texts(texts, {main, "DISCON.IN"});
}

bool leaves_out_part(const foreign::Imported& imported, const std::string& part) {
  for (const std::string& text : imported.left_out)
    if (contains(text, part)) return true;
  return false;
}

}  // namespace

TEST_CASE("ROSCO's parameters are laws on the hub's side") {
  const foreign::Imported imported = import_with(discon());
  REQUIRE(imported.scenario.space->outer_control);
  const OuterControl& control = *imported.scenario.space->outer_control;
  CHECK(control.joints == std::vector<std::string>{"pitch"});
  CHECK(control.sign == -1.0);
  CHECK(control.yaw_joint == "yaw");
  const TurbineLaws& laws = *control.laws;
  CHECK(*laws.filter->damping == 0.7);
  CHECK(laws.torque->square == Approx(0.9 * kGear * kGear * kGear));
  CHECK(laws.torque->speed == Approx(31.0 / kGear));
  CHECK(laws.torque->rated == Approx(1000.0 * kGear));
  CHECK(laws.torque->above == AboveRated::power);
  CHECK(laws.torque->proportional == Approx(60.0 * kGear * kGear));
  CHECK(laws.torque->integral == Approx(9.0 * kGear * kGear));
  CHECK(*laws.torque->minimum == Approx(1.0));
  CHECK(*laws.torque->maximum == Approx(11000.0));
  CHECK(*laws.torque->rate == Approx(40000.0));
  CHECK(*laws.torque->switch_pitch == 0.017);
  CHECK(laws.pitch->speed == Approx(3.2));
  CHECK(laws.pitch->angle == std::vector<double>{0.0, 0.1, 0.2});
  CHECK(laws.pitch->proportional.at(2) == Approx(-0.05));
  CHECK(laws.pitch->integral.at(0) == Approx(0.08));
  CHECK(laws.pitch->minimum == -0.02);
  CHECK(*laws.pitch->rate == 0.14);
  CHECK(laws.schedule->angle == std::vector<double>{0.0, 0.05});
  CHECK(*laws.schedule->filter == 0.2);
  CHECK(laws.smoothing->torque_gain == 1.5);
  CHECK(laws.smoothing->pitch_gain == 0.001);
  CHECK(laws.individual->integral == 1e-8);
  CHECK(*laws.individual->wind_to == 9.0);
  CHECK(laws.actuator->damping == 0.707);
  CHECK(laws.yaw->error == Approx(8.0 * 3.14159265358979 / 180.0));
  CHECK(leaves_out_part(imported, "WE_Mode, DISCON.IN:12"));
  CHECK(leaves_out_part(imported, "follows what yaws it without a spring"));
  CHECK(std::holds_alternative<TorqueDrive>(imported.scenario.space->hub.drive));
}

TEST_CASE("what of ROSCO's modes is left out, or stands for it, is said") {
  const auto with = [](const std::string& from, const std::string& to) {
    return import_with(replaced(discon(), from, to));
  };
  CHECK(leaves_out_part(with("1             ! VS_ControlMode", "2 ! VS_ControlMode"),
                        "VS_ControlMode, DISCON.IN:7, which is 2: the estimate of the wind"));
  CHECK(leaves_out_part(with("0             ! TD_Mode", "1 ! TD_Mode"), "damping of the tower"));
  CHECK(leaves_out_part(with("1             ! IPC_ControlMode", "2 ! IPC_ControlMode"),
                        "second harmonic"));
  CHECK(leaves_out_part(with("2             ! PA_Mode", "1 ! PA_Mode"), "first order"));
  const auto still = with("1             ! PC_ControlMode", "0 ! PC_ControlMode");
  CHECK_FALSE(still.scenario.space->outer_control->laws->pitch);
  const auto fine = with("1             ! PS_Mode", "0 ! PS_Mode");
  CHECK(fine.scenario.space->outer_control->laws->pitch->minimum == 0.01);
  CHECK_FALSE(fine.scenario.space->outer_control->laws->schedule);
}

TEST_CASE("faults of ROSCO's parameters are refused with their lines") {
  const auto refusal = [](const std::string& from, const std::string& to) {
    return message_of([&] { import_with(replaced(discon(), from, to)); });
  };
  CHECK(refusal("10.0          ! WE_GearboxRatio", "0 ! WE_GearboxRatio") ==
        "DISCON.IN:56: WE_GearboxRatio is 0, expected more than 0");
  CHECK(refusal("-0.008  -0.006  -0.004", "-0.008") ==
        "DISCON.IN:28: PC_GS_KI has 1 numbers, expected 3");
  CHECK(contains(refusal("0.0  0.1  0.2", "0.0 0.2 0.1"),
                 "PC_GS_angles is 0.1 after 0.2, expected each greater than the one before"));
  CHECK(refusal("-60.0", "60.0") == "DISCON.IN:50: VS_KP is 60, expected 0 or less");
  CHECK(refusal("0.9           ! VS_Rgn2K", "0.9 ! VS_Rgn") ==
        "DISCON.IN: has no VS_Rgn2K, expected a line \"value ! VS_Rgn2K\"");
  CHECK(contains(refusal("1             ! VS_ControlMode", "7 ! VS_ControlMode"),
                 "VS_ControlMode is 7, expected 0 to 4"));
  CHECK(contains(message_of([&] {
                   import_texts({{"DISCON.IN", discon()}}, {"DISCON.IN"});
                 }),
                 "has no rotor to control"));
}

TEST_CASE("the parameters that a missing library would read take its place") {
  Texts texts = samples();
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"1             VSContrl", "5 VSContrl"}, {"0             PCMode", "5 PCMode"}})
    texts["small_turbine_ServoDyn.dat"] = replaced(texts["small_turbine_ServoDyn.dat"], from, to);
  texts["small_turbine.IN"] = discon();
  const foreign::Imported imported = import_texts(texts, {"small_turbine.fst"});
  REQUIRE(imported.scenario.space->outer_control);
  CHECK(imported.scenario.space->outer_control->laws);
  CHECK(leaves_out_part(imported, "the library small_turbine.so, in whose place"));
}
