#pragma once

// The nodes of the slices of a solid in nodal coordinates, where it has several: its terms and its
// solution are several nodes of one body.

#include "engine/bodies/table/body_kind.h"
#include "engine/step/assembly.h"

namespace spoke {

/// Returns what a body does by slices; null if it has none of its own. In the plane none has.
inline const BodySlices* slices_of(const BodyData<Plane>&) { return nullptr; }
inline const BodySlices* slices_of(const BodyData<Space>& body) { return body.kind->slices(body); }

/// Adds the nodes of the terms of each slice.
template <class World>
void add_mass_tiles(const Assembly<World>& g, int i, int j);
/// Adds the nodes of the half solutions of each slice.
template <class World>
void add_forward(const Assembly<World>& g, int i, int j);
/// Adds the nodes of the accelerations of each slice, and the node that the integrator takes all
/// from.
template <class World>
void add_backward(const Assembly<World>& g, int i, int j);

}  // namespace spoke
