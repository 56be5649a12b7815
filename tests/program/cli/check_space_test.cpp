// Models in space on the command line.

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/program/cli/program.h"

TEST_CASE("check prints the tree of a model in space, and its mass") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", shipped("articulated_rotor")}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"Articulated rotor with cyclic pitch\n", "in space, 4 trees, 24 bodies, 584 coordinates\n",
        "  blade 1         body 1 (beam, 0 to 0.3 m, 4 elements, nonlinear strains), on the hub: "
        "fixed\n",
        "                    body 2 (beam, 0.3 to 0.4 m, 4 elements, nonlinear strains), on body 1 "
        "at 0.3 m: hinges, "
        "universal about [0, -1, 0], [0, 0, 1], free and free\n",
        "                      body 3 ... body 6 (beam, 0.4 to 7.3 m, 16 elements, nonlinear "
        "strains), on body 2 at "
        "0.4 m: pitch, revolute about [1, 0, 0], prescribed\n",
        "67.31 kg, first moment [242.859, 0, 0] kg m\n", "  blade 4         as blade 1\n",
        "  all             269.24 kg, first moment [0, 0, 0] kg m\n"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("check counts the coordinates that a run has") {
  const WorkFolder folder;
  const auto count_of = [&folder](std::vector<std::string> arguments) {
    const Ended ended = run_spoke(arguments, folder);
    REQUIRE(ended.status == 0);
    const std::size_t end = ended.out.find(" coordinates");
    REQUIRE(end != std::string::npos);
    const std::size_t begin = ended.out.rfind(' ', end - 1) + 1;
    return ended.out.substr(begin, end - begin);
  };
  // A prescribed pitch, a hub driven by a torque, free ones, supports.
  for (const char* model : {"articulated_rotor", "vehicle", "nrel_5mw_turbine", "satellite_booms",
                            "helicopter_on_gear", "ground_resonance", "tree_of_bodies"}) {
    CAPTURE(model);
    CHECK(count_of({"check", shipped(model)}) ==
          count_of({"trace", shipped(model), "--steps", "1", "--out", "trace"}));
  }
}

TEST_CASE("check prints the controller of pitch, which overrides may give a model") {
  const WorkFolder folder;
  const std::string control =
      "control.pitch={joint=\"pitch\", speed=34, proportional=0.1, integral=0.2, minimum=0, "
      "maximum=0.2, rate=0.5, sign=-1}";
  const Ended ended = run_spoke({"check", shipped("articulated_rotor"), "--set", control}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("  pitch           joint pitch reversed, hub to 34 rad/s, 0 to 0.2 rad, at "
                       "most 0.5 rad/s, every step\n") != std::string::npos);
  const Ended refused = run_spoke({"check", shipped("articulated_rotor"), "--set", control, "--set",
                                   "control.pitch.joint=hinges"},
                                  folder);
  CHECK(refused.status == 2);
  CHECK(refused.err.find("control.pitch.joint: names a joint of kind \"universal\" on blade 1") !=
        std::string::npos);
}

TEST_CASE("the memory that check tells has the box of turbulence") {
  const WorkFolder folder;
  const auto megabytes = [&folder](const std::string& duration) {
    const Ended ended = run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set", "initial={}",
                                   "--set", "wind.turbulence.duration=" + duration},
                                  folder);
    REQUIRE(ended.status == 0);
    const std::string before = "  memory          about ";
    const std::size_t at = ended.out.find(before);
    REQUIRE(at != std::string::npos);
    return std::stod(ended.out.substr(at + before.size()));
  };
  const double one = megabytes("20"), two = megabytes("40");
  CHECK(one > 0.6);
  CHECK(two > 1.5 * one);
}

TEST_CASE("check prints the drag of bodies") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"check", shipped("nrel_5mw_turbine"), "--set", "air={}", "--set",
                 "wind={velocity=[50,0,0]}", "--set", "support.body.1.drag={diameter=[6.0,3.87]}",
                 "--set", "support.body.2.drag={area=[40,60,50],point=[0,0,1.75]}"},
                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out.find("  drag            support / tower: 6 to 3.87 m wide at 0 to 87.6 m, "
                       "coefficient 1\n                  support / nacelle: areas [40, 60, 50] m^2 "
                       "at [0, 0, 1.75] m\n") != std::string::npos);
}

