#include "models/reader/spatial/tension_hints.h"

#include <variant>

#include "models/tree/beam_strain.h"

namespace spoke {
namespace {

/// Adds a hint at a beam, if it is given linear strains; `unknown`: what these do not know.
void look(const std::string& of, const spatial::Beam& beam, const std::string& unknown,
          std::vector<std::string>& hints) {
  if (beam.strain != spatial::BeamStrain::linear || !beam.geometric_stiffening) return;
  if (!unknown.empty())
    hints.push_back("the linear strains of " + of +
                    " know the tension that rotation of the hub, gravity and loads put on the "
                    "undeformed bodies, but " +
                    unknown + ": give strain \"nonlinear\", or leave it to \"automatic\"");
  else if (has_axis_beside(beam))
    hints.push_back("the sections of " + of +
                    " have their centres beside its axis, where linear strains make torsion in "
                    "rotation wrong: give strain \"nonlinear\", or leave it to \"automatic\"");
}

void look(const spatial::Model& model, const spatial::Subsystem& subsystem,
          std::vector<std::string>& hints) {
  const std::string unknown = find_unknown_tension(model, subsystem);
  for (const spatial::Body& body : subsystem.bodies) {
    const std::string of = subsystem.name + " / " + body.name;
    if (const auto* beam = std::get_if<spatial::Beam>(&body.shape)) look(of, *beam, unknown, hints);
    const auto* solid = std::get_if<spatial::SolidBody>(&body.shape);
    if (!solid || !solid->geometric_stiffening || solid->frame != spatial::SolidFrame::clamped)
      continue;
    if (const std::string cause = find_joint_or_loop(model, subsystem, body.name); !cause.empty())
      hints.push_back("the solid " + of +
                      " knows the tension that rotation of the hub, gravity and loads put on the "
                      "undeformed bodies, but " +
                      cause +
                      ": within it the tension by that is missed; cut it into several solids, or "
                      "take a beam where it is slender");
  }
}

}  // namespace

std::vector<std::string> find_tension_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  if (!scenario.space) return hints;
  const spatial::Model& model = *scenario.space;
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    look("blade " + std::to_string(i + 1), model.blades[i].beam,
         find_unknown_tension(model, model.blades[i]), hints);
  for (const spatial::Subsystem& subsystem : model.subsystems) look(model, subsystem, hints);
  return hints;
}

}  // namespace spoke
