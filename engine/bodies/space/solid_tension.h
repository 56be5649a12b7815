#pragma once

// Geometric stiffening of a reduced solid (docs/formulation.md, section 13): to second order in the
// deformation
//   T = T_linear - 1/2 sum_k w_k q^T Kg^(k) q = T_linear - 1/2 w^T Lambda w
//   V = V_linear + 1/2 sum_c g_c q^T Kg^(c) q = V_linear + g . gamma
// with w_k the monomials of the hub's angular velocity and g the field, both along the axes of B in
// the undeformed tree. A place is drawn inward by r_c = -1/2 q^T K_G q, the K_G of a unit force.

#include <array>
#include <vector>

#include "engine/bodies/space/body_data.h"
#include "models/space/solid.h"

namespace spoke::space {

/// Matrices of the stiffening, as padded columns (reduced_products.h).
struct SolidTensionColumns {
  /// Of a solid in nodal coordinates, whose tiles have the matrices of spin and gravity, and its
  /// constants those of forces; else null.
  const NodalSolid* nodal = nullptr;
  int modes = 0;
  int stride = 0;
  std::array<std::vector<double>, kSpins> spin;
  std::array<std::vector<double>, 3>
      gravity;  ///< empty of a body that stiffens by its own rotation
  /// By place: of unit forces on it.
  std::vector<std::array<std::vector<double>, 3>> forces;
};

/// Makes the columns of a solid; `tension`: in its tree; null: of its own rotation.
SolidTensionColumns make_tension_columns(const SolidConstants& constants,
                                         const SolidTension* tension);

/// Terms of the stiffening in the equations of the hub, or of the body that flies by itself.
struct SolidStiffening {
  Matrix3 Lambda = Matrix3::Zero();       ///< in B [kg m^2]
  Matrix3 Lambda_rate = Matrix3::Zero();  ///< in B [kg m^2/s]
  TensionMoment gamma;                    ///< in B
};

/// Returns them from the forms q^T K q of the matrices of spin and then of gravity, and q^T K q'.
SolidStiffening make_stiffening(const double* values, const double* rates,
                                const Position& gravity) noexcept;

/// Adds -K_G q to `force`, by mode; w, gravity: along the axes of B. q, v: padded; `product`:
/// memory for one vector.
SolidStiffening add_solid_stiffening(const SolidTensionColumns& columns, const Angular& w,
                                     const Position& gravity, const double* q, const double* v,
                                     double* product, double* force) noexcept;

/// Displacement of a place by the stiffening, along the axes of B in the undeformed tree, and its
/// derivatives.
struct PlaceDrawn {
  Position place = Position::Zero();         ///< [m]
  Position rate = Position::Zero();          ///< [m/s]
  Position acceleration = Position::Zero();  ///< [m/s^2]; only where q'' was given
};
/// Returns it; `a` may be null. `padded`: memory for four vectors of `stride`.
PlaceDrawn calc_place_drawn(const SolidTensionColumns& columns, std::size_t place, const double* q,
                            const double* v, const double* a, double* padded) noexcept;

/// Adds -sum_c N_c K_G^(c) q of a force N at a place, along those axes, to the rows; returns r x N,
/// its moment on the hub in those axes, and adds its power on the deformation.
Angular add_place_tension(const SolidTensionColumns& columns, std::size_t place, const Position& N,
                          const double* q, const double* v, const BodyWork& work,
                          double& power) noexcept;

}  // namespace spoke::space
