#pragma once

// Forces on places of a solid in nodal coordinates that stiffen it (solid_tension.h).

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/solid_tension.h"

namespace spoke::space {

/// Counts the doubles of memory that the functions below use.
std::size_t count_nodal_tension(const NodalSolid& solid);

/// As calc_place_drawn() of a reduced solid.
PlaceDrawn calc_nodal_drawn(const NodalTiles& tiles, const NodalSolid& solid, std::size_t place,
                            const double* q, const double* v, const double* a,
                            double* memory) noexcept;

/// As add_place_tension() of a reduced solid.
Angular add_nodal_tension(const NodalTiles& tiles, const NodalSolid& solid, std::size_t place,
                          const Position& N, const double* q, const double* v, double* memory,
                          const BodyWork& work, double& power) noexcept;

}  // namespace spoke::space
