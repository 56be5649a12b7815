// Puts the tables of arms together.

#include "tests/engine/loops/tied_arms.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "models/space/rotation_vector.h"

namespace spoke::test {

const std::vector<HubCase> kHubs{
    {"driven", "[hub]\ninertia=5\n[hub.drive]\nkind='constant'\nspeed=12\n"},
    {"by a torque", "[hub]\ninertia=5\n[hub.drive]\nkind='torque'\ntorque=5\n"},
    {"free",
     "[hub]\nsupport='free'\nmass=20\ncenter=[0.01,0.02,0]\ninertia=[3,3,5]\n"
     "angular_velocity=[0.1,0.2,12]\n"},
    {"on a support",
     "[hub]\nmass=20\ncenter=[0.01,0.02,0]\ninertia=5\n[hub.drive]\nkind='constant'\nspeed=12\n"
     "[support]\nbody=[ { name='stage', kind='rigid', mass=80, inertia=[4,4,4] } ]\n"
     "joint=[ { name='bush', parent='ground', child='stage', kind='bushing',"
     " stiffness=[1e5,2e5,3e5,1e5,1e5,1e5], damping=[100,100,100,50,50,50] } ]\n"
     "axle={ body='stage', offset=[0,0,0.4] }\n"}};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

namespace {

/// An arm on two hinges and a flap on it, which a rod of its own ties to the hub.
struct Arm {
  int index = 0;
  bool is_alone = true;  ///< whether it is a subsystem of its own

