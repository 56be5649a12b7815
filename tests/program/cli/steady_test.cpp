#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;
using nlohmann::json;

TEST_CASE("static prints an equilibrium and writes its files") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"static", shipped("articulated_rotor"), "--speed", "30"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"30 rad/s", "hub moment", "blade 4", "hinges 2", "static.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  const fs::path results = folder.path() / "results" / "articulated_rotor" / "static";
  const json all = json::parse(file_text(results / "static.json"));
  CHECK(all["speed_rad_per_s"] == 30.0);
  CHECK(all["blades"].size() == 4);
  CHECK(all["blades"][0]["nodes_m"].size() == all["blades"][0]["undeformed_nodes_m"].size());
  CHECK(lines_of(file_text(results / "section_forces.csv")).size() ==
        1 + 4 * all["blades"][0]["section_forces"].size());
  CHECK(file_text(results / "static.html").find("Equilibrium at 30 rad/s") != std::string::npos);
}

TEST_CASE("static says how far bodies bend, warns of it, and writes no -0") {
  const WorkFolder folder;
  const std::vector<std::string> arguments = {
      "static", shipped("spin_up_hold_spin_down"),        "--speed", "-0", "--out", "x",
      "--set",  "load=[{moment=300.0,frame=\"section\"}]"};
  const Ended ended = run_spoke(arguments, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("largest bending blade 1 / body 1 by ") != std::string::npos);
  CHECK(ended.err.starts_with("warning: blade 1 / body 1 bends by "));
  CHECK(ended.err.find("up to which its linear elasticity holds: cut the blade into about ") !=
        std::string::npos);
  const json all = json::parse(file_text(folder.path() / "x" / "static.json"));
  CHECK(all["blades"][0]["bending"].size() == all["blades"][0]["section_forces"].size());
  CHECK("warning: " + all["warnings"][0].get<std::string>() + '\n' == ended.err);
  for (const char* file : {"static.json", "section_forces.csv"}) {
    CAPTURE(file);
    const std::string text = ' ' + file_text(folder.path() / "x" / file);
    for (std::size_t at = text.find("-0"); at != std::string::npos; at = text.find("-0", at + 1)) {
      const bool is_alone = std::string(" ,\n").find(text[at - 1]) != std::string::npos;
      const std::size_t end = text.find_first_of(",\n]", at);
      if (is_alone) CHECK(std::stod(text.substr(at, end - at)) != 0.0);
    }
  }
  CHECK(ended.out.find("-0 ") == std::string::npos);
}

TEST_CASE("modes prints a table and writes its files") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"modes", shipped("wu_haug_rotor"), "--speed", "4", "--count", "3", "--out", "x"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out.find("blades 1 to 3  lag 1") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "x" / "modes.json"));
  CHECK(all["modes"].size() == 3);
  CHECK(all["blades_couple"] == false);
  CHECK(all["modes"][0]["shape"][0]["real"].size() == all["equilibrium"][0]["nodes_m"].size());
  CHECK(lines_of(file_text(folder.path() / "x" / "modes.csv")).size() == 4);
}

TEST_CASE("modes and campbell without --count take what there is") {
  const WorkFolder folder;
  const Ended modes = run_spoke({"modes", shipped("heavy_top"), "--out", "x"}, folder);
  CHECK(modes.status == 0);
  CHECK(lines_of(file_text(folder.path() / "x" / "modes.csv")).size() == 1 + 3);
  const Ended campbell =
      run_spoke({"campbell", shipped("heavy_top"), "--speeds", "1:3:1", "--out", "y"}, folder);
  CHECK(campbell.status == 0);
  CHECK(campbell.err.empty());
}

