// Parts a periodic system, reduces it, and takes its modes back.

#include "engine/small_motions/vibration/floquet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/small_motions/vibration/periodic_basis.h"
#include "engine/small_motions/vibration/turn_modes.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void lift(const MatrixXd& V, std::vector<PeriodicMode>& modes) {
  for (PeriodicMode& mode : modes)
    for (Harmonic& harmonic : mode.harmonics) harmonic.amplitude = (V * harmonic.amplitude).eval();
}

/// Whether modes have the multipliers that they had.
bool are_settled(const std::vector<PeriodicMode>& modes, const std::vector<PeriodicMode>& before) {
  constexpr double kTolerance = 1e-9, kMeet = 1e-3, kHalf = 1e-4;
  return std::all_of(modes.begin(), modes.end(), [&](const PeriodicMode& mode) {
    const double size = std::max(std::abs(mode.multiplier), kTolerance);
    double nearest = 1e300;
    for (const PeriodicMode& other : before)
      nearest = std::min(nearest, std::abs(other.multiplier - mode.multiplier));
    const auto near = std::count_if(modes.begin(), modes.end(), [&](const PeriodicMode& other) {
      return std::abs(other.multiplier - mode.multiplier) < kMeet * size;
    });
    return nearest <= size * (near > 1 ? kHalf : kTolerance);
  });
}

/// Returns the modes of a system whose mean mass matrix has a diagonal of ones. What is stiff is
/// left away, as over a turn it would take many steps.
std::vector<PeriodicMode> find_reduced(const PeriodicSystem& system, Index count) {
  MatrixXd V = find_low_motions(system, count);
  std::vector<PeriodicMode> before;
  for (;;) {
    std::vector<PeriodicMode> modes = find_modes_over_turn(project(system, V), count);
    lift(V, modes);
    if (!before.empty() && are_settled(modes, before)) return modes;
    const MatrixXd more = find_missing_motions(system, V, modes);
    if (more.cols() == 0) return modes;
    MatrixXd wider(V.rows(), V.cols() + more.cols());
    wider << V, more;
    V = std::move(wider);
    before = std::move(modes);
  }
}

std::vector<PeriodicMode> find_connected_modes(const PeriodicSystem& system, Index count) {
  const MatrixXd factors = system.M.parts[0].diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
  std::vector<PeriodicMode> modes = find_reduced(project(system, factors), count);
  lift(factors, modes);
  return modes;
}

/// Returns the part of a system whose hub has no coordinates that is one subsystem's.
PeriodicSystem take_subsystem(const PeriodicSystem& system, Index at, Index size) {
  PeriodicSystem part = system;
  for (Periodic* matrix : {&part.M, &part.C, &part.K})
    for (MatrixXd& own : matrix->parts) own = MatrixXd(own.block(at, at, size, size));
  part.starts = {0};
  return part;
}

Index size_of(std::size_t i, const PeriodicSystem& system) {
  const Index end = i + 1 < system.starts.size() ? system.starts[i + 1] : system.size();
  return end - system.starts[i];
}

/// Returns the subsystems that have the matrices of subsystem `i`, itself the first.
std::vector<std::size_t> list_alike(std::size_t i, const PeriodicSystem& system) {
  if (system.alike.empty()) return {i};
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < system.alike.size(); ++k)
    if (system.alike[k] == i) list.push_back(k);
  return list;
}

/// Returns the mode of subsystem `i` as one of subsystem `to`, which passes the same places.
PeriodicMode move_mode(const PeriodicMode& mode, std::size_t i, std::size_t to,
                       const PeriodicSystem& system) {
  const double ahead = to == i ? 0.0 : system.azimuths[to] - system.azimuths[i];
  PeriodicMode moved = mode;
  for (Harmonic& harmonic : moved.harmonics) {
    const double k = system.speed < 0.0 ? -harmonic.multiple : harmonic.multiple;
    Eigen::VectorXcd all = Eigen::VectorXcd::Zero(system.size());
    all.segment(system.starts[to], harmonic.amplitude.size()) =
        std::polar(1.0, k * ahead) * harmonic.amplitude;
    harmonic.amplitude = std::move(all);
  }
  return moved;
}

/// Returns the modes of subsystems that the hub does not couple; of those that are alike one after
/// the other.
std::vector<PeriodicMode> find_separate_modes(const PeriodicSystem& system, Index count) {
  struct Group {
    std::vector<std::size_t> subsystems;
    PeriodicMode mode;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < system.starts.size(); ++i) {
    const std::vector<std::size_t> like = list_alike(i, system);
    const Index size = size_of(i, system), copies = std::ssize(like);
    if (size == 0 || copies == 0) continue;
    const Index own = std::min((count + copies - 1) / copies, size);
    for (PeriodicMode& mode :
         find_connected_modes(take_subsystem(system, system.starts[i], size), own))
      groups.push_back({like, std::move(mode)});
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return std::abs(a.mode.s) < std::abs(b.mode.s);
  });
  std::vector<PeriodicMode> modes;
  for (const Group& group : groups)
    for (const std::size_t to : group.subsystems)
      if (std::ssize(modes) < count)
        modes.push_back(move_mode(group.mode, group.subsystems[0], to, system));
  return modes;
}

}  // namespace

void require_periodic(const PeriodicSystem& system) {
  if (system.speed == 0.0)
    throw InputError("the frame \"floquet\" expects a hub that turns: at rest nothing is periodic");
  Index size = system.size();
  std::string whose;
  if (system.hub == 0 && !system.starts.empty()) {
    size = 0;
    for (std::size_t i = 0; i < system.starts.size(); ++i)
      size = std::max(size, size_of(i, system));
    whose = " of each blade";
  }
  const Index most = system.hub > 6 ? kMostOnSupport : kMostPeriodic;
  if (size > most)
    throw InputError("the frame \"floquet\" expects at most " + std::to_string(most) +
                     " coordinates" + whose + ", got " + std::to_string(size));
}

std::vector<PeriodicMode> find_periodic_modes(const PeriodicSystem& system, Index count) {
  require_periodic(system);
  if (system.size() == 0 || count < 1) return {};
  if (system.hub == 0 && system.starts.size() > 1) return find_separate_modes(system, count);
  return find_connected_modes(system, count);
}

}  // namespace spoke::vibration
