// Compares joints of all kinds with finite differences of the poses of child and parent.

#include "engine/bodies/space/joint_motion.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/engine/bodies/space/random_joint.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

/// A smooth function of time with its derivatives.
struct Course {
  double value, rate, second;
};

/// Random smooth functions a + b t + c t^2/2 + d t^3/6.
struct Polynomial {
  explicit Polynomial(std::mt19937& random) {
    for (double& c : c_) c = random_number(random);
  }
  Course at(double t) const {
    return {c_[0] + t * (c_[1] + t * (c_[2] / 2 + t * c_[3] / 6)),
            c_[1] + t * (c_[2] + t * c_[3] / 2), c_[2] + t * c_[3]};
  }

 private:
  std::array<double, 4> c_{};
};

struct VectorCourse {
  Position value, rate, second;
};

struct VectorPolynomial {
  explicit VectorPolynomial(std::mt19937& random) : x(random), y(random), z(random) {}
  VectorCourse at(double t) const {
    const Course a = x.at(t), b = y.at(t), c = z.at(t);
    return {{a.value, b.value, c.value}, {a.rate, b.rate, c.rate}, {a.second, b.second, c.second}};
  }
  Polynomial x, y, z;
};

/// Pose, twist and acceleration, all resolved in the inertial frame.
struct Motion {
  Pose pose;
  Twist twist;
  Twist acceleration;
};

/// Returns d/dt at t, of order 4.
template <class Function>
auto differentiate(const Function& f, double t, double h) {
  return ((8.0 * (f(t + h) - f(t - h)) - (f(t + 2.0 * h) - f(t - 2.0 * h))) / (12.0 * h)).eval();
}

/// Returns the angular velocity of R(t), in the inertial frame.
template <class Function>
Angular calc_angular_velocity(const Function& R, double t) {
  const Matrix3 rate = differentiate([&](double s) -> Matrix3 { return R(s).axes; }, t, 2e-3);
  const Matrix3 w = rate * R(t).axes.transpose();
  return {w(2, 1), w(0, 2), w(1, 0)};
}

/// Returns the motion that belongs to poses as a function of time.
template <class Function>
Motion differentiate_pose(const Function& pose, double t) {
  const auto R = [&](double s) { return pose(s).R; };
  const auto velocity = [&](double s) -> Position {
    return differentiate([&](double u) -> Position { return pose(u).p; }, s, 2e-3);
  };
  const auto w = [&](double s) -> Angular { return calc_angular_velocity(R, s); };
  return {pose(t), make_twist(velocity(t), w(t)),
          make_twist(differentiate(velocity, t, 2e-3), differentiate(w, t, 2e-3))};
}

/// A joint between a parent that moves in space and its child, all as functions of time.
class MovingJoint {
 public:
  MovingJoint(const char* kind, std::mt19937& random)
      : joint(make_random_joint(kind, random)),
        parent_place_(random),
        parent_turn_(random),
        section_turn_(random),
        spherical_turn_(random),
        reference_(make_quaternion(random_vector(random))) {
    for (int c = 0; c < Joint::kMost; ++c) courses_.emplace_back(random);
  }

  Pose parent(double t) const {
    return {parent_place_.at(t).value, exponential(parent_turn_.at(t).value)};
  }
  /// Returns the rotation of the handle against the frame of the parent, at whose origin it stands.
  Rotation section(double t) const { return exponential(section_turn_.at(t).value); }
  Pose handle(double t) const { return {parent(t).p, parent(t).R * section(t)}; }

