// Chooses the kind of a body.

#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/kinds/gyrostat/gyrostat_kind.h"
#include "engine/bodies/kinds/nodal/nodal_kind.h"
#include "engine/bodies/kinds/reduced/reduced_kind.h"
#include "engine/bodies/kinds/rigid/rigid_kind.h"

namespace spoke {

const BodyKind<Space>& kind_of(const space::Body& body) noexcept {
  static const RigidKind rigid;
  static const GyrostatKind gyrostat;
  static const BeamKind beam;
  static const ReducedKind reduced;
  static const NodalKind nodal;
  if (body.rigid()) return body.rigid()->spin.isZero(0.0) ? rigid : gyrostat;
  if (body.flexible()) return beam;
  if (body.solid()->constants->nodal()) return nodal;
  return reduced;
}

}  // namespace spoke
