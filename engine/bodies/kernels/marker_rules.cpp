// Checks what a marker says of its place.

#include "engine/bodies/kernels/marker_rules.h"

#include "models/error.h"

namespace spoke {

void require_no_interface(const std::string& whose, const Marker& marker) {
  if (!marker.interface.empty())
    throw InputError(whose + ": its interface \"" + marker.interface +
                     "\" belongs to solids, expected none");
}

void require_on_beam(const std::string& whose, const Marker& marker) {
  require_no_interface(whose, marker);
  if (!marker.point.isZero(0.0))
    throw InputError(whose + ": its point belongs to rigid bodies, expected a station on a beam");
  if (!(marker.station >= 0.0 && marker.station <= 1.0))
    throw InputError(whose + ": station " + std::to_string(marker.station) + ", expected 0 to 1");
}

}  // namespace spoke
