#pragma once

// Constants of beams and solids, each made once: equal blades share theirs.

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "models/solid/solid.h"
#include "models/space/body.h"
#include "models/spatial_model.h"
#include "models/system/beam_modes.h"
#include "models/tree/solid_part.h"

namespace spoke {

/// Beams, their bodies, and solids.
class SharedBodies {
 public:
  using Pointer = std::shared_ptr<const space::Body>;

  /// A beam, and the modes that damp it.
  struct MadeBeam {
    std::shared_ptr<const space::Beam> beam;
    std::shared_ptr<const BeamModes> modes;  ///< none: it is not damped by modes
  };

  /// `damping`: of beams; `control`: of what takes seconds. Both must outlive this.
  SharedBodies(const Damping& damping, const solid::Control& control)
      : damping_(damping), control_(control) {}

  /// Finds or makes a beam; `nodes`: the stations of all its nodes. `beam` must outlive this.
  MadeBeam find_or_make(const spatial::Beam& beam, const std::vector<double>& nodes);
  /// Returns the body between the first and the last of its nodes, which are stations of the beam.
  Pointer find_or_make_body(const std::shared_ptr<const space::Beam>& beam,
                            const std::vector<double>& nodes, ReferenceFrame frame,
                            const std::vector<int>& handles);
  /// Returns a solid with handles at these places, of the constants that its part keeps.
  Pointer find_or_make_solid(const spatial::SolidPart& part, const std::vector<int>& handles);

 private:
  /// A beam has one reference frame, which the key therefore lacks.
  using Key = std::tuple<const space::Beam*, std::vector<double>, std::vector<int>>;

  /// A beam of the description, and its nodes where these decide about its modes.
  struct KnownBeam {
    const spatial::Beam* described;
    std::vector<double> nodes;
    MadeBeam made;
  };

  const Damping& damping_;
  const solid::Control& control_;
  std::vector<KnownBeam> beams_;
  std::map<Key, Pointer> bodies_;
  std::map<std::pair<const space::SolidConstants*, std::vector<int>>, Pointer> solids_;
};

}  // namespace spoke
