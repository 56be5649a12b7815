// Newton's method on openings, by the least motion of coordinates.

#include "engine/small_motions/steady/close_loops.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/small_motions/steady/free_motion.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostClosings = 100;
constexpr double kLargestMove = 0.3;  ///< by the scale of coordinates
constexpr double kClosed = 1e-12;     ///< by what coordinates of that scale do to a row

SubsystemState at_rest(const VectorXd& q) {
  const VectorXd zero = VectorXd::Zero(q.size());
  return {q, zero, q, zero};
}

class Closing {
 public:
  Closing(std::size_t subsystem, SteadyModel& model)
      : subsystem_(subsystem),
        model_(model),
        rows_(find_rigid_rows(model.closure_rows(subsystem))),
        scale_(std::ssize(model.coordinates(subsystem))) {
    for (Index k = 0; k < scale_.size(); ++k)
      scale_[k] = model.coordinates(subsystem)[static_cast<std::size_t>(k)].scale;
  }

  const std::vector<Index>& rows() const { return rows_; }

  /// Finds the openings at q, by the sizes of their rows.
  bool open(const VectorXd& q) {
    SubsystemResponse response;
    model_.evaluate(subsystem_, at_rest(q), model_.no_offset(), response);
    if (!response.openings.allFinite()) return false;
    slope_ = model_.closures(subsystem_)(rows_, Eigen::lastN(scale_.size())) * scale_.asDiagonal();
    opening_ = response.openings(rows_);
    for (Index r = 0; r < opening_.size(); ++r) {
      const double size = slope_.row(r).norm();
      if (size == 0.0) continue;
      opening_[r] /= size;
      slope_.row(r) /= size;
    }
    return true;
  }
  double largest(Index* row = nullptr) const {
    Index at = 0;
    const double most = opening_.cwiseAbs().maxCoeff(&at);
    if (row) *row = at;
    return most;
  }

  /// Closes the loops by these coordinates. Returns false, and leaves q, if that fails.
  bool close(const std::vector<Index>& moved, VectorXd& q) {
    if (moved.empty()) return false;
    VectorXd trial = q;
    LeastSquares least;
    for (int i = 0; i < kMostClosings; ++i) {
      if (!open(trial)) return false;
      const bool is_closed = largest() <= kClosed;
      least.compute(slope_(Eigen::all, moved));
      VectorXd change = -least.solve(opening_);
      const double size = change.lpNorm<Eigen::Infinity>();
      if (!std::isfinite(size)) return false;
      if (!is_closed && size > kLargestMove) change *= kLargestMove / size;
      for (std::size_t k = 0; k < moved.size(); ++k)
        trial[moved[k]] += scale_[moved[k]] * change[static_cast<Index>(k)];
      if (!is_closed) continue;
      q = trial;
      return true;
    }
    return false;
  }

  std::vector<Index> find(bool only_joints) const {
    std::vector<Index> found;
    for (Index k = 0; k < scale_.size(); ++k)
      if (!only_joints || model_.coordinates(subsystem_)[static_cast<std::size_t>(k)].node < 0)
        found.push_back(k);
    return found;
  }

 private:
  std::size_t subsystem_;
  SteadyModel& model_;
  std::vector<Index> rows_;
  VectorXd scale_;
  VectorXd opening_;
  MatrixXd slope_;
};

}  // namespace

std::vector<Index> close_loops(std::size_t subsystem, SteadyModel& model, VectorXd& q) {
  Closing closing(subsystem, model);
  if (closing.rows().empty()) return {};
  if (!closing.open(q) || closing.largest() > kClosed) {
    if (!closing.close(closing.find(true), q) && !closing.close(closing.find(false), q)) {
      Index row = 0;
      closing.open(q);
      closing.largest(&row);
      const auto at = static_cast<std::size_t>(closing.rows()[static_cast<std::size_t>(row)]);
      const std::size_t loop = model.closure_rows(subsystem)[at].loop;
      throw InputError(model.name_of(subsystem) + " / " + model.loop_words(subsystem, loop) +
                       " cannot be closed by moving its joints and bodies");
    }
  }
  SubsystemResponse response;
  model.evaluate(subsystem, at_rest(q), model.no_offset(), response);
  const auto& coordinates = model.coordinates(subsystem);
  return FreeMotion(model.closures(subsystem).rightCols(std::ssize(coordinates)), closing.rows(),
                    coordinates)
      .rows();
}

}  // namespace spoke::steady
