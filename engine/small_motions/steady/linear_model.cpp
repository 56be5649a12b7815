// Puts the matrices of the subsystems and the hub together.

#include "engine/small_motions/steady/linear_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/small_motions/steady/alike_subsystems.h"
#include "engine/small_motions/steady/derivatives.h"
#include "engine/small_motions/steady/differences.h"
#include "engine/small_motions/steady/free_motion.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;

/// Columns of the hub's coordinates in matrices, from the derivatives of forces by its turn and
/// twist.
struct HubColumns {
  MatrixXd M, C, K;
};
HubColumns make_columns(const MatrixXd& mass, const MatrixXd& by_turn, const MatrixXd& by_twist,
                        const HubKinematics& hub) {
  return {mass, mass * hub.P1 - by_twist, mass * hub.P0 - by_turn - by_twist * hub.W};
}

/// Common quantities of subsystems that are alike: their matrices, and their coupling with all
/// components of the hub's motion, seen along the first of them.
struct Shared {
  LinearSubsystem subsystem;
  HubColumns by_hub;                      ///< rows of the subsystem's coordinates
  MatrixXd M_on_hub, C_on_hub, K_on_hub;  ///< columns of the subsystem's coordinates
  HubColumns hub;                         ///< its share in the matrices of the hub
  MatrixXd following;                     ///< see HubCoupling, for all components
  double effort = 0.0;                    ///< see calc_effort()
};

/// Returns the size of forces in a subsystem: the force on a coordinate consists of terms up to
/// this times the square root of its mass [sqrt(kg) m/s^2]. This bounds inertia forces m w^2 r by
/// the inequality of Cauchy and Schwarz, and other forces as far as they reach the hub.
double calc_effort(const MatrixXd& mass_of_hub, const HubVector& hub_force,
                   const SteadyModel& model) {
  const int r = model.first_rotation();
  const double spin = model.speed() * model.speed();
  const double mass = mass_of_hub(0, 0), inertia = mass_of_hub.diagonal().tail(1)[0];
  const double largest = mass_of_hub.diagonal().tail(mass_of_hub.rows() - r).maxCoeff();
  double effort = spin * std::sqrt(inertia);
  if (mass > 0.0) effort += hub_force.head(r).norm() / std::sqrt(mass);
  if (largest > 0.0) effort += hub_force.tail(hub_force.size() - r).norm() / std::sqrt(largest);
  return effort;
}

/// Returns the round-off of a subsystem's matrices.
RoundOff find_round_off(std::size_t i, const MatrixXd& mass, double effort,
                        const SteadyModel& model) {
  RoundOff found{effort * mass.diagonal().cwiseSqrt(), Eigen::VectorXd(mass.rows())};
  for (Eigen::Index k = 0; k < mass.rows(); ++k)
    found.step[k] = kStep * model.coordinates(i)[static_cast<std::size_t>(k)].scale;
  return found;
}

/// Adds the stiffness of springs in closures, which were held.
void add_springs(std::size_t i, const MatrixXd& closures, Shared& all, const SteadyModel& model) {
  const MatrixXd springs = calc_spring_stiffness(model.closure_rows(i), closures);
  const Eigen::Index d = model.twist_size(), n = all.subsystem.K.rows();
  all.subsystem.K += springs.bottomRightCorner(n, n);
  if (all.hub.K.size() == 0) return;
  all.by_hub.K += springs.bottomLeftCorner(n, d);
  all.K_on_hub += springs.topRightCorner(d, n);
  all.hub.K += springs.topLeftCorner(d, d);
}

/// Returns the motion of coordinates by which the rigid rows stay closed when the free components
/// of the hub move; empty if nothing follows them.
MatrixXd find_following(std::size_t i, const FreeMotion& motion, const MatrixXd& closures,
                        const std::vector<int>& free, const SteadyModel& model) {
  const Eigen::Index d = model.twist_size(), n = closures.cols() - d;
  MatrixXd by_hub = MatrixXd::Zero(closures.rows(), d);
  for (const int c : free) by_hub.col(c) = closures.col(c);
  const auto size = [&](Eigen::Index r) { return 1e-9 * closures.row(r).norm(); };
  const MatrixXd following = motion.open(-MatrixXd(by_hub(motion.rows(), Eigen::all)));
  const MatrixXd left = by_hub + closures.rightCols(n) * following;
  bool follows = false;
  for (const Eigen::Index r : find_rigid_rows(model.closure_rows(i))) {
    follows = follows || by_hub.row(r).norm() > size(r);
    if (left.row(r).norm() <= size(r)) continue;
    const std::size_t loop = model.closure_rows(i)[static_cast<std::size_t>(r)].loop;
    throw InputError(model.name_of(i) + " / " + model.loop_words(i, loop) +
                     " holds the hub, which nothing else does: expected a hub at a given speed");
  }
  return follows ? following : MatrixXd();
}

