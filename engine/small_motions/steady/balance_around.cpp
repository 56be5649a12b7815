// Compares forces at two azimuths of the hub.

#include "engine/small_motions/steady/balance_around.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/small_motions/steady/at_azimuth.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the largest opening of springs, by the largest scale of coordinates.
double find_largest_opening(std::size_t i, const SubsystemResponse& response,
                            const SteadyModel& model) {
  double scale = 0.0, largest = 0.0;
  for (const SubsystemCoordinate& coordinate : model.coordinates(i))
    scale = std::max(scale, coordinate.scale);
  const std::vector<ClosureRow>& rows = model.closure_rows(i);
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (!rows[r].is_rigid())
      largest = std::max(largest, std::abs(response.openings[static_cast<Eigen::Index>(r)]));
  return scale > 0.0 ? largest / scale : largest;
}

/// Whether the forces on a subsystem in equilibrium stay as they are where the hub has turned.
bool stays_balanced(std::size_t i, const SubsystemState& state, SteadyModel& model) {
  constexpr double kClosed = 1e-9, kSame = 1e-6;
  SubsystemResponse here, there;
  model.evaluate(i, state, model.no_offset(), here);
  const MatrixXd closures = model.closures(i).rightCols(state.q.size());
  {
    const AtAzimuth turned(kElsewhere, model);
    model.evaluate(i, state, model.no_offset(), there);
  }
  if (find_largest_opening(i, here, model) <= kClosed &&
      find_largest_opening(i, there, model) <= kClosed)
    return true;
  const VectorXd size = closures.cwiseAbs().transpose() * here.multipliers.cwiseAbs();
  return (there.force - here.force).cwiseAbs().maxCoeff() <= kSame * size.maxCoeff();
}

}  // namespace

void require_balance_around(std::size_t i, const SubsystemState& state, SteadyModel& model) {
  if (model.standing_springs(i).empty() || stays_balanced(i, state, model)) return;
  throw InputError(
      model.name_of(i) + " / loop \"" + model.standing_springs(i) +
      "\" bears forces of what the hub turns against, which change with its azimuth: "
      "for an equilibrium expected places that meet on the hub's axis, or springs that "
      "are alike in all directions across it");
}

}  // namespace spoke::steady
