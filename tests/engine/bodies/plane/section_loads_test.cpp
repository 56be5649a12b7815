#include "engine/bodies/kernels/plane/section_loads.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/approx.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

/// A wrench at a place, both in the inertial frame: what a load does, without the kernels' help.
struct Applied {
  std::function<Twist(const Eigen::VectorXd& y)> place;
  Twist wrench;
};

/// A random state of a random rotor with loads, and what they are in it.
class LoadedRotor {
 public:
  using AddLoads = std::function<void(Rotor&)>;

  LoadedRotor(unsigned seed, const AddLoads& add_loads) : random_(seed) {
    rotor_ = make_random_rotor({2, HubSupport::free, false}, random_);
    rotor_.damping = {};
    make_context(rotor_, Formulation::structured, Rk4{1e-5}, without_);
    add_loads(rotor_);
    make_context(rotor_, Formulation::structured, Rk4{1e-5}, with_);
    randomize_state(random_, without_);
    copy_state(without_, with_);
    evaluate(kTime, without_);
    evaluate(kTime, with_);
    y_ = independent_coordinates(with_);
    v_ = independent_velocities(with_);
  }

  static constexpr double kTime = 1.0;

  const Rotor& rotor() const { return rotor_; }
  double hub_angle() const { return y_[kRotation]; }
  double hub_speed() const { return v_[kRotation]; }

  /// The section of the first blade at a distance from its root.
  SectionMotion section(double distance) const { return section_at(distance, y_); }

  /// A wrench on that section, in the inertial frame.
  Applied at(double distance, const Twist& wrench) const {
    return {[this, distance](const Eigen::VectorXd& y) {
              const auto [body, x] = body_at(distance);
              const Position drawn = Lagrangian(with_.system).drawn(y, 0, body, x);
              Twist place = section_at(distance, y).place;
              place.head<kPosition>() += drawn;
              return place;
            },
            wrench};
  }
  /// A wrench on the hub, at a point of its frame.
  Applied on_hub(const Position& p, const Twist& wrench) const {
    return {[this, p](const Eigen::VectorXd& y) {
              const Position at = plane::Rotation::from_angle(y[kRotation]) * p -
                                  Lagrangian(with_.system).drawn_centre(y);
              return Twist(y[0] + at.x(), y[1] + at.y(), y[kRotation]);
            },
            wrench};
  }

  /// Velocity of the section relative to what turns and moves with the hub.
  Position velocity_in_hub(double distance) const {
    const SectionMotion motion = section(distance);
    const Position r{motion.place[0] - y_[0], motion.place[1] - y_[1]};
    return Position(motion.rate.head<kPosition>()) - Position(v_.head<kPosition>()) -
           hub_speed() * quarter_turn(r);
  }

  /// Checks that what was added is a torque on the hub.
  void check_torque(double torque) const {
    check_forces({on_hub({0.0, 0.0}, {0.0, 0.0, torque})}, 1e-6);
  }

  /// Checks that the loads change the generalised forces by the derivatives of the work of `all`,
  /// and that their power is that of the wrenches.
  void check(const std::vector<Applied>& all, double accuracy) const {
    const Eigen::VectorXd expected = check_forces(all, accuracy);
    CHECK(load_power(with_) - load_power(without_) ==
          approx(expected.dot(v_)).epsilon(accuracy).scale(expected.lpNorm<Eigen::Infinity>()));
  }

  /// Checks the forces, and returns them.
  Eigen::VectorXd check_forces(const std::vector<Applied>& all, double accuracy) const {
    const Lagrangian lagrangian(with_.system);
    const Eigen::VectorXd found = lagrangian.mass(y_) * (independent_accelerations(with_) -
                                                         independent_accelerations(without_));
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(y_.size());
    constexpr double h = 1e-6;
    for (const Applied& applied : all)
      for (Eigen::Index k = 0; k < y_.size(); ++k) {
        const Eigen::VectorXd e = h * Eigen::VectorXd::Unit(y_.size(), k);
        expected[k] +=
            applied.wrench.dot(applied.place(y_ + e) - applied.place(y_ - e)) / (2.0 * h);
      }
    const double scale = expected.lpNorm<Eigen::Infinity>();
    REQUIRE(scale > 0.1);
    CHECK((found - expected).lpNorm<Eigen::Infinity>() < accuracy * scale);
    return expected;
  }

