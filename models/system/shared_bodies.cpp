// Finds what has been made already.

#include "models/system/shared_bodies.h"

#include <algorithm>

#include "models/tree/space_beam.h"

namespace spoke {

SharedBodies::MadeBeam SharedBodies::find_or_make(const spatial::Beam& beam,
                                                  const std::vector<double>& nodes) {
  const bool has_modes = !damping_.modes.ratios.empty();
  const auto at = std::find_if(beams_.begin(), beams_.end(), [&](const KnownBeam& known) {
    return *known.described == beam && (!has_modes || known.nodes == nodes);
  });
  if (at != beams_.end()) return at->made;
  space::Beam made = spatial::make_space_beam(beam, damping_.directions);
  std::shared_ptr<const BeamModes> modes;
  if (has_modes) {
    modes = std::make_shared<const BeamModes>(find_damped_modes(made, nodes, damping_.modes));
    made.stiffness_damping = modes->stiffness_factor;
  }
  const auto shared = std::make_shared<const space::Beam>(std::move(made));
  return beams_.emplace_back(KnownBeam{&beam, nodes, {shared, modes}}).made;
}

SharedBodies::Pointer SharedBodies::find_or_make_body(
    const std::shared_ptr<const space::Beam>& beam, const std::vector<double>& nodes,
    ReferenceFrame frame, const std::vector<int>& handles) {
  Pointer& body = bodies_[{beam.get(), nodes, handles}];
  if (!body)
    body = std::make_shared<const space::Body>(
        space::Body{make_beam_body(*beam, nodes, frame, handles), beam});
  return body;
}

SharedBodies::Pointer SharedBodies::find_or_make_solid(const spatial::SolidPart& part,
                                                       const std::vector<int>& handles) {
  const std::shared_ptr<const space::SolidConstants> constants =
      find_constants(part, control_).constants;
  Pointer& body = solids_[{constants.get(), handles}];
  if (!body)
    body =
        std::make_shared<const space::Body>(space::Body{space::Solid{constants, handles}, nullptr});
  return body;
}

}  // namespace spoke
