// Takes the patterns that do not meet the hub apart from the others, and solves each problem.

#include <algorithm>
#include <cmath>

#include "engine/small_motions/vibration/eigenvalues.h"
#include "engine/small_motions/vibration/multi_blade.h"
#include "engine/small_motions/vibration/pencil.h"
#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using steady::LinearModel;

/// Some patterns of a rotor, with its hub or without.
struct Part {
  LinearModel model;
  std::vector<std::size_t> patterns;
};

Part make_part(const LinearModel& model, const std::vector<std::size_t>& patterns, bool has_hub) {
  Part part{{{}, {}, {}, {}, {}, {}, {}, model.rate}, patterns};
  LinearModel& own = part.model;
  if (has_hub) {
    own.M = model.M;
    own.C = model.C;
    own.K = model.K;
    own.round_off = model.round_off;
  }
  for (const std::size_t k : patterns) {
    own.alike.push_back(own.subsystems.size());
    own.subsystems.push_back(model.subsystem(k));
    if (has_hub) own.couplings.push_back(model.couplings[k]);
  }
  return part;
}

std::vector<Part> list_parts(const FixedFrame& frame) {
  std::vector<Part> parts;
  std::vector<std::size_t> meeting;
  const bool is_coupled = frame.model.is_coupled();
  for (std::size_t k = 0; k < frame.patterns.size(); ++k) {
    const BladePattern& pattern = frame.patterns[k];
    const bool meets = is_coupled && !pattern.is_differential && pattern.multiple <= 1;
    if (meets)
      meeting.push_back(k);
    else
      parts.push_back(make_part(frame.model, {k}, false));
  }
  if (is_coupled) parts.push_back(make_part(frame.model, meeting, true));
  return parts;
}

/// Counts motions at zero once that gyroscopic forces pair: x with K x = 0 goes on only if C x is
/// zero, too. With the skew part A of C in these motions, the vectors of a pair of its eigenvalues
/// +-i a are conjugate: they are one mode. `speed`: the largest of the hubs, not negative [rad/s].
void pair_standing(const Pencil& pencil, double speed, std::vector<Root>& roots) {
  constexpr double kGyroscopic = 1e-6;  // of the speed
  const auto end =
      std::find_if(roots.begin(), roots.end(), [](const Root& root) { return root.s != 0.0; });
  const Index count = end - roots.begin();
  if (count < 2 || speed == 0.0) return;
  MatrixXd X(pencil.size(), count);
  for (Index k = 0; k < count; ++k)
    X.col(k) = roots[static_cast<std::size_t>(k)].x.real().cwiseQuotient(pencil.scale());
  const MatrixXd G = X.transpose() * pencil.damping(0.0, X);
  const HermitianEigen eigen = solve_hermitian(std::complex<double>(0.0, 0.5) *
                                               (G - G.transpose()).cast<std::complex<double>>());
  const double least = kGyroscopic * speed;
  MatrixXd held = MatrixXd::Identity(count, count);
  std::vector<Root> kept;
  for (Index k = 0; k < count; ++k) {
    if (std::abs(eigen.values[k]) <= least) continue;
    const Eigen::VectorXcd u = eigen.vectors.col(k);
    held -= (u * u.adjoint()).real();
    if (eigen.values[k] > 0.0) kept.push_back({0.0, pencil.scale().asDiagonal() * (X * u)});
  }
  if (kept.empty()) return;
  const SymmetricEigen rest = solve_symmetric(held);
  for (Index k = 0; k < count; ++k)
    if (rest.values[k] > 0.5)
      kept.push_back(
          {0.0,
           (pencil.scale().asDiagonal() * (X * rest.vectors.col(k))).cast<std::complex<double>>()});
  roots.erase(roots.begin(), end);
  roots.insert(roots.begin(), kept.begin(), kept.end());
}

}  // namespace

std::vector<Root> find_fixed_roots(const FixedFrame& frame, Index count) {
  std::vector<Root> roots;
  const Index size = frame.start(frame.patterns.size());
  for (const Part& part : list_parts(frame)) {
    const Pencil pencil(part.model);
    std::vector<Root> own = find_roots(pencil, std::min(count, pencil.size()));
    pair_standing(pencil, frame.fastest, own);
    const Index h = part.model.M.rows();
    for (const Root& root : own) {
      Root& whole = roots.emplace_back(Root{root.s, Eigen::VectorXcd::Zero(size)});
      whole.x.head(h) = root.x.head(h);
      for (std::size_t k = 0; k < part.patterns.size(); ++k) {
        const Index rows = part.model.subsystem(k).M.rows();
        whole.x.segment(frame.start(part.patterns[k]), rows) =
            root.x.segment(pencil.start(k), rows);
      }
    }
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [](const Root& a, const Root& b) { return std::abs(a.s) < std::abs(b.s); });
  if (std::ssize(roots) > count) roots.resize(static_cast<std::size_t>(count));
  return roots;
}

}  // namespace spoke::vibration
