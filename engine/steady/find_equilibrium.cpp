// Newton's method on the forces on subsystems.

#include "engine/steady/find_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

#include "engine/steady/alike_subsystems.h"
#include "engine/steady/derivatives.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::VectorXd;

constexpr int kMostIterations = 60;
constexpr double kSmallestStep = 1.0 / 128;   ///< of the line search
constexpr double kSmallestShare = 1.0 / 256;  ///< of a load step
constexpr double kConverged = 1e-9;  ///< change by the scale of coordinates, before polish()

/// Newton's method for one subsystem.
class Search {
 public:
  Search(std::size_t subsystem, SteadyModel& model) : subsystem_(subsystem), model_(model) {
    const auto& coordinates = model.coordinates(subsystem);
    scale_.resize(std::ssize(coordinates));
    for (Eigen::Index k = 0; k < scale_.size(); ++k)
      scale_[k] = coordinates[static_cast<std::size_t>(k)].scale;
  }

  /// Moves q to the equilibrium. Returns false if it is not found; q is then as before.
  bool run(VectorXd& q) {
    const VectorXd start = q;
    if (scale_.size() == 0) return evaluate(q).has_value();
    for (int i = 0; i < kMostIterations; ++i) {
      ++iterations;
      if (!advance(q)) break;
      if (last_change <= kConverged) return polish(q);
    }
    q = start;
    return false;
  }

  int iterations = 0;
  double last_change = 0.0;
  Eigen::Index worst = 0;  ///< coordinate of the largest correction
  bool is_singular = false;
  Eigen::Index loose = 0;  ///< a coordinate that nothing holds, if it is singular

 private:
  double size(const VectorXd& change) const {
    return change.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  }

  std::optional<VectorXd> evaluate(const VectorXd& q) {
    SubsystemResponse response;
    model_.evaluate(subsystem_, make_state(q), model_.no_offset(), response);
    if (!response.is_valid) return std::nullopt;
    return response.force;
  }

  /// Factorises the derivative of the forces.
  void factorise(const VectorXd& q) {
    const Eigen::MatrixXd by_q = calc_rough_derivative(subsystem_, make_state(q), model_);
    const Eigen::Index n = scale_.size();
    const Eigen::MatrixXd slope = scale_.asDiagonal() *
                                  (model_.stiffness(subsystem_) - by_q.topRows(n)) *
                                  scale_.asDiagonal();
    lu_.compute(slope);
    is_singular = !(lu_.rcond() > 1e-15);
    if (!is_singular) return;
    least_squares_.compute(slope);
    const Eigen::Index rank = std::min(least_squares_.rank(), n - 1);
    loose = least_squares_.pivot(rank);
  }

  VectorXd correct(const VectorXd& force) const {
    const VectorXd scaled = scale_.asDiagonal() * force;
    VectorXd correction(scaled.size());
    if (is_singular) {
      correction = least_squares_.solve(scaled);
    } else {
      lu_.solve(scaled, correction);
    }
    return scale_.asDiagonal() * correction;
  }

  /// Makes one step with a line search, in which the next correction must shrink.
  bool advance(VectorXd& q) {
    const std::optional<VectorXd> force = evaluate(q);
    if (!force) return false;
    factorise(q);
    const VectorXd change = correct(*force);
    if (!change.allFinite()) return false;
    change.cwiseQuotient(scale_).cwiseAbs().maxCoeff(&worst);
    for (double length = 1.0; length >= kSmallestStep; length *= 0.5) {
      const VectorXd trial = q + length * change;
      const std::optional<VectorXd> left = evaluate(trial);
      if (!left) continue;
      const double next = size(correct(*left));
      if (!(next <= (1.0 - 0.25 * length) * size(change)) && next > kConverged) continue;
      last_change = length < 1.0 ? size(change) : next;
      q = trial;
      return true;
    }
    return false;
  }

  /// Corrects by the last factors as long as corrections become smaller.
  bool polish(VectorXd& q) {
    for (int i = 0; i < 10; ++i) {
      const std::optional<VectorXd> force = evaluate(q);
      if (!force) return false;
      const VectorXd change = correct(*force);
      if (i > 0 && !(size(change) < 0.5 * last_change)) break;
      last_change = size(change);
      q += change;
    }
    model_.settle(subsystem_, q);
    return evaluate(q).has_value();
  }