 private:
  /// The body of the first blade at a distance from its root, and the place on it.
  std::pair<int, double> body_at(double distance) const {
    const Blade& blade = rotor_.blades[0];
    const double length = blade.length / blade.bodies;
    const int j = std::min(static_cast<int>(distance / length), blade.bodies - 1);
    return {j, distance - j * length};
  }
  SectionMotion section_at(double distance, const Eigen::VectorXd& y) const {
    const auto [body, x] = body_at(distance);
    return Lagrangian(with_.system).section(y, v_, 0, body, x);
  }

  /// Power of the loads on blades and hub [W].
  static double load_power(const SystemContext<Plane>& context) {
    double sum = context.data.hub_solution.load.dot(context.data.hub.twist);
    for (const SubsystemData<Plane>& subsystem : context.data.subsystems)
      for (const BodyData<Plane>& body : subsystem.bodies) sum += body.terms.load_power;
    return sum;
  }

  std::mt19937 random_;
  Rotor rotor_;
  SystemContext<Plane> without_, with_;
  Eigen::VectorXd y_, v_;
};

/// From the frame of a load to the inertial one.
plane::Rotation rotation_of(LoadFrame frame, const LoadedRotor& loaded, double distance) {
  if (frame == LoadFrame::inertial) return {};
  return plane::Rotation::from_angle(
      frame == LoadFrame::hub ? loaded.hub_angle() : loaded.section(distance).place[kRotation]);
}

/// Visits the points of a load per length where it is summed, each with the length it stands for:
/// three of Gauss's in every piece.
template <class Visit>
void for_each_piece(double from, double to, Visit&& visit) {
  constexpr int kPieces = 100;
  const double length = (to - from) / kPieces, side = std::sqrt(0.15) * length;
  for (int k = 0; k < kPieces; ++k) {
    const double middle = from + (k + 0.5) * length;
    visit(middle - side, 5.0 / 18.0 * length);
    visit(middle, 8.0 / 18.0 * length);
    visit(middle + side, 5.0 / 18.0 * length);
  }
}

Twist force_only(const Position& force) { return {force.x(), force.y(), 0.0}; }

}  // namespace

TEST_CASE("point loads do the work of their force and moment where they are asked to act") {
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section})
    for (const double share : {0.0, 0.37, 0.7, 1.0}) {
      double distance = 0.0;
      const LoadedRotor loaded(5, [&](Rotor& rotor) {
        distance = share * rotor.blades[0].length;
        PointLoad load;
        load.blade = BladeChoice::number(1);
        if (share < 1.0) load.position = distance;  // else the tip
        load.frame = frame;
        load.force = {3.0, -2.0};
        load.moment = 0.7;
        rotor.loads.push_back(load);
      });
      Twist wrench = rotation_of(frame, loaded, distance) * Twist(3.0, -2.0, 0.7);
      CAPTURE(share);
      loaded.check({loaded.at(distance, wrench)}, 1e-6);
    }
}

TEST_CASE("a load per length does the work of its pieces, also of parts of elements") {
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section}) {
    double from = 0.0, to = 0.0;
    const LoadedRotor loaded(6, [&](Rotor& rotor) {
      from = 0.13 * rotor.blades[0].length;
      to = 0.71 * rotor.blades[0].length;
      DistributedLoad load;
      load.blade = BladeChoice::number(1);
      load.from = from;
      load.to = to;
      load.frame = frame;
      load.force_per_length = {0.5, 2.0};
      load.moment_per_length = 0.3;
      rotor.distributed_loads.push_back(load);
    });
    std::vector<Applied> pieces;
    for_each_piece(from, to, [&](double x, double length) {
      pieces.push_back(
          loaded.at(x, length * (rotation_of(frame, loaded, x) * Twist(0.5, 2.0, 0.3))));
    });
    loaded.check(pieces, 1e-5);
  }
}

