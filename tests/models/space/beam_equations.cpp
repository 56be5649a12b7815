#include "tests/models/space/beam_equations.h"

#include <Eigen/Dense>
#include <cmath>

namespace spoke::space::test {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Visits steps between breaks; sections are taken within a step, so that the next piece is not
/// met.
template <class Visit>
void visit_steps(const Beam& beam, int steps, Visit&& visit) {
  const double first = beam.station.front(), last = beam.station.back();
  const std::vector<double> breaks = beam.breaks(first, last);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double width = breaks[k + 1] - breaks[k];
    const int n = std::max(4, static_cast<int>(std::ceil(steps * width / (last - first))));
    for (int i = 0; i < n; ++i) visit(breaks[k] + i * width / n, width / n);
  }
}

/// Returns a place within a step; its end belongs to it, not to the next one.
double within(double x, double width, double part) {
  return x + width * (part == 0.0 ? 1e-13 : part == 1.0 ? 1.0 - 1e-13 : part);
}

}  // namespace

MassMoments integrate_mass(const Beam& beam, const Pose& frame) {
  MassMoments sum;
  const auto add = [&](double x, double ds, const MassMoments& mass) {
    const SectionAt at = beam.geometry(x);
    const Position p = frame.R.inverse() * Position(at.p - frame.p);
    const Matrix3 R = (frame.R.inverse() * at.axes).axes;
    const Position S = R * mass.first;
    sum.mass += ds * mass.mass;
    sum.first += ds * (mass.mass * p + S);
    sum.second += ds * (R * mass.second * R.transpose() + p * S.transpose() + S * p.transpose() +
                        mass.mass * p * p.transpose());
  };
  visit_steps(beam, 2000, [&](double x, double width) {
    for (const auto& [part, weight] : {std::pair{0.0, 1.0}, {0.5, 4.0}, {1.0, 1.0}}) {
      const double at = within(x, width, part);
      add(at, weight / 6.0 * width * beam.geometry(at).tangent.norm(), beam.section(at).mass);
    }
  });
  for (const PointMass& point : beam.masses) add(point.station, 1.0, point.moments);
  return sum;
}

Twist solve_statics(const Beam& beam, const Pose& frame, const Twist& wrench) {
  // All in the beam's frame. F is constant; u' = gamma + th x p', th' = kappa.
  const Position F = frame.R * Position(linear(wrench)),
                 M_tip = frame.R * Position(angular(wrench));
  const Position tip = beam.curve.at(beam.station.back());
  const auto rate = [&](double x, const Position& th) {
    const SectionAt at = beam.geometry(x);
    const Rotation to_section = at.axes.inverse();
    const Twist resultants =
        make_twist(to_section * F, to_section * Position(M_tip + cross(tip - at.p, F)));
    const Twist strains = at.axes * Twist(beam.section(x).compliance * resultants);
    const double ds = at.tangent.norm();
    return make_twist(ds * linear(strains) + cross(th, at.tangent), ds * angular(strains));
  };
  Twist y = Twist::Zero();
  visit_steps(beam, 1000, [&](double x, double h) {
    const Twist a = rate(within(x, h, 0.0), angular(y));
    const Twist b = rate(x + 0.5 * h, angular(y) + 0.5 * h * angular(a));
    const Twist c = rate(x + 0.5 * h, angular(y) + 0.5 * h * angular(b));
    const Twist d = rate(within(x, h, 1.0), angular(y) + h * angular(c));
    y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  });
  return frame.R.inverse() * y;
}

BeamEquations::BeamEquations(const Beam& beam, int steps) {
  visit_steps(beam, steps, [&](double x, double width) {
    widths_.push_back(width);
    for (const double part : {0.0, 0.5, 1.0}) {
      const double at = within(x, width, part);
      points_.push_back({beam.geometry(at), beam.section(at)});
    }
  });
}

BeamEquations::State BeamEquations::derivative(const Point& point, double squared_frequency,
                                               const State& state) const {
  const Matrix3& R = point.at.axes.axes;
  const double ds = point.at.tangent.norm();
  const Matrix3 normal = skew(R.col(0));
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R;
  const MassMoments& mass = point.section.mass;
  const Matrix3 J = R * mass.second * R.transpose(), S = skew(R * mass.first);
  const Matrix3 Theta = J.trace() * Matrix3::Identity() - J;
  const auto u = state.topRows<3>(), th = state.middleRows<3>(3);
  State rate;
  rate.topRows<6>() = turn * point.section.compliance * turn.transpose() * state.bottomRows<6>();
  rate.topRows<3>() -= normal * th;
  rate.middleRows<3>(6) = -squared_frequency * (mass.mass * u - S * th);
  rate.bottomRows<3>() =
      -normal * state.middleRows<3>(6) - squared_frequency * (S * u + Theta * th);
  return ds * rate;
}

double BeamEquations::determinant(double frequency) const {
  const double ww = frequency * frequency;
  State y = State::Zero();
  y.bottomRows<6>().setIdentity();
  for (std::size_t i = 0; i < widths_.size(); ++i) {
    const Point* point = &points_[3 * i];
    const double h = widths_[i];
    const State a = derivative(point[0], ww, y);
    const State b = derivative(point[1], ww, y + 0.5 * h * a);
    const State c = derivative(point[1], ww, y + 0.5 * h * b);
    const State d = derivative(point[2], ww, y + h * c);
    y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return Matrix6(y.bottomRows<6>()).determinant();
}

double BeamEquations::find_frequency(double guess) const {
  // The secant method finds the zero of a smooth function.
  double x = guess, before = 1.001 * guess;
  double f = determinant(x), f_before = determinant(before);
  for (int i = 0; i < 20 && std::abs(x - before) > 1e-10 * guess; ++i) {
    const double next = x - f * (x - before) / (f - f_before);
    before = x;
    f_before = f;
    x = next;
    f = determinant(x);
  }
  return x;
}

}  // namespace spoke::space::test
