// What is made of a reduced solid once, and what a pass asks it.

#include "engine/bodies/kinds/reduced/reduced_kind.h"

#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/condensed_parts.h"
#include "engine/bodies/kinds/solid/condense_solid.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"

namespace spoke {

space::Block ReducedKind::make_block(const space::Body& body,
                                     const space::BlockFactors& factors) const {
  space::Block block;
  block.solid = make_solid_block(*body.solid(), factors);
  block.products.emplace(*body.solid()->constants->reduced());
  return block;
}

std::span<double> ReducedKind::rows_of(const Data& body) const noexcept {
  return {body.work.rows,
          static_cast<std::size_t>(space::kSolidRow * solid_of(body).coordinates())};
}

std::span<double> ReducedKind::scratch_of(const Data& body) const noexcept {
  return {body.work.scratch, space::count_scratch(solid_of(body))};
}

void ReducedKind::declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const {
  const auto count = static_cast<std::size_t>(space::kSolidRow * solid_of(body).coordinates());
  add_condensed(maker, {memory_of(body.work.half, count)}, body, parts);
}

// Counts the matrices, with those that kernels read, and the half solutions.
double ReducedKind::estimate_constants(const space::Body& body) const {
  const space::Solid& solid = *body.solid();
  const double n = solid.coordinates();
  const auto places = static_cast<double>(solid.constants->places.size());
  return sizeof(double) *
         (count_solid_rows(solid) + static_cast<double>(solid.constants->reduced()->shapes.size()) +
          2.0 * n * n * (9.0 + 9.0 + 6.0 * places));
}

void ReducedKind::calc_terms(const System<Space>& system, double t, const space::ImplicitShares&,
                             std::size_t j, SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  body.terms = calc_solid_terms(solid_model_of(body), body_state_of(body),
                                body_motion_of(system, t, j, data), system.damping, body.work);
}

void ReducedKind::condense(const space::Twist& twist, bool implicit,
                           const structured::BodyWork<Space>&, Data& body) const noexcept {
  condense_solid(solid_of(body), solid_block_of(body, implicit), body.terms, angular(twist),
                 body.work);
}

void ReducedKind::recover(const structured::BodyWork<Space>&, bool implicit, Data& body,
                          double* a) const noexcept {
  body.X = recover_solid(solid_of(body), solid_block_of(body, implicit), body.work.wrenches,
                         body.work, a);
}

}  // namespace spoke
