// A modulus in GPa or MPa is told by the speed of waves. What is too stiff is not asked about:
// bodies may be meant as rigid.

#include "models/reader/material_hints.h"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <variant>

namespace spoke {
namespace {

/// Waves run faster than this [m/s] in all that parts are made of: in soft rubber and in foam at
/// some 30 m/s, in wood and metals at thousands.
constexpr double kSlowestWaves = 10.0;

/// Adds a hint, if the modulus [Pa] is small for the density [kg/m^3].
void look(const std::string& of, double modulus, double density, std::vector<std::string>& hints) {
  const double speed = std::sqrt(modulus / density);
  if (!hints.empty() || !(speed < kSlowestWaves)) return;
  std::ostringstream text;
  text << "the material of " << of << " has Young's modulus " << modulus << " Pa and density "
       << density << " kg/m^3, in which waves would run at " << speed
       << " m/s, slower than in any part: MPa or GPa?";
  hints.push_back(text.str());
}

}  // namespace

std::vector<std::string> find_material_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  for (std::size_t i = 0; !scenario.space && i < scenario.rotor.blades.size(); ++i) {
    const Blade& blade = scenario.rotor.blades[i];
    if (blade.sections.station.empty())
      look("blade " + std::to_string(i + 1), blade.youngs_modulus, blade.density, hints);
  }
  if (!scenario.space) return hints;
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (const spatial::Body& body : subsystem.bodies) {
      const auto* solid = std::get_if<spatial::SolidBody>(&body.shape);
      if (solid && solid->material)
        look(subsystem.name + " / " + body.name, solid->material->youngs_modulus,
             solid->material->density, hints);
    }
  return hints;
}

}  // namespace spoke
