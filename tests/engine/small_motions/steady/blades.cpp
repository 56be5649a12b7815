#include "tests/engine/small_motions/steady/blades.h"

#include <sstream>

namespace spoke::test {
namespace {

std::string tail(const UnitBlade& blade) {
  return blade.more + "\n[integration]\nduration = 1.0\n";
}

}  // namespace

Scenario make_planar(const UnitBlade& blade) {
  std::ostringstream text;
  text.precision(17);
  text << "[hub]\nradius = " << blade.radius
       << "\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n[[blades]]\nlength = 1.0\nbodies = "
       << blade.bodies << "\nelements = " << blade.elements
       << "\ndensity = 1.0\narea = 1.0\nsecond_moment = "
       << blade.bending_stiffness / blade.axial_stiffness
       << "\nyoungs_modulus = " << blade.axial_stiffness << "\nazimuth = 0.0\n"
       << tail(blade);
  return parse_scenario(text.str(), "planar.toml");
}

Scenario make_spatial(const UnitBlade& blade) {
  std::ostringstream text;
  text.precision(17);
  text << "world = \"space\"\n[hub]\ninertia = 1.0\nradius = " << blade.radius
       << "\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n[[blades]]\nlength = 1.0\nbodies = "
       << blade.bodies << "\nelements = " << blade.elements
       << "\nazimuth = 0.3\n[blades.sections]\nmass_per_length = 1.0\naxial_stiffness = "
       << blade.axial_stiffness << "\nlag_stiffness = " << blade.bending_stiffness
       << "\nflap_stiffness = " << blade.bending_stiffness
       << "\ntorsion_stiffness = " << 0.1 * blade.bending_stiffness
       << "\nlag_inertia = 1e-8\nflap_inertia = 1e-8\n"
       << blade.joint << tail(blade);
  return parse_scenario(text.str(), "spatial.toml");
}

}  // namespace spoke::test
