#include "tests/engine/lagrangian.h"

#include <array>
#include <cmath>

#include "tests/engine/rotors.h"

namespace spoke::test {
namespace {

/// A number and its rate: forward differentiation in time.
struct Dual {
  double value = 0.0;
  double rate = 0.0;
  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.rate + b.rate}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.rate - b.rate}; }
  friend Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.value * b.rate + a.rate * b.value};
  }
};
Dual constant(double value) { return {value, 0.0}; }
Dual sine(Dual a) { return {std::sin(a.value), std::cos(a.value) * a.rate}; }
Dual cosine(Dual a) { return {std::cos(a.value), -std::sin(a.value) * a.rate}; }

/// A frame in motion.
struct Frame {
  Dual x, y, angle;

  /// Place of a point given in the frame.
  std::array<Dual, 2> point(Dual px, Dual py) const {
    const Dual c = cosine(angle), s = sine(angle);
    return {x + c * px - s * py, y + s * px + c * py};
  }
};

/// Values of the element's shape functions at 0 <= xi <= 1.
struct Shape {
  std::array<double, 2> u;
  std::array<double, 4> v;
  std::array<double, 4> slope;
  std::array<double, 4> curvature;
};
Shape shape_at(double xi, double l) {
  const double x2 = xi * xi, x3 = x2 * xi;
  return {{1 - xi, xi},
          {1 - 3 * x2 + 2 * x3, l * (xi - 2 * x2 + x3), 3 * x2 - 2 * x3, l * (x3 - x2)},
          {(-6 * xi + 6 * x2) / l, 1 - 4 * xi + 3 * x2, (6 * xi - 6 * x2) / l, 3 * x2 - 2 * xi},
          {(-6 + 12 * xi) / (l * l), (-4 + 6 * xi) / l, (6 - 12 * xi) / (l * l), (6 * xi - 2) / l}};
}

constexpr std::array<double, 5> kGaussPoints{-0.9061798459386640, -0.5384693101056831, 0.0,
                                             0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kGaussWeights{0.2369268850561891, 0.4786286704993665,
                                              0.5688888888888889, 0.4786286704993665,
                                              0.2369268850561891};

/// Coordinates of one body with their rates; those the frame fixes are zero.
class BodyCoordinates {
 public:
  BodyCoordinates(const FlexibleBody& body, const double* q, const double* v)
      : body_(body), q_(q), v_(v) {}
  Dual at(int node, int component) const {
    const int index = body_.coordinate(node, component);
    return index < 0 ? Dual{} : Dual{q_[index], v_ ? v_[index] : 0.0};
  }

 private:
  const FlexibleBody& body_;
  const double* q_;
  const double* v_;
};

/// Calls visit(blade, body, frame, coordinates) for every body, with its frame in motion.
template <class Visit>
void for_each_body(const System& system, const Eigen::VectorXd& y, const double* v, Visit&& visit) {
  const auto hub = [&](int c) { return Dual{y[c], v ? v[c] : 0.0}; };
  const Frame hub_frame{hub(0), hub(1), hub(2)};
  Eigen::Index next = kTwist;
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const Pose& root = system.subsystems[i].root;
    const auto [x0, y0] = hub_frame.point(constant(root.p.x()), constant(root.p.y()));
    const double azimuth = std::atan2(root.R.sine, root.R.cosine);
    Frame bracket{x0, y0, hub_frame.angle + constant(azimuth)};
    for (std::size_t j = 0; j < system.subsystems[i].bodies.size(); ++j) {
      const FlexibleBody& body = *system.subsystems[i].bodies[j].body;
      const BodyCoordinates q(body, y.data() + next, v ? v + next : nullptr);
      const Frame frame{bracket.x, bracket.y, bracket.angle - q.at(0, 2)};
      visit(static_cast<int>(i), static_cast<int>(j), frame, q);
      const auto [x, y_end] =
          frame.point(constant(body.length) + q.at(body.elements, 0), q.at(body.elements, 1));
      bracket = {x, y_end, frame.angle + q.at(body.elements, 2)};
      next += body.coordinates();
    }
  }
}

