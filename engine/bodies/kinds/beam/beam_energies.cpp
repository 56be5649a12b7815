// Calculates energies by sums over slots and elements.

#include "engine/bodies/kinds/beam/beam_energies.h"

#include <cassert>

#include "engine/bodies/kinds/beam/body_slots.h"
#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/body_stiffening.h"
#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/nonlinear_strain.h"

namespace spoke::space {
namespace {

/// Returns 1/2 sum rho'_i . mu'_i.
double deformation_energy(const FlexibleBody& body, const BodyScratch& scratch) {
  const int slots = kNodeSlots * body.node_count() + body.elements;
  double sum = 0.0;
  for (int i = 0; i < slots; ++i)
    for (int c = 3; c < kSlot; ++c)
      sum += scratch.slots[kSlot * i + c] * scratch.momenta[kSlot * i + c];
  return 0.5 * sum;
}

double strain_energy(const FlexibleBody& body, const double* q, const BodyScratch& scratch) {
  if (body.is_nonlinear()) return calc_nonlinear_energy(body, q, scratch.slots);
  double sum = 0.0;
  for (const BeamElement& element : body.beam) {
    double d[kTwist], F[kTwist];
    calc_relative(element, q, d);
    multiply(element.stiffness.data(), d).store_to(F);
    for (int i = 0; i < kTwist; ++i) sum += d[i] * F[i];
    q += kTwist;
  }
  return 0.5 * sum;
}

}  // namespace

BodyEnergies calc_body_energies(const BodyModel& model, const BodyState& state, const Twist& twist,
                                const BodyMotion& motion, const BodyWork& work) noexcept {
  assert(model.body && state.q && state.v);
  const FlexibleBody& body = *model.body;
  const ScratchRoom scratch(body, work);
  double *q = scratch->nodal[0], *v = scratch->nodal[1];
  expand(body, state.q, q);
  expand(body, state.v, v);
  const SlotSums sums = calc_slots(body, q, v, *scratch);
  const Position v0 = linear(twist), w = angular(twist);
  // The sum of rho x mu' follows from G = sum rho mu'^T.
  const Position spin(sums.G(1, 2) - sums.G(2, 1), sums.G(2, 0) - sums.G(0, 2),
                      sums.G(0, 1) - sums.G(1, 0));
  BodyEnergies energies;
  energies.S = sums.S;
  energies.kinetic = 0.5 * body.mass * v0.squaredNorm() + v0.dot(cross(w, sums.S) + sums.S_rate) +
                     0.5 * w.dot(sums.inertia().lazyProduct(w)) + w.dot(spin) +
                     deformation_energy(body, *scratch);
  energies.strain = strain_energy(body, q, *scratch);
  if (body.is_nonlinear())
    energies.kinetic -= 0.5 * w.dot(calc_turned_inertia(body, q).lazyProduct(w));
  if (!model.tension) return energies;
  const StiffeningForms stiffening = calc_stiffening_forms(model, q);
  const Matrix3 inertia = calc_hub_inertia(*model.tension, stiffening);
  energies.kinetic -= 0.5 * motion.hub_w.dot(inertia.lazyProduct(motion.hub_w));
  energies.tension = motion.gravity.dot(calc_tension_moment(*model.tension, stiffening));
  return energies;
}

double calc_strain_energy(const FlexibleBody& body, const double* q,
                          const BodyWork& work) noexcept {
  const ScratchRoom scratch(body, work);
  expand(body, q, scratch->nodal[0]);
  return strain_energy(body, scratch->nodal[0], *scratch);
}

double calc_foreshortening(const BodyModel& model, const double* q, const BodyWork& work) noexcept {
  if (!model.tension) return 0.0;
  const ScratchRoom scratch(*model.body, work);
  expand(*model.body, q, scratch->nodal[0]);
  return 0.5 * sum_slope_products(*model.body, scratch->nodal[0], scratch->nodal[0],
                                  model.body->elements - 1, 1.0);
}

Foreshortening calc_foreshortening(const BodyModel& model, const Section& section, const double* q,
                                   const double* v, const double* a,
                                   const BodyWork& work) noexcept {
  if (!model.tension) return {};
  const ScratchRoom scratch(*model.body, work);
  const double* flex[] = {q, v, a};
  for (std::size_t k = 0; k < 3; ++k) expand(*model.body, flex[k], scratch->nodal[k]);
  const double xi = place_in_element(*model.body, section);
  const auto product = [&](std::size_t i, std::size_t k) {
    return sum_slope_products(*model.body, scratch->nodal[i], scratch->nodal[k], section.element,
                              xi);
  };
  return {0.5 * product(0, 0), product(0, 1), product(1, 1) + product(0, 2)};
}

}  // namespace spoke::space