  std::string name(const std::string& body) const {
    return is_alone ? body : body + std::to_string(index);
  }
  double angle() const { return 2.0 * std::numbers::pi * index / kArms; }
  std::string bodies() const {
    return "{ name='" + name("arm") + "', kind='rigid', mass=" + std::to_string(5 + index) +
           ", center=[0.5,0.02,0.01], inertia=[0.1,0.6,0.7] }, { name='" + name("flap") +
           "', kind='rigid', mass=1, center=[0.1,0.3,0], inertia=[0.05,0.02,0.05] }";
  }
  std::string joints() const {
    const double x = is_alone ? 0.3 : 0.3 * std::cos(angle());
    const double y = is_alone ? 0.0 : 0.3 * std::sin(angle());
    return "{ name='" + name("hinge") + "', parent='hub', child='" + name("arm") + "', offset=[" +
           number(x) + ',' + number(y) + ",0], orientation=[0,0," +
           number(is_alone ? 0.0 : angle()) +
           "], kind='universal', axes=[[0,-1,0],[0,0,1]], initial=[" + number(0.02 * index) + ',' +
           number(0.03 - 0.01 * index) + "], initial_speed=[" + number(0.1 * index) +
           ",0] }, { name='" + name("turn") + "', parent='" + name("arm") + "', child='" +
           name("flap") + "', kind='revolute', axis=[1,0,0], offset=[0.6,0,0], damping=1 }";
  }
  /// The rod from the flap to the hub.
  std::string rod() const {
    const space::Rotation turn =
        space::exponential(space::Position(0, 0, is_alone ? 0.0 : angle()));
    const space::Position at = turn * space::Position(0.8, 0.2, -0.5);
    return "{ name='" + name("rod") + "', kind='distance', from={ body='" + name("flap") +
           "', point=[0.1,0.3,0] }, to={ body='hub', point=[" + number(at.x()) + ',' +
           number(at.y()) + ',' + number(at.z()) + "] } }";
  }
  /// A coupling of the flap's hinge with the next one's, and with a coordinate of that arm's own.
  std::string gear(const std::string& rest) const {
    const Arm next{(index + 1) % kArms, is_alone};
    const std::string where = is_alone ? "subsystem='arm" + std::to_string(next.index) + "', " : "";
    return "{ name='" + name("gear") + "', joints=[ { joint='" + name("turn") + "', ratio=1 }, { " +
           where + "joint='" + next.name("turn") + "', ratio=-0.7 }, { " + where + "joint='" +
           next.name("hinge") + "', coordinate=2, ratio=0.4 } ]" + rest + " }";
  }
  /// A closure to the next arm.
  std::string tie(const std::string& kind) const {
    const Arm next{(index + 1) % kArms, is_alone};
    const std::string where = is_alone ? "subsystem='arm" + std::to_string(next.index) + "', " : "";
    return "{ name='" + name("tie") + "', from={ body='" + name("arm") +
           "', point=[0.3,0.1,0] }, to={ " + where + "body='" + next.name("flap") +
           "', point=[0,0.1,0.05] }, " + kind + " }";
  }
};

}  // namespace

std::string make_tied_arms(const std::string& hub, bool is_apart, const std::string& tie,
                           int ties) {
  std::string text = "world='space'\n" + hub + kWeight;
  std::string bodies, joints, loops, couplings;
  const bool is_coupled = tie.starts_with("coupling");
  for (int i = 0; i < kArms; ++i) {
    const Arm arm{i, is_apart};
    const std::string comma = is_apart || i == 0 ? "" : ", ";
    if (is_apart) bodies = joints = loops = couplings = "";
    bodies += comma + arm.bodies();
    joints += comma + arm.joints();
    loops += comma + arm.rod() + (i < ties && !is_coupled ? ", " + arm.tie(tie) : "");
    if (i < ties && is_coupled) couplings += comma + arm.gear(tie.substr(8));
    if (is_apart)
      text += "[[subsystem]]\nname='arm" + std::to_string(i) + "'\nazimuth=" + number(arm.angle()) +
              "\nbody=[" + bodies + "]\njoint=[" + joints + "]\nloop=[" + loops + "]\n" +
              (couplings.empty() ? "" : "coupling=[" + couplings + "]\n");
  }
  if (!is_apart)
    text += "[[subsystem]]\nname='all'\nbody=[" + bodies + "]\njoint=[" + joints + "]\nloop=[" +
            loops + "]\n" + (couplings.empty() ? "" : "coupling=[" + couplings + "]\n");
  return text + kOfASecond;
}

std::string make_hammond(double speed, int missing, const std::string& more) {
  const double a = 1.5, lag = 4067.5, tie = 0.5 * lag / (a * a * 0.5);
  std::string text =
      "world='space'\n[hub]\ninertia=5\n[hub.drive]\nkind='constant'\nspeed=" + number(speed) +
      "\n[support]\nbody=[ { name='x', kind='rigid', mass=4743, inertia=100 },"
      " { name='y', kind='rigid', mass=3283.6, inertia=100 } ]\n"
      "joint=[ { parent='ground', child='x', kind='prismatic', axis=[1,0,0], initial=1e-6,"
      " stiffness=1240481.8, damping=51078.7 }, { parent='x', child='y', kind='prismatic',"
      " axis=[0,1,0], stiffness=1240481.8, damping=25539.3 } ]\naxle={ body='y' }\n";
  for (int i = 0; i < 4; ++i) {
    const double centre = 189.1 / 94.9;
    const std::string inertia = number(1084.7 - 94.9 * centre * centre);
    text += "[[subsystem]]\nname='b" + std::to_string(i) +
            "'\nazimuth=" + number(0.5 * std::numbers::pi * i) +
            "\nbody=[ { name='rod', kind='rigid', mass=94.9, center=[" + number(centre) +
            ",0,0], inertia=[1," + inertia + ',' + inertia +
            "] } ]\njoint=[ { name='lag', parent='hub', child='rod', kind='revolute',"
            " axis=[0,0,1], offset=[0.3048,0,0]" +
            more + " } ]\n";
    if (i < missing) continue;
    text += "loop=[ { name='damper', kind='distance', stiffness=1e-9, damping=" + number(tie) +
            ", from={ body='rod', point=[" + number(a) + ",0,0] }, to={ subsystem='b" +
            std::to_string((i + 1) % 4) + "', body='rod', point=[" + number(a) + ",0,0] } } ]\n";
  }
  return text + kOfASecond;
}

}  // namespace spoke::test
