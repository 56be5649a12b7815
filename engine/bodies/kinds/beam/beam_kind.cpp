// What is made of a beam once.

#include "engine/bodies/kinds/beam/beam_kind.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>

#include "engine/bodies/kernels/body_memory.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/condensed_parts.h"

namespace spoke {
namespace {

using graph::bytes_of;

/// Of a body with strains of second order: coordinates of the norm s bend an element of length l by
/// (sqrt(2) + l) s at most.
double calc_nonlinear_norm(const space::FlexibleBody& beam, double range) {
  double norm = std::numeric_limits<double>::infinity();
  for (const space::BeamElement& element : beam.beam)
    norm = std::min(
        norm, range * element.length / beam.length() / (std::numbers::sqrt2 + element.length));
  return norm;
}

/// Lists what is factorised anew.
Memory memory_of_block(space::ElasticBlock& block) {
  Memory memory{bytes_of(block.C_W)};
  for (std::vector<double>* values : {&block.inverse, &block.below, &block.W_t})
    memory.push_back(bytes_of(*values));
  for (std::vector<double>& Z : block.Z) memory.push_back(bytes_of(Z));
  for (std::span<std::byte> range :
       {bytes_of(block.Z_W), bytes_of(block.Z_diagonal), bytes_of(block.Z_pairs)})
    memory.push_back(range);
  return memory;
}

Memory memory_of_matrix(space::BlockTridiagonal& matrix) {
  return {bytes_of(matrix.diagonal), bytes_of(matrix.below)};
}

/// Counts the factors of one block.
double estimate_factors(const space::FlexibleBody& beam) {
  constexpr double kBlock = Space::kTwist * Space::kTwist;
  constexpr double kMomentum = 3.0 * Space::kTwist;
  double numbers = beam.node_count() * (2.0 * kBlock + kMomentum);
  for (const int node : beam.handles)
    if (node >= beam.first_node()) numbers += kBlock * (beam.node_count() - node);
  return sizeof(double) * numbers;
}

}  // namespace

space::BodyModel body_model_of(const BodyData<Space>& body) {
  assert(body.model->body->flexible() && body.blocks[0] && body.blocks[0]->elastic);
  assert(body.tension || body.strain || (body.blocks[1] && body.blocks[1]->elastic));
  const space::FlexibleBody* flexible = body.model->body->flexible();
  const auto& tension = body.model->stiffening;
  const space::ElasticBlock* implicit = nullptr;
  if (body.tension)
    implicit = &body.tension->block;
  else if (body.strain)
    implicit = &body.strain->block;
  else
    implicit = &*body.blocks[1]->elastic;
  return {flexible,
          {&*body.blocks[0]->elastic, implicit},
          tension ? &*tension : nullptr,
          body.strain ? &body.strain->shift : nullptr};
}

space::Section make_element_section(const space::Body& body, int element, double s) {
  const space::FlexibleBody& beam = *body.flexible();
  assert(body.beam && element >= 0 && element < beam.elements);
  assert(s >= -1e-9 && s <= 1.0 + 1e-9);
  const auto e = static_cast<std::size_t>(element);
  return make_section(*body.beam, beam,
                      beam.stations[e] + s * (beam.stations[e + 1] - beam.stations[e]));
}

std::size_t BeamKind::count_work(const space::Body& body) const {
  return space::count_work(*body.flexible());
}

space::BodyWork BeamKind::place_work(const space::Body& body, double* memory) const {
  return space::place_work(*body.flexible(), memory);
}

// Returns the bound as a planar body does (engine/bodies/plane/body.cpp), for both directions
// together.
double BeamKind::calc_surely_linear(const space::Body& body, double range) const {
  assert(range >= 0.0);
  const space::FlexibleBody& beam = *body.flexible();
  if (beam.is_nonlinear()) {
    const double norm = calc_nonlinear_norm(beam, range);
    return norm * norm;
  }
  const double l = beam.length() / beam.elements;
  return range * range / std::max(1.0, 0.5 + l * l / 32.0);
}

bool BeamKind::has_nonlinear_strain(const space::Body& body) const {
  return body.flexible()->is_nonlinear();
}

bool BeamKind::clears_rows(const space::Body& body) const {
  return body.flexible()->reference_frame == ReferenceFrame::chord;
}

space::Block BeamKind::make_block(const space::Body& body,
                                  const space::BlockFactors& factors) const {
  space::Block block;
  block.elastic = make_elastic_block(*body.flexible(), factors);
  return block;
}

void BeamKind::make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                            Data& body) const {
  if (implicit.tension_factor == 0.0) return;
  const space::FlexibleBody& beam = *body.model->body->flexible();
  if (beam.is_nonlinear()) {
    memory.strains.push_back(std::make_unique<space::ImplicitStrain>(space::make_implicit_strain(
        beam, factors_of(implicit), implicit.tension_factor, *body.blocks[0]->elastic)));
    body.strain = memory.strains.back().get();
    return;
  }
  if (!body.model->stiffening) return;
  memory.tensions.push_back(std::make_unique<space::ImplicitTension>(
      space::make_implicit_tension(beam, *body.model->stiffening, factors_of(implicit),
                                   implicit.tension_factor, *body.blocks[1]->elastic)));
  body.tension = memory.tensions.back().get();
}

