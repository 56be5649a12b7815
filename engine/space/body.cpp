// Places a spatial body's fields in memory, and makes its constant blocks.

#include "engine/space/body.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>

#include "engine/space/solid_limits.h"

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

/// Of a body with strains of second order: coordinates of the norm s bend an element of length l by
/// (sqrt(2) + l) s at most.
double calc_surely_linear(const FlexibleBody& body, double range) {
  double norm = std::numeric_limits<double>::infinity();
  for (const BeamElement& element : body.beam)
    norm = std::min(
        norm, range * element.length / body.length() / (std::numbers::sqrt2 + element.length));
  return norm * norm;
}

}  // namespace

Layout make_layout(const Body& body) { return {body.coordinates()}; }

void set_extent(const Layout& layout, CoordinateBlock& block) { block.size = layout.size(); }

// Returns the bound as a planar body does (engine/plane/body.cpp), for both directions together.
double calc_surely_linear(const Body& body, double range) {
  if (body.rigid()) return std::numeric_limits<double>::infinity();
  assert(range >= 0.0);
  if (const Solid* solid = body.solid()) return calc_surely_linear(*solid, range);
  if (body.flexible()->is_nonlinear()) return calc_surely_linear(*body.flexible(), range);
  const double l = body.flexible()->length() / body.flexible()->elements;
  return range * range / std::max(1.0, 0.5 + l * l / 32.0);
}

Block make_block(const Body& body, const BlockFactors& factors) {
  Block block;
  if (const FlexibleBody* flexible = body.flexible())
    block.elastic = make_elastic_block(*flexible, factors);
  else if (const RigidBody* rigid = body.rigid())
    block.rigid.emplace(*rigid);
  else
    block.solid = make_solid_block(*body.solid(), factors);
  if (body.solid() && body.solid()->constants->reduced())
    block.products.emplace(*body.solid()->constants->reduced());
  return block;
}

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

std::size_t count_fields(const Body& body) {
  return even(std::visit([](const auto& shape) { return count_work(shape); }, body.shape));
}

void place_fields(const Body& body, double* memory, BodyFields& fields) {
  std::visit([&](const auto& shape) { fields.work = place_work(shape, memory); }, body.shape);
}

Section make_section(const Body& body, int element, double s) {
  assert(body.flexible() && body.beam && element >= 0 && element < body.flexible()->elements);
  assert(s >= -1e-9 && s <= 1.0 + 1e-9);
  const FlexibleBody& flexible = *body.flexible();
  const auto e = static_cast<std::size_t>(element);
  return make_section(*body.beam, flexible,
                      flexible.stations[e] + s * (flexible.stations[e + 1] - flexible.stations[e]));
}

}  // namespace spoke::space
