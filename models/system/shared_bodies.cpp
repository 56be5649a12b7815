// Finds what has been made already.

#include "models/system/shared_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

SharedBodies::PlacedBody SharedBodies::find_or_make_body(
    const std::shared_ptr<const space::Beam>& beam, const std::vector<double>& nodes,
    ReferenceFrame frame, const std::vector<int>& handles) {
  if (const auto stretch = beam->uniform_stretch(nodes.front(), nodes.back()))
    return {find_or_make_uniform(beam, *stretch, nodes, frame, handles), nodes.front()};
  Pointer& body = bodies_[{beam.get(), nodes, handles}];
  if (!body)
    body = std::make_shared<const space::Body>(
        space::Body{make_beam_body(*beam, nodes, frame, handles), beam});
  return {body};
}

// Stations of a beam's cuts are rounded, so that differences of them are equal to a few units in
// the last place of the stations only.
SharedBodies::Pointer SharedBodies::find_or_make_uniform(
    const std::shared_ptr<const space::Beam>& beam, std::size_t stretch,
    const std::vector<double>& nodes, ReferenceFrame frame, const std::vector<int>& handles) {
  std::vector<double> own;  // from the first node
  for (const double node : nodes) own.push_back(node - nodes.front());
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * beam->station.back();
  std::vector<Pointer>& known = uniform_bodies_[{beam.get(), stretch, nodes.size(), handles}];
  const auto at = std::find_if(known.begin(), known.end(), [&](const Pointer& body) {
    return std::equal(own.begin(), own.end(), body->flexible()->stations.begin(),
                      [&](double a, double b) { return std::abs(a - b) <= rounding; });
  });
  if (at != known.end()) return *at;
  const auto piece = std::make_shared<const space::Beam>(beam->uniform_piece(stretch, own.back()));
  return known.emplace_back(std::make_shared<const space::Body>(
      space::Body{make_beam_body(*piece, std::move(own), frame, handles), piece}));
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
