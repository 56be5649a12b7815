// Finds what has been made already.

#include "models/system/shared_bodies.h"

#include <algorithm>

#include "models/tree/space_beam.h"

namespace spoke {

std::shared_ptr<const space::Beam> SharedBodies::find_or_make(const spatial::Beam& beam) {
  const auto at = std::find_if(beams_.begin(), beams_.end(),
                               [&beam](const auto& made) { return *made.first == beam; });
  if (at != beams_.end()) return at->second;
  auto made = std::make_shared<const space::Beam>(spatial::make_space_beam(beam, 0.0));
  return beams_.emplace_back(&beam, std::move(made)).second;
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
