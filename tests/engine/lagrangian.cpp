#include "tests/engine/lagrangian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

  /// Returns the place of a point given in the frame.
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
  BodyCoordinates(const plane::FlexibleBody& body, const double* q, const double* v)
      : body_(body), q_(q), v_(v) {}
  Dual at(int node, int component) const {
    const int index = body_.coordinate(node, component);
    return index < 0 ? Dual{} : Dual{q_[index], v_ ? v_[index] : 0.0};
  }

 private:
  const plane::FlexibleBody& body_;
  const double* q_;
  const double* v_;
};

/// Calls visit(blade, body, frame, coordinates) for every body, with its frame in motion.
template <class Visit>
void for_each_body(const System<Plane>& system, const Eigen::VectorXd& y, const double* v,
                   Visit&& visit) {
  const auto hub = [&](int c) { return Dual{y[c], v ? v[c] : 0.0}; };
  const Frame hub_frame{hub(0), hub(1), hub(2)};
  Eigen::Index next = kTwist;
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const plane::Pose& root = system.subsystems[i].root;
    const auto [x0, y0] = hub_frame.point(constant(root.p.x()), constant(root.p.y()));
    const double azimuth = std::atan2(root.R.sine, root.R.cosine);
    Frame bracket{x0, y0, hub_frame.angle + constant(azimuth)};
    for (std::size_t j = 0; j < system.subsystems[i].bodies.size(); ++j) {
      const plane::FlexibleBody& body = *system.subsystems[i].bodies[j].body;
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

/// A place on a body: displacements of its section there.
struct Point {
  double x;
  Dual u, v, slope;
};

Point point_at(const plane::FlexibleBody& body, const BodyCoordinates& q, double x) {
  const double l = body.length / body.elements;
  const int e = std::min(static_cast<int>(x / l), body.elements - 1);
  const Shape N = shape_at(x / l - e, l);
  Point point{x, {}, {}, {}};
  for (int side = 0; side < 2; ++side) {
    point.u = point.u + constant(N.u[side]) * q.at(e + side, 0);
    for (int k = 0; k < 2; ++k) {
      point.v = point.v + constant(N.v[2 * side + k]) * q.at(e + side, 1 + k);
      point.slope = point.slope + constant(N.slope[2 * side + k]) * q.at(e + side, 1 + k);
    }
  }
  return point;
}

/// Masses along a blade, in the coordinate x of a body that begins at `origin`.
struct Matter {
  const plane::FlexibleBody& body;
  const Blade* blade;  ///< null: uniform
  double origin;

  double mass_per_length(double x) const {
    if (!blade) return body.mass / body.length;
    const BladeSections& sections = blade->sections;
    if (sections.station.empty()) return blade->density * blade->area;
    std::size_t k = 1;
    while (k + 1 < sections.station.size() && sections.station[k] < origin + x) ++k;
    const double part =
        (origin + x - sections.station[k - 1]) / (sections.station[k] - sections.station[k - 1]);
    return (1.0 - part) * sections.mass_per_length[k - 1] + part * sections.mass_per_length[k];
  }
  /// Returns places from `from` to the end between which no property has a corner: nodes, stations,
  /// point masses.
  std::vector<double> corners(double from) const {
    std::vector<double> all{from, body.length};
    for (int e = 1; e < body.elements; ++e) all.push_back(e * body.length / body.elements);
    if (blade) {
      for (const double station : blade->sections.station) all.push_back(station - origin);
      for (const PointMass& point : blade->point_masses) all.push_back(point.position - origin);
    }
    std::erase_if(all, [&](double x) { return x < from || x > body.length; });
    std::sort(all.begin(), all.end());
    return all;
  }
  /// Calls visit(x, weight) at five Gauss points of each stretch from `from` to the end.
  template <class Visit>
  void for_each_point(double from, const Visit& visit) const {
    const std::vector<double> places = corners(from);
    for (std::size_t k = 1; k < places.size(); ++k)
      for (std::size_t g = 0; g < kGaussPoints.size(); ++g) {
        const double half = 0.5 * (places[k] - places[k - 1]);
        if (half > 0.0)
          visit(places[k - 1] + half * (1.0 + kGaussPoints[g]), half * kGaussWeights[g]);
      }
  }
  /// Calls visit(x, point mass) for the point masses of this body beyond `from`.
  template <class Visit>
  void for_each_mass(double from, const Visit& visit) const {
    if (!blade) return;
    for (const PointMass& point : blade->point_masses) {
      const double x = point.position - origin;
      const bool is_here = (x > 1e-9 || origin == 0.0) && x < body.length + 1e-9;
      if (is_here && x >= from) visit(std::min(x, body.length), point);
    }
  }
};

Matter matter_of(const Subsystem<Plane>& subsystem, std::size_t body, const Blade* blade) {
  double origin = 0.0;
  for (std::size_t j = 0; j < body; ++j) origin += subsystem.bodies[j].body->length;
  return {*subsystem.bodies[body].body, blade, origin};
}

/// Calls visit(i, j, x, mass) for all matter of the bodies of a system.
template <class Visit>
void for_each_mass(const System<Plane>& system, std::span<const Blade> blades, const Visit& visit) {
  for (std::size_t i = 0; i < system.subsystems.size(); ++i)
    for (std::size_t j = 0; j < system.subsystems[i].bodies.size(); ++j) {
      const Matter matter =
          matter_of(system.subsystems[i], j, blades.empty() ? nullptr : &blades[i]);
      const auto at = [&](double x, double mass) {
        visit(static_cast<int>(i), static_cast<int>(j), x, mass);
      };
      matter.for_each_point(
          0.0, [&](double x, double weight) { at(x, weight * matter.mass_per_length(x)); });
      matter.for_each_mass(0.0, [&](double x, const PointMass& point) { at(x, point.mass); });
    }
}

/// Returns the point about which the undeformed system turns, in the hub frame: the hub, or the
/// mass centre of a system that flies.
Position centre_of_rotation(const System<Plane>& system, std::span<const Blade> blades) {
  if (system.hub.support == HubSupport::axle) return Position::Zero();
  double mass = system.hub.mass;
  Position moment = Position::Zero();
  for_each_mass(system, blades, [&](int i, int j, double x, double m) {
    const Subsystem<Plane>& subsystem = system.subsystems[static_cast<std::size_t>(i)];
    for (int k = 0; k < j; ++k) x += subsystem.bodies[static_cast<std::size_t>(k)].body->length;
    mass += m;
    moment += m * (subsystem.root.p + subsystem.root.R * Position{x, 0.0});
  });
  return moment / mass;
}

/// Returns the tension of the undeformed blade at unit hub speed, at x of a body: int rhoA r dr
/// outboard of x, with r from the centre of rotation along the blade.
double unit_tension(const Subsystem<Plane>& subsystem, const Blade* blade, std::size_t body,
                    double x, const Position& centre) {
  const Position along = subsystem.root.R * Position{1.0, 0.0};
  const double radius = std::hypot(subsystem.root.p.x(), subsystem.root.p.y()) - along.dot(centre);
  double tension = 0.0;
  for (std::size_t j = body; j < subsystem.bodies.size(); ++j) {
    const Matter matter = matter_of(subsystem, j, blade);
    const double from = j == body ? x : 0.0, r = radius + matter.origin;
    matter.for_each_point(from, [&](double at, double weight) {
      tension += weight * matter.mass_per_length(at) * (r + at);
    });
    matter.for_each_mass(
        from, [&](double at, const PointMass& point) { tension += point.mass * (r + at); });
  }
  return tension;
}

Eigen::VectorXd gather(const SystemContext<Plane>& context, double* CoordinateBlock::*member) {
  const StepData<Plane>& data = context.data;
  Eigen::VectorXd all(kTwist + context.system.deformation_count());
  for (int c = 0; c < kTwist; ++c) all[c] = (data.hub_coordinates.*member)[c];
  Eigen::Index next = kTwist;
  for (const SubsystemData<Plane>& subsystem : data.subsystems)
    for (const BodyData<Plane>& body : subsystem.bodies) {
      const Eigen::VectorXd part = unpadded(body.coordinates.*member, body.layout);
      all.segment(next, part.size()) = part;
      next += part.size();
    }
  return all;
}

/// The elastic stiffness itself is checked against the beam's analytic solutions elsewhere.
double elastic_energy(const plane::FlexibleBody& body, const Eigen::VectorXd& q) {
  if (body.is_nonlinear()) {
    const plane::FlexLayout layout = plane::make_layout(body);
    std::vector<double> flex(static_cast<std::size_t>(layout.size()), 0.0);
    for (int i = 0; i < body.coordinates(); ++i)
      flex[static_cast<std::size_t>(layout.offset(i))] = q[i];
    return plane::calc_nonlinear_energy(body, layout, flex.data());
  }
  const Eigen::VectorXd u = q.head(body.axial()), v = q.tail(body.bending());
  return 0.5 * (u.dot(body.K_axial.to_dense() * u) + v.dot(body.K_bending.to_dense() * v));
}

}  // namespace

double Lagrangian::kinetic_energy(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  const Hub& hub = system_.hub;
  const Position centre = centre_of_rotation(system_, blades_);
  double energy = 0.5 * hub.mass * (v[0] * v[0] + v[1] * v[1]) + 0.5 * hub.inertia * v[2] * v[2];
  for_each_body(
      system_, y, v.data(), [&](int i, int j, const Frame& frame, const BodyCoordinates& q) {
        const Subsystem<Plane>& subsystem = system_.subsystems[i];
        const TreeBody<Plane>& member = subsystem.bodies[j];
        const Blade* blade = blades_.empty() ? nullptr : &blades_[i];
        const Matter matter = matter_of(subsystem, static_cast<std::size_t>(j), blade);
        const auto of_particle = [&](const Point& at, double side) {
          // The mass is beside the axis by `side`; the section carries it as far as linear in its
          // rotation.
          const auto [px, py] =
              frame.point(constant(at.x) + at.u - constant(side) * at.slope, at.v + constant(side));
          return 0.5 * (px.rate * px.rate + py.rate * py.rate);
        };
        const auto of_stiffening = [&](double per_slope, const Point& at) {
          return member.stiffening.centrifugal
                     ? 0.5 * v[2] * v[2] * per_slope * at.slope.value * at.slope.value
                     : 0.0;
        };
        matter.for_each_point(0.0, [&](double x, double weight) {
          const Point at = point_at(*member.body, q, x);
          energy += weight * matter.mass_per_length(x) * of_particle(at, 0.0);
          energy -= of_stiffening(
              weight * unit_tension(subsystem, blade, static_cast<std::size_t>(j), x, centre), at);
        });
        // Two halves on either side of the axis have the inertia; turned by psi, each goes towards
        // the axis by side psi^2 / 2.
        matter.for_each_mass(0.0, [&](double x, const PointMass& point) {
          const Point at = point_at(*member.body, q, x);
          const double side = std::sqrt(point.inertia / point.mass);
          energy += 0.5 * point.mass * (of_particle(at, side) + of_particle(at, -side));
          energy -= of_stiffening(point.inertia, at);
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
        const plane::FlexibleBody& body = *system_.subsystems[i].bodies[j].body;
        const Matter matter = matter_of(system_.subsystems[i], static_cast<std::size_t>(j),
                                        blades_.empty() ? nullptr : &blades_[i]);
        const auto of_gravity = [&](double mass, double x) {
          const Point at = point_at(body, q, x);
          const auto [px, py] = frame.point(constant(x) + at.u, at.v);
          energy -= mass * (g.x() * px.value + g.y() * py.value);
          // These sum up to zero where the hub flies.
          if (system_.hub.support == HubSupport::axle)
            energy -= mass * g.dot(drawn_on_hub(y, i, j, x));
        };
        matter.for_each_point(0.0, [&](double x, double weight) {
          of_gravity(weight * matter.mass_per_length(x), x);
        });
        matter.for_each_mass(0.0,
                             [&](double x, const PointMass& point) { of_gravity(point.mass, x); });
        energy += elastic_energy(body, y.segment(next, body.coordinates()));
        next += body.coordinates();
      });
  return energy;
}

double Lagrangian::momentum(const Eigen::VectorXd& y, const Eigen::VectorXd& v, int i) const {
  Eigen::VectorXd plus = v, minus = v;
  plus[i] += 1.0;
  minus[i] -= 1.0;
  return 0.5 * (kinetic_energy(y, plus) - kinetic_energy(y, minus));
}

Eigen::VectorXd Lagrangian::momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  Eigen::VectorXd p(size());
  for (int i = 0; i < size(); ++i) p[i] = momentum(y, v, i);
  return p;
}

Twist Lagrangian::hub_momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  return {momentum(y, v, 0), momentum(y, v, 1), momentum(y, v, 2)};
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
                  const Point at = point_at(*system_.subsystems[i].bodies[j].body, q, x);
                  const auto [px, py] = frame.point(constant(x) + at.u, at.v);
                  const Dual angle = frame.angle + at.slope;
                  found = {{px.value, py.value, angle.value}, {px.rate, py.rate, angle.rate}};
                });
  return found;
}