TEST_CASE("check prints what a condition of IEC 61400-1 stands for, at the model's hub") {
  const WorkFolder folder;
  const auto check = [&folder](const std::string& iec) {
    const Ended ended = run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set", "initial={}",
                                   "--set", "wind={iec=" + iec + "}"},
                                  folder);
    CHECK(ended.err.empty());
    return ended.status == 0 ? ended.out : std::string();
  };
  const std::string gust = check("{class=\"IB\", case=\"EWS\", speed=14, start=60}");
  CHECK(gust.find("  wind            14 m/s along [1, 0, 0] at 90 m") != std::string::npos);
  CHECK(gust.find(", shear exponent 0.2\n                  gust of vertical_shear, ") !=
        std::string::npos);
  CHECK(gust.find(" 1/m from 60 s on for 12 s, one_minus_cosine\n") != std::string::npos);
  const std::string turbulent = check("{class=\"IB\", case=\"NTM\", speed=14}");
  CHECK(turbulent.find("turbulence of 16.1 %, 2.254 m/s, kaimal, seed 1\n") != std::string::npos);
}

TEST_CASE("check prints air, wind, stations and aerofoils") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set", "wind.turbulence.duration=20",
                 "--set", "wind.gust={amplitude=3, start=5}"},
                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"  pitch           joint pitch reversed, hub to 1.26711 rad/s, 0 to 1.5708 rad",
        "  air             1.225 kg/m^3, 1.5e-05 m^2/s, induction momentum, inflow dynamic, stall "
        "dynamic\n",
        "  wind            12 m/s along [1, 0, 0] at 90 m, shear exponent 0.2\n",
        "                  gust of 3 m/s from 5 s on for 10.5 s, one_minus_cosine\n",
        "                  turbulence of 14 %, 1.68 m/s, kaimal, seed 1\n",
        "                  15 x 17 points over 150 x 170 m, every 0.1 s for 20 s, repeats\n",
        "  air, blade 1    19 stations from 0 to 61.5 m, chord 1.419 to 4.652 m, leading edge "
        "towards +y\n                  cylinder1 at 0 to 4.1 m\n                  cylinder2 at "
        "6.8333 m\n",
        "                  naca64 at 43.05 to 61.5 m\n  aerofoils       cylinder1: 3 angles, drag "
        "from 0.5",
        "                  du40: ", ", moment\n"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(ended.out.find("air, blade 2") == std::string::npos);  // as blade 1

  const Ended still = run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set", "wind={}", "--set",
                                 "aerodynamics.inflow_factor=1.15"},
                                folder);
  CHECK(still.out.find("  wind            0 m/s\n") != std::string::npos);
  CHECK(still.out.find("induction momentum times 1.15, inflow dynamic") != std::string::npos);
  const Ended course = run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set",
                                  "wind={velocity=[0,1,0], time=[0,10,60], speed=[4,12,8]}"},
                                 folder);
  CHECK(course.out.find("  wind            4 m/s along [0, 1, 0]\n                  speed over "
                        "time, 4 to 12 m/s, from 0 to 60 s\n") != std::string::npos);
}

TEST_CASE("check prints what a file of wind holds") {
  const WorkFolder folder;
  folder.write("gusty.txt", "0 8\n10 12\n");
  const Ended table = run_spoke(
      {"check", shipped("nrel_5mw_in_wind"), "--set",
       "wind={velocity=[1,0,0], file=\"" + (folder.path() / "gusty.txt").string() + "\"}"},
      folder);
  CAPTURE(table.err);
  CHECK(table.out.find("mean of gusty.txt, a table over time\n") != std::string::npos);
  CHECK(run_spoke({"wind", shipped("nrel_5mw_in_wind"), "--set", "wind.turbulence.duration=20",
                   "--out", "w.bts"},
                  folder)
            .status == 0);
  const Ended box =
      run_spoke({"check", shipped("nrel_5mw_in_wind"), "--set",
                 "wind={velocity=[1,0,0], file=\"" + (folder.path() / "w.bts").string() + "\"}"},
                folder);
  CAPTURE(box.err);
  CHECK(box.out.find("mean of w.bts: 15 x 17 points over 150 x 170 m, every 0.1 s for 20 s, "
                     "repeats\n") != std::string::npos);
}

