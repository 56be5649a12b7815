// Lays out the coordinates of a spatial body, and places the state of its joint in memory.

#include "engine/bodies/space/body.h"

#include <cassert>
#include <memory>
#include <utility>

namespace spoke::space {
namespace {

constexpr std::size_t kMotion = sizeof(PrescribedMotion) / sizeof(double);
constexpr std::size_t kForces = sizeof(JointForces) / sizeof(double);
constexpr std::size_t kRotationState = sizeof(RotationState) / sizeof(double);

std::size_t even(std::size_t n) { return n + n % 2; }

/// Returns the doubles of one vector of a joint's coordinates.
std::size_t joint_stride(const Joint& joint) {
  return even(static_cast<std::size_t>(joint.coordinates));
}

/// Returns the vectors of a joint's coordinates: q, v, a, a_found and the integrator's.
std::size_t joint_vectors(int history) { return 4 + static_cast<std::size_t>(history); }

}  // namespace

Layout make_layout(const Body& body) { return {body.coordinates()}; }

void set_extent(const Layout& layout, CoordinateBlock& block) { block.size = layout.size(); }

std::size_t count_state(const Joint& joint, int history) {
  return joint_stride(joint) * joint_vectors(history) + even(kForces) + even(kRotationState) +
         even(kMotion * static_cast<std::size_t>(joint.driven));
}

void place_state(const Joint& joint, int history, double* memory, BodyFields& fields) {
  const auto take = [&memory](std::size_t count) {
    return std::exchange(memory, memory + even(count));
  };
  JointData& data = fields.joint;
  CoordinateBlock& block = data.coordinates;
  block.size = joint.coordinates;
  const std::size_t stride = joint_stride(joint);
  block.q = take(stride);
  block.v = take(stride);
  block.a = take(stride);
  data.a_found = take(stride);
  for (int k = 0; k < history; ++k) block.history[static_cast<std::size_t>(k)] = take(stride);
  data.forces = std::construct_at(reinterpret_cast<JointForces*>(take(kForces)));
  data.rotation = std::construct_at(reinterpret_cast<RotationState*>(take(kRotationState)));
  data.driven =
      reinterpret_cast<PrescribedMotion*>(take(kMotion * static_cast<std::size_t>(joint.driven)));
  std::uninitialized_value_construct_n(data.driven, joint.driven);
}

}  // namespace spoke::space
