#include "models/reader/spatial/section_hints.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <utility>
#include <variant>

namespace spoke {
namespace {

/// Share of a beam's length that the radius of gyration of its sections stays below.
constexpr double kMostGyration = 0.5;

class SectionHints {
 public:
  void look(const std::string& of, const spatial::Beam& beam) {
    const spatial::Sections& s = beam.sections;
    if (!s.mass_6x6.empty() || !s.stiffness_6x6.empty()) return;
    if (s.lag_inertia.empty()) look("lag", of, beam, s.lag_stiffness);
    if (s.flap_inertia.empty()) look("flap", of, beam, s.flap_stiffness);
  }
  std::vector<std::string> take() { return std::move(texts_); }

 private:
  /// Looks at the default inertia of one direction, mass_per_length EI/EA.
  void look(const std::string& direction, const std::string& of, const spatial::Beam& beam,
            const std::vector<double>& stiffness) {
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
      const double radius = std::sqrt(stiffness[i] / beam.sections.axial_stiffness[i]);
      if (radius < kMostGyration * beam.length) continue;
      if (!seen_.insert(direction).second) return;
      std::ostringstream text;
      text << "the default " << direction << "_inertia of " << of
           << " makes a radius of gyration of " << radius << " m at station "
           << beam.sections.station[i] << " m, as that of " << direction << "_stiffness "
           << stiffness[i] << " N m^2 and axial_stiffness " << beam.sections.axial_stiffness[i]
           << " N is, in a beam of " << beam.length << " m: give " << direction
           << "_inertia, or the stiffness that is meant";
      texts_.push_back(text.str());
      return;
    }
  }

  std::set<std::string> seen_;
  std::vector<std::string> texts_;
};

}  // namespace

std::vector<std::string> find_section_hints(const Scenario& scenario) {
  SectionHints hints;
  if (!scenario.space) return {};
  for (std::size_t i = 0; i < scenario.space->blades.size(); ++i)
    hints.look("blade " + std::to_string(i + 1), scenario.space->blades[i].beam);
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (const spatial::Body& body : subsystem.bodies)
      if (const auto* beam = std::get_if<spatial::Beam>(&body.shape))
        hints.look(subsystem.name + " / " + body.name, *beam);
  return hints.take();
}

}  // namespace spoke
