// Newton's method on the forces on subsystems.

#include "engine/small_motions/steady/find_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "engine/small_motions/steady/alike_subsystems.h"
#include "engine/small_motions/steady/balance_around.h"
#include "engine/small_motions/steady/close_loops.h"
#include "engine/small_motions/steady/derivatives.h"
#include "engine/small_motions/steady/free_motion.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::VectorXd;

constexpr int kMostIterations = 60;
constexpr double kSmallestStep = 1.0 / 128;   ///< of the line search
constexpr double kSmallestShare = 1.0 / 256;  ///< of a load step
constexpr double kConverged = 1e-9;  ///< change by the scale of coordinates, before polish()
constexpr double kNear = 0.1;        ///< to which share corrections by kept factors must shrink

}  // namespace

/// The derivative of the forces on a subsystem, factorised on what its loops leave free.
struct Tangent {
  Eigen::MatrixXd slope;
  FreeMotion free;
  LuFactors lu;
  LeastSquares least_squares;
  bool is_singular = false;
  Eigen::Index loose = 0;  ///< a coordinate that nothing holds, if it is singular

  Tangent(Eigen::MatrixXd by_q, FreeMotion motion)
      : slope(std::move(by_q)), free(std::move(motion)) {}
  /// Whether it stays of use where the subsystem has moved a little.
  bool serves() const { return free.is_all() && !is_singular; }
};

namespace {

/// A change of coordinates, and of the forces of loops.
struct Change {
  VectorXd q, multipliers;
};

/// Newton's method for one subsystem, on its coordinates and the forces of its loops.
class Search {
 public:
  Search(std::size_t subsystem, const std::vector<Eigen::Index>& rows, SteadyModel& model)
      : subsystem_(subsystem), model_(model), rows_(rows) {
    multipliers = VectorXd::Zero(std::ssize(model.closure_rows(subsystem)));
    const auto& coordinates = model.coordinates(subsystem);
    scale_.resize(std::ssize(coordinates));
    for (Eigen::Index k = 0; k < scale_.size(); ++k)
      scale_[k] = coordinates[static_cast<std::size_t>(k)].scale;
  }

  /// Moves q to the equilibrium. Returns false if it is not found; q is then as before.
  bool run(VectorXd& q) {
    const VectorXd start = q, at_start = multipliers;
    is_near_ = false;
    if (scale_.size() == 0) return evaluate(q, multipliers).has_value();
    for (int i = 0; i < kMostIterations; ++i) {
      ++iterations;
      if (!advance(q) && !std::exchange(is_near_, false)) break;
      if (last_change <= kConverged) return polish(q);
    }
    q = start;
    multipliers = at_start;
    return false;
  }

  /// Moves q to the equilibrium by the factors of another one that is near, as long as they bring
  /// it there quickly. Returns false if they do not; q is then as before.
  bool run_by(std::shared_ptr<const Tangent> kept, VectorXd& q) {
    const VectorXd start = q;
    tangent = std::move(kept);
    for (double last = std::numeric_limits<double>::infinity(); last > kConverged;) {
      ++iterations;
      const std::optional<SubsystemResponse> at = evaluate(q, multipliers);
      const VectorXd change = at ? correct(*at).q : VectorXd();
      if (!at || !(size(change) <= kNear * last) || !change.allFinite()) {
        q = start;
        return false;
      }
      q += change;
      last = size(change);
    }
    return polish(q);
  }

  VectorXd multipliers;  ///< forces of the rows of loops
  int iterations = 0;
  double last_change = 0.0;
  Eigen::Index worst = 0;                  ///< coordinate of the largest correction
  bool is_locked = false;                  ///< whether the loops are in a singular position
  std::shared_ptr<const Tangent> tangent;  ///< the last one

 private:
  double size(const VectorXd& change) const {
    return change.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  }

  std::optional<SubsystemResponse> evaluate(const VectorXd& q, const VectorXd& forces) {
    SubsystemResponse response;
    model_.evaluate(subsystem_, make_state(q, forces), model_.no_offset(), response);
    if (!response.is_valid) return std::nullopt;
    return response;
  }

  /// Factorises the derivative of the forces on what the loops leave free. Returns false where the
  /// loops are in a singular position.
  bool factorise(const VectorXd& q, const SubsystemResponse& at) {
    const auto made =
        std::make_shared<Tangent>(calc_stiffness(subsystem_, q, at.multipliers, model_),
                                  FreeMotion(model_.closures(subsystem_).rightCols(scale_.size()),
                                             rows_, model_.coordinates(subsystem_)));
    tangent = made;
    const FreeMotion& free = made->free;
    is_locked = free.rows().size() < rows_.size();
    if (is_locked) return false;
    const Eigen::Index n = std::ssize(free.independent());
    if (n == 0) return true;
    const VectorXd scale = scale_(free.independent());
    const Eigen::MatrixXd slope =
        scale.asDiagonal() * reduce(made->slope, free) * scale.asDiagonal();
    made->lu.compute(slope);
    made->is_singular = !(made->lu.rcond() > 1e-15);
    if (!made->is_singular) return true;
    made->least_squares.compute(slope);
    const Eigen::Index rank = std::min(made->least_squares.rank(), n - 1);
    made->loose = free.independent()[static_cast<std::size_t>(made->least_squares.pivot(rank))];
    return true;
  }

