// What sensors, loads and markers ask a solid, and its full matrices.

#include <algorithm>
#include <string_view>

#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/solid/solid_kind.h"
#include "engine/bodies/kinds/solid/solid_places.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

using space::Position;

int place_number_of(const BodyData<Space>& body, int handle) {
  return solid_of(body).handles[static_cast<std::size_t>(handle)];
}

/// Returns by how much the stiffening moves a place, at the velocities in the table.
space::PlaceDrawn find_drawn(const BodyData<Space>& body, int place, const double* a = nullptr) {
  return calc_solid_drawn(body, place, body.coordinates.q, body.coordinates.v, a);
}

void add_drawn_place(const BodyData<Space>& body, int place, const SpatialMotion& frame,
                     SpatialMotion& shown) {
  const space::PlaceDrawn drawn = find_drawn(body, place, body.coordinates.a);
  const Position r = frame.R * drawn.place, rate = frame.R * drawn.rate;
  const Position turned = cross(frame.w, r);
  shown.p += r;
  shown.v += turned + rate;
  shown.a += cross(frame.alpha, r) + cross(frame.w, turned) + 2.0 * cross(frame.w, rate) +
             frame.R * drawn.acceleration;
}

}  // namespace

void SolidKind::place_handles(Data& body) const noexcept {
  calc_handles(solid_of(body), body.coordinates.q, body.coordinates.v, body.work.handles);
}

void SolidKind::leave_inboard(const Data& body, space::JointMotion& joint,
                              space::Twist& twist) const noexcept {
  if (!body.model->body->moves_inboard()) return;
  const space::HandleMotion& handle = body.work.handles[0];
  leave_section(handle.turn, joint, twist);
  linear(twist) -= cross(angular(twist), handle.s) + handle.velocity;
}

Eigen::MatrixXd SolidKind::make_dense_block(const space::Body& body,
                                            const space::BlockFactors& factors) const {
  return space::make_dense_elastic_block(*body.solid(), factors);
}

void SolidKind::calc_dense_mass(const Data& body, const Eigen::MatrixXd& elastic, bool,
                                Eigen::Ref<Eigen::MatrixXd> mass) const {
  space::calc_dense_mass(solid_of(body), body.terms, body.work, elastic, mass);
}

void SolidKind::calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const {
  space::calc_dense_force(solid_of(body), body.terms, body.work, force);
}

void SolidKind::calc_handle_jacobian(const Data& body, int handle,
                                     Eigen::Ref<Eigen::MatrixXd> J) const {
  space::calc_handle_jacobian(solid_of(body), handle, body.work, J);
}

space::Section SolidKind::place_marker(const std::string& whose, const Marker& marker,
                                       const space::Body& body) const {
  if (marker.station != 0.0 || !marker.point.isZero(0.0))
    throw InputError(whose + ": its station and its point belong to beams and rigid bodies, " +
                     "expected the interface of a solid");
  const space::Solid& solid = *body.solid();
  const space::SolidConstants& constants = *solid.constants;
  std::vector<std::string_view> names;
  for (int i = 0; i < constants.interfaces; ++i)
    names.push_back(constants.places[static_cast<std::size_t>(i)].name);
  if (marker.interface.empty() && names.size() == 2) return make_solid_section(solid, 1);
  const auto at = std::find(names.begin(), names.end(), marker.interface);
  if (at == names.end())
    throw InputError(whose + ": its interface " + describe_unknown(marker.interface, names));
  return make_solid_section(solid, static_cast<int>(at - names.begin()));
}

space::Section SolidKind::section_at(const space::Body& body, double) const {
  return make_solid_section(*body.solid(), 0);
}

int SolidKind::place_of_handle(const space::Body& body, std::size_t handle) const {
  return body.solid()->handles[handle];
}

space::HandleMotion SolidKind::motion_at(const Data& body,
                                         const space::Section& section) const noexcept {
  return calc_place_motion(*section.place, body.coordinates.q, body.coordinates.v);
}

space::Twist SolidKind::calc_section_acceleration(const Data&, const space::Section& section,
                                                  const space::HandleMotion& motion,
                                                  const space::Twist& X, const space::Angular& w,
                                                  const double* a) const noexcept {
  space::Twist acceleration = motion.carry(X) + motion.bias(w);
  acceleration += calc_place_deformation(*section.place, motion, a);
  return acceleration;
}

space::Twist SolidKind::calc_handle_deformation(const Data& body, int handle) const noexcept {
  return calc_place_deformation(solid_of(body).handle(static_cast<std::size_t>(handle)),
                                body.work.handles[handle], body.coordinates.a);
}

void SolidKind::add_handle_turning(const Data& body, int handle,
                                   space::Angular& sum) const noexcept {
  sum += angular(calc_handle_deformation(body, handle));
}

space::DrawnInward SolidKind::calc_handle_drawn(const Data& body, int handle) const noexcept {
  const space::PlaceDrawn drawn = find_drawn(body, place_number_of(body, handle));
  return {drawn.place, drawn.rate};
}

space::DrawnInward SolidKind::calc_section_drawn(const Data& body,
                                                 const space::Section& section) const noexcept {
  const space::PlaceDrawn drawn = find_drawn(body, section.place_number);
  return {drawn.place, drawn.rate};
}

space::Position SolidKind::calc_shown_drawn(const Data& body, int handle) const noexcept {
  const int place =
      handle > 0 ? place_number_of(body, handle) : solid_of(body).constants->tip_number;
  return find_drawn(body, place).place;
}

space::Position SolidKind::calc_shown_drawn(const Data& body,
                                            const space::Section& section) const noexcept {
  return find_drawn(body, section.place_number).place;
}

void SolidKind::add_shown_drawn(const Data& body, int handle, const SpatialMotion& frame,
                                SpatialMotion& shown) const noexcept {
  add_drawn_place(body, place_number_of(body, handle), frame, shown);
}

void SolidKind::add_shown_drawn(const Data& body, const space::Section& section,
                                const SpatialMotion& frame, SpatialMotion& shown) const noexcept {
  add_drawn_place(body, section.place_number, frame, shown);
}

space::Position SolidKind::find_tip(const Data& body) const noexcept {
  return calc_place_motion(solid_of(body).constants->tip, body.coordinates.q, body.coordinates.v).s;
}

space::BodyEnergies SolidKind::calc_energies(const Data& body, const space::Twist& twist,
                                             const space::BodyMotion& motion) const noexcept {
  return calc_solid_energies(solid_model_of(body), body_state_of(body), twist, motion, body.work);
}

double SolidKind::calc_strain_energy(const Data& body) const noexcept {
  return space::calc_strain_energy(solid_of(body), body.coordinates.q);
}

space::Twist SolidKind::calc_momentum(const Data& body, const space::Twist& twist) const noexcept {
  return calc_solid_momentum(body, twist);
}

space::Angular SolidKind::calc_stiffening_momentum(const Data& body,
                                                   const space::Angular& hub_w) const noexcept {
  return calc_solid_stiffening_momentum(body, hub_w);
}

}  // namespace spoke
