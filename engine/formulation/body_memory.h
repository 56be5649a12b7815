#pragma once

// Stretches of memory that belong together in a world's bodies: by these, the parts of the table
// are declared (engine/step/step_parts.h). Each world lists its own: engine/plane and engine/space,
// body_memory.cpp.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/formulation/structured.h"
#include "engine/table/step_data.h"
#include "graph/step_graph.h"

namespace spoke {

/// Stretches of memory, in no order.
using Memory = std::vector<std::span<std::byte>>;

/// Returns `count` values from the first one on.
template <class T>
std::span<std::byte> memory_of(T* first, std::size_t count) {
  return graph::bytes_of(*first, count);
}

/// Adds the parts of a flex vector that hold coordinates.
template <class Layout>
void add_flex(Memory& memory, double* flex, const Layout& layout) {
  layout.for_parts([&](int first, int n) {
    memory.push_back(graph::bytes_of(flex[first], static_cast<std::size_t>(n)));
  });
}

/// Adds the memory of the coordinates of the joint that carries a body: values and rates, the
/// integrator's history of them, accelerations. Planar joints have none.
inline void add_joint_coordinates(BodyData<Plane>&, Memory&, Memory&, Memory&) {}
void add_joint_coordinates(BodyData<Space>& body, Memory& coordinates, Memory& history,
                           Memory& accelerations);

/// Lists the memory of the results of "position" and "velocity" besides poses and twists.
Memory memory_of_motions(SubsystemData<Plane>& data);
Memory memory_of_motions(SubsystemData<Space>& data);

/// Lists the memory of the twists, and in the plane of the angular accelerations that go with them.
Memory memory_of_twists(SubsystemData<Plane>& data);
inline Memory memory_of_twists(SubsystemData<Space>& data) {
  return {memory_of(&data.twists[0], data.twists.size())};
}

/// Lists the memory of slides that deformation makes.
inline Memory memory_of_slides(SubsystemData<Plane>&) { return {}; }
Memory memory_of_slides(SubsystemData<Space>& data);

/// Lists the memory of the wrenches at the joints, and of the accelerations of joint coordinates
/// that a pass finds.
Memory memory_of_wrenches(SubsystemData<Plane>& data);
Memory memory_of_wrenches(SubsystemData<Space>& data);

/// Lists the memory of the terms of a body, and of the joint that carries it.
Memory memory_of_terms(BodyData<Plane>& body);
Memory memory_of_terms(BodyData<Space>& body);

/// Lists the workspace of the kernels of terms and recovery; none in the plane.
inline Memory memory_of_scratch(BodyData<Plane>&) { return {}; }
Memory memory_of_scratch(BodyData<Space>& body);

/// Lists the memory of the wrenches of elements at the state at which a step begins.
Memory memory_of_wrenches_at_start(BodyData<Plane>& body);
Memory memory_of_wrenches_at_start(BodyData<Space>& body);
/// Lists the memory of the tension on the left-hand side of implicit steps; empty without.
Memory memory_of_tension(BodyData<Plane>& body);
Memory memory_of_tension(BodyData<Space>& body);

/// Memory of a solid in nodal coordinates, by slice; empty for other bodies.
struct SliceMemory {
  std::vector<Memory> tiles;   ///< rows and sums of its terms
  std::vector<Memory> halves;  ///< half solutions (structured)
  /// Accelerations (structured), and last those between slices.
  std::vector<Memory> solution;
};
inline SliceMemory memory_of_slices(BodyData<Plane>&) { return {}; }
SliceMemory memory_of_slices(BodyData<Space>& body);

/// Lists the memory of the formulation `structured` for a body besides the elimination of its
/// joint: its response, the workspace of that, and its multi-port if that is no part of the
/// response. `by_mass`: of a body that is eliminated by its mass.
Memory memory_of_inverse(BodyData<Plane>& body, plane::Condensed& work);
Memory memory_of_inverse(BodyData<Space>& body, BodyTypes<Space>::Condensed& work);
Memory memory_of_workspace(BodyData<Plane>& body, plane::Condensed& work);
inline Memory memory_of_workspace(BodyData<Space>&, BodyTypes<Space>::Condensed&) { return {}; }
inline Memory memory_of_port(BodyData<Plane>&, bool) { return {}; }
Memory memory_of_port(BodyData<Space>& body, bool by_mass);

}  // namespace spoke