  /// Sets the coordinates; a spherical primitive turns by D(t).
  void set_state(double t) {
    const TurnFrame frame = frame_of_spherical();
    for (int c = 0; c < joint.coordinates; ++c) {
      const Course course = courses_[static_cast<std::size_t>(c)].at(t);
      q_[c] = course.value;
      v_[c] = course.rate;
      a_[c] = course.second;
    }
    for (int c = 0; c < joint.driven; ++c) {
      const Course course = courses_[static_cast<std::size_t>(joint.coordinates + c)].at(t);
      driven_[static_cast<std::size_t>(c)] = {course.value, course.rate, course.second};
    }
    if (joint.spherical_at < 0) return;
    const VectorCourse D = spherical_turn_.at(t);
    // In the child's frame the velocity is H(D)^T D' = H(-D) D'.
    const double sign = frame == TurnFrame::child ? -1.0 : 1.0;
    const RotationVectorMotion turned = calc_rotation_vector_motion(sign * D.value, sign * D.rate);
    const Angular w = sign * turned.velocity;
    const Angular w_rate = turned.H * D.second + sign * turned.convective;
    for (int c = 0; c < kAngular; ++c) {
      q_[joint.spherical_at + c] = D.value[c];
      v_[joint.spherical_at + c] = w[c];
      a_[joint.spherical_at + c] = w_rate[c];
    }
  }
  JointState state() const { return {q_.data(), v_.data(), &reference_, driven_.data()}; }
  const double* accelerations() const { return a_.data(); }

  /// Returns the pose of the child in space by the definition of the joint: offset, then every
  /// primitive.
  Pose child(double t) {
    set_state(t);
    Pose reached = handle(t);
    const auto go = [&reached](const Position& p, const Rotation& R) {
      reached.p += reached.R * p;
      reached.R = reached.R * R;
    };
    go(joint.offset.p, joint.offset.R);
    int free = 0, given = 0;
    for (const JointPrimitive& primitive : joint.sequence()) {
      if (primitive.kind == JointPrimitive::Kind::spherical) {
        const Rotation D = exponential(spherical_turn_.at(t).value), Q = make_rotation(reference_);
        go(Position::Zero(), primitive.frame == TurnFrame::child ? Q * D : D * Q);
        free += kAngular;
        continue;
      }
      const double q = primitive.is_driven ? driven_[static_cast<std::size_t>(given++)].value
                                           : q_[static_cast<std::size_t>(free++)];
      if (primitive.kind == JointPrimitive::Kind::revolute)
        go(Position::Zero(), exponential(q * primitive.axis));
      else
        go(q * primitive.axis, Rotation{});
    }
    return reached;
  }

  Joint joint;

 private:
  TurnFrame frame_of_spherical() const {
    for (const JointPrimitive& primitive : joint.sequence())
      if (primitive.kind == JointPrimitive::Kind::spherical) return primitive.frame;
    return TurnFrame::child;
  }

  VectorPolynomial parent_place_, parent_turn_, section_turn_, spherical_turn_;
  Quaternion reference_;
  std::vector<Polynomial> courses_;
  std::array<double, Joint::kMost> q_{}, v_{}, a_{};
  std::array<PrescribedMotion, Joint::kMost> driven_{};
};

Twist resolve(const Rotation& R, const Twist& v) { return R.inverse() * v; }

}  // namespace

TEST_CASE("pose, twist and acceleration behind a joint are those of its primitives") {
  std::mt19937 random(1);
  for (const char* kind : kJointKinds)
    for (int round = 0; round < 3; ++round) {
      CAPTURE(std::string(kind));
      MovingJoint moving(kind, random);
      const double t = 0.3;
      const Rotation R_P = moving.parent(t).R;
      const Motion handle = differentiate_pose([&](double s) { return moving.handle(s); }, t);
      const Motion child = differentiate_pose([&](double s) { return moving.child(s); }, t);
      moving.set_state(t);
      JointMotion motion;
      Twist twist;
      calc_joint_motion(moving.joint, moving.state(), moving.section(t), resolve(R_P, handle.twist),
                        motion, twist);

      CHECK((handle.pose.p + R_P * motion.p - child.pose.p).norm() < 1e-14);
      CHECK(((R_P * motion.R).axes - child.pose.R.axes).norm() < 1e-14);
      CHECK((twist - resolve(child.pose.R, child.twist)).norm() < 1e-9);
      // R X_child = T a_handle + columns q'' + bias, T = [1, -p~; 0, 1].
      Twist X = refer(-motion.p, resolve(R_P, handle.acceleration)) + motion.bias;
      for (int c = 0; c < moving.joint.coordinates; ++c)
        X += moving.accelerations()[c] * motion.columns.col(c);
      CHECK((motion.R.inverse() * X - resolve(child.pose.R, child.acceleration)).norm() < 1e-7);
    }
}