/// Takes matrices to the motions that leave loops closed.
void reduce(const MatrixXd& Z, const MatrixXd& G, Shared& all) {
  LinearSubsystem& own = all.subsystem;
  const auto close = [&](MatrixXd& by_hub, MatrixXd& on_hub, MatrixXd& hub, MatrixXd& matrix) {
    if (G.size() > 0) {
      hub += on_hub * G + G.transpose() * (by_hub + matrix * G);
      by_hub += matrix * G;
      on_hub += G.transpose() * matrix;
    }
    if (by_hub.size() > 0) {
      by_hub = Z.transpose() * by_hub;
      on_hub = on_hub * Z;
    }
    matrix = Z.transpose() * matrix * Z;
  };
  const MatrixXd size = Z.cwiseAbs();
  own.K_terms = size.transpose() * own.K.cwiseAbs() * size;
  close(all.by_hub.M, all.M_on_hub, all.hub.M, own.M);
  close(all.by_hub.C, all.C_on_hub, all.hub.C, own.C);
  close(all.by_hub.K, all.K_on_hub, all.hub.K, own.K);
  own.round_off.force = size.transpose() * own.round_off.force;
  own.round_off.step = (size.transpose() * own.round_off.step.cwiseInverse()).cwiseInverse().eval();
}

/// Adds what the loops of a subsystem do, at its equilibrium. `rows`: the rigid ones that do not
/// depend on others.
void close_subsystem(std::size_t i, const std::vector<Eigen::Index>& rows,
                     const std::vector<int>& free, SteadyModel& model, Shared& all) {
  const MatrixXd closures = model.closures(i);
  add_springs(i, closures, all, model);
  const FreeMotion motion(closures.rightCols(all.subsystem.M.rows()), rows, model.coordinates(i));
  if (motion.rows().size() < rows.size())
    throw InputError(model.name_of(i) +
                     ": its loops are in a singular position, expected one that they can leave in "
                     "one way");
  if (motion.is_all()) return;
  if (!free.empty()) all.following = find_following(i, motion, closures, free, model);
  reduce(motion.basis(), all.following, all);
  all.subsystem.independent = motion.independent();
  all.subsystem.basis = motion.basis();
}

/// Returns the order that puts each of the forces, which are last, behind the coordinates up to the
/// one on which it acts.
std::vector<Eigen::Index> order_forces(const std::vector<Eigen::Index>& independent) {
  std::vector<Eigen::Index> order(independent.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return independent[static_cast<std::size_t>(a)] < independent[static_cast<std::size_t>(b)];
  });
  return order;
}

/// Returns a matrix with rows and columns for as many forces behind the others.
MatrixXd make_room(const MatrixXd& m, Eigen::Index rows, Eigen::Index columns) {
  MatrixXd larger = MatrixXd::Zero(m.rows() + rows, m.cols() + columns);
  larger.topLeftCorner(m.rows(), m.cols()) = m;
  return larger;
}