void BeamKind::declare_tension(std::size_t j, SubsystemData<Space>& data) const {
  const PartMaker maker = maker_of_body(j, data);
  Data& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  if (body.strain) {
    space::ImplicitStrain& strain = *body.strain;
    maker.add(parts.coordinates, strain.wrenches, strain.nodal);  // those at which a step begins
    parts.tension =
        maker.cover("tension", Mark::none, strain.turn, strain.shift.nodes,
                    memory_of_matrix(strain.added), strain.lean, memory_of_block(strain.block));
  } else if (body.tension) {
    space::ImplicitTension& tension = *body.tension;
    parts.tension = maker.cover("tension", Mark::none, tension.w, tension.turn, tension.elements,
                                memory_of_matrix(tension.stiffness), tension.lean,
                                memory_of_block(tension.block));
  }
}

std::span<double> BeamKind::rows_of(const Data& body) const noexcept {
  const int nodes = body.model->body->flexible()->node_count();
  return {body.work.rows, static_cast<std::size_t>(space::kNodeRows * nodes)};
}

std::span<double> BeamKind::scratch_of(const Data& body) const noexcept {
  if (!body.work.scratch) return {};
  return {body.work.scratch, space::count_scratch(*body.model->body->flexible())};
}

void BeamKind::declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  const int first = space::kNodeRows * beam.first_node();
  const int end = space::kNodeRows * beam.node_count();
  add_condensed(maker, {memory_of(body.work.half + first, static_cast<std::size_t>(end - first))},
                body, parts);
}

PlacedLoad<Space, BodyLoad<Space>> BeamKind::place_load(const BodyLoad<Space>& load,
                                                        const space::Body& body) const {
  std::vector<space::Section> sections;
  std::vector<double> weights;
  for (const BodyLoad<Space>::Point& point : load.points) {
    sections.push_back(make_element_section(body, point.element, point.s));
    weights.push_back(point.weight);
  }
  return {&load, make_loaded_sections(*body.flexible(), sections, weights), {}};
}

// Counts elements, the matrices M, K and D, slots, and the factors of both constant blocks.
double BeamKind::estimate_constants(const space::Body& body) const {
  const space::FlexibleBody& beam = *body.flexible();
  constexpr double kBlock = Space::kTwist * Space::kTwist;
  constexpr double kSlotNumbers =
      2.0 * space::kNodeSlots * space::kNodeSlots + space::kElementSlots + 1.0;
  constexpr double kMomentum = 3.0 * Space::kTwist;
  const double nodes = beam.node_count();
  double numbers = nodes * (6.0 * kBlock + kSlotNumbers + kMomentum);  // numbers of the body
  return sizeof(double) * numbers + beam.elements * sizeof(space::BeamElement) +
         2.0 * estimate_factors(beam);
}

// Counts the factors of an implicit block of its own, and the matrices that are added to them.
double BeamKind::estimate_own(const TreeBody<Space>& member) const {
  const space::FlexibleBody& beam = *member.body->flexible();
  if (!member.stiffening && !beam.is_nonlinear()) return 0.0;
  constexpr double kBlock = Space::kTwist * Space::kTwist;
  const double numbers = beam.node_count() * (2.0 * kBlock + 3.0 * Space::kTwist);
  return estimate_factors(beam) + sizeof(double) * numbers +
         beam.elements * sizeof(space::ImplicitTension::Element);
}

}  // namespace spoke
