// Compares subsystems by their answers at a state in which all coordinates are moved.

#include "engine/small_motions/steady/alike_subsystems.h"

#include <cmath>
#include <random>

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kDifference = 1e-8;  ///< round-off, by the largest force

class Dice {
 public:
  VectorXd vector(Index size, double scale) {
    return VectorXd::NullaryExpr(size, [&](Index) { return scale * uniform_(random_); });
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// Returns a state that is moved from `q` by a hundredth of the scale of each coordinate, where
/// loops of `rows` rows have forces.
SubsystemState move_all(const VectorXd& q, const std::vector<SubsystemCoordinate>& coordinates,
                        std::size_t rows, Dice& dice) {
  VectorXd scale(q.size());
  for (Index k = 0; k < q.size(); ++k)
    scale[k] = 0.01 * coordinates[static_cast<std::size_t>(k)].scale;
  const auto moved = [&](double share) {
    return VectorXd(scale.cwiseProduct(dice.vector(q.size(), share)));
  };
  SubsystemState state{q + moved(1.0), moved(1.0), q + moved(0.01), moved(0.01)};
  state.multipliers = dice.vector(static_cast<Index>(rows), 1.0);
  return state;
}

bool are_equal(const VectorXd& a, const VectorXd& b) {
  if (a.size() == 0) return true;
  return (a - b).lpNorm<Eigen::Infinity>() <= kDifference * a.lpNorm<Eigen::Infinity>();
}

/// Returns how the coordinates of a subsystem move the rows of its loops.
VectorXd closures_of(std::size_t subsystem, const SubsystemState& state, SteadyModel& model) {
  if (model.closure_rows(subsystem).empty()) return {};
  SubsystemResponse response;
  model.evaluate(subsystem, state, model.no_offset(), response);
  return model.closures(subsystem).rightCols(state.q.size()).reshaped();
}

bool are_alike(std::size_t a, std::size_t b, SteadyModel& model) {
  const auto& coordinates = model.coordinates(a);
  if (coordinates.size() != model.coordinates(b).size()) return false;
  if (!are_same(model.initial(a), model.initial(b))) return false;
  if (model.force_states(a) != model.force_states(b)) return false;
  Dice dice;
  if (model.closure_rows(a).size() != model.closure_rows(b).size()) return false;
  const SubsystemState state = move_all(VectorXd::Zero(std::ssize(coordinates)), coordinates,
                                        model.closure_rows(a).size(), dice);
  SubsystemResponse of_a, of_b;
  model.evaluate(a, state, model.no_offset(), of_a);
  model.evaluate(b, state, model.no_offset(), of_b);
  return are_equal(of_a.force, of_b.force) && are_equal(of_a.openings, of_b.openings) &&
         are_equal(closures_of(a, state, model), closures_of(b, state, model));
}

bool are_alike_about_hub(std::size_t a, std::size_t b, const VectorXd& q, SteadyModel& model) {
  Dice dice;
  const SubsystemState state =
      move_all(q, model.coordinates(a), model.closure_rows(a).size(), dice);
  const Index d = model.twist_size();
  const HubOffset at_a{dice.vector(d, 0.01), dice.vector(d, 0.1), dice.vector(d, 1.0)};
  const Eigen::MatrixXd turn = turn_hub(model.azimuth(b) - model.azimuth(a), model);
  const HubOffset at_b{turn * at_a.turn, turn * at_a.twist, turn * at_a.acceleration};
  SubsystemResponse of_a, of_b;
  model.evaluate(a, state, at_a, of_a);
  model.evaluate(b, state, at_b, of_b);
  return are_equal(of_a.force, of_b.force) && are_equal(turn * of_a.hub_force, of_b.hub_force);
}

}  // namespace

bool are_same(const VectorXd& a, const VectorXd& b) {
  constexpr double kRoundOff = 1e-12;
  return a.size() == b.size() && (a.size() == 0 || (a - b).lpNorm<Eigen::Infinity>() <= kRoundOff);
}

std::vector<std::size_t> find_alike(SteadyModel& model) {
  std::vector<std::size_t> alike(model.subsystems());
  for (std::size_t i = 0; i < alike.size(); ++i) {
    alike[i] = i;
    for (std::size_t k = 0; k < i && alike[i] == i; ++k)
      if (alike[k] == k && model.hub_of(k) == model.hub_of(i) && are_alike(k, i, model))
        alike[i] = k;
  }
  return alike;
}

std::vector<std::size_t> find_alike_about_hub(std::vector<std::size_t> alike,
                                              const std::vector<VectorXd>& q, SteadyModel& model) {
  for (std::size_t i = 0; i < alike.size(); ++i) {
    const std::size_t first = alike[i];
    if (q[i] != q[first] || !are_alike_about_hub(first, i, q[i], model)) alike[i] = i;
  }
  return alike;
}

Eigen::MatrixXd turn_hub(double angle, const SteadyModel& model) {
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(model.twist_size(), model.twist_size());
  Eigen::Matrix2d plane;
  plane << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  turn.topLeftCorner<2, 2>() = plane;
  if (model.is_spatial()) turn.block<2, 2>(3, 3) = plane;
  return turn;
}

}  // namespace spoke::steady