TEST_CASE("check prints the mean wind of a file at the hub, however high the ground is") {
  const WorkFolder folder;
  // 8 m/s at 90 m, with shear, over a ground 90 m below the hub, which is at the origin.
  const std::string scenario = R"(world = "space"
[hub]
axis = [1, 0, 0]
[hub.drive]
kind = "fixed"
[air]
[wind]
velocity = [8.0, 0, 0]
shear_exponent = 0.2
reference_height = 90.0
ground = -90.0
turbulence = { intensity = 0.1, width = 100.0, points = 5, duration = 60.0 }
[blade]
count = 1
length = 20.0
[blade.sections]
mass_per_length = 100.0
axial_stiffness = 1e12
flap_stiffness = 1e12
lag_stiffness = 1e12
torsion_stiffness = 1e12
[blade.aerodynamics]
station = [0.0, 20.0]
chord = 1.0
airfoil = "round"
[[airfoil]]
name = "round"
angle = [-3.141592653589793, 0, 3.141592653589793]
lift = [0, 0, 0]
drag = [1, 1, 1]
[integration]
duration = 10.0
)";
  folder.write("written.toml", scenario);
  REQUIRE(run_spoke({"wind", "written.toml", "--out", "w.bts"}, folder).status == 0);
  const Ended read = run_spoke(
      {"check", "written.toml", "--set", "wind={ file = \"w.bts\", ground = -90.0 }"}, folder);
  CAPTURE(read.err);
  CAPTURE(read.out);
  const std::size_t at = read.out.find("  wind            ");
  REQUIRE(at != std::string::npos);
  CHECK(std::stod(read.out.substr(at + 18)) == doctest::Approx(8.0).epsilon(1e-3));
  CHECK(read.out.find(" at the hub, 90 m above the ground at -90 m\n", at) != std::string::npos);
}

TEST_CASE("check tells at which speed rk4's limit is, and leaves out large trees") {
  const WorkFolder folder;
  const Ended turning = run_spoke({"check", shipped("heavy_top"), "--set",
                                   "hub.drive.kind=constant", "--set", "hub.drive.speed=30.0"},
                                  folder);
  CHECK(turning.status == 0);
  CHECK(turning.out.find("  rk4             stable up to a step of 0.09428 s (at 30 rad/s)\n") !=
        std::string::npos);
  const Ended large =
      run_spoke({"check", shipped("nrel_5mw_rotor"), "--set", "blade.bodies=60"}, folder);
  CHECK(large.status == 0);
  CHECK(large.out.find("  rk4             largest step not known: the frequencies of \"blade 1\" "
                       "are not computed: it has ") != std::string::npos);
}

TEST_CASE("check prints solids with their interfaces") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", shipped("solid_bracket")}, folder);
  CHECK(ended.status == 0);
  for (const char* part :
       {"bracket (solid bracket.msh, 1009 nodes, ", " kg, reduced, 20 modes), on the hub: ",
        "interface root: rigid, ", " at [0.02, 0.05, 0.4] m, 0.004 m^2\n", "interface tip: rigid, ",
        " at [0.4, 0.05, 0.02] m, 0.004 m^2\n", "rotor (rigid, 2 kg), on bracket at tip: "}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
}

TEST_CASE("check counts coordinates of solids as far as they are known") {
  const WorkFolder folder;
  const std::filesystem::path scenario = shipped("solid_bracket");
  const auto find_size = [&](const std::string& modes) {
    std::string text = file_text(scenario);
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"modes = 20", modes},
          {"mesh = \"meshes", "mesh = \"" + (scenario.parent_path() / "meshes").string()}}) {
      REQUIRE(text.find(from) != std::string::npos);
      text.replace(text.find(from), from.size(), to);
    }
    folder.write("scenario.toml", text);
    const std::string out = run_spoke({"check", "scenario.toml"}, folder).out;
    const std::size_t line = out.find("in space, ");
    REQUIRE(line != std::string::npos);
    return out.substr(line, out.find('\n', line) - line);
  };
  // Besides 30 modes: six shapes of the tip, the bearing, three beams of four elements.
  CHECK(find_size("modes = 30") == "in space, 1 tree, 5 bodies, at most 109 coordinates");
  CHECK(find_size("up_to = 2000.0") ==
        "in space, 1 tree, 5 bodies, 79 coordinates and the modes up to a frequency");
}

