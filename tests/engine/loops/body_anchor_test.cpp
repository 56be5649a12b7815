// Anchors that move against bodies: the same as a body of next to no mass on prescribed joints,
// formulations, work and energy, loops from other subsystems, on beams, and errors.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/tied_arms.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kTime = "time=[0,0.02,0.05,0.1,1], ";
const std::string kHeave = "[0,0.004,-0.003,0.005,0]", kTurn = "[0,0.05,-0.04,0.06,0]";

/// What differs about a machine with a plate that heaves and turns on a carrier.
struct PlateCase {
  std::string kind;         ///< keys of the loop
  bool is_apart = false;    ///< whether the rod is in a subsystem of its own
  bool is_on_beam = false;  ///< whether the carrier is a beam
};

/// The machine: on a driven hub a carrier on a sprung joint, and a rod that a loop ties to the
/// plate. `is_anchor`: the plate is an anchor of the carrier's frame, else a body on prescribed
/// joints.
std::string make_plate(const PlateCase& of, bool is_anchor) {
  const std::string carrier =
      of.is_on_beam
          ? "{ name='carrier', kind='beam', length=0.8, bodies=1, elements=2, strain='nonlinear',"
            " sections={ mass_per_length=2, axial_stiffness=2e4, lag_stiffness=200,"
            " flap_stiffness=150, torsion_stiffness=120 } }"
          : "{ name='carrier', kind='rigid', mass=2, center=[0.1,0.02,0.03],"
            " inertia=[0.05,0.06,0.07] }";
  const std::string at = of.is_on_beam ? "station=0.4, " : "";
  const std::string rod =
      "{ name='rod', kind='rigid', mass=1, center=[0.3,0,0.02], inertia=[0.01,0.08,0.08] }";
  const std::string carried =
      "{ name='tilt', parent='hub', child='carrier', kind='universal', axes=[[1,0,0],[0,1,0]],"
      " offset=[0,0,0.3], stiffness=[40,50], initial=[0.05,-0.04], initial_speed=[0.4,0.3] }";
  const std::string hinge =
      "{ name='hinge', parent='hub', child='rod', kind='universal', axes=[[0,1,0],[0,0,1]],"
      " stiffness=[20,25], initial_speed=[-0.2,0.1] }";
  const std::string slide = "{ parent='carrier', " + at +
                            "child='lift', kind='prismatic', axis=[0,0,1], motion={ " + kTime +
                            "value=" + kHeave +
                            " } }, { parent='lift', child='plate', kind='revolute', axis=[0,0,1],"
                            " motion={ " +
                            kTime + "value=" + kTurn + " } }";
  const std::string light = "kind='rigid', mass=1e-9, inertia=1e-10 }";
  const std::string place = "point=[0.2,0.1,0.05] } }";
  const std::string to = is_anchor ? "to={ anchor='plate', " + place
                                   : "to={ " + std::string(of.is_apart ? "subsystem='s', " : "") +
                                         "body='plate', " + place;
  const std::string loop = "loop=[ { name='tie', " + of.kind +
                           ", from={ body='rod', point=[0.5,0.1,0] }, " + to + " ]\n";
  std::string bodies = carrier, joints = carried;
  if (!is_anchor) {
    bodies += ", { name='lift', " + light + ", { name='plate', " + light;
    joints += ", " + slide;
  }
  std::string text =
      "world='space'\n[hub]\ninertia=5\n[hub.drive]\nkind='constant'\nspeed=4\n" + kWeight;
  if (is_anchor)
    text += "[[anchor]]\nname='plate'\nframe='carrier'\nsubsystem='s'\n" +
            std::string(of.is_on_beam ? "station=0.4\n" : "") + "[anchor.motion]\ntranslation={ " +
            kTime + "x=[0,0,0,0,0], y=[0,0,0,0,0], z=" + kHeave + " }\nrotation={ " + kTime +
            "x=[0,0,0,0,0], y=[0,0,0,0,0], z=" + kTurn + " }\n";
  if (of.is_apart)
    return text + "[[subsystem]]\nname='s'\nbody=[ " + bodies + " ]\njoint=[ " + joints +
           " ]\n[[subsystem]]\nname='t'\nbody=[ " + rod + " ]\njoint=[ " + hinge + " ]\n" + loop +
           kOfASecond;
  return text + "[[subsystem]]\nname='s'\nbody=[ " + bodies + ", " + rod + " ]\njoint=[ " + joints +
         ", " + hinge + " ]\n" + loop + kOfASecond;
}

const std::vector<std::string> kClosures{
    "kind='distance'", "kind='spherical', stiffness=500, damping=3",
    "kind='fixed', stiffness=[400,500,600,20,30,40], damping=[1,1,1,0.1,0.1,0.1]"};

/// Returns the angles of the rod's hinge, 0.1 s from the start.
Eigen::Vector2d run_rod(const std::string& text, const std::string& subsystem) {
  Simulation run(parse_scenario(text, "plate.toml"));
  for (int k = 0; k < 100; ++k) run.step();
  return {run.sensor(subsystem + ".hinge.1"), run.sensor(subsystem + ".hinge.2")};
}

}  // namespace

TEST_CASE("an anchor on a body is a body of next to no mass on prescribed joints") {
  for (const std::string& kind : kClosures)
    for (const bool is_apart : {false, true})
      for (const bool is_on_beam : {false, true}) {
        CAPTURE(kind);
        CAPTURE(is_apart);
        CAPTURE(is_on_beam);
        const PlateCase of{kind, is_apart, is_on_beam};
        const std::string subsystem = is_apart ? "t" : "s";
        const Eigen::Vector2d anchor = run_rod(make_plate(of, true), subsystem);
        const Eigen::Vector2d body = run_rod(make_plate(of, false), subsystem);
        CHECK((anchor - body).norm() < 1e-7);
        CHECK(body.norm() > 1e-3);
      }
}

TEST_CASE("an anchor on a body: formulations agree, and its work is that of the energies") {
  for (const std::string& kind : kClosures)
    for (const bool is_apart : {false, true}) {
      CAPTURE(kind);
      CAPTURE(is_apart);
      std::string text = make_plate({kind, is_apart, false}, true);
      for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})})
        check_formulations(make_system(parse_model(text)), method, 30, 1e-9);
    }
}

TEST_CASE("an anchor on a body: errors") {
  const std::string text = make_plate({kClosures[0]}, true);
  const auto with = [&](const std::string& old, const std::string& made) {
    std::string changed = text;
    changed.replace(changed.find(old), old.size(), made);
    return message_of([&] { parse_scenario(changed, "p.toml"); });
  };
  CHECK(with("frame='carrier'", "frame='carier'").find("anchor.1.frame") != std::string::npos);
  CHECK(with("frame='carrier'", "frame='carier'").find("did you mean \"carrier\"") !=
        std::string::npos);
  CHECK(with("subsystem='s'\n", "subsystem='x'\n").find("anchor.1.subsystem") != std::string::npos);
  CHECK(with("subsystem='s'\n", "").find("along with subsystem") != std::string::npos);
  CHECK(with("subsystem='s'\n", "subsystem='s'\nstation=0.1\n").find("station") !=
        std::string::npos);
  CHECK(with("frame='carrier'\nsubsystem='s'", "frame='hub'\nsubsystem='s'")
            .find("anchor.1.subsystem: is given, but the frame is \"hub\"") != std::string::npos);
  CHECK(with("frame='carrier'", "frame='carrier'\nturns_with_hub=true").find("turns_with_hub") !=
        std::string::npos);
}