Position Lagrangian::drawn_on_hub(const Eigen::VectorXd& y, int blade, int body, double x) const {
  double length = 0.0;
  for_each_body(system_, y, nullptr, [&](int i, int j, const Frame&, const BodyCoordinates& q) {
    const TreeBody<Plane>& member =
        system_.subsystems[static_cast<std::size_t>(i)].bodies[static_cast<std::size_t>(j)];
    if (i != blade || j > body || !member.stiffening) return;
    const double end = j < body ? member.body->length : x;
    const double l = member.body->length / member.body->elements;
    for (int e = 0; e < member.body->elements && e * l < end; ++e) {
      const double half = 0.5 * (std::min(end, (e + 1) * l) - e * l);
      for (std::size_t g = 0; g < kGaussPoints.size(); ++g) {
        const Point at = point_at(*member.body, q, e * l + half * (1.0 + kGaussPoints[g]));
        length += 0.5 * half * kGaussWeights[g] * at.slope.value * at.slope.value;
      }
    }
  });
  const plane::Rotation R = plane::Rotation::from_angle(y[2]) *
                            system_.subsystems[static_cast<std::size_t>(blade)].root.R;
  return R * Position{-length, 0.0};
}

Position Lagrangian::drawn_centre(const Eigen::VectorXd& y) const {
  Position sum = Position::Zero();
  if (system_.hub.support == HubSupport::axle) return sum;
  double mass = system_.hub.mass;
  for_each_mass(system_, blades_, [&](int i, int j, double x, double m) {
    sum += m * drawn_on_hub(y, i, j, x);
    mass += m;
  });
  return sum / mass;
}

Position Lagrangian::drawn(const Eigen::VectorXd& y, int blade, int body, double x) const {
  return drawn_on_hub(y, blade, body, x) - drawn_centre(y);
}

Eigen::VectorXd independent_coordinates(const SystemContext<Plane>& context) {
  return gather(context, &CoordinateBlock::q);
}
Eigen::VectorXd independent_velocities(const SystemContext<Plane>& context) {
  return gather(context, &CoordinateBlock::v);
}
Eigen::VectorXd independent_accelerations(const SystemContext<Plane>& context) {
  return gather(context, &CoordinateBlock::a);
}

}  // namespace spoke::test