  static Eigen::MatrixXd reduce(const Eigen::MatrixXd& matrix, const FreeMotion& free) {
    if (free.is_all()) return matrix;
    return free.basis().transpose() * matrix * free.basis();
  }

  /// Returns the motion that these forces on independent coordinates take to come to rest.
  VectorXd follow(const VectorXd& force) const {
    const VectorXd scale = scale_(tangent->free.independent());
    const VectorXd scaled = scale.asDiagonal() * force;
    VectorXd correction(scaled.size());
    if (tangent->is_singular) {
      correction = tangent->least_squares.solve(scaled);
    } else if (scaled.size() > 0) {
      tangent->lu.solve(scaled, correction);
    }
    return scale.asDiagonal() * correction;
  }

  Change correct(const SubsystemResponse& at) const {
    const FreeMotion& free = tangent->free;
    if (free.is_all()) return {follow(at.force), VectorXd::Zero(multipliers.size())};
    const Eigen::MatrixXd& Z = free.basis();
    Change change;
    change.q = free.open(-VectorXd(at.openings(free.rows())));
    const VectorXd left = at.force - tangent->slope * change.q;
    change.q += Z * follow(Z.transpose() * left);
    change.multipliers = free.hold(at.force - tangent->slope * change.q);
    return change;
  }

  /// Makes one step with a line search, in which the next correction must shrink.
  bool advance(VectorXd& q) {
    const std::optional<SubsystemResponse> at = evaluate(q, multipliers);
    if (!at || (!is_near_ && !factorise(q, *at))) return false;
    const Change change = correct(*at);
    if (!change.q.allFinite() || !change.multipliers.allFinite()) return false;
    change.q.cwiseQuotient(scale_).cwiseAbs().maxCoeff(&worst);
    for (double length = 1.0; length >= kSmallestStep; length *= 0.5) {
      const VectorXd trial = q + length * change.q;
      const VectorXd forces = multipliers + length * change.multipliers;
      const std::optional<SubsystemResponse> left = evaluate(trial, forces);
      if (!left) continue;
      const double next = size(correct(*left).q);
      if (!(next <= (1.0 - 0.25 * length) * size(change.q)) && next > kConverged) continue;
      last_change = length < 1.0 ? size(change.q) : next;
      is_near_ = tangent->serves() && length == 1.0 && next <= kNear * size(change.q);
      q = trial;
      multipliers = forces;
      return true;
    }
    return false;
  }

  /// Corrects by the last factors as long as corrections become smaller.
  bool polish(VectorXd& q) {
    for (int i = 0; i < 10; ++i) {
      const std::optional<SubsystemResponse> at = evaluate(q, multipliers);
      if (!at) return false;
      const Change change = correct(*at);
      if (i > 0 && !(size(change.q) < 0.5 * last_change)) break;
      last_change = size(change.q);
      q += change.q;
      multipliers += change.multipliers;
    }
    model_.settle(subsystem_, q);
    const std::optional<SubsystemResponse> at = evaluate(q, multipliers);
    if (at) multipliers = at->multipliers;
    return at.has_value();
  }

  std::size_t subsystem_;
  SteadyModel& model_;
  const std::vector<Eigen::Index>& rows_;  ///< rigid ones that do not depend on others
  VectorXd scale_;
  bool is_near_ = false;  ///< whether the factors are of a place from which they lead on quickly
};

/// Throws if the loops of a subsystem are where they do not determine its motion.
void require_regular(std::size_t subsystem, const Search& search, const SteadyModel& model) {
  if (search.is_locked)
    throw DivergenceError("no equilibrium found: the loops of " + model.name_of(subsystem) +
                              " come to a singular position, in which they do not determine which "
                              "way its joints go",
                          {.subsystem = model.name_of(subsystem), .quantity = "loops"});
}

[[noreturn]] void give_up(std::size_t subsystem, const Search& search, double share,
                          const SteadyModel& model) {
  const std::string coordinate =
      model.coordinates(subsystem)[static_cast<std::size_t>(search.worst)].name;
  std::ostringstream text;
  text
      << "no equilibrium found at " << model.speed()
      << " rad/s: " << model.full_name(subsystem, coordinate) << " does not settle at "
      << 100.0 * share
      << " % of loads and speed squared; take more bodies per blade, smaller loads, another speed, "
         "or springs for joints that nothing holds";
  throw DivergenceError(text.str(),
                        {.subsystem = model.name_of(subsystem), .quantity = coordinate});
}

/// Keeps what a search has found besides the coordinates, in so many load steps.
void keep(std::size_t subsystem, const Search& search, int steps, const SteadyModel& model,
          Equilibrium& result) {
  result.multipliers[subsystem] = search.multipliers;
  result.load_steps = std::max(result.load_steps, steps);
  result.iterations += search.iterations;
  result.last_change = std::max(result.last_change, search.last_change);
  if (const Tangent* tangent = search.tangent.get(); tangent && tangent->is_singular)
    result.loose = model.full_name(
        subsystem, model.coordinates(subsystem)[static_cast<std::size_t>(tangent->loose)].name);
}

/// Finds the equilibrium of one subsystem, in as many load steps as it takes.
void find_subsystem(std::size_t subsystem, SteadyModel& model, Equilibrium& result) {
  VectorXd& q = result.q[subsystem] = model.initial(subsystem);
  std::vector<Eigen::Index>& rows = result.rows[subsystem] = close_loops(subsystem, model, q);
  Search search(subsystem, rows, model);
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
      if (step < kSmallestShare) {
        require_regular(subsystem, search, model);
        give_up(subsystem, search, target, model);
      }
    }
  }
  keep(subsystem, search, steps, model, result);
}

