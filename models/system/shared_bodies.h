#pragma once

// Constants of beams and solids, each made once: equal blades share theirs.

#include <cstddef>
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
  /// A body, and where its stations begin.
  struct PlacedBody {
    Pointer body;
    double begin = 0.0;  ///< station on the beam less that of the body [m]
  };
  /// Returns the body between the first and the last of its nodes, which are stations of the beam.
  /// Where the beam is uniform, bodies of equal nodes but for round-off are one, whose stations
  /// begin at 0 with its own piece of the beam.
  PlacedBody find_or_make_body(const std::shared_ptr<const space::Beam>& beam,
                               const std::vector<double>& nodes, ReferenceFrame frame,
                               const std::vector<int>& handles);
  /// Returns a solid with handles at these places, of the constants that its part keeps.
  Pointer find_or_make_solid(const spatial::SolidPart& part, const std::vector<int>& handles);

 private:
  Pointer find_or_make_uniform(const std::shared_ptr<const space::Beam>& beam, std::size_t stretch,
                               const std::vector<double>& nodes, ReferenceFrame frame,
                               const std::vector<int>& handles);

  /// A beam has one reference frame, which the keys therefore lack.
  using Key = std::tuple<const space::Beam*, std::vector<double>, std::vector<int>>;
  /// A uniform stretch of a beam, the count of nodes and the handles.
  using UniformKey = std::tuple<const space::Beam*, std::size_t, std::size_t, std::vector<int>>;

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
  std::map<UniformKey, std::vector<Pointer>> uniform_bodies_;
  std::map<std::pair<const space::SolidConstants*, std::vector<int>>, Pointer> solids_;
};

}  // namespace spoke
