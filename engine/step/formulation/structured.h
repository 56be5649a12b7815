#pragma once

// Spoke's own formulation: (P 7) to (P 11) without ever forming what is constant or zero.
//
// Per body, with Mhat = Mff (+ the implicit shares of D and K) factorised once, C = M_Rf:
//   Mhat qf'' + C^T X = Q_f + E_i^T F + E_o^T f      E: the handles' deformation coordinates
//   M_RR X + C qf''   = Q   + J_i^T F + J_o^T f      F, f: wrenches on the handles
// condense_body() (engine/bodies/kernels/structured_body.h) eliminates qf'':
//   qf'' = z - W X + Z_i F + Z_o f,   W = Mhat^-1 C^T,  z = Mhat^-1 Q_f,  Z_e = Mhat^-1 E_e^T
//   S_R X = p + X_i^T F + X_o^T f,    S_R = M_RR - C W,  p = Q - C z,  X_e = J_e - E_e W
// and so to the multi-port of handle accelerations. Per subsystem the tree of multi-ports is
// eliminated from the tips to the root (engine/bodies/tree) (the block-tridiagonal Phi M^-1 Phi^T
// of (P 8)); what remains at the root is (P 10). Trees of one subsystem meet at the hub alone: each
// has a root of its own, and (P 10) is their sum. Trees of rigid bodies alone are eliminated by
// masses. Sources: structured/effective_inertia and recovery; tree_elimination and mass_elimination
// in space.

#include "engine/bodies/kernels/structured_body.h"
#include "engine/bodies/table/step_data.h"
#include "engine/bodies/tree/joint_recovery.h"

namespace spoke::structured {

/// Memory of the formulation per subsystem.
template <class World>
struct alignas(kInterferenceSize) SubsystemWork {
  ArenaVector<BodyWork<World>> bodies;
  std::vector<int> root_bodies;  ///< bodies that the hub carries
  std::vector<int> root_at;      ///< by body: its place among these; -1: another carries it
  ArenaVector<tree::RootElimination<World>> roots;
  ArenaVector<double> storage;  ///< memory of all bodies
  /// Whether the subsystem has rigid bodies alone, in space: they are eliminated by their masses
  /// (engine/bodies/tree/mass_elimination.h) in place of their compliances.
  bool by_mass = false;
};

template <class World>
void allocate(SubsystemData<World>& data, SubsystemWork<World>& work);

/// Calculates effective mass and force (P 10): eliminates the joints from the tips to the roots,
/// over which it sums in their order.
template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept;

/// Calculates what unit forces of one loop do, and its rows' accelerations without them: its parts
/// of LoopData::joints, branches, hub and free. The tree must have been eliminated.
template <class World>
void calc_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                       const SubsystemWork<World>& work, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                               const SubsystemData<World>& data);

/// Fills D of the loops, from the columns of all.
template <class World>
void fill_loop_matrix(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept;
/// Returns the parts that it depends on.
template <class World>
PartList parts_of_loop_matrix(const Subsystem<World>& subsystem, const SubsystemData<World>& data);

/// Adds to the accelerations at joints and roots what the loops' forces make of them, for recovery.
template <class World>
void load_joints_by_loops(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                          SubsystemWork<World>& work) noexcept;
/// Returns the parts that this depends on besides the forces.
template <class World>
PartList parts_of_loaded_joints(const SubsystemData<World>& data) {
  PartList list = data.parts.loops.columns;
  graph::add_to(list, data.parts.effective, data.parts.joints());
  return list;
}

/// Calculates joint wrenches from the roots to the tips (P 8), from the hub's acceleration; by
/// masses the bodies' accelerations as well, in `work`.
template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on: of bodies the multi-ports, and in space the terms, forces
/// of joints among them. Ports of planar tips are in the effective inertia already.
template <class World>
PartList parts_of_wrenches(const SubsystemData<World>& data);

}  // namespace spoke::structured
