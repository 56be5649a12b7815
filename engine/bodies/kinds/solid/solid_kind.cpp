// What all solids have in common.

#include "engine/bodies/kinds/solid/solid_kind.h"

#include "engine/bodies/kernels/body_memory.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"
#include "engine/bodies/space/solid_limits.h"

namespace spoke {

const space::SolidBlock& solid_block_of(const BodyData<Space>& body, bool implicit) noexcept {
  return *body.blocks[implicit]->solid;
}

double count_solid_rows(const space::Solid& solid) {
  return 2.0 * solid.coordinates() *
         (space::kSolidRow + space::kHandleRow * static_cast<double>(solid.handles.size()));
}

std::size_t SolidKind::count_work(const space::Body& body) const {
  return space::count_work(*body.solid());
}

space::BodyWork SolidKind::place_work(const space::Body& body, double* memory) const {
  return space::place_work(*body.solid(), memory);
}

double SolidKind::calc_surely_linear(const space::Body& body, double range) const {
  return space::calc_surely_linear(*body.solid(), range);
}

// The matrices of a solid's stiffening are those in its tree, or by its own rotation.
void SolidKind::make_tension(const ElasticShares&, BodyMemory<Space>& memory, Data& body) const {
  const space::SolidConstants& constants = *solid_of(body).constants;
  const auto& place = body.model->stiffening;
  const bool is_own = constants.frame == spatial::SolidFrame::mean_axis;
  if (!constants.is_stiffened || !(place || is_own)) return;
  const space::SolidTension* in_tree = place ? place->solid.get() : nullptr;
  const void* key = &constants;
  if (in_tree) key = in_tree;
  body.solid_tension = &find_or_add(memory.constants->solid_tensions, key,
                                    [&] { return make_tension_columns(constants, in_tree); });
}

PlacedLoad<Space, BodyLoad<Space>> SolidKind::place_load(const BodyLoad<Space>& load,
                                                         const space::Body& body) const {
  PlacedLoad<Space, BodyLoad<Space>> placed{&load, {}, {}};
  for (const BodyLoad<Space>::Point& point : load.points)
    placed.places.push_back(make_solid_section(*body.solid(), point.element));
  return placed;
}

void SolidKind::add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                            SubsystemData<Space>& data) const noexcept {
  add_applied_to_solid(t, R_HB, j, data);
}

void SolidKind::add_forces(double factor, const double* forces, Data& body) const noexcept {
  for (int k = 0; k < solid_of(body).coordinates(); ++k)
    body.work.rows[space::kSolidRow * k + 3] += factor * forces[k];
}

space::Position SolidKind::sum_loads(double t, const space::Rotation& R_HB,
                                     const space::Rotation& R_0, const Data& body) const noexcept {
  space::Position sum = space::Position::Zero();
  for (const auto& placed : body.loads)
    for (std::size_t k = 0; k < placed.places.size(); ++k)
      sum += linear(calc_load_wrench(*placed.load, k, t, R_HB, R_0,
                                     motion_at(body, placed.places[k]).turn.R));
  return sum;
}

space::Position SolidKind::calc_linear_momentum(const Data& body,
                                                const space::Twist& twist) const noexcept {
  return calc_deformed_momentum(body, twist);
}

}  // namespace spoke