TEST_CASE("check prints branches behind the body that they are on") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", shipped("tree_of_bodies")}, folder);
  CHECK(ended.status == 0);
  std::size_t at = 0;
  for (const char* line :
       {"boom / body 1 ... boom / body 2 (beam, 0 to 6 m, 8 elements, nonlinear strains), on the "
        "hub",
        "  bracket (rigid, 2 kg), on boom / body 1 at 3 m: bracket, fixed",
        "    panel (beam, 0 to 4 m, 6 elements, nonlinear strains), on bracket: panel, revolute",
        "  antenna (rigid, 9 kg), on boom / body 2 at 6 m: gimbal, universal"}) {
    CAPTURE(line);
    at = ended.out.find(line, at);
    CHECK(at != std::string::npos);
  }
}

TEST_CASE("check prints frequencies and steps of a model in space, and warns of rk4's") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", shipped("nrel_5mw_rotor")}, folder);
  for (const char* part :
       {"  memory          about ", "  at rest         lowest natural frequency 4.24",
        "                  highest natural frequency ", "  rk4             stable up to a step of ",
        "  integration     generalized_alpha, 3000 steps of 0.01 s\n"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(ended.err.empty());
  const Ended unstable =
      run_spoke({"check", shipped("nrel_5mw_rotor"), "--set", "integration.method=rk4"}, folder);
  CHECK(unstable.status == 0);
  CHECK(unstable.err.find("0.01 s is not stable with rk4, expected at most ") != std::string::npos);
  CHECK(run_spoke({"check", shipped("heavy_top")}, folder).out.find("nothing vibrates") !=
        std::string::npos);
}

TEST_CASE("check accepts every shipped scenario in space, with overrides") {
  const WorkFolder folder;
  for (const char* name :
       {"nrel_5mw_rotor", "drone_rotor", "satellite_booms", "heavy_top", "spatial_wu_haug"}) {
    CAPTURE(name);
    CHECK(run_spoke({"check", shipped(name)}, folder).status == 0);
  }
  const Ended ended = run_spoke(
      {"check", shipped("nrel_5mw_rotor"), "--set", "blade.bodies=8", "--set", "blade.count=2"},
      folder);
  CHECK(ended.out.find("2 trees, 16 bodies") != std::string::npos);
  CHECK(run_spoke({"check", shipped("heavy_top"), "--set", "subsystem.1.body.1.inertia=[1,1,0]"},
                  folder)
            .status == 2);
}

TEST_CASE("a model in space runs as others do") {
  const WorkFolder folder;
  const Ended run = run_spoke(
      {"run", shipped("articulated_rotor"), "--set", "integration.duration=0.02", "--out", "run"},
      folder);
  CHECK(run.status == 0);
  for (const char* file : {"sensors.csv", "summary.json", "report.html"})
    CHECK(std::filesystem::exists(folder.path() / "run" / file));
  const std::string sensors = file_text(folder.path() / "run" / "sensors.csv");
  for (const char* name :
       {"blade1.tip.z", "blade4.hinges.1", "blade2.pitch", "blade3.root.moment.y"})
    CHECK(sensors.find(name) != std::string::npos);
  const Ended trace = run_spoke({"trace", shipped("heavy_top"), "--out", "trace"}, folder);
  CHECK(trace.status == 0);
}

TEST_CASE("a model in space has three formulations") {
  const WorkFolder folder;
  const auto final_tip = [&](const std::string& formulation) {
    REQUIRE(run_spoke({"run", shipped("tree_of_bodies"), "--set", "integration.duration=0.05",
                       "--formulation", formulation, "--out", "run", "--quiet"},
                      folder)
                .status == 0);
    const auto summary = nlohmann::json::parse(file_text(folder.path() / "run" / "summary.json"));
    CHECK(summary["formulation"] == formulation);
    return summary["sensors"]["appendage.tip.z"]["final"].get<double>();
  };
  const double structured = final_tip("structured");
  CHECK(structured != 0.0);
  for (const char* formulation : {"subsystem", "augmented"})
    CHECK(final_tip(formulation) == doctest::Approx(structured).epsilon(1e-6));
  CHECK(run_spoke({"trace", shipped("heavy_top"), "--formulation", "subsystem", "--out", "trace"},
                  folder)
            .status == 0);
}

TEST_CASE("what is not simulated of a model in space is refused in one line") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"run", shipped("articulated_rotor"), "--set", "hub.drive={ kind = \"free\" }",
                 "--set", "integration.method=rk4", "--out", "a"},
                folder);
  CHECK(ended.status == 2);
  CHECK(ended.err.find("follows the azimuth of a hub that no drive prescribes the rotation of, "
                       "expected \"generalized_alpha\"") != std::string::npos);
  CHECK(ended.err.find('\n') == ended.err.size() - 1);
  CHECK(folder.entries() == 0);
}