/// Appends the forces z of joints that relax to the coordinates y: rows T m z'' + z' + z/T - k/T q,
/// with m next to nothing. `on_all`: what forces by z are on coordinates and hub. K has the springs
/// as if they did not relax.
void append_forces(const std::vector<ForceState>& forces, const MatrixXd& on_all, Shared& all) {
  constexpr double kLightness = 1e-10;
  LinearSubsystem& own = all.subsystem;
  const Eigen::Index m = std::ssize(forces), y = own.M.rows();
  const Eigen::Index n = own.basis.rows() > 0 ? own.basis.rows() : y;
  const MatrixXd Z = own.basis.rows() > 0 ? own.basis : MatrixXd::Identity(n, n);
  const MatrixXd on_q = on_all.topRows(n);
  for (MatrixXd* matrix : {&own.M, &own.C, &own.K}) *matrix = make_room(*matrix, m, m);
  if (own.K_terms.size() > 0) own.K_terms = make_room(own.K_terms, m, m);
  own.K.topRightCorner(y, m) = -Z.transpose() * on_q;
  MatrixXd by_q(m, n);
  for (Eigen::Index k = 0; k < m; ++k) {
    const ForceState& force = forces[static_cast<std::size_t>(k)];
    by_q.row(k) = -force.stiffness / force.time * on_q.col(k).transpose();
    own.M(y + k, y + k) = kLightness * force.time;
    own.C(y + k, y + k) = 1.0;
    own.K(y + k, y + k) = 1.0 / force.time;
    own.independent.push_back(force.coordinate);
  }
  own.K.bottomLeftCorner(m, y) = by_q * Z;
  if (own.K_terms.size() > 0) {
    own.K_terms.rightCols(m) = own.K.rightCols(m).cwiseAbs();
    own.K_terms.bottomRows(m) = own.K.bottomRows(m).cwiseAbs();
  }
  own.basis = make_room(Z, 0, m);
  own.round_off.force = make_room(own.round_off.force, m, 0);
  own.round_off.step = make_room(own.round_off.step, m, 0);
  own.round_off.step.tail(m).setOnes();
  if (all.by_hub.M.size() == 0) return;
  for (MatrixXd* columns : {&all.by_hub.M, &all.by_hub.C, &all.by_hub.K})
    *columns = make_room(*columns, m, 0);
  for (MatrixXd* rows : {&all.M_on_hub, &all.C_on_hub, &all.K_on_hub})
    *rows = make_room(*rows, 0, m);
  all.K_on_hub.rightCols(m) = -on_all.bottomRows(on_all.rows() - n);
  if (all.following.size() == 0) return;
  all.by_hub.K.bottomRows(m) = by_q * all.following;
  all.K_on_hub.rightCols(m) -= all.following.transpose() * on_q;
}

/// Puts coordinates of a subsystem in another order.
void reorder(const std::vector<Eigen::Index>& order, Shared& all) {
  LinearSubsystem& own = all.subsystem;
  for (MatrixXd* matrix : {&own.M, &own.C, &own.K}) *matrix = (*matrix)(order, order).eval();
  if (own.K_terms.size() > 0) own.K_terms = own.K_terms(order, order).eval();
  own.basis = own.basis(Eigen::all, order).eval();
  own.round_off.force = own.round_off.force(order).eval();
  own.round_off.step = own.round_off.step(order).eval();
  if (all.by_hub.M.size() == 0) return;
  for (MatrixXd* columns : {&all.by_hub.M, &all.by_hub.C, &all.by_hub.K})
    *columns = (*columns)(order, Eigen::all).eval();
  for (MatrixXd* rows : {&all.M_on_hub, &all.C_on_hub, &all.K_on_hub})
    *rows = (*rows)(Eigen::all, order).eval();
}

/// Adds what joints of a subsystem that relax do, at `state`.
void relax_subsystem(std::size_t i, const SubsystemState& state, SteadyModel& model, Shared& all) {
  const std::vector<ForceState> forces = model.force_states(i);
  if (forces.empty()) return;
  append_forces(forces, calc_by_forces(i, state, forces, model), all);
  LinearSubsystem& own = all.subsystem;
  const std::vector<Eigen::Index> order = order_forces(own.independent);
  const Eigen::Index first = std::ssize(order) - std::ssize(forces);
  std::vector<Eigen::Index> independent;
  for (std::size_t k = 0; k < order.size(); ++k) {
    independent.push_back(own.independent[static_cast<std::size_t>(order[k])]);
    if (order[k] >= first) own.forces.push_back(static_cast<Eigen::Index>(k));
  }
  own.independent = std::move(independent);
  reorder(order, all);
}