TEST_CASE("modes and campbell see vibrations from outside") {
  const WorkFolder folder;
  const std::string rotor = shipped("nrel_5mw_rotor");
  const Ended modes = run_spoke(
      {"modes", rotor, "--speed", "1.267", "--count", "4", "--frame", "fixed", "--out", "x"},
      folder);
  CHECK(modes.status == 0);
  CHECK(modes.out.find("flap 1 regressive") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "x" / "modes.json"));
  CHECK(all["frame"] == "fixed");
  const json& energy = all["modes"][0]["energy"];
  double sum = 0.0;
  for (const json& body : energy["bodies"]) sum += body["share"].get<double>();
  CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));  // nothing but blades moves
  CHECK(energy["flap"].get<double>() > 0.8);
  const std::vector<std::string> rows = lines_of(file_text(folder.path() / "x" / "modes.csv"));
  CHECK(rows[0].find(",share_flap,share_lag,share_axial,share_torsion,share_hub,share_of blades 1 "
                     "to 3 / ") != std::string::npos);
  const Ended campbell = run_spoke(
      {"campbell", rotor, "--speeds", "0:1:0.5", "--count", "3", "--frame", "fixed", "--out", "y"},
      folder);
  CHECK(campbell.status == 0);
  CHECK(file_text(folder.path() / "y" / "campbell.html").find("in the frame that stands") !=
        std::string::npos);
  const Ended periodic = run_spoke(
      {"modes", shipped("heavy_top"), "--speed", "3", "--frame", "floquet", "--out", "z"}, folder);
  CHECK(periodic.status == 0);
  CHECK(json::parse(file_text(folder.path() / "z" / "modes.json"))["modes"][0]["harmonics"].size() >
        0);
}

TEST_CASE("a round top has from outside the frequencies of the frame that turns, by the speed") {
  const WorkFolder folder;
  const auto frequencies = [&](const std::string& frame) {
    const Ended ended = run_spoke(
        {"modes", shipped("heavy_top"), "--speed", "3", "--frame", frame, "--out", frame}, folder);
    CHECK(ended.status == 0);
    std::vector<double> found;
    const json all = json::parse(file_text(folder.path() / frame / "modes.json"));
    for (const json& mode : all["modes"])
      found.push_back(mode["frequency_rad_per_s"].get<double>());
    return found;
  };
  const std::vector<double> outside = frequencies("fixed"), turning = frequencies("turning");
  REQUIRE(outside.size() == 3);
  REQUIRE(turning.size() == 3);
  CHECK(outside[1] == doctest::Approx(turning[2] - 3.0).epsilon(1e-7));
  CHECK(outside[2] == doctest::Approx(turning[1] + 3.0).epsilon(1e-7));
}

TEST_CASE("frames that a model cannot be seen in are refused in one line") {
  const WorkFolder folder;
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    const Ended ended = run_spoke(std::move(arguments), folder);
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.err.find(why) != std::string::npos);
    CHECK(lines_of(ended.err).size() == 1);
  };
  const std::string rotor = shipped("nrel_5mw_rotor"), two = shipped("wu_haug_rotor");
  refused({"modes", rotor, "--frame", "outside"}, "--frame");
  refused({"modes", rotor, "--frame"}, "--frame");
  refused({"static", rotor, "--frame", "fixed"}, "--frame");
  refused({"modes", rotor, "--speed", "0", "--frame", "floquet"}, "expects a hub that turns");
  refused({"campbell", rotor, "--speeds", "0:1:0.5", "--frame", "floquet"},
          "expects a hub that turns");
  refused({"modes", rotor, "--frame", "fixed", "--set", "blade.count=2"},
          "of modes the frame \"floquet\" takes any blades");
  refused({"modes", shipped("free_hub_satellite"), "--speed", "0.2", "--frame", "fixed"},
          "three or more equal blades");
  // A top that is round about the axis is seen from outside as a shaft is; this one is not.
  refused({"modes", shipped("heavy_top"), "--speed", "3", "--frame", "fixed", "--set",
           "subsystem.1.body.1.inertia=[0.2,0.4,0.3]"},
          "expects shafts whose mass and stiffness are alike in all directions");
  refused({"campbell", two, "--speeds", "1:2:0.5", "--frame", "fixed", "--set", "blade.count=1"},
          "three or more equal blades, got 1");
}

TEST_CASE("modes are capped, static tells what small motions do, critical has frames") {
  const WorkFolder folder;
  const std::string top = shipped("heavy_top");
  const Ended capped =
      run_spoke({"modes", top, "--speed", "3", "--count", "8", "--out", "x"}, folder);
  CHECK(capped.status == 0);
  CHECK(capped.out.find("8 modes are asked for, top has 3") != std::string::npos);
  const std::string rotor = shipped("wu_haug_rotor");
  const Ended still = run_spoke({"static", rotor, "--speed", "1", "--out", "y"}, folder);
  CHECK(still.status == 0);
  CHECK(still.out.find("small motions") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "y" / "static.json"));
  CHECK(all["stability"]["small_motions"] == "persist");
  const Ended critical = run_spoke({"critical", rotor, "--of", "speed", "--from", "0", "--to", "1",
                                    "--frame", "floquet", "--out", "z"},
                                   folder);
  CHECK(critical.status == 2);
  CHECK(critical.err.find("--frame") != std::string::npos);
}