TEST_CASE("columns of a joint are what its rates add to the child's twist") {
  std::mt19937 random(2);
  for (const char* kind : kJointKinds) {
    CAPTURE(std::string(kind));
    MovingJoint moving(kind, random);
    moving.set_state(0.2);
    const JointState state = moving.state();
    std::array<double, Joint::kMost> still{};
    std::array<PrescribedMotion, Joint::kMost> driven{};
    std::copy_n(state.driven, driven.size(), driven.begin());
    for (PrescribedMotion& motion : driven) motion.rate = 0.0;
    const JointState stopped{state.q, still.data(), state.reference, driven.data()};
    JointMotion motion, same;
    Twist moves, stops;
    const Twist handle = random_twist(random);
    calc_joint_motion(moving.joint, state, Rotation{}, handle, motion, moves);
    calc_joint_motion(moving.joint, stopped, Rotation{}, handle, same, stops);
    Twist difference = Twist::Zero();
    for (int c = 0; c < moving.joint.coordinates; ++c)
      difference += state.v[c] * motion.columns.col(c);
    for (int c = 0; c < moving.joint.driven; ++c)
      difference += state.driven[c].rate * motion.columns.col(moving.joint.coordinates + c);
    CHECK((motion.R * Twist(moves - stops) - difference).norm() < 1e-13);
    CHECK((motion.columns - same.columns).norm() == 0.0);
    for (int c = moving.joint.coordinates + moving.joint.driven; c < Joint::kMost; ++c)
      CHECK(motion.columns.col(c).norm() == 0.0);
  }
}

TEST_CASE("a drive's power is its force on the child by its rate") {
  std::mt19937 random(3);
  MovingJoint moving("rp", random);
  moving.set_state(0.1);
  JointMotion motion;
  Twist twist, without;
  calc_joint_motion(moving.joint, moving.state(), Rotation{}, Twist::Zero(), motion, twist);
  const Twist F = random_twist(random);  // on the child, whose whole twist is the drives'
  CHECK(std::abs(calc_drive_power(moving.joint, moving.state(), motion, F) - F.dot(twist)) < 1e-14);
  const double first = calc_drive_force(moving.joint, motion, 0, F);
  const double second = calc_drive_force(moving.joint, motion, 1, F);
  CHECK(std::abs(first * moving.state().driven[0].rate + second * moving.state().driven[1].rate -
                 F.dot(twist)) < 1e-14);
}

TEST_CASE("behind a section that is turned against its frame, the motion is that of the frame") {
  std::mt19937 random(4);
  const VectorPolynomial turn(random);  // of the section against the frame
  const VectorPolynomial path(random), section_turn(random);
  const double t = 0.4;
  const auto section = [&](double s) { return exponential(section_turn.at(s).value); };
  const auto frame = [&](double s) -> Pose {
    return {path.at(s).value, section(s) * exponential(turn.at(s).value).inverse()};
  };
  const Motion expected = differentiate_pose(frame, t);
  const Motion of_section = differentiate_pose(
      [&](double s) -> Pose {
        return {path.at(s).value, section(s)};
      },
      t);
  JointMotion motion;
  motion.R = section(t);
  motion.p.setZero();
  Twist twist = resolve(section(t), of_section.twist);
  leave_section(calc_rotation_vector_motion(turn.at(t).value, turn.at(t).rate), motion, twist);
  CHECK((motion.R.axes - expected.pose.R.axes).norm() < 1e-14);
  CHECK((twist - resolve(expected.pose.R, expected.twist)).norm() < 1e-10);
}