/// Goes on from the equilibrium of one subsystem at another state. Returns false if none is found.
bool continue_subsystem(std::size_t subsystem, const Equilibrium& at, const SteadyModel& before,
                        SteadyModel& model, Tangents* kept, Equilibrium& result) {
  model.settle_at(subsystem, before.absolute(subsystem, at.q[subsystem]));
  result.q[subsystem] = at.q[subsystem];
  result.rows[subsystem] = at.rows[subsystem];
  Search search(subsystem, result.rows[subsystem], model);
  search.multipliers = at.multipliers[subsystem];
  const auto tangent = kept ? (*kept)[subsystem] : nullptr;
  const bool is_near = tangent && tangent->serves() && search.run_by(tangent, result.q[subsystem]);
  if (!is_near && !search.run(result.q[subsystem])) return false;
  if (kept) (*kept)[subsystem] = search.tangent;
  keep(subsystem, search, 1, model, result);
  return true;
}

/// Takes the equilibrium of a subsystem over to one that is like it. Returns false if it is to be
/// sought anew.
bool take_over(std::size_t from, std::size_t to, SteadyModel& model, Equilibrium& result) {
  // Spherical joints are turned about references of their own: they search themselves.
  VectorXd q = result.q[from];
  SubsystemResponse response;
  model.evaluate(to, make_state(result, from), model.no_offset(), response);
  result.q[to] = q;
  result.multipliers[to] = result.multipliers[from];
  result.rows[to] = result.rows[from];
  return are_same(model.absolute(from, q), model.absolute(to, q));
}

/// Makes an equilibrium without coordinates.
Equilibrium make_empty(SteadyModel& model) {
  Equilibrium result;
  result.q.resize(model.subsystems());
  result.multipliers.resize(model.subsystems());
  result.rows.resize(model.subsystems());
  result.alike = find_alike(model);
  return result;
}

/// Adds what support and drive exert on the hub.
void add_wrench(SteadyModel& model, Equilibrium& result) {
  result.wrench = -model.hub_force(model.no_offset());
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    SubsystemResponse response;
    require_balance_around(i, make_state(result, i), model);
    model.evaluate(i, make_state(result, i), model.no_offset(), response);
    result.wrench -= response.hub_force;
    result.force_scale += response.hub_force.lpNorm<Eigen::Infinity>();
  }
}

}  // namespace

SubsystemState make_state(const Eigen::VectorXd& q) { return make_state(q, VectorXd()); }
SubsystemState make_state(const Eigen::VectorXd& q, const Eigen::VectorXd& multipliers) {
  const VectorXd zero = VectorXd::Zero(q.size());
  return {q, zero, q, zero, multipliers};
}
SubsystemState make_state(const Equilibrium& equilibrium, std::size_t subsystem) {
  return make_state(equilibrium.q[subsystem], equilibrium.multipliers[subsystem]);
}

Equilibrium find_equilibrium(SteadyModel& model) {
  Equilibrium result = make_empty(model);
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::size_t first = result.alike[i];
    if (first == i || !take_over(first, i, model, result)) find_subsystem(i, model, result);
  }
  add_wrench(model, result);
  return result;
}

std::optional<Equilibrium> continue_equilibrium(const Equilibrium& at, const SteadyModel& before,
                                                SteadyModel& model, Tangents* kept) {
  Equilibrium result = make_empty(model);
  if (kept) kept->resize(model.subsystems());
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::size_t first = result.alike[i];
    const bool is_taken = first != i && take_over(first, i, model, result);
    if (!is_taken && !continue_subsystem(i, at, before, model, kept, result)) return std::nullopt;
  }
  add_wrench(model, result);
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
