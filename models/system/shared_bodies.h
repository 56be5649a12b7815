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
#include "models/tree/solid_part.h"

namespace spoke {

/// Beams, their bodies, and solids.
class SharedBodies {
 public:
  using Pointer = std::shared_ptr<const space::Body>;

  /// `control`: of what takes seconds.
  explicit SharedBodies(const solid::Control& control) : control_(control) {}

  /// Finds or makes a beam. `beam` must outlive this.
  std::shared_ptr<const space::Beam> find_or_make(const spatial::Beam& beam);
  /// Returns the body between the first and the last of its nodes, which are stations of the beam.
  Pointer find_or_make_body(const std::shared_ptr<const space::Beam>& beam,
                            const std::vector<double>& nodes, ReferenceFrame frame,
                            const std::vector<int>& handles);
  /// Returns a solid with handles at these places, of the constants that its part keeps.
  Pointer find_or_make_solid(const spatial::SolidPart& part, const std::vector<int>& handles);

 private:
  /// A beam has one reference frame, which the key therefore lacks.
  using Key = std::tuple<const space::Beam*, std::vector<double>, std::vector<int>>;

  const solid::Control& control_;
  std::vector<std::pair<const spatial::Beam*, std::shared_ptr<const space::Beam>>> beams_;
  std::map<Key, Pointer> bodies_;
  std::map<std::pair<const space::SolidConstants*, std::vector<int>>, Pointer> solids_;
};

}  // namespace spoke
