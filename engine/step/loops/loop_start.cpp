// Closes loops by Gauss and Newton's method, and looks at the rank of their rows.

#include "engine/step/loops/loop_start.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>
#include <string>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/step/formulation/loops/shared_loops.h"
#include "engine/step/loops/given_rates.h"
#include "engine/step/loops/loop_coordinates.h"
#include "engine/step/loops/loop_rank.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke {
namespace {

// Openings by the model's length, or rates by it in 1/s, that count as closed.
constexpr double kClosed = 1e-10;

/// Returns the solution of least squares and least norm of J x = b, without directions in which the
/// rows hardly open: near a redundant row they are none.
Eigen::VectorXd solve_least(const Eigen::MatrixXd& J, const Eigen::VectorXd& b) {
  constexpr double kLeast = 1e-7;
  if (J.cols() == 0) return Eigen::VectorXd::Zero(0);
  const RightSingular singular = find_right_singular(J);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(J.cols());
  const Eigen::VectorXd Jt_b = J.transpose() * b;
  for (Eigen::Index k = 0; k < singular.values.size(); ++k) {
    const double s = singular.values[k];
    if (s <= kLeast * singular.values[0]) break;
    x += singular.vectors.col(k) * (singular.vectors.col(k).dot(Jt_b) / (s * s));
  }
  return x;
}

double largest_of(const Eigen::VectorXd& values) {
  return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0;
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

/// Makes the error of a loop, with the place of its key.
InputError fail(const LoopModel& loop, const std::string& what) {
  return InputError(
      loop.key + ": " + loop.word() + " \"" + loop.name + "\" of " + loop.owner + ": " + what,
      {.key = loop.key});
}

/// Finds the loop and the row in it of a row of a subsystem.
template <class World>
LoopRowPlace place_of(const SubsystemData<World>& data, std::size_t subsystem, int row) {
  const std::vector<LoopPath>& paths = data.loops.paths;
  std::size_t k = paths.size();
  while (paths[--k].first_row > row) {
  }
  return {static_cast<int>(subsystem), static_cast<int>(k), row - paths[k].first_row};
}

/// The start of the loops of a group of subsystems.
template <class World>
class LoopStarter {
 public:
  /// `holds`: whether joints that are to be held stay as they are.
  LoopStarter(SystemContext<World>& context, const LoopGroup& group, bool holds)
      : context_(context), group_(group), holds_(holds), kinematics_(context, group) {}

  void measure_at_start();
  void close();
  void close_rates();
  void find_rank(double redundancy, double duration);
  /// Whether prescribed motion moves a place of its loops within the run.
  bool is_driven() const { return is_driven_; }

 private:
  /// Sets them of a loop of one subsystem.
  void measure_at_start(std::size_t subsystem, LoopModel& loop);
  /// Returns where a rigid row of the group is.
  LoopRowPlace place_of_row(Eigen::Index row) const {
    const SubsystemRow& at = kinematics_.rigid_rows()[static_cast<std::size_t>(row)];
    return place_of(context_.data.subsystems[at.subsystem], at.subsystem, at.row);
  }
  const LoopModel& loop_of(Eigen::Index row) const {
    const LoopRowPlace place = place_of_row(row);
    return context_.system.subsystems[static_cast<std::size_t>(place.subsystem)]
        .loops[static_cast<std::size_t>(place.loop)];
  }

  void require_closed(const Eigen::VectorXd& openings);
  void require_no_fight(const RowRank& rank, const GivenRates& given) const;

  /// Returns what to change of the first `count` coordinates so that the rows change by `right`.
  Eigen::VectorXd solve(int count, const Eigen::VectorXd& right);
  /// Returns "crank, rod" of the joints that are held; empty if none is.
  std::string list_held() const;

  SystemContext<World>& context_;
  const LoopGroup& group_;
  bool holds_;
  LoopKinematics<World> kinematics_;
  bool is_driven_ = false;
};

/// Sets the frames and lengths that are those at the start.
template <class World>
void LoopStarter<World>::measure_at_start() {
  kinematics_.evaluate();
  for (const std::size_t i : group_)
    for (LoopModel& loop : context_.system.subsystems[i].loops) {
      if (loop.is_coupling() || loop.is_share) continue;
      measure_at_start(i, loop);
    }
}

template <class World>
void LoopStarter<World>::measure_at_start(std::size_t subsystem, LoopModel& loop) {
  const auto [from, to] = calc_place_motions(context_.system, subsystem, loop, 0.0, context_.data);
  if (loop.turns_to_start) loop.from.offset.R = loop.from.offset.R * (from.R.inverse() * to.R);
  const double distance = (from.p - to.p).norm();
  if (loop.measures_at_start) loop.rows[0].rest = distance;
  if (loop.kind == LoopKind::distance && distance < 1e-9 * context_.data.length)
    throw fail(loop, "its places coincide at the start, expected a distance between them");
}

template <class World>
Eigen::VectorXd LoopStarter<World>::solve(int count, const Eigen::VectorXd& right) {
  if (!holds_) return solve_least(kinematics_.calc_jacobian(count), right);
  Eigen::VectorXd by = solve_least(kinematics_.calc_free_jacobian(count), right);
  for (int c = 0; c < count; ++c)  // to the bit
    if (kinematics_.coordinates()[static_cast<std::size_t>(c)].is_held) by[c] = 0.0;
  return by;
}

template <class World>
std::string LoopStarter<World>::list_held() const {
  std::string text;
  if (!holds_) return text;
  for (const std::string& name : kinematics_.held_joints())
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

template <class World>
void LoopStarter<World>::close() {
  constexpr int kMost = 100;
  constexpr double kRoundOff = 1e-15, kLongest = 0.5;
  kinematics_.evaluate();
  Eigen::VectorXd openings = kinematics_.openings();
  for (int i = 0; i < kMost && largest_of(openings) > kRoundOff; ++i) {
    Eigen::VectorXd by = solve(kinematics_.joint_count(), -openings);
    const double longest = largest_of(by);
    if (!(longest > 0.0)) break;
    if (longest > kLongest) by *= kLongest / longest;
    kinematics_.move(by);
    kinematics_.evaluate();
    const double before = largest_of(openings);
    openings = kinematics_.openings();
    // What no step makes smaller any more is round-off.
    if (before < 1e-12 && largest_of(openings) > 0.25 * before) break;
  }
  require_closed(openings);
}

template <class World>
void LoopStarter<World>::require_closed(const Eigen::VectorXd& openings) {
  if (largest_of(openings) <= kClosed) return;
  Eigen::Index row = 0;
  openings.cwiseAbs().maxCoeff(&row);
  const LoopRowPlace place = place_of_row(row);
  const bool is_length = loop_of(row).rows[static_cast<std::size_t>(place.row)].is_length();
  const double opening = std::abs(openings[row]) * (is_length ? context_.data.length : 1.0);
  const std::string best = number(opening) + (is_length ? " m" : " rad") + " at best, expected ";
  const std::string held = list_held();
  if (!held.empty())
    throw fail(loop_of(row), "cannot be closed while joints are held (" + held +
                                 "): by moving the others its opening comes to " + best +
                                 "fewer joints with hold = true, or initial values that fit");
  throw fail(loop_of(row), "cannot be closed: by moving joints its opening comes to " + best +
                               "places, lengths and initial values of joints that fit");
}

// Joints alone, if they can; else deformations, too.
template <class World>
void LoopStarter<World>::close_rates() {
  kinematics_.evaluate();
  const double scale = std::max(1.0, largest_of(kinematics_.rates()));
  const int all = static_cast<int>(kinematics_.coordinates().size());
  for (const int count : {kinematics_.joint_count(), all})
    for (int i = 0; i < 3; ++i) {
      const Eigen::VectorXd rates = kinematics_.rates();
      if (largest_of(rates) <= 1e-15 * scale) return;
      if (i > 0 && largest_of(rates) > 1e-9 * scale) break;
      kinematics_.add_speeds(solve(count, -rates));
      kinematics_.evaluate();
    }
  const Eigen::VectorXd rates = kinematics_.rates();
  if (largest_of(rates) <= 1e-9 * scale) return;
  Eigen::Index row = 0;
  rates.cwiseAbs().maxCoeff(&row);
  const std::string held = list_held();
  if (!held.empty())
    throw fail(loop_of(row), "opens at " + number(std::abs(rates[row])) +
                                 " model lengths or rad a second at the initial_speed of the "
                                 "joints that are held (" +
                                 held +
                                 "), and no other joint can follow; expected fewer joints with "
                                 "hold = true, or speeds that fit");
  throw fail(loop_of(row), "prescribed motion fights it: at the start it opens at " +
                               number(std::abs(rates[row])) +
                               " model lengths or rad a second, and no joint can follow");
}

template <class World>
void LoopStarter<World>::require_no_fight(const RowRank& rank, const GivenRates& given) const {
  constexpr double kShare = 1e-2;
  for (std::size_t r = 0; r < rank.is_redundant.size(); ++r) {
    if (!rank.is_redundant[r]) continue;
    const auto row = static_cast<Eigen::Index>(r);
    for (Eigen::Index c = 0; c < given.columns.cols(); ++c)
      if (std::abs(rank.left(row, c)) > kShare * std::max(1e-9, rank.sizes(row, c)))
        throw fail(loop_of(row),
                   given.names[static_cast<std::size_t>(c)] +
                       " fights it: it opens the loop, and no free coordinate can follow");
  }
}

template <class World>
int count_joint_coordinates(const TreeBody<World>& body) {
  if constexpr (tree::kHasJointCoordinates<World>) return body.joint.joint.coordinates;
  return 0;
}

template <class World>
LoopFreedoms count_freedoms(const Subsystem<World>& subsystem) {
  LoopFreedoms freedoms;
  for (const TreeBody<World>& body : subsystem.bodies) {
    freedoms.joints += count_joint_coordinates(body);
    freedoms.deformations += body.body->coordinates();
  }
  return freedoms;
}

template <class World>
void LoopStarter<World>::find_rank(double redundancy, double duration) {
  const int count = static_cast<int>(kinematics_.coordinates().size());
  const GivenRates given = find_given_rates(context_, group_, duration, kinematics_);
  const RowRank rank =
      find_redundant_rows(kinematics_.calc_jacobian(count), given.columns, redundancy);
  for (std::size_t r = 0; r < rank.is_redundant.size(); ++r) {
    const SubsystemRow& at = kinematics_.rigid_rows()[r];
    LoopFreedoms& freedoms = context_.loop_start.freedoms[at.subsystem];
    ++freedoms.rows;
    freedoms.independent += !rank.is_redundant[r];
    context_.data.subsystems[at.subsystem].loops.use[static_cast<std::size_t>(at.row)] =
        rank.is_redundant[r] ? LoopRowUse::dropped : LoopRowUse::solved;
    if (rank.is_redundant[r])
      context_.loop_start.dropped.push_back(place_of_row(static_cast<Eigen::Index>(r)));
  }
  require_no_fight(rank, given);
  is_driven_ = (given.columns.size() > 0 && given.columns.cwiseAbs().maxCoeff() > 0.0) ||
               std::any_of(group_.begin(), group_.end(), [this](std::size_t i) {
                 return may_be_moved(context_.system, context_.system.subsystems[i]);
               });
}

/// Throws if nothing of the model can move.
template <class World>
void require_freedom(const SystemContext<World>& context, const std::vector<LoopGroup>& groups) {
  const std::vector<LoopFreedoms>& freedoms = context.loop_start.freedoms;
  std::vector<bool> is_tied(freedoms.size(), false);
  LoopFreedoms locked;
  std::size_t which = 0;
  for (const LoopGroup& group : groups) {
    LoopFreedoms sum;
    for (const std::size_t i : group) {
      is_tied[i] = true;
      sum.joints += freedoms[i].joints;
      sum.deformations += freedoms[i].deformations;
      sum.rows += freedoms[i].rows;
      sum.independent += freedoms[i].independent;
      if (freedoms[i].rows > 0) which = i;
    }
    if (sum.mobility() > 0) return;
    if (sum.rows > 0) locked = sum;
  }
  for (std::size_t i = 0; i < freedoms.size(); ++i)
    if (!is_tied[i] && freedoms[i].mobility() > 0) return;
  if (locked.rows == 0 || !is_at_rest(context.system, context.loop_limits.duration)) return;
  throw fail(
      context.system.subsystems[which].loops.back(),
      "the mechanism has no freedom: " + std::to_string(locked.joints + locked.deformations) +
          " free coordinates, " + std::to_string(locked.independent) +
          " independent rows of loops, and nothing prescribed moves");
}

/// Returns the coordinates of the joints of a subsystem.
std::vector<double> take_joints(const SubsystemData<Plane>&) { return {}; }

using Orientations = std::vector<space::Quaternion>;
Orientations take_orientations(const SubsystemData<Plane>&) { return {}; }
Orientations take_orientations(const SubsystemData<Space>& data) {
  Orientations orientations;
  for (const BodyData<Space>& body : data.bodies)
    orientations.push_back(body.model->joint.joint.spherical_at >= 0
                               ? body.joint.rotation->reference
                               : space::Quaternion{});
  return orientations;
}
std::vector<double> take_joints(const SubsystemData<Space>& data) {
  std::vector<double> values;
  for (const BodyData<Space>& body : data.bodies)
    values.insert(values.end(), body.joint.coordinates.q,
                  body.joint.coordinates.q + body.model->joint.joint.coordinates);
  return values;
}

/// Adds the joints that were moved since.
void add_moves(std::size_t, const std::vector<double>&, const Orientations&,
               const SubsystemData<Plane>&, std::vector<LoopMove>&) {}
void add_moves(std::size_t i, const std::vector<double>& before, const Orientations& turned,
               const SubsystemData<Space>& data, std::vector<LoopMove>& moves) {
  constexpr double kLeast = 1e-12;
  auto value = before.begin();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Space>& body = data.bodies[j];
    int at = 0;
    for (const space::JointPrimitive& primitive : body.model->joint.joint.sequence()) {
      if (primitive.is_driven) continue;
      LoopMove move{static_cast<int>(i), static_cast<int>(j), at};
      if (primitive.kind == space::JointPrimitive::Kind::spherical) {
        move.by = logarithm(turned[j].conjugate() * body.joint.rotation->reference).norm();
      } else {
        move.is_angle = primitive.kind == space::JointPrimitive::Kind::revolute;
        move.by = body.joint.coordinates.q[at] - *value;
      }
      if (std::abs(move.by) > kLeast) moves.push_back(move);
      at += primitive.components();
      value += primitive.components();
    }
  }
}

/// Adds the coordinates whose given speeds have changed.
void add_speeds(std::size_t, const SubsystemData<Plane>&, std::vector<LoopSpeed>&) {}
void add_speeds(std::size_t i, const SubsystemData<Space>& data, std::vector<LoopSpeed>& speeds) {
  constexpr double kLeast = 1e-9;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Space>& body = data.bodies[j];
    const space::TreeJoint& joint = body.model->joint;
    std::size_t at = 0;
    for (const space::JointPrimitive& primitive : joint.joint.sequence()) {
      if (primitive.is_driven) continue;
      for (int c = 0; c < primitive.components(); ++c, ++at) {
        const double from = joint.course.initial_speed[at], to = body.joint.coordinates.v[at];
        if (from != 0.0 && std::abs(to - from) > kLeast * std::abs(from))
          speeds.push_back({static_cast<int>(i), static_cast<int>(j),
                            primitive.kind != space::JointPrimitive::Kind::prismatic, from, to});
      }
    }
  }
}

}  // namespace

