#pragma once

// The part of a condensed body (engine/bodies/table/parts.h).

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Adds the memory of condensing a body to its inverse; `half`: that of its half solutions.
inline void add_condensed(const PartMaker& maker, const Memory& half, BodyData<Space>& body,
                          const BodyParts& parts) {
  space::Condensed& condensed = body.work.condensed;
  const auto handles = static_cast<std::size_t>(body.work.port.handles);
  maker.add(parts.inverse, condensed.S_inverse, condensed.p, half, memory_of(condensed.X, handles));
}

}  // namespace spoke
