#pragma once

// Reads, writes and checks [damping], in the plane and in space.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "models/damping.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/toml_section.h"
#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke {

/// What there is of beams for damping.
struct DampedBeams {
  bool in_plane = false;
  bool is_any = false;                ///< whether there is a beam
  std::size_t least_coordinates = 0;  ///< of the beam that has fewest

  explicit DampedBeams(const std::vector<Blade>& blades);
  explicit DampedBeams(const spatial::Model& model);
};

/// A fault of damping: key and what is wrong; the text is empty if nothing is.
struct DampingFault {
  std::string key, text;
};

/// Finds a fault of what directions and modes give, their numbers out of range among them.
DampingFault find_damping_fault(const Damping& damping, const DampedBeams& beams);

/// Reads [damping] of a scenario's root. Throws InputError; mass_factor remains to be checked.
Damping read_damping(const TomlSection& root, const DampedBeams& beams);

Json damping_to_json(const Damping& damping);

}  // namespace spoke
