// Reads stability from roots with and without velocities.

#include "engine/small_motions/vibration/stability.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "engine/small_motions/vibration/coupled_roots.h"
#include "engine/small_motions/vibration/eigenvalues.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using steady::LinearModel;

/// Returns how many roots of a pencil to look at.
using Choose = std::function<Index(Index)>;

std::vector<Root> find_lowest(const LinearModel& linear, const std::vector<double>& azimuths,
                              const Choose& choose) {
  if (linear.is_coupled())
    return find_coupled_roots(linear, azimuths, choose(Pencil(linear).size()));
  std::vector<Root> all;
  for (std::size_t i = 0; i < linear.alike.size(); ++i) {
    if (linear.alike[i] != i || linear.subsystem(i).M.rows() == 0) continue;
    const Pencil pencil(linear, {i});
    for (Root& root : find_roots(pencil, choose(pencil.size()))) all.push_back(std::move(root));
  }
  return all;
}

/// Whether a root is so much faster than the slowest that its real part has no digits: round-off of
/// the inverse grows with the square of the ratio.
bool is_too_fast(const Root& root, double slowest) {
  constexpr double kFaster = 1e4;
  return std::abs(root.s) > kFaster * slowest;
}

/// Whether a root is one of a rotation that stands for rest, 1e-100 rad/s: of a model that has no
/// stiffness there, which is not held, but does not grow either.
bool is_of_rest(const Root& root) { return std::abs(root.s) < 1e-50; }

/// Returns the least magnitude of a root that is not zero; 0 if there is none.
double find_slowest(const std::vector<Root>& roots) {
  double slowest = 0.0;
  for (const Root& root : roots) {
    const double size = std::abs(root.s);
    if (!is_of_rest(root) && (slowest == 0.0 || size < slowest)) slowest = size;
  }
  return slowest;
}

/// Returns the model without forces of velocities, whose roots are those of s^2 M + K.
LinearModel without_velocities(LinearModel linear) {
  linear.C.setZero();
  for (steady::LinearSubsystem& subsystem : linear.subsystems) subsystem.C.setZero();
  for (steady::HubCoupling& coupling : linear.couplings) {
    coupling.C_bh.setZero();
    coupling.C_hb.setZero();
  }
  return linear;
}

/// Finds the root that grows most.
void find_growth(const std::vector<Root>& roots, RootStability& found) {
  const double slowest = find_slowest(roots);
  for (const Root& root : roots) {
    if (!(root.s.real() > 0.0) || is_of_rest(root) || is_too_fast(root, slowest)) continue;
    const double growth = root.s.real() / std::abs(root.s);
    if (growth <= found.growth) continue;
    found.growth = growth;
    found.growing = root.s;
  }
}

}  // namespace

RootStability assess_stability(const LinearModel& linear, const std::vector<double>& azimuths,
                               int count) {
  RootStability found;
  // Of the stiffest quarter round-off may turn the sign.
  const auto softer = [count](Index size) { return std::min<Index>(count, size - size / 4); };
  for (const Root& root : find_lowest(without_velocities(linear), azimuths, softer)) {
    const double square = std::norm(root.s);
    if (root.s.imag() == 0.0 && root.s.real() >= 0.0) ++found.unheld;
    if (square == 0.0) {
      ++found.rigid;
      continue;
    }
    found.stiffest = std::max(found.stiffest, square);
    found.softest = found.softest == 0.0 ? square : std::min(found.softest, square);
  }
  find_growth(
      find_lowest(linear, azimuths, [count](Index size) { return std::min<Index>(count, size); }),
      found);
  return found;
}

RootStability assess_stability(const FixedFrame& frame, int count) {
  RootStability found;
  const Index size = frame.start(frame.patterns.size());
  find_growth(find_fixed_roots(frame, std::min<Index>(count, size)), found);
  return found;
}

}  // namespace spoke::vibration