  std::size_t subsystem_;
  SteadyModel& model_;
  VectorXd scale_;
  LuFactors lu_;
  LeastSquares least_squares_;
};

[[noreturn]] void give_up(std::size_t subsystem, const Search& search, double share,
                          const SteadyModel& model) {
  const std::string coordinate =
      model.coordinates(subsystem)[static_cast<std::size_t>(search.worst)].name;
  std::ostringstream text;
  text
      << "no equilibrium found at " << model.speed() << " rad/s: " << model.name_of(subsystem)
      << " / " << coordinate << " does not settle at " << 100.0 * share
      << " % of loads and speed squared; take more bodies per blade, smaller loads, another speed, "
         "or springs for joints that nothing holds";
  throw DivergenceError(text.str(),
                        {.subsystem = model.name_of(subsystem), .quantity = coordinate});
}

/// Finds the equilibrium of one subsystem, in as many load steps as it takes.
void find_subsystem(std::size_t subsystem, SteadyModel& model, Equilibrium& result) {
  VectorXd& q = result.q[subsystem] = model.initial(subsystem);
  Search search(subsystem, model);
  double share = 0.0, step = 1.0;
  int steps = 0;
  while (share < 1.0) {
    const double target = std::min(1.0, share + step);
    model.set_share(target);
    if (search.run(q)) {
      share = target;
      step *= 2.0;
      ++steps;
    } else {
      step *= 0.5;
      if (step < kSmallestShare) give_up(subsystem, search, target, model);
    }
  }
  result.load_steps = std::max(result.load_steps, steps);
  result.iterations += search.iterations;
  result.last_change = std::max(result.last_change, search.last_change);
  if (search.is_singular)
    result.loose = model.name_of(subsystem) + " / " +
                   model.coordinates(subsystem)[static_cast<std::size_t>(search.loose)].name;
}

/// Takes the equilibrium of a subsystem over to one that is like it.
void take_over(std::size_t from, std::size_t to, SteadyModel& model, Equilibrium& result) {
  // Spherical joints are turned about references of their own: they search themselves.
  VectorXd q = result.q[from];
  SubsystemResponse response;
  model.evaluate(to, make_state(q), model.no_offset(), response);
  result.q[to] = q;
  if (model.absolute(from, q) != model.absolute(to, q)) find_subsystem(to, model, result);
}

}  // namespace

SubsystemState make_state(const Eigen::VectorXd& q) {
  const VectorXd zero = VectorXd::Zero(q.size());
  return {q, zero, q, zero};
}

Equilibrium find_equilibrium(SteadyModel& model) {
  Equilibrium result;
  result.q.resize(model.subsystems());
  result.alike = find_alike(model);
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    result.alike[i] == i ? find_subsystem(i, model, result)
                         : take_over(result.alike[i], i, model, result);
  result.wrench = -model.hub_force(model.no_offset());
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    SubsystemResponse response;
    model.evaluate(i, make_state(result.q[i]), model.no_offset(), response);
    result.wrench -= response.hub_force;
    result.force_scale += response.hub_force.lpNorm<Eigen::Infinity>();
  }
  return result;
}

void require_held(const Equilibrium& equilibrium) {
  if (!equilibrium.loose.empty())
    throw InputError(equilibrium.loose +
                     ": nothing holds it, expected a spring, rotation, or gravity that does");
}

void require_steady_hub(const SteadyModel& model, const Equilibrium& equilibrium) {
  for (const int c : model.free_components()) {
    if (c == model.twist_size() - 1 && model.has_torque_drive()) continue;
    const double left = std::abs(equilibrium.wrench[c]);
    if (left <= 1e-6 * equilibrium.force_scale + 1e-9) continue;
    std::ostringstream text;
    text << "the hub is free, and " << left << (c < model.first_rotation() ? " N" : " N m")
         << " act on it at " << model.speed()
         << " rad/s: it has no steady motion there, expected forces that balance";
    throw InputError(text.str());
  }
}

}  // namespace spoke::steady
