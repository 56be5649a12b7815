#pragma once

// The places of a solid at a state, and wrenches on them.

#include "engine/bodies/space/body_data.h"
#include "models/space/solid.h"

namespace spoke::space {

/// Returns the motion of a place at the flex vectors q and v, against B.
HandleMotion calc_place_motion(const SolidPlace& place, const double* q, const double* v) noexcept;

/// Calculates the handles of a solid.
void calc_handles(const Solid& body, const double* q, const double* v,
                  HandleMotion* handles) noexcept;

/// Returns (E_u a; H E_th a): the share of a flex vector a = q'' in the acceleration of a place.
Twist calc_place_deformation(const SolidPlace& place, const HandleMotion& motion,
                             const double* a) noexcept;

/// Adds a wrench (f, m), in B, on a place that moves as given: Q += (f, m + s x f), Q_f += E_u^T f
/// + E_th^T H^T m.
void add_place_wrench(const SolidPlace& place, const HandleMotion& motion, const Twist& wrench,
                      BodyTerms& terms, const BodyWork& work) noexcept;

}  // namespace spoke::space