/// Displacements u, v and rotation v' at `xi`, 0 to 1 within element `e` of length `l`.
struct Displacement {
  Dual u, v, slope;
};
Displacement displacement_at(const BodyCoordinates& q, int e, double xi, double l) {
  const Shape N = shape_at(xi, l);
  Displacement d;
  for (int side = 0; side < 2; ++side) {
    d.u = d.u + constant(N.u[side]) * q.at(e + side, 0);
    for (int k = 0; k < 2; ++k) {
      d.v = d.v + constant(N.v[2 * side + k]) * q.at(e + side, 1 + k);
      d.slope = d.slope + constant(N.slope[2 * side + k]) * q.at(e + side, 1 + k);
    }
  }
  return d;
}

/// Calls visit(x, weight, u, v, slope) at the quadrature points of a body.
template <class Visit>
void for_each_point(const FlexibleBody& body, const BodyCoordinates& q, Visit&& visit) {
  const double l = body.length / body.elements;
  for (int e = 0; e < body.elements; ++e)
    for (std::size_t g = 0; g < kGaussPoints.size(); ++g) {
      const double xi = 0.5 * (1.0 + kGaussPoints[g]);
      const auto [u, v, slope] = displacement_at(q, e, xi, l);
      visit((e + xi) * l, 0.5 * kGaussWeights[g] * l, u, v, slope);
    }
}

double mass_per_length(const FlexibleBody& body) { return body.mass / body.length; }

/// Distance of a body's undeformed frame from the hub axis.
double undeformed_distance(const Subsystem& subsystem, int body) {
  double r = std::hypot(subsystem.root.p.x(), subsystem.root.p.y());
  for (int j = 0; j < body; ++j) r += subsystem.bodies[j].body->length;
  return r;
}

/// Tension of the undeformed blade at unit hub speed, at x of a body: int rhoA r dr outboard of x.
double unit_tension(const Subsystem& subsystem, int body, double x) {
  const double r = undeformed_distance(subsystem, body);
  const double end = r + subsystem.bodies[body].body->length;
  double tension =
      mass_per_length(*subsystem.bodies[body].body) * (end * end - (r + x) * (r + x)) / 2.0;
  for (std::size_t j = body + 1; j < subsystem.bodies.size(); ++j) {
    const double a = undeformed_distance(subsystem, static_cast<int>(j));
    const double b = a + subsystem.bodies[j].body->length;
    tension += mass_per_length(*subsystem.bodies[j].body) * (b * b - a * a) / 2.0;
  }
  return tension;
}

Eigen::VectorXd gather(const StepContext& context, double* CoordinateBlock::*member) {
  const StepData& data = context.data;
  Eigen::VectorXd all(kTwist + context.system.deformation_count());
  for (int c = 0; c < kTwist; ++c) all[c] = (data.hub_coordinates.*member)[c];
  Eigen::Index next = kTwist;
  for (const SubsystemData& subsystem : data.subsystems)
    for (const BodyData& body : subsystem.bodies) {
      const Eigen::VectorXd part = unpadded(body.coordinates.*member, body.layout);
      all.segment(next, part.size()) = part;
      next += part.size();
    }
  return all;
}

}  // namespace

double Lagrangian::kinetic_energy(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  const Hub& hub = system_.hub;
  double energy = 0.5 * hub.mass * (v[0] * v[0] + v[1] * v[1]) + 0.5 * hub.inertia * v[2] * v[2];
  for_each_body(
      system_, y, v.data(), [&](int i, int j, const Frame& frame, const BodyCoordinates& q) {
        const ChainBody& member = system_.subsystems[i].bodies[j];
        const double rhoA = mass_per_length(*member.body);
        for_each_point(*member.body, q, [&](double x, double weight, Dual u, Dual w, Dual slope) {
          const auto [px, py] = frame.point(constant(x) + u, w);
          energy += 0.5 * weight * rhoA * (px.rate * px.rate + py.rate * py.rate);
          if (member.centrifugal_stiffness)
            energy -= 0.5 * v[2] * v[2] * weight * unit_tension(system_.subsystems[i], j, x) *
                      slope.value * slope.value;
        });
      });
  return energy;
}

