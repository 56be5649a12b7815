// What is made of a solid in nodal coordinates once, and what a pass asks it.

#include "engine/bodies/kinds/nodal/nodal_kind.h"

#include <algorithm>
#include <cmath>

#include "engine/bodies/kernels/body_memory.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/nodal/nodal_body.h"
#include "engine/bodies/kinds/solid/condense_solid.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"

namespace spoke {

space::Block NodalKind::make_block(const space::Body& body,
                                   const space::BlockFactors& factors) const {
  space::Block block;
  block.solid = make_solid_block(*body.solid(), factors);
  return block;
}

// Hands the solid its tiles besides, and memory for its kernels.
void NodalKind::make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                             Data& body) const {
  SolidKind::make_tension(implicit, memory, body);
  const space::Solid& solid = solid_of(body);
  const auto& place = body.model->stiffening;
  const space::SolidTension* tension = body.solid_tension && place ? place->solid.get() : nullptr;
  const space::SolidConstants& constants = *solid.constants;
  body.tiles = &find_or_add(memory.constants->tiles, {&constants, tension},
                            [&] { return space::make_nodal_tiles(constants, tension); });
  memory.nodal_memory.push_back(std::make_unique<space::NodalMemory>());
  space::place_nodal_work(solid, *body.tiles, solid_block_of(body, false),
                          solid_block_of(body, true), *memory.nodal_memory.back(), body.work);
}

// Counts the matrices, with those that kernels read, and the half solutions.
double NodalKind::estimate_constants(const space::Body& body) const {
  const space::Solid& solid = *body.solid();
  const double n = solid.coordinates();
  const auto places = static_cast<double>(solid.constants->places.size());
  const space::NodalSolid& nodal = *solid.constants->nodal();
  constexpr double kEntry = sizeof(double) + sizeof(int);
  // The factor of a slender body of 20,000 coordinates has 13 n^(4/3) entries, that of a block
  // more.
  const double factors = 2.0 * 20.0 * std::pow(n, 4.0 / 3.0);
  // Tiles have K and Mff by four rows where three have the same columns, and m with its forms.
  const double tiles = (8.0 / 3.0 + 0.2) * static_cast<double>(nodal.K.nonZeros()) +
                       11.0 * static_cast<double>(nodal.m.nonZeros());
  return sizeof(double) * (count_solid_rows(solid) + factors + tiles) +
         kEntry * static_cast<double>(nodal.K.nonZeros() + nodal.Xi.nonZeros()) +
         static_cast<double>(nodal.m.nonZeros()) * (kEntry + sizeof(double) * (9.0 + 6.0 * places));
}

// Counts rows, half solutions and motions (engine/bodies/space/nodal_memory.h).
double NodalKind::estimate_own(const TreeBody<Space>& member) const {
  return 16.0 * sizeof(double) * member.body->coordinates();
}

double NodalKind::count_own_nodes(const space::Body& body) const {
  return 1.0 + 3.0 * static_cast<double>(body.solid()->constants->nodal()->slices.size());
}

void NodalKind::calc_terms(const System<Space>& system, double t, const space::ImplicitShares&,
                           std::size_t j, SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  const space::BodyMotion motion = body_motion_of(system, t, j, data);
  body.terms = slices(body) ? sum_nodal_terms(solid_model_of(body), motion, body.work)
                            : calc_solid_terms(solid_model_of(body), body_state_of(body), motion,
                                               system.damping, body.work);
}

void NodalKind::condense(const space::Twist& twist, bool implicit,
                         const structured::BodyWork<Space>&, Data& body) const noexcept {
  const auto condense_all = slices(body) ? space::condense_between : space::condense_solid;
  condense_all(solid_of(body), solid_block_of(body, implicit), body.terms, angular(twist),
               body.work);
}

void NodalKind::recover(const structured::BodyWork<Space>&, bool implicit, Data& body,
                        double* a) const noexcept {
  const space::Solid& solid = solid_of(body);
  const space::SolidBlock& block = solid_block_of(body, implicit);
  const space::Twist* wrenches = body.work.wrenches;
  body.X = slices(body) ? recover_between(solid, block, wrenches, body.work)
                        : recover_solid(solid, block, wrenches, body.work, a);
}

const BodySlices* NodalKind::slices(const Data& body) const noexcept {
  return body.tiles && body.tiles->count() > 1 ? this : nullptr;
}

void NodalKind::calc_terms(const System<Space>& system, double t, int j, int p,
                           SubsystemData<Space>& data) const noexcept {
  const auto index = static_cast<std::size_t>(j);
  const Data& body = data.bodies[index];
  calc_nodal_tile(solid_model_of(body), p, body_state_of(body),
                  body_motion_of(system, t, index, data), system.damping, body.work);
}

void NodalKind::condense(int p, bool implicit, Data& body) const noexcept {
  condense_slice(solid_of(body), solid_block_of(body, implicit), p, body.work);
}

void NodalKind::recover(int p, bool implicit, Data& body) const noexcept {
  recover_slice(solid_of(body), solid_block_of(body, implicit), p, body.X, body.work.wrenches,
                body.work);
}

void NodalKind::take(const Data& body, double* a) const noexcept {
  std::copy_n(body.work.solution, solid_of(body).coordinates(), a);
}

}  // namespace spoke