Shared linearize_subsystem(std::size_t i, const Equilibrium& equilibrium,
                           const HubKinematics& kinematics, const std::vector<int>& free,
                           SteadyModel& model) {
  const bool is_coupled = !free.empty();
  const Eigen::Index d = model.twist_size();
  SubsystemState state = make_state(equilibrium, i);
  state.holds_springs = true;
  const SubsystemDerivatives by = calc_derivatives(i, state, is_coupled, model);
  const SubsystemMatrices matrices = model.matrices(i);
  const Eigen::Index n = by.by_q.cols();
  Shared all;
  all.subsystem.M = matrices.mass.bottomRightCorner(n, n);
  all.subsystem.C = matrices.damping - by.by_v.topRows(n);
  all.subsystem.K = model.stiffness(i) - by.by_q.topRows(n);
  SubsystemResponse response;
  model.evaluate(i, make_state(equilibrium, i), model.no_offset(), response);
  all.effort = calc_effort(matrices.mass.topLeftCorner(d, d), response.hub_force, model);
  all.subsystem.round_off = find_round_off(i, all.subsystem.M, all.effort, model);
  all.subsystem.independent.resize(static_cast<std::size_t>(n));
  std::iota(all.subsystem.independent.begin(), all.subsystem.independent.end(), Eigen::Index{0});
  if (is_coupled) {
    const MatrixXd M_bh = matrices.mass.bottomLeftCorner(n, d);
    all.by_hub = make_columns(M_bh, by.by_turn.topRows(n), by.by_twist.topRows(n), kinematics);
    all.M_on_hub = M_bh.transpose();
    all.C_on_hub = -by.by_v.bottomRows(d);
    all.K_on_hub = -by.by_q.bottomRows(d);
    all.hub = make_columns(matrices.mass.topLeftCorner(d, d), by.by_turn.bottomRows(d),
                           by.by_twist.bottomRows(d), kinematics);
  }
  if (!model.closure_rows(i).empty()) close_subsystem(i, equilibrium.rows[i], free, model, all);
  relax_subsystem(i, state, model, all);
  return all;
}

/// Couples a subsystem with the hub, where `turn` takes it to the place at which `shared` was
/// found; adds its share to the hub's matrices for all components.
HubCoupling couple(const Shared& shared, const MatrixXd& turn, const std::vector<int>& free,
                   HubColumns& sum) {
  const auto columns = [&](const MatrixXd& m) { return MatrixXd((m * turn)(Eigen::all, free)); };
  const auto rows = [&](const MatrixXd& m) {
    return MatrixXd((turn.transpose() * m)(free, Eigen::all));
  };
  sum.M += turn.transpose() * shared.hub.M * turn;
  sum.C += turn.transpose() * shared.hub.C * turn;
  sum.K += turn.transpose() * shared.hub.K * turn;
  return {columns(shared.by_hub.M),
          columns(shared.by_hub.C),
          columns(shared.by_hub.K),
          rows(shared.M_on_hub),
          rows(shared.C_on_hub),
          rows(shared.K_on_hub),
          shared.following.size() > 0 ? columns(shared.following) : MatrixXd()};
}

/// Derivatives of the forces on the hub itself, which are simple functions.
HubColumns linearize_hub(const HubKinematics& kinematics, const SteadyModel& model) {
  constexpr double kStep = 1e-4;
  const Eigen::Index d = model.twist_size();
  MatrixXd by_turn = MatrixXd::Zero(d, d), by_twist = MatrixXd::Zero(d, d);
  for (Eigen::Index c = 0; c < d; ++c) {
    const auto differ = [&](HubVector HubOffset::*member) {
      HubOffset plus = model.no_offset(), minus = plus;
      (plus.*member)[c] = kStep;
      (minus.*member)[c] = -kStep;
      return HubVector((model.hub_force(plus) - model.hub_force(minus)) / (2.0 * kStep));
    };
    if (c >= model.first_rotation()) by_turn.col(c) = differ(&HubOffset::turn);
    by_twist.col(c) = differ(&HubOffset::twist);
  }
  return make_columns(model.hub_mass(), by_turn, by_twist, kinematics);
}

/// Returns the stiffness by which a wrench that turns with the hub differs from one that stays: a
/// turn theta adds theta x force, and theta x moment.
MatrixXd turn_wrench(const HubVector& wrench, const SteadyModel& model) {
  MatrixXd K = MatrixXd::Zero(wrench.size(), wrench.size());
  if (!model.is_spatial()) {
    K(0, 2) = wrench[1];
    K(1, 2) = -wrench[0];
    return K;
  }
  for (const Eigen::Index part : {0, 3}) {
    const Eigen::Vector3d v = wrench.segment(part, 3);
    K.block<3, 3>(part, 3) << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
  }
  return K;
}

}  // namespace