TEST_CASE("check draws a model, in space or not, in a page that runs nothing") {
  const WorkFolder folder;
  for (const char* name : {"tree_of_bodies", "wu_haug_rotor"}) {
    CAPTURE(name);
    const Ended ended = run_spoke({"check", shipped(name), "--html", "model.html"}, folder);
    CHECK(ended.status == 0);
    CHECK(ended.out.find("  drawn           model.html\n") != std::string::npos);
    CHECK(file_text(folder.path() / "model.html").find("id=\"model-view\"") != std::string::npos);
  }
  CHECK(folder.entries() == 1);
  // With a mount that moves, too.
  const auto mounted = folder.write("mounted.toml", file_text(shipped("heavy_top")) + R"(
[hub.mount]
rotation = { amplitude = [0.1, 0.0, 0.0], frequency = 0.6 }
)");
  CHECK(run_spoke({"check", mounted.string(), "--html", "m.html"}, folder).status == 0);
}

TEST_CASE("a page that cannot be written is refused") {
  const WorkFolder folder;
  const Ended there = run_spoke({"check", shipped("heavy_top"), "--html", "."}, folder);
  CHECK(there.status == 2);
  CHECK(there.err.find('.') != std::string::npos);
  const Ended nowhere = run_spoke({"check", shipped("heavy_top"), "--html", "no/m.html"}, folder);
  CHECK(nowhere.status == 2);
  CHECK(nowhere.err.find("no/m.html: cannot be written") != std::string::npos);
  CHECK(run_spoke({"check", shipped("heavy_top"), "--html", ""}, folder).status == 2);
  CHECK(folder.entries() == 0);
}

TEST_CASE("run tells the largest tip displacements of a model in space") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped("tree_of_bodies"), "--set",
                                 "integration.duration=1", "--no-report", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("  tip moved       ") != std::string::npos);
  CHECK(ended.out.find(" s (appendage)\n") != std::string::npos);
}

TEST_CASE("--vtk writes models in space") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped("heavy_top"), "--set", "integration.duration=0.1",
                                 "--vtk", "--no-report", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("vtk (11 times)") != std::string::npos);
  const std::string last = file_text(folder.path() / "o" / "vtk" / "blades_000010.vtp");
  CHECK(last.find("NumberOfLines=\"0\"") != std::string::npos);
  CHECK(last.ends_with("</VTKFile>\n"));
}

TEST_CASE("check prints loops, redundant rows, the mobility, and what was moved") {
  const WorkFolder folder;
  const Ended ring = run_spoke({"check", shipped("bricard"), "--html", "ring.html"}, folder);
  CHECK(ring.status == 0);
  for (const char* part :
       {"  loops           ring: hinge_6 (revolute, 5 rows), bar_5 to the hub\n",
        "ring: 5 free joint coordinates, less 4 rows (1 of 5 redundant): mobility 1\n",
        "  redundant       ring / hinge_6: "}) {
    CAPTURE(part);
    CHECK(ring.out.find(part) != std::string::npos);
  }
  CHECK(file_text(folder.path() / "ring.html").find("<td>ring / hinge_6</td><td>revolute</td>") !=
        std::string::npos);
  CHECK(file_text(folder.path() / "ring.html")
            .find("<td>ring</td><td>5</td><td>0</td><td>5</td><td>1</td>") != std::string::npos);
  CHECK(run_spoke({"check", shipped("four_bar")}, folder)
            .out.find("  redundant       linkage / close_1, linkage / close_2: displacement along "
                      "z\n") != std::string::npos);
  const Ended car =
      run_spoke({"check", shipped("vehicle"), "--set", "subsystem.1.joint.1.initial=0.02"}, folder);
  CHECK(car.status == 0);
  CHECK(car.out.find("front_left: spring (distance, 1 row, sprung), lower_arm to the hub\n") !=
        std::string::npos);
  CHECK(car.out.find("  moved           front_left / ") != std::string::npos);
}
