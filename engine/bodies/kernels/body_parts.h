#pragma once

// Declares the parts of a body (engine/bodies/table/parts.h) that a method and a formulation add to
// those of the table, as their memory is placed. Each world declares its own: engine/bodies/plane
// and engine/bodies/space, body_parts.cpp.

#include <cstddef>

#include "engine/bodies/kernels/structured_body.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Declare the tension that implicit steps have of body j, if it has any; of a solid in nodal
/// coordinates its tiles, and what of its terms lies between them.
void declare_tension(std::size_t j, SubsystemData<Plane>& data);
inline void declare_tension(std::size_t j, SubsystemData<Space>& data) {
  data.bodies[j].kind->declare_tension(j, data);
}

/// Declare the memory of the formulation `structured` for body j besides the elimination of its
/// joint: its response, the workspace of that, its multi-port if that is no part of the response,
/// and the slices of a solid.
void declare_inverse(std::size_t j, structured::BodyWork<Plane>& work, SubsystemData<Plane>& data);
void declare_inverse(std::size_t j, structured::BodyWork<Space>& work, SubsystemData<Space>& data);

}  // namespace spoke
