#pragma once

// Scenarios of one rotor, or of several, on a carrier that stands on a joint.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::test {

/// A rotor of a scenario: its table, or those of the only one.
struct RotorText {
  std::string name = {};  ///< empty: it is the only one
  double speed = 0.0;
  std::string place = "[0, 0, 0]";  ///< on the carrier
  std::string hub = "mass = 2.0, inertia = 0.3";
  int blades = 0;
  std::string drive = {};                           ///< in place of a constant speed
  double mass_factor = 1.0;                         ///< of blades
  std::string size = "bodies = 2\nelements = 2\n";  ///< of blades

  std::string text() const {
    const std::string of = name.empty() ? "" : "rotor.";
    const std::string turns =
        drive.empty() ? "{ kind = \"constant\", speed = " + std::to_string(speed) + " }" : drive;
    const std::string own = hub + ", radius = 0.1, drive = " + turns;
    const std::string on = "body = \"carrier\", offset = " + place;
    std::string all = name.empty() ? "[hub]\n" : "[[rotor]]\nname = \"" + name + "\"\n";
    if (name.empty()) {
      all = "hub = { " + own + " }\n";
    } else {
      all += "hub = { " + own + " }\naxle = { " + on + " }\n";
    }
    if (blades == 0) return all;
    const auto scaled = [&](double value) { return std::to_string(mass_factor * value) + "\n"; };
    return all + "[" + of + "blade]\ncount = " + std::to_string(blades) + "\nlength = 2.0\n" +
           size + "[" + of + "blade.sections]\nmass_per_length = " + scaled(2.0) +
           "axial_stiffness = " + scaled(2e6) + "flap_stiffness = " + scaled(2e3) +
           "lag_stiffness = " + scaled(2e4) + "torsion_stiffness = " + scaled(2e3);
  }
};

/// A rigid carrier of mass 20 on a joint from the ground, given by its keys, with rotors.
inline Scenario make_on_carrier(const std::string& joint, const std::vector<RotorText>& rotors,
                                const std::string& more = "") {
  std::string text = "world = \"space\"\n";
  const bool is_one = rotors.front().name.empty();
  if (is_one) text += rotors.front().text();
  text +=
      "[integration]\nduration = 1.0\n[support]\nfrom = \"ground\"\n[[support.body]]\nname = "
      "\"carrier\"\nkind = \"rigid\"\nmass = 20.0\ninertia = 5.0\ncenter = [0, 0, "
      "0]\n[[support.joint]]\nname = \"foot\"\nchild = \"carrier\"\n" +
      joint + "\n";
  if (is_one) text += "[support.axle]\nbody = \"carrier\"\noffset = " + rotors.front().place + "\n";
  if (!is_one)
    for (const RotorText& rotor : rotors) text += rotor.text();
  return parse_scenario(text + more, "rotors.toml");
}

inline const std::string kSprings =
    "kind = \"bushing\"\nstiffness = [2e5, 3e5, 4e5, 2e4, 3e4, 4e4]";

}  // namespace spoke::test