TEST_CASE("campbell follows modes and writes its files") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"campbell", shipped("wu_haug_rotor"), "--speeds", "0:4:0.5", "--count", "2", "--out", "x"},
      folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("Crossings") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "x" / "campbell.json"));
  CHECK(all["speeds_rad_per_s"].size() == 9);
  CHECK(all["branches"].size() == 2);
  CHECK(all["branches"][0]["mode"] == "lag 1");
  CHECK(lines_of(file_text(folder.path() / "x" / "campbell.csv")).size() == 1 + 2 * 9);
  CHECK(file_text(folder.path() / "x" / "campbell.html").find("per revolution") !=
        std::string::npos);
}

TEST_CASE("critical finds a buckling load, and writes its files") {
  const WorkFolder folder;
  const std::string rotor = shipped("wu_haug_rotor");
  const std::vector<std::string> loaded = {
      "--set",   "load=[{name=\"push\",frame=\"hub\",blade=1,force=[-1.0,0.0]}]",
      "--speed", "0",
      "--count", "2"};
  const auto find = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"critical", rotor});
    arguments.insert(arguments.end(), loaded.begin(), loaded.end());
    return run_spoke(arguments, folder);
  };
  const Ended ended =
      find({"--of", "load=push", "--from", "0", "--to", "40", "--points", "4", "--out", "x"});
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out.find("buckling at a factor of the load push of ") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "x" / "critical.json"));
  CHECK(all["of"] == "load=push");
  CHECK(all["values"].size() == 5);
  const json& critical = all["critical"];
  CHECK(critical["kind"] == "buckling");
  // Euler's load of a cantilever, pi^2/4 EI/L^2.
  CHECK(std::abs(critical["value"].get<double>() - 21.8343) < 1e-3);
  CHECK(critical["mode"]["name"] == "lag 1");
  CHECK(critical["mode"]["of"] == "blade 1");
  CHECK(critical["mode"]["shape"][0]["real"].size() ==
        critical["equilibrium"][0]["nodes_m"].size());
  const std::vector<std::string> rows = lines_of(file_text(folder.path() / "x" / "critical.csv"));
  CHECK(rows[0] ==
        "load_factor,branch,of,mode,frequency_Hz,frequency_rad_per_s,damping_ratio,"
        "eigenvalue_real_per_s,grows,critical");
  CHECK(std::count_if(rows.begin(), rows.end(),
                      [](const std::string& row) { return row.ends_with(",1"); }) == 1);
  CHECK(file_text(folder.path() / "x" / "critical.html").find("campbell-growth") !=
        std::string::npos);
  const Ended none =
      find({"--of", "load=push", "--from", "0", "--to", "1", "--points", "2", "--out", "y"});
  CHECK(none.status == 0);
  CHECK(none.out.find("none: the equilibrium is stable from 0 to 1") != std::string::npos);
  CHECK(json::parse(file_text(folder.path() / "y" / "critical.json"))["critical"] == nullptr);
}

TEST_CASE("critical refuses bad input in one line") {
  const std::string rotor = shipped("wu_haug_rotor");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& text) {
    arguments.insert(arguments.begin(), {"critical", rotor});
    check_refused(arguments, text);
  };
  const std::vector<std::string> range = {"--from", "0", "--to", "4"};
  const auto of = [&](const std::string& what, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"--of", what};
    arguments.insert(arguments.end(), range.begin(), range.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  refused(range, "--of is required");
  for (const std::string what : {"", "mass", "load", "load="})
    refused(of(what), "--of: expected speed or load=NAME, got \"" + what + '"');
  refused({"--of", "speed", "--to", "4"}, "--from is required");
  refused({"--of", "speed", "--from", "4"}, "--to is required");
  for (const std::string end : {"", "nan", "inf", "4 rad", "1e31"})
    refused({"--of", "speed", "--from", "0", "--to", end},
            "--to: expected a number from -1e30 to 1e30, got \"" + end);
  refused({"--of", "speed", "--from", "4", "--to", "1"},
          "the range goes from 4 to 1, expected it to ascend");
  refused(of("speed", {"--points", "1"}), "--points: Value 1 not in range");
  refused(of("speed", {"--count", "0"}), "--count: Value 0 not in range");
  refused(of("speed", {"--speed", "1"}), "a speed is given, expected none");
  refused(of("load=push"), "the load is \"push\", expected \"gravity\"");
  refused(of("load=gravity"), "gravity.acceleration: is 0, expected gravity");
  refused(of("load=push", {"--set",
                           "load=[{name=\"push\",force=[1.0,0.0],time=[0.0,1.0],"
                           "factor=[1.0,0.0]}]"}),
          "the load \"push\" ends with a factor of 0");
  refused(of("speed", {"--set", "load=[{name=\"gravity\",force=[1.0,0.0]}]"}),
          "is \"gravity\", the name of [gravity], expected another one");
  refused(of("speed", {"--set", "load=[{name=\"a b\",force=[1.0,0.0]}]"}),
          "expected letters, digits");
  refused({"--of", "load=push", "--from", "1", "--to", "2", "--set",
           "load=[{name=\"push\",force=[-30.0,0.0]}]", "--speed", "0"},
          "the equilibrium is unstable already: lag 1 of blade");
}