TEST_CASE("drag is opposite to the velocity, linear and quadratic, at a point and along a blade") {
  for (const DragFrame frame : {DragFrame::inertial, DragFrame::hub})
    for (const bool is_along : {false, true}) {
      double from = 0.0, to = 0.0, position = 0.0;
      const LoadedRotor loaded(7, [&](Rotor& rotor) {
        position = 0.62 * rotor.blades[0].length;
        from = 0.2 * rotor.blades[0].length;
        to = 0.93 * rotor.blades[0].length;
        Drag drag;
        drag.blade = BladeChoice::number(1);
        drag.relative_to = frame;
        drag.position = position;
        drag.from = from;
        drag.to = to;
        (is_along ? drag.linear_per_length : drag.linear) = 0.6;
        (is_along ? drag.quadratic_per_length : drag.quadratic) = 0.8;
        rotor.drags.push_back(drag);
      });
      const auto force_at = [&](double x) {
        const Position u = frame == DragFrame::hub
                               ? loaded.velocity_in_hub(x)
                               : Position(loaded.section(x).rate.head<kPosition>());
        return force_only(-(0.6 + 0.8 * u.norm()) * u);
      };
      std::vector<Applied> pieces;
      if (is_along)
        for_each_piece(from, to, [&](double x, double length) {
          pieces.push_back(loaded.at(x, length * force_at(x)));
        });
      else
        pieces.push_back(loaded.at(position, force_at(position)));
      CAPTURE(is_along);
      // Relative to the hub u passes through 0 within elements, where |u| u has a kink.
      const double along_accuracy = frame == DragFrame::hub ? 2e-3 : 1e-4;
      loaded.check(pieces, is_along ? along_accuracy : 1e-6);
    }
}

TEST_CASE("loads on the hub do the work of their force, torque and lever") {
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub}) {
    const LoadedRotor loaded(8, [&](Rotor& rotor) {
      HubLoad load;
      load.position = {0.4, -0.2};
      load.frame = frame;
      load.force = {5.0, 3.0};
      load.torque = 1.5;
      rotor.hub_loads.push_back(load);
    });
    const Twist wrench = rotation_of(frame, loaded, 0.0) * Twist(5.0, 3.0, 1.5);
    loaded.check({loaded.on_hub({0.4, -0.2}, wrench)}, 1e-6);
  }
}

TEST_CASE("a torque by speed is that of the hub's speed, and rises over its ramp") {
  for (const double ramp : {0.0, 2.0}) {
    LoadedRotor loaded(9, [&](Rotor& rotor) {
      const double torque = calc_torque(rotor.hub.drive, LoadedRotor::kTime, 0.0);
      // The torque is the random rotor's, and a part that depends on the speed.
      rotor.hub.drive = TorqueBySpeed{Curve({-4.0, 4.0}, {torque - 8.0, torque + 8.0}), 2.0, ramp};
    });
    const double at_rest = calc_torque(loaded.rotor().hub.drive, 100.0, 0.0);
    const double torque =
        (at_rest + 2.0 * loaded.hub_speed()) * calc_rise(LoadedRotor::kTime, ramp) - at_rest;
    CHECK(calc_rise(LoadedRotor::kTime, ramp) == approx(ramp > 0.0 ? 0.5 : 1.0));
    loaded.check_torque(torque);
  }
}

TEST_CASE("the three formulations agree under every kind of load") {
  for (const bool is_driven : {false, true}) {
    std::mt19937 random(17);
    const HubSupport support = is_driven ? HubSupport::axle : HubSupport::free;
    Rotor rotor = make_random_rotor({3, support, is_driven}, random);
    add_all_loads(rotor);
    SystemContext<Plane> contexts[3];
    int next = 0;
    for (const Formulation formulation : formulations())
      make_context(rotor, formulation, Rk4{1e-5}, contexts[next++]);
    randomize_state(random, contexts[0]);
    copy_state(contexts[0], contexts[1]);
    copy_state(contexts[0], contexts[2]);
    const Evaluation first = evaluate(0.8, contexts[0]);
    for (int k = 1; k < 3; ++k) {
      const Evaluation other = evaluate(0.8, contexts[k]);
      const auto differ = [](const auto& a, const auto& b) {
        return (a - b).norm() / std::max(1.0, b.norm());
      };
      CHECK(differ(first.accelerations, other.accelerations) < 1e-8);
      CHECK(differ(first.wrenches, other.wrenches) < 1e-8);
      CHECK(differ(first.hub_reaction, other.hub_reaction) < 1e-8);
    }
  }
}
