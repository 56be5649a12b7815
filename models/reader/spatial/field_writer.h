#pragma once

// Writes the numbers and vectors that spatial_fields.h lists.

#include <string_view>

#include "models/reader/spatial/spatial_fields.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Writes the numbers of a structure, for visit_fields().
struct FieldWriter {
  Json& json;

  template <class Range>
  void operator()(std::string_view key, double value, const Range&, Presence) const {
    json.set(key, value);
  }
  void operator()(std::string_view key, int value, const Count&, Presence) const {
    json.set(key, value);
  }
  void operator()(std::string_view key, const Vector& value, const Quantity&, Presence) const {
    json.set(key, Json::array({value.x(), value.y(), value.z()}));
  }
};

}  // namespace spoke::spatial