LoopLimits make_loop_limits(const Integration& integration) {
  LoopLimits limits;
  limits.redundancy = integration.loop_redundancy;
  limits.duration = integration.duration;
  return limits;
}

template <class World>
void start_loops(SystemContext<World>& context) {
  context.loop_start = {};
  bool is_driven = false;
  for (const Subsystem<World>& subsystem : context.system.subsystems)
    context.loop_start.freedoms.push_back(count_freedoms(subsystem));
  if (context.loop_limits.has_started) return;
  const std::vector<LoopGroup> groups = find_loop_groups(context.system);
  for (const LoopGroup& group : groups) {
    std::vector<std::vector<double>> before;
    std::vector<Orientations> turned;
    for (const std::size_t i : group) {
      before.push_back(take_joints(context.data.subsystems[i]));
      turned.push_back(take_orientations(context.data.subsystems[i]));
    }
    LoopStarter<World> starter(context, group, true);
    starter.measure_at_start();
    starter.close();
    for (std::size_t k = 0; k < group.size(); ++k)
      add_moves(group[k], before[k], turned[k], context.data.subsystems[group[k]],
                context.loop_start.moves);
    starter.find_rank(context.loop_limits.redundancy, context.loop_limits.duration);
    is_driven = is_driven || starter.is_driven();
    starter.close_rates();
    for (const std::size_t i : group)
      add_speeds(i, context.data.subsystems[i], context.loop_start.speeds);
  }
  take_uses_of_shared_loops(context.system, context.data);
  if (!groups.empty() && !is_driven) require_freedom(context, groups);
}

template <class World>
void close_loops(SystemContext<World>& context) {
  for (const LoopGroup& group : find_loop_groups(context.system)) {
    LoopStarter<World> starter(context, group, false);
    starter.close();
    starter.close_rates();
  }
}

template void start_loops(SystemContext<Plane>&);
template void close_loops(SystemContext<Plane>&);
template void start_loops(SystemContext<Space>&);
template void close_loops(SystemContext<Space>&);

}  // namespace spoke
