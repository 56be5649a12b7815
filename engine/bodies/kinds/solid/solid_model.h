#pragma once

// The constants that the kernels of a solid in its tree read.

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/reduced_products.h"
#include "engine/bodies/space/solid_tension.h"

namespace spoke::space {

/// Constants of a solid in its tree.
struct SolidModel {
  const Solid* body = nullptr;
  const ReducedProducts* products = nullptr;     ///< null: coordinates are nodal
  const SolidTensionColumns* tension = nullptr;  ///< null: without geometric stiffening
  const TensionPlace* place = nullptr;           ///< null: it stiffens by its own rotation, or not
  const NodalTiles* tiles = nullptr;             ///< of nodal coordinates; else null
};

/// Sets the terms of a stiffening in its tree; gravity: in H.
void put_stiffening(const TensionPlace& place, const SolidStiffening& sums, const Position& gravity,
                    BodyTerms& terms) noexcept;

/// Returns a tensor along the axes that R turns its own axes to.
Matrix3 turn_tensor(const Rotation& R, const Matrix3& tensor);

}  // namespace spoke::space
