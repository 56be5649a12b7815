// Weighs shapes by mass, and assigns those of one state to those of the next.

#include "engine/small_motions/vibration/match_modes.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/small_motions/vibration/assignment.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

/// Returns the shape of a mode by mass, of length one.
VectorXcd unit_shape(const Mode& mode) {
  const double length = mode.weighed.norm();
  return length > 0.0 ? VectorXcd(mode.weighed / length) : mode.weighed;
}

/// The shapes of a state's modes.
struct Shapes {
  explicit Shapes(const ModesResult& state) : modes(state.modes) {
    for (const Mode& mode : modes) {
      shapes.push_back(unit_shape(mode));
      subsystems.push_back(first_subsystem(mode));
    }
  }

  /// Returns how much of a shape is in the modes that have the same root as mode m.
  double share_of(const VectorXcd& shape, std::size_t m) const {
    constexpr double kEqual = 1e-6;
    std::vector<VectorXcd> basis;
    double share = 0.0;
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const double apart = std::abs(modes[k].eigenvalue - modes[m].eigenvalue);
      if (subsystems[k] != subsystems[m] || apart > kEqual * std::abs(modes[m].eigenvalue))
        continue;
      VectorXcd direction = shapes[k];
      for (const VectorXcd& other : basis) direction -= other.dot(direction) * other;
      if (direction.norm() < kEqual) continue;
      basis.push_back(direction.normalized());
      share += std::norm(basis.back().dot(shape));
    }
    return share;
  }

  const std::vector<Mode>& modes;
  std::vector<VectorXcd> shapes;
  std::vector<std::size_t> subsystems;
};

/// Pairs modes that have no partner yet. `is_conjugate`: with the conjugates of the first shapes.
void pair_up(const Shapes& from, const Shapes& to, bool is_conjugate, ModeMatch& match) {
  std::vector<bool> is_taken(to.modes.size());
  for (const auto& next : match.next)
    if (next) is_taken[*next] = true;
  const auto rows = static_cast<Index>(from.modes.size()),
             columns = static_cast<Index>(to.modes.size());
  Eigen::MatrixXd criterion = Eigen::MatrixXd::Zero(rows, columns);
  std::vector<VectorXcd> shapes = from.shapes;
  if (is_conjugate)
    for (VectorXcd& shape : shapes) shape = shape.conjugate().eval();
  for (std::size_t a = 0; a < shapes.size(); ++a)
    for (std::size_t b = 0; b < to.shapes.size(); ++b) {
      const bool is_free = !match.next[a] && !is_taken[b];
      if (is_free && from.subsystems[a] == to.subsystems[b] &&
          shapes[a].size() == to.shapes[b].size())
        criterion(static_cast<Index>(a), static_cast<Index>(b)) =
            std::norm(shapes[a].dot(to.shapes[b]));
    }
  const std::vector<Index> pairs = find_best_assignment(criterion);
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    if (pairs[a] < 0 || criterion(static_cast<Index>(a), pairs[a]) == 0.0) continue;
    const auto b = static_cast<std::size_t>(pairs[a]);
    // Conjugate shapes do not lie among those that have a mode's root.
    const double likeness =
        is_conjugate ? criterion(static_cast<Index>(a), pairs[a])
                     : std::max(from.share_of(to.shapes[b], a), to.share_of(shapes[a], b));
    if (likeness < kLeastLikeness) continue;
    match.next[a] = b;
    match.likeness[a] = likeness;
  }
  if (!is_conjugate) match.criterion = std::move(criterion);
}

}  // namespace

std::size_t first_subsystem(const Mode& mode) {
  return static_cast<std::size_t>(std::find_if(mode.shape.begin(), mode.shape.end(),
                                               [](const auto& nodes) { return !nodes.empty(); }) -
                                  mode.shape.begin());
}

ModeMatch match_modes(const ModesResult& from, const ModesResult& to, ThroughZero through_zero) {
  ModeMatch match;
  match.next.resize(from.modes.size());
  match.likeness.resize(from.modes.size());
  const Shapes first(from), second(to);
  pair_up(first, second, false, match);
  if (through_zero == ThroughZero::yes) pair_up(first, second, true, match);
  return match;
}

}  // namespace spoke::vibration