TEST_CASE("linearize writes matrices whose rows and columns have names") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"linearize", shipped("wu_haug_rotor"), "--speed", "4", "--set",
                                 "load=[{force=[0.0,1.0]}]", "--out", "x"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  const json names = json::parse(file_text(folder.path() / "x" / "linear.json"));
  CHECK(names["inputs"].size() == 3);
  CHECK(names["inputs"][0]["name"] == "blade 1 / load.1");
  CHECK(names["outputs"][1] == json{{"name", "blade1.tip.y"}, {"unit", "m"}});
  const std::vector<std::string> b = lines_of(file_text(folder.path() / "x" / "B.mtx"));
  CHECK(b[0] == "%%MatrixMarket matrix coordinate real general");
  const std::string sizes = std::to_string(names["states"].size()) + " 3 ";
  CHECK(b[1] == sizes + std::to_string(b.size() - 2));
}

TEST_CASE("linearize sees a rotor that turns on a support from outside") {
  const WorkFolder folder;
  const std::string machine = shipped("ground_resonance");
  const Ended ended = run_spoke({"linearize", machine, "--out", "x"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out.find("fixed: multi-blade coordinates") != std::string::npos);
  const json names = json::parse(file_text(folder.path() / "x" / "linear.json"));
  CHECK(names["frame"] == "fixed");
  CHECK(names["left_out_inputs"].empty());
  CHECK(names["states"].size() == 10);
  CHECK(names["states"][3] ==
        json{{"name", "blade1, blade2, blade3 / lag cosine"}, {"unit", "rad"}});
  check_refused({"linearize", machine, "--frame", "turning"},
                "the frame \"turning\" expects a hub whose support does not move");
  check_refused({"linearize", machine, "--frame", "floquet"}, "--frame: floquet not in {");
  check_refused({"linearize", machine, "--set", "subsystem.1.count=2"},
                "the frame \"fixed\" expects three or more equal blades, got 2");
}

TEST_CASE("static says why it does not know what small motions do") {
  // The arms of a governor come to lie along its axis, where its loops leave one another free.
  const WorkFolder folder;
  folder.write("g.toml", R"(world = "space"
[hub.drive]
kind = "fixed"
[gravity]
acceleration = [0, 0, -9.81]
[[subsystem]]
name = "g"
body = [
 { name = "collar", kind = "rigid", mass = 2, inertia = 0.01 },
 { name = "arm1", kind = "rigid", mass = 3, center = [0.5, 0, 0], inertia = 1e-3 },
 { name = "arm2", kind = "rigid", mass = 3, center = [0.5, 0, 0], inertia = 1e-3 } ]
joint = [
 { name = "s", parent = "hub", child = "collar", kind = "prismatic", axis = [0, 0, 1], offset = [0, 0, 0.5669873] },
 { name = "a1", parent = "hub", child = "arm1", kind = "revolute", axis = [0, 1, 0], offset = [0, 0, 1], initial = 1.0471975512 },
 { name = "a2", parent = "hub", child = "arm2", kind = "revolute", axis = [0, 1, 0], offset = [0, 0, 1], orientation = [0, 0, 3.14159265358979], initial = 1.0471975512 } ]
loop = [
 { name = "r1", kind = "distance", from = { body = "arm1", point = [0.25, 0, 0] }, to = { body = "collar" }, length = 0.25 },
 { name = "r2", kind = "distance", from = { body = "arm2", point = [0.25, 0, 0] }, to = { body = "collar" }, length = 0.25 } ]
[integration]
step = 2e-3
duration = 1
)");
  const Ended ended = run_spoke({"static", "g.toml", "--out", "o"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("  small motions   not known: g: its loops are in a singular position") !=
        std::string::npos);
  const json all = json::parse(file_text(folder.path() / "o" / "static.json"));
  CHECK(all["stability"]["small_motions"] == "unknown");
  CHECK(all["stability"]["reason"].get<std::string>().find("singular") != std::string::npos);
}

TEST_CASE("static, modes, campbell and linearize refuse bad input in one line") {
  const std::string scenario = shipped("wu_haug_rotor");
  check_refused({"static", scenario, "--speed", "fast"}, "spoke static: ");
  check_refused({"static", shipped("satellite_booms")},
                "hub.support: the hub is free, expected an axle: nothing holds the model");
  check_refused({"modes", scenario, "--count", "0"}, "--count: Value 0 not in range");
  check_refused(
      {"modes", scenario, "--set", "hub.drive={kind=\"torque\",torque=1.0}"},
      "hub.drive: a torque has no steady speed by itself, expected a speed to be given (--speed)");
  const std::string range =
      "--speeds: expected FROM:TO:STEP, ascending numbers up to 1e30 [rad/s], got ";
  for (const std::string speeds :
       {"4:0:0.5", "0:4:-1", "0:4", "a:4:1", "0:4:9", "0:nan:1", "0:1e308:1e307"})
    check_refused({"campbell", scenario, "--speeds", speeds}, range + speeds);
  check_refused({"campbell", scenario, "--speeds", "1:1:1"},
                range + "1:1:1; of one speed: spoke modes --speed 1");
  check_refused({"campbell", scenario}, "--speeds is required");
  for (const std::string command : {"static", "modes", "linearize"})
    for (const std::string speed : {"", "nan", "inf", "1e400", "1e308", "-1e31", "3 rad"})
      check_refused({command, scenario, "--speed", speed},
                    "--speed: expected a number from -1e30 to 1e30 [rad/s], got \"" + speed);
  check_refused({"run", scenario, "--set", "initial={state=\"equilibrium\",speed=1.0}"},
                "initial.speed: is 1, expected a speed that the drive has: 0 at its start, or 4 "
                "after its ramp (rad/s); --set initial={} starts without equilibrium");
}

TEST_CASE("performance refuses bad input in one line") {
  const std::string turbine = shipped("nrel_5mw_in_wind");
  const std::string wind =
      "--wind: expected a number above 0 or FROM:TO:STEP, ascending (m/s), got ";
  for (const std::string given : {"8,12", "fast", "0", "12:8:1", "8:12", "8:12:9", "8:12:-1"})
    check_refused({"performance", turbine, "--wind", given}, wind);
  check_refused({"performance", turbine, "--wind", "1:20000:1"},
                "--wind: expected 10000 numbers at most, got \"1:20000:1\"");
  check_refused({"performance", turbine, "--tip-speed-ratio", "-1"},
                "--tip-speed-ratio: expected a number above 0 or FROM:TO:STEP, ascending, got -1");
  check_refused({"performance", turbine, "--wind", "8", "--pitch", "-200"}, "--pitch: expected a ");
  check_refused({"performance", turbine}, "no wind speeds and no tip-speed ratios are given");
  check_refused({"performance", turbine, "--wind", "8:10:1", "--pitch", "0:2:1"},
                "several pitch angles are given without tip-speed ratios, expected one or none");
  check_refused({"performance", turbine, "--tip-speed-ratio", "7:8:1.001"},
                "--tip-speed-ratio: expected a number above 0 or FROM:TO:STEP, ascending, got "
                "\"7:8:1.001\"");
  check_refused({"performance", turbine, "--wind", "8:10:1", "--tip-speed-ratio", "7"},
                "several wind speeds are given along with tip-speed ratios, expected one or none");
  check_refused({"performance", turbine, "--wind", "8", "--pitch", "1", "--joint", "pich", "--set",
                 "control={}"},
                "no blade has a joint \"pich\", expected the name of the joint that pitches");
  check_refused({"performance", shipped("nrel_5mw_turbine"), "--wind", "8"},
                "air: is missing, expected [air] with the aerodynamics of blades");
}
