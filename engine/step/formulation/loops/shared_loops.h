#pragma once

// Loops between subsystems (docs/formulation.md, section 12). Each subsystem that such a loop
// visits hands its rows up, see loops.h: the Schur complement of D, N and free. On the way from a
// rotor to the base they are rows again of the support, whose unit forces on the hub are N. Where
// all meet, at the hub of the system, they are one set of rows, which is solved as those of one
// subsystem are.

#include <vector>

#include "engine/step/formulation/loops/loops.h"

namespace spoke {

/// Allocates the rows where they meet. The loops of all subsystems must be allocated.
template <class World>
void allocate_shared_loops(const System<World>& system, StepData<World>& data);
/// Lets them, and the shares of loops, take part as the loops themselves do.
template <class World>
void take_uses_of_shared_loops(const System<World>& system, StepData<World>& data);

/// Puts the rows that the subsystems of a rotor hand up on its hub: unit forces, and what happens
/// without any.
template <class World>
void put_rows_on_hub(const System<World>& system, std::size_t rotor,
                     StepData<World>& data) noexcept;
/// Return the parts that these depend on, and those that are set; none where no loop comes through.
template <class World>
PartList parts_of_rows_on_hub(const System<World>& system, std::size_t rotor,
                              const StepData<World>& data);
template <class World>
PartList parts_with_rows_on_hub(const System<World>& system, std::size_t rotor,
                                const StepData<World>& data);

/// Adds D of the rows that come through the hubs on subsystem `i` to that of its loops.
template <class World>
void add_handed_up(const System<World>& system, std::size_t i, StepData<World>& data) noexcept;
/// Returns the parts that it depends on.
template <class World>
PartList parts_of_handed_up(const System<World>& system, std::size_t i,
                            const StepData<World>& data);

/// Eliminates the rows where they meet, and sets what they add to the hub of the system.
template <class World>
void factorise_shared_loops(const System<World>& system, StepData<World>& data) noexcept;
/// Sets their multipliers, and those of all subsystems that they visit, from the hub's
/// acceleration.
template <class World>
void calc_shared_forces(const System<World>& system, StepData<World>& data) noexcept;
/// Return the parts that these depend on, and those that they set; none without such loops.
template <class World>
PartList parts_of_shared_loops(const StepData<World>& data);
template <class World>
PartList parts_with_shared_loops(const StepData<World>& data);

}  // namespace spoke