double Lagrangian::potential_energy(const Eigen::VectorXd& y) const {
  const Position& g = system_.gravity;
  double energy = -system_.hub.mass * (g.x() * y[0] + g.y() * y[1]);
  Eigen::Index next = kTwist;
  for_each_body(
      system_, y, nullptr, [&](int i, int j, const Frame& frame, const BodyCoordinates& q) {
        const FlexibleBody& body = *system_.subsystems[i].bodies[j].body;
        for_each_point(body, q, [&](double x, double weight, Dual u, Dual w, Dual) {
          const auto [px, py] = frame.point(constant(x) + u, w);
          energy -= weight * mass_per_length(body) * (g.x() * px.value + g.y() * py.value);
        });
        // The elastic stiffness itself is checked against the beam's analytic solutions elsewhere.
        const Eigen::VectorXd q_u = y.segment(next, body.axial());
        const Eigen::VectorXd q_v = y.segment(next + body.axial(), body.bending());
        energy += 0.5 * q_u.dot(body.K_axial.to_dense() * q_u) +
                  0.5 * q_v.dot(body.K_bending.to_dense() * q_v);
        next += body.coordinates();
      });
  return energy;
}

Eigen::VectorXd Lagrangian::momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  Eigen::VectorXd p(size());
  for (int i = 0; i < size(); ++i) {
    Eigen::VectorXd plus = v, minus = v;
    plus[i] += 1.0;
    minus[i] -= 1.0;
    p[i] = 0.5 * (kinetic_energy(y, plus) - kinetic_energy(y, minus));
  }
  return p;
}

Eigen::MatrixXd Lagrangian::mass(const Eigen::VectorXd& y) const {
  Eigen::MatrixXd M(size(), size());
  for (int i = 0; i < size(); ++i) M.col(i) = momenta(y, Eigen::VectorXd::Unit(size(), i));
  return M;
}

Eigen::VectorXd Lagrangian::residual(const Eigen::VectorXd& y, const Eigen::VectorXd& v,
                                     const Eigen::VectorXd& a) const {
  constexpr double h = 1e-4;
  // Fourth-order central differences.
  const auto derivative = [&](auto&& f) {
    return (8.0 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12.0 * h);
  };
  Eigen::VectorXd r(size());
  const Eigen::VectorXd p_rate =
      (8.0 * (momenta(y + h * v, v + h * a) - momenta(y - h * v, v - h * a)) -
       (momenta(y + 2 * h * v, v + 2 * h * a) - momenta(y - 2 * h * v, v - 2 * h * a))) /
      (12.0 * h);
  for (int i = 0; i < size(); ++i) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(size(), i);
    r[i] = p_rate[i] - derivative([&](double s) { return kinetic_energy(y + s * e, v); }) +
           derivative([&](double s) { return potential_energy(y + s * e); });
  }
  return r;
}

SectionMotion Lagrangian::section(const Eigen::VectorXd& y, const Eigen::VectorXd& v, int blade,
                                  int body, double x) const {
  SectionMotion found;
  for_each_body(system_, y, v.data(),
                [&](int i, int j, const Frame& frame, const BodyCoordinates& q) {
                  if (i != blade || j != body) return;
                  const FlexibleBody& model = *system_.subsystems[i].bodies[j].body;
                  const double l = model.length / model.elements;
                  const int e = std::min(static_cast<int>(x / l), model.elements - 1);
                  const auto [u, w, slope] = displacement_at(q, e, x / l - e, l);
                  const auto [px, py] = frame.point(constant(x) + u, w);
                  const Dual angle = frame.angle + slope;
                  found = {{px.value, py.value, angle.value}, {px.rate, py.rate, angle.rate}};
                });
  return found;
}

Eigen::VectorXd independent_coordinates(const StepContext& context) {
  return gather(context, &CoordinateBlock::q);
}
Eigen::VectorXd independent_velocities(const StepContext& context) {
  return gather(context, &CoordinateBlock::v);
}
Eigen::VectorXd independent_accelerations(const StepContext& context) {
  return gather(context, &CoordinateBlock::a);
}

}  // namespace spoke::test
