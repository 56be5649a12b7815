// Hands the table's data to the kernels of solids.

#include "engine/bodies/kinds/solid/solid_table_terms.h"

#include <cassert>

#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/solid/solid_places.h"
#include "engine/bodies/space/nodal_tension.h"

namespace spoke {
namespace {

/// What is applied to a solid, as it is added.
class AppliedToSolid {
 public:
  /// `turn`: from B to the axes of the undeformed tree.
  AppliedToSolid(const space::Twist& twist, const space::Rotation& turn, BodyData<Space>& body)
      : twist_(twist), turn_(turn), body_(body) {}

  /// Adds a wrench on a place, resolved in B.
  void add(const space::Section& section, const space::Twist& wrench) {
    const space::HandleMotion motion = motion_at(body_, section);
    add_place_wrench(*section.place, motion, wrench, body_.terms, body_.work);
    body_.terms.load_power += calc_wrench_power(wrench, motion, twist_);
    add_tension(section.place_number, turn_ * space::Position(linear(wrench)));
  }
  /// Adds the tension of a force on a place, along the axes of the undeformed tree.
  void add_tension(int place, const space::Position& force) {
    const bool is_stiffened = body_.solid_tension && body_.model->stiffening;
    if (!is_stiffened || !body_.forces || place < 0) return;
    const space::BodyState state = body_state_of(body_);
    const space::NodalSolid* nodal = body_.solid_tension->nodal;
    if (nodal) {
      on_hub_ += add_nodal_tension(*body_.tiles, *nodal, static_cast<std::size_t>(place), force,
                                   state.q, state.v, body_.work.observed.motions, body_.work,
                                   body_.terms.load_power);
      return;
    }
    on_hub_ += add_place_tension(*body_.solid_tension, static_cast<std::size_t>(place), force,
                                 state.q, state.v, body_.work, body_.terms.load_power);
  }
  /// Returns the moment of the tension on the hub, along those axes.
  const space::Angular& on_hub() const { return on_hub_; }

 private:
  const space::Twist& twist_;
  space::Rotation turn_;
  BodyData<Space>& body_;
  space::Angular on_hub_ = space::Angular::Zero();
};

}  // namespace

const space::Solid& solid_of(const BodyData<Space>& body) noexcept {
  assert(body.model->body->solid());
  return *body.model->body->solid();
}

space::SolidModel solid_model_of(const BodyData<Space>& body) {
  assert(body.blocks[0] && body.blocks[0]->solid && body.blocks[1] && body.blocks[1]->solid);
  const auto& products = body.blocks[0]->products;
  const auto& place = body.model->stiffening;
  return {&solid_of(body), products ? &*products : nullptr, body.solid_tension,
          place ? &*place : nullptr, body.tiles};
}

void add_applied_to_solid(double t, const space::Rotation& R_HB, std::size_t j,
                          SubsystemData<Space>& data) noexcept {
  assert(j < data.bodies.size());
  BodyData<Space>& body = data.bodies[j];
  const TreeBody<Space>& model = *body.model;
  const space::Solid& solid = solid_of(body);
  space::Rotation to_undeformed;
  if (model.stiffening) to_undeformed = model.stiffening->R_HB.inverse();
  AppliedToSolid applied(data.twists[j], to_undeformed * R_HB, body);
  if (body.solid_tension && model.stiffening && body.forces.carried)
    for (std::size_t h = 1; h <= model.children.size(); ++h)
      applied.add_tension(
          solid.handles[h],
          to_undeformed * data.applied_forces[static_cast<std::size_t>(model.children[h - 1])]);
  for (const AppliedWrench<Space>& at : body.applied)
    applied.add(*at.section, make_wrench(at.wrench->force, at.wrench->moment));
  for (const auto& load : body.loads)
    for (std::size_t k = 0; k < load.places.size(); ++k) {
      const space::Rotation turned = motion_at(body, load.places[k]).turn.R;
      applied.add(load.places[k], calc_load_wrench(*load.load, k, t, R_HB, data.hub->R, turned));
    }
  if (model.stiffening)
    add_hub_moment(model.stiffening->R_HB * applied.on_hub(), *data.hub, body.terms);
}

space::PlaceDrawn calc_solid_drawn(const BodyData<Space>& body, int place_number, const double* q,
                                   const double* v, const double* a) noexcept {
  if (!body.solid_tension || place_number < 0 || !body.model->stiffening) return {};
  if (const space::NodalSolid* nodal = body.solid_tension->nodal)
    return calc_nodal_drawn(*body.tiles, *nodal, static_cast<std::size_t>(place_number), q, v, a,
                            body.work.observed.motions);
  return calc_place_drawn(*body.solid_tension, static_cast<std::size_t>(place_number), q, v, a,
                          body.work.scratch);
}

space::Angular calc_solid_stiffening_momentum(const BodyData<Space>& body,
                                              const space::Angular& hub_w) noexcept {
  if (!body.solid_tension) return space::Angular::Zero();
  const space::SolidModel model = solid_model_of(body);
  return calc_stiffening_inertia(model, body_state_of(body), body.work).lazyProduct(hub_w);
}

space::Twist calc_solid_momentum(const BodyData<Space>& body, const space::Twist& twist) noexcept {
  return calc_solid_momentum(solid_model_of(body), body_state_of(body), twist, body.work);
}

}  // namespace spoke