std::vector<int> list_components(const SteadyModel& model, HubFreedom freedom) {
  if (freedom == HubFreedom::described) return model.free_components();
  std::vector<int> all(static_cast<std::size_t>(model.twist_size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

HubKinematics make_hub_kinematics(const SteadyModel& model) {
  const Eigen::Index d = model.twist_size();
  HubKinematics hub{MatrixXd::Zero(d, d), MatrixXd::Zero(d, d), MatrixXd::Zero(d, d)};
  Eigen::Matrix2d cross;
  cross << 0.0, -model.speed(), model.speed(), 0.0;
  hub.W.topLeftCorner<2, 2>() = cross;
  hub.P1.topLeftCorner<2, 2>() = 2.0 * cross;
  hub.P0.topLeftCorner<2, 2>() = cross * cross;
  if (!model.is_spatial()) return hub;
  hub.W.block<2, 2>(3, 3) = cross;
  hub.P1.block<2, 2>(3, 3) = cross;
  return hub;
}

Eigen::VectorXcd LinearModel::motion_of(std::size_t i, const Eigen::VectorXcd& y,
                                        const Eigen::VectorXcd& hub) const {
  const LinearSubsystem& own = subsystem(i);
  assert(y.size() == own.M.rows());
  Eigen::VectorXcd q = own.basis.rows() > 0 ? Eigen::VectorXcd(own.basis * y) : y;
  if (is_coupled() && couplings[i].following.size() > 0) q += couplings[i].following * hub;
  return q;
}

std::vector<SubsystemCoordinate> list_independent(std::size_t subsystem, const LinearModel& linear,
                                                  const SteadyModel& model) {
  const LinearSubsystem& own = linear.subsystem(subsystem);
  std::vector<SubsystemCoordinate> list;
  for (const Eigen::Index k : own.independent)
    list.push_back(model.coordinates(subsystem)[static_cast<std::size_t>(k)]);
  for (const Eigen::Index k : own.forces) {
    SubsystemCoordinate& force = list[static_cast<std::size_t>(k)];
    force = force_on(force);
  }
  return list;
}

bool has_forces(const LinearModel& linear) {
  const auto relaxes = [](const LinearSubsystem& own) { return !own.forces.empty(); };
  return std::any_of(linear.subsystems.begin(), linear.subsystems.end(), relaxes) ||
         (linear.support && !linear.support->forces.empty());
}

LinearModel linearize(const Equilibrium& equilibrium, SteadyModel& model, HubFreedom freedom) {
  assert(equilibrium.q.size() == model.subsystems() &&
         equilibrium.alike.size() == model.subsystems());
  const std::vector<int> free = list_components(model, freedom);
  const HubKinematics kinematics = make_hub_kinematics(model);
  HubColumns hub = linearize_hub(kinematics, model);
  if (freedom == HubFreedom::all) hub.K += turn_wrench(-equilibrium.wrench, model);
  LinearModel result;
  result.subsystems.resize(model.subsystems());
  result.alike = equilibrium.alike;
  if (!free.empty()) result.alike = find_alike_about_hub(equilibrium.alike, equilibrium.q, model);
  result.rate = std::max(1.0, std::abs(model.speed()));
  const double of_hub = calc_effort(model.hub_mass(), model.hub_force(model.no_offset()), model);
  double squares = of_hub * of_hub;
  std::vector<Shared> shared(model.subsystems());
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::size_t first = result.alike[i];
    if (first == i) {
      shared[i] = linearize_subsystem(i, equilibrium, kinematics, free, model);
      result.subsystems[i] = std::move(shared[i].subsystem);
    }
    if (free.empty()) continue;
    const MatrixXd turn = turn_hub(model.azimuth(first) - model.azimuth(i), model);
    result.couplings.push_back(couple(shared[first], turn, free, hub));
    squares += shared[first].effort * shared[first].effort;
  }
  result.M = hub.M(free, free);
  result.C = hub.C(free, free);
  result.K = hub.K(free, free);
  result.round_off = {std::sqrt(squares) * result.M.diagonal().cwiseSqrt(),
                      Eigen::VectorXd::Constant(result.M.rows(), kStep)};
  return result;
}

}  // namespace spoke::steady
