#pragma once

// One body's share of the table. Vectors of deformation coordinates ("flex vectors") are stored
// padded, see the world's layout.

#include <array>
#include <limits>
#include <vector>

#include "engine/bodies/coordinate_block.h"
#include "engine/bodies/plane/body.h"
#include "engine/bodies/space/body.h"
#include "engine/bodies/table/load_data.h"
#include "engine/bodies/table/step_progress.h"
#include "models/system/system.h"

namespace spoke {

/// Values that a body's recovery reports to the end of the pass.
struct BodyReport {
  double change;       ///< largest change of a coordinate in this iteration [m, rad]
  double step_change;  ///< see PassReport; only in the first iteration of a step, else 0
  double deflection;   ///< by the body's length, if beyond the linear range; else 0
  StepError error;     ///< only in the first iteration of a step, else 0
  double drive_power;  ///< power of the drive of the joint that carries it [W]; 0 in the plane
  Flag failed;         ///< a coordinate is not finite or beyond its limit
};

/// Whether forces are applied to a body itself, and to bodies that it carries: its tension depends
/// on them.
struct ForceSources {
  bool applied = false;
  bool carried = false;
  explicit operator bool() const { return applied || carried; }
};

/// One body's share of the table.
template <class World>
struct BodyData : BodyTypes<World>::Fields {
  using Types = BodyTypes<World>;

  const TreeBody<World>* model = nullptr;
  std::array<const typename Types::Block*, 2> blocks{};  ///< explicit, implicit
  typename Types::Layout layout;
  double linear_range = std::numeric_limits<double>::infinity();  ///< bound of deflections [m]
  double length = 1.0;  ///< of the body, by which errors of its coordinates are measured [m]
  /// No deflection is beyond the linear range if the sum of the squares of all coordinates is not
  /// greater than this.
  double surely_linear = std::numeric_limits<double>::infinity();

  CoordinateBlock coordinates;
  const double* q_elastic = nullptr;  ///< coordinates in the elastic force (flex vector)
  const double* v_elastic = nullptr;  ///< velocities in the damping force (flex vector)
  const double* v_modal = nullptr;    ///< velocities in the damping by modes (flex vector)

  typename Types::Terms terms;
  double* a_found =
      nullptr;       ///< accelerations that the pass finds (flex vector); for rk4 `a` itself
  TwistOf<World> X;  ///< frame acceleration, body frame, less gravity
  BodyReport report;
  std::vector<AppliedWrench<World>> applied;  ///< wrenches of the user's loads
  std::vector<PlacedLoad<World, BodyLoad<World>>> loads;
  std::vector<PlacedLoad<World, BodyDrag<World>>> drags;
  ForceSources forces;
  /// Planar bodies whose tension depends on applied forces: the forces that act in each element
  /// and, the last value, those of bodies that it carries, body frame [N]. Memory of the kernel of
  /// its terms.
  ArenaVector<PositionOf<World>> element_forces;
};

/// Whether the strains of a body are of second order: its elastic and damping forces are no linear
/// function of its coordinates.
inline bool has_nonlinear_strain(const BodyData<Plane>& body) {
  return body.model->body->is_nonlinear();
}
bool has_nonlinear_strain(const BodyData<Space>& body);

}  // namespace spoke
