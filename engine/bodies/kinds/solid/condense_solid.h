#pragma once

// Elimination of a solid's deformation and its recovery, with the equations of condense_body.h.

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/solid_block.h"

namespace spoke::space {

/// Calculates the half solutions of the rows, the condensed inertia and the multi-port, at the
/// angular velocity w of B.
void condense_solid(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                    const Angular& w, BodyWork& work) noexcept;

/// Returns the acceleration X of the frame and sets q'' (flex vector `a`), from the wrenches on the
/// handles.
Twist recover_solid(const Solid& body, const SolidBlock& block, const Twist* wrenches,
                    const BodyWork& work, double* a) noexcept;

// The same of a solid in nodal coordinates, by slices: each by itself, then what is between them
// and the rest, and back in the reverse order. condense_solid() and recover_solid() do all.

/// Calculates the half solutions of the rows of slice p, and their products.
void condense_slice(const Solid& body, const SolidBlock& block, int p, BodyWork& work) noexcept;
/// Calculates those between slices, and all that condense_solid() does, from the products.
void condense_between(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                      const Angular& w, BodyWork& work) noexcept;
/// Returns X, and calculates q'' between slices into `work.solution`.
Twist recover_between(const Solid& body, const SolidBlock& block, const Twist* wrenches,
                      const BodyWork& work) noexcept;
/// Calculates q'' of slice p there, at the acceleration X of the frame.
void recover_slice(const Solid& body, const SolidBlock& block, int p, const Twist& X,
                   const Twist* wrenches, const BodyWork& work) noexcept;

}  // namespace spoke::space
