// Goes through the rows of a loop at the state in the table.

#include "engine/bodies/kernels/loops/loop_readings.h"

#include <cassert>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/loops/loop_rows.h"

namespace spoke {
namespace {

/// Returns the sum of what `vector_of(row, motion)` returns for each row of a loop: a vector in H,
/// along the row's unit wrench.
template <class World, class VectorOf>
LoopVector sum_rows(const System<World>& system, std::size_t i, std::size_t k, double t,
                    const StepData<World>& data, const VectorOf& vector_of) {
  assert(i < system.subsystems.size() && k < system.subsystems[i].loops.size());
  const LoopModel& loop = system.subsystems[i].loops[k];
  const auto [from, to] = calc_place_motions(system, i, loop, t, data);
  LoopVector vector;
  for (std::size_t row = 0; row < loop.rows.size(); ++row) {
    const RowMotion motion = calc_loop_row(loop.rows[row], from, to);
    const space::Twist share = vector_of(row, motion);
    vector.in_hub += share;
    // From `to` to `from`.
    if (loop.kind == LoopKind::distance) vector.in_loop[0] += motion.unit.dot(share);
  }
  if (loop.kind != LoopKind::distance) vector.in_loop = to.R.inverse() * vector.in_hub;
  return vector;
}

}  // namespace

template <class World>
LoopVector calc_loop_reaction(const System<World>& system, std::size_t i, std::size_t k, double t,
                              const StepData<World>& data,
                              std::span<const double> multipliers) noexcept {
  assert(i < data.subsystems.size() && k < data.subsystems[i].loops.paths.size());
  const auto first = static_cast<std::size_t>(data.subsystems[i].loops.paths[k].first_row);
  LoopVector vector = sum_rows(system, i, k, t, data,
                               [multipliers, first](std::size_t row, const RowMotion& motion) {
                                 return space::Twist(multipliers[first + row] * motion.unit);
                               });
  // A rod under tension pulls `from` towards `to`.
  if (system.subsystems[i].loops[k].kind == LoopKind::distance)
    vector.in_loop[0] = -vector.in_loop[0];
  return vector;
}

template <class World>
LoopVector calc_loop_opening(const System<World>& system, std::size_t i, std::size_t k, double t,
                             const StepData<World>& data) noexcept {
  return sum_rows(system, i, k, t, data, [](std::size_t, const RowMotion& motion) {
    // The smallest motion that opens the row so far.
    return space::Twist(motion.opening / motion.unit.squaredNorm() * motion.unit);
  });
}

template LoopVector calc_loop_reaction(const System<Plane>&, std::size_t, std::size_t, double,
                                       const StepData<Plane>&, std::span<const double>) noexcept;
template LoopVector calc_loop_opening(const System<Plane>&, std::size_t, std::size_t, double,
                                      const StepData<Plane>&) noexcept;
template LoopVector calc_loop_reaction(const System<Space>&, std::size_t, std::size_t, double,
                                       const StepData<Space>&, std::span<const double>) noexcept;
template LoopVector calc_loop_opening(const System<Space>&, std::size_t, std::size_t, double,
                                      const StepData<Space>&) noexcept;

}  // namespace spoke
