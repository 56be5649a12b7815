// Integrals of the shape functions over an element (docs/formulation.md, section 2), assembled into
// a body.

#include "models/plane/beam_elements.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spoke::plane {
namespace {

using Vector4 = Eigen::Vector4d;

// Indices of the axial and of the bending coordinates among the six of an element.
constexpr std::array<int, 2> kAxial{0, 3};
constexpr std::array<int, 4> kBending{1, 2, 4, 5};

/// Places and weights of Gauss's rule of four points, in pairs; by the closed form, an ulp off
/// GaussRule<4> in two numbers, so that states keep the bits that they have had.
const std::array<std::array<double, 2>, 4> kGauss = [] {
  const double a = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double b = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double weight_a = (18.0 + std::sqrt(30.0)) / 72.0;
  const double weight_b = (18.0 - std::sqrt(30.0)) / 72.0;
  return std::array<std::array<double, 2>, 4>{{{(1 - b) / 2, weight_b},
                                               {(1 - a) / 2, weight_a},
                                               {(1 + a) / 2, weight_a},
                                               {(1 + b) / 2, weight_b}}};
}();

/// Adds an element's bending matrix to the band, without the coordinates fixed by the frame.
void add_bending(const FlexibleBody& body, int element, const Eigen::Matrix4d& matrix,
                 SymmetricBand<3>& band) {
  const int first = body.axial();
  const std::array<int, 4> at{body.coordinate(element, 1), body.coordinate(element, 2),
                              body.coordinate(element + 1, 1), body.coordinate(element + 1, 2)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j <= i; ++j)
      if (at[i] >= 0 && at[j] >= 0) band.add(at[i] - first, at[j] - first, matrix(i, j));
}

void add_axial(const FlexibleBody& body, int element, const Eigen::Matrix2d& matrix,
               SymmetricBand<1>& band) {
  const std::array<int, 2> at{body.coordinate(element, 0), body.coordinate(element + 1, 0)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j <= i; ++j)
      if (at[i] >= 0 && at[j] >= 0) band.add(at[i], at[j], matrix(i, j));
}

Eigen::Matrix4d bending_mass(double l) {
  Eigen::Matrix4d m;
  m << 156.0, 22.0 * l, 54.0, -13.0 * l,              //
      22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l,  //
      54.0, 13.0 * l, 156.0, -22.0 * l,               //
      -13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l;
  return m * (l / 420.0);
}

Eigen::Matrix4d bending_stiffness(double l) {
  Eigen::Matrix4d k;
  k << 12.0, 6.0 * l, -12.0, 6.0 * l,               //
      6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l,  //
      -12.0, -6.0 * l, 12.0, -6.0 * l,              //
      6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l;
  return k / (l * l * l);
}

Eigen::Matrix2d axial_mass(double l) {
  return (Eigen::Matrix2d() << 2, 1, 1, 2).finished() * (l / 6.0);
}

Eigen::Matrix2d axial_stiffness(double l) {
  return (Eigen::Matrix2d() << 1, -1, -1, 1).finished() / l;
}

/// int_0^1 of the Hermite functions (v1, psi1, v2, psi2) times l.
Vector4 bending_area(double l) { return Vector4{0.5, l / 12.0, 0.5, -l / 12.0} * l; }

/// int_0^1 xi of the Hermite functions times l: also row 2 of the coupling with N_u = (1-xi, xi).
Vector4 bending_moment(double l) { return Vector4{3.0 / 20, l / 30, 7.0 / 20, -l / 20} * l; }

/// Derivatives of the Hermite functions with respect to x at xi = x/l.
Vector4 bending_slope(double xi, double l) {
  return {(-6.0 * xi + 6.0 * xi * xi) / l, 1.0 - 4.0 * xi + 3.0 * xi * xi,
          (6.0 * xi - 6.0 * xi * xi) / l, 3.0 * xi * xi - 2.0 * xi};
}

/// Returns the Hermite functions at xi = x/l.
Vector4 bending_shape(double xi, double l) {
  return {1.0 - xi * xi * (3.0 - 2.0 * xi), l * xi * (1.0 - xi * (2.0 - xi)),
          xi * xi * (3.0 - 2.0 * xi), l * xi * xi * (xi - 1.0)};
}

/// Returns the Hermite functions' second derivatives with respect to x.
Vector4 bending_curvature(double xi, double l) {
  return {(12.0 * xi - 6.0) / (l * l), (6.0 * xi - 4.0) / l, (6.0 - 12.0 * xi) / (l * l),
          (6.0 * xi - 2.0) / l};
}

/// Rows of H: `inner` belongs to N_u1 = 1 - xi, `outer` to N_u2 = xi.
void add_coupling(const FlexibleBody& body, int element, const Vector4& inner, const Vector4& outer,
                  AxialBendingCoupling& H) {
  for (int side = 0; side < 2; ++side) {
    const int row = body.coordinate(element + side, 0);
    if (row < 0) continue;
    for (int k = 0; k < 4; ++k) {
      const int column = body.coordinate(element + k / 2, 1 + k % 2);
      if (column < 0) continue;
      H.at(row, column - body.axial()) += side == 0 ? inner[k] : outer[k];
    }
  }
}

/// An element's shares of S, d0 and c0.
struct FirstMoments {
  Eigen::Vector2d S_axial, d_axial;
  Vector4 S_bending, c_bending;
};

void add_first_moments(FlexibleBody& body, int element, const FirstMoments& moments) {
  for (int side = 0; side < 2; ++side) {
    const int u = body.coordinate(element + side, 0);
    if (u < 0) continue;
    body.S_axial[u] += moments.S_axial[side];
    body.d_axial[u] += moments.d_axial[side];
  }
  for (int k = 0; k < 4; ++k) {
    const int v = body.coordinate(element + k / 2, 1 + k % 2);
    if (v < 0) continue;
    body.S_bending[v - body.axial()] += moments.S_bending[k];
    body.c_bending[v - body.axial()] += moments.c_bending[k];
  }
}

/// Adds a uniform element, in closed form.
void add_uniform_element(const BeamProperties& beam, int e, FlexibleBody& body) {
  const double rhoA = beam.mass_per_length;
  const double l = beam.length / beam.elements;
  const double x0 = e * l;
  add_axial(body, e, rhoA * axial_mass(l), body.M_axial);
  add_axial(body, e, beam.axial_stiffness * axial_stiffness(l), body.K_axial);
  add_bending(body, e, rhoA * bending_mass(l), body.M_bending);
  add_bending(body, e, beam.bending_stiffness * bending_stiffness(l), body.K_bending);
  const Vector4 area = bending_area(l), moment = bending_moment(l);
  const Vector4 outer = rhoA * moment;
  add_coupling(body, e, rhoA * area - outer, outer, body.H);
  add_first_moments(body, e,
                    {Eigen::Vector2d::Constant(rhoA * l / 2.0),
                     {rhoA * (x0 * l / 2.0 + l * l / 6.0), rhoA * (x0 * l / 2.0 + l * l / 3.0)},
                     rhoA * area,
                     rhoA * (x0 * area + l * moment)});
}

/// A place at which an integrand is evaluated.
struct Place {
  int element;
  double x;   ///< distance from the body's inboard end [m]
  double xi;  ///< place within the element, 0 to 1
};

Place place_at(const BeamProperties& beam, double x) {
  const double along = x / beam.length * beam.elements;
  const int e = std::clamp(static_cast<int>(along), 0, beam.elements - 1);
  return {e, x, along - e};
}

/// Calls visit(place, dx, piece) at four Gauss points of each stretch that lies in one piece and in
/// one element: sums over them are the integrals of polynomials up to degree 7.
template <class Visit>
void visit_gauss_points(const BeamProperties& beam, const Visit& visit) {
  const double l = beam.length / beam.elements;
  for (const BeamPiece& piece : beam.pieces)
    for (int e = place_at(beam, piece.begin).element; e < beam.elements && e * l < piece.end; ++e) {
      const double begin = std::max(piece.begin, e * l), end = std::min(piece.end, (e + 1) * l);
      for (const auto& [at, weight] : kGauss) {
        const double x = begin + at * (end - begin);
        if (begin < end) visit(Place{e, x, x / l - e}, weight * (end - begin), piece);
      }
    }
}

/// Adds the element's share of a point mass.
void add_mass(const Place& at, double l, double mass, double inertia, BeamElement& element) {
  const Eigen::Vector2d axial{1.0 - at.xi, at.xi};
  const Vector4 shape = bending_shape(at.xi, l), slope = bending_slope(at.xi, l);
  element.mass(kAxial, kAxial) += mass * axial * axial.transpose();
  element.mass(kBending, kBending) +=
      mass * shape * shape.transpose() + inertia * slope * slope.transpose();
}

/// Adds a point mass to all mass constants of a body but Mff. In a body that is not uniform, each
/// constant is a sum over such masses.
void add_mass(const Place& at, double mass, double inertia, FlexibleBody& body) {
  const double l = body.length / body.elements;
  const Eigen::Vector2d axial{1.0 - at.xi, at.xi};
  const Vector4 shape = bending_shape(at.xi, l), slope = bending_slope(at.xi, l);
  body.mass += mass;
  body.S0.x() += mass * at.x;
  body.I0 += mass * at.x * at.x + inertia;
  add_coupling(body, at.element, mass * axial[0] * shape, mass * axial[1] * shape, body.H);
  add_first_moments(
      body, at.element,
      {mass * axial, mass * at.x * axial, mass * shape, mass * at.x * shape + inertia * slope});
}

void add_varying_elements(const BeamProperties& beam, FlexibleBody& body) {
  const std::vector<BeamElement> elements = make_beam_elements(beam);
  for (int e = 0; e < beam.elements; ++e) {
    const BeamElement& element = elements[static_cast<std::size_t>(e)];
    add_axial(body, e, element.mass(kAxial, kAxial), body.M_axial);
    add_axial(body, e, element.stiffness(kAxial, kAxial), body.K_axial);
    add_bending(body, e, element.mass(kBending, kBending), body.M_bending);
    add_bending(body, e, element.stiffness(kBending, kBending), body.K_bending);
  }
  visit_gauss_points(beam, [&](const Place& at, double dx, const BeamPiece& piece) {
    add_mass(at, dx * piece.at(piece.mass_per_length, at.x), 0.0, body);
  });
  for (const BodyMass& point : beam.masses)
    add_mass(place_at(beam, point.x), point.mass, point.inertia, body);
}

Handle make_handle(const FlexibleBody& body, int node) {
  Handle handle;
  handle.node = node;
  handle.p = Position{body.length * node / body.elements, 0.0};
  for (int c = 0; c < kTwist; ++c) handle.coordinate[c] = body.coordinate(node, c);
  return handle;
}

/// Makes a body of the right sizes, its integrals still zero.
FlexibleBody make_empty_body(const BeamProperties& beam) {
  FlexibleBody body;
  body.reference_frame = beam.reference_frame;
  body.elements = beam.elements;
  body.length = beam.length;
  const int E = beam.elements;
  body.S_axial = body.d_axial = Eigen::VectorXd::Zero(body.padded_axial());
  body.S_bending = body.c_bending = Eigen::VectorXd::Zero(2 * E);
  body.M_axial = body.K_axial = SymmetricBand<1>(E);
  body.M_bending = body.K_bending = SymmetricBand<3>(2 * E);
  body.H.rows.setZero(Eigen::Index{body.padded_axial()} * AxialBendingCoupling::kWidth);
  body.H.pairs.setZero(Eigen::Index{E} * AxialBendingCoupling::kHeight * 2);
  // Row i belongs to node i + 1, whose left neighbour's v stands at 2 i - 2 (clamped: node 1 is the
  // first) or 2 i - 1 (chord: psi_0 stands in front).
  body.H.offset = beam.reference_frame == ReferenceFrame::clamped ? -2 : -1;
  body.inboard = make_handle(body, 0);
  body.outboard = make_handle(body, E);
  return body;
}

/// Gives a body whose strains are of second order the matrices that it has for them.
void make_nonlinear(const BeamProperties& beam, FlexibleBody& body) {
  const std::vector<BeamElement> elements = make_beam_elements(beam);
  for (std::size_t e = 0; std::cmp_less(e, beam.elements); ++e)
    body.strain_stiffness.push_back(
        elements[std::min(e, elements.size() - 1)].stiffness.bottomRightCorner<kTwist, kTwist>());
  body.K_axial = SymmetricBand<1>(body.axial());
  body.K_bending = SymmetricBand<3>(body.bending());
  for (const BodyMass& point : beam.masses) {
    if (point.inertia == 0.0) continue;
    if (body.turning.size() == 0) body.turning = SymmetricBand<3>(body.bending());
    const Place at = place_at(beam, point.x);
    const Vector4 slope = bending_slope(at.xi, beam.length / beam.elements);
    add_bending(body, at.element, point.inertia * slope * slope.transpose(), body.turning);
  }
}

}  // namespace

FlexibleBody make_beam_body(const BeamProperties& beam) {
  assert(follow_one_another(beam.pieces, beam.length));
  assert(beam.length > 0.0 && beam.elements > 0);
  assert(!beam.pieces.empty() || (beam.mass_per_length > 0.0 && beam.axial_stiffness > 0.0 &&
                                  beam.bending_stiffness > 0.0));
  FlexibleBody body = make_empty_body(beam);
  if (beam.pieces.empty()) {
    body.mass = beam.mass_per_length * beam.length;
    body.S0 = Position{body.mass * beam.length / 2.0, 0.0};
    body.I0 = body.mass * beam.length * beam.length / 3.0;
    for (int e = 0; e < beam.elements; ++e) add_uniform_element(beam, e, body);
  } else {
    body.pieces = beam.pieces;
    body.masses = beam.masses;
    add_varying_elements(beam, body);
  }
  body.H.transpose();
  if (beam.is_nonlinear) make_nonlinear(beam, body);
  return body;
}

namespace {

/// int tension(x) N_v'^T N_v' dx: exact up to a cubic tension in each piece.
template <class Tension>
SymmetricBand<3> integrate_slopes(const BeamProperties& beam, Tension&& tension) {
  const FlexibleBody body = make_empty_body(beam);
  const double l = beam.length / beam.elements;
  SymmetricBand<3> sum(body.bending());
  for (int e = 0; e < beam.elements; ++e) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    for (const auto& [xi, weight] : kGauss) {
      const Vector4 slope = bending_slope(xi, l);
      matrix += (weight * l * tension((e + xi) * l)) * slope * slope.transpose();
    }
    add_bending(body, e, matrix, sum);
  }
  return sum;
}

/// Returns the stiffness of a body in pieces.
SymmetricBand<3> make_varying_centrifugal_stiffness(const BeamProperties& beam, double distance,
                                                    double outboard) {
  const FlexibleBody body = make_empty_body(beam);
  const double l = beam.length / beam.elements;
  SymmetricBand<3> sum(body.bending());
  const auto add = [&](const Place& at, double factor) {
    const Vector4 slope = bending_slope(at.xi, l);
    add_bending(body, at.element, factor * slope * slope.transpose(), sum);
  };
  const std::vector<double> moments = first_moments_outboard(beam.pieces, beam.masses, distance);
  visit_gauss_points(beam, [&](const Place& at, double dx, const BeamPiece& piece) {
    const auto k = static_cast<std::size_t>(&piece - beam.pieces.data());
    add(at, dx * (first_moment_beyond(piece, at.x, distance) + moments[k] + outboard));
  });
  for (const BodyMass& point : beam.masses) add(place_at(beam, point.x), point.inertia);
  return sum;
}

}  // namespace

SymmetricBand<3> make_centrifugal_stiffness(const BeamProperties& beam, double distance,
                                            double outboard) {
  if (!beam.pieces.empty()) return make_varying_centrifugal_stiffness(beam, distance, outboard);
  const double L = beam.length;
  return integrate_slopes(beam, [&](double x) {
    return beam.mass_per_length * ((L * L - x * x) / 2.0 + distance * (L - x)) + outboard;
  });
}

SymmetricBand<3> make_outboard_mass_stiffness(const BeamProperties& beam, double outboard) {
  assert(outboard >= 0.0);
  if (beam.pieces.empty())
    return integrate_slopes(
        beam, [&](double x) { return beam.mass_per_length * (beam.length - x) + outboard; });
  const FlexibleBody body = make_empty_body(beam);
  SymmetricBand<3> sum(body.bending());
  const std::vector<double> masses = masses_outboard(beam.pieces, beam.masses);
  visit_gauss_points(beam, [&](const Place& at, double dx, const BeamPiece& piece) {
    const Vector4 slope = bending_slope(at.xi, beam.length / beam.elements);
    const auto k = static_cast<std::size_t>(&piece - beam.pieces.data());
    const double mass = mass_beyond(piece, at.x) + masses[k] + outboard;
    add_bending(body, at.element, dx * mass * slope * slope.transpose(), sum);
  });
  return sum;
}

SymmetricBand<3> make_slope_integral(const BeamProperties& beam) {
  return integrate_slopes(beam, [](double) { return 1.0; });
}

namespace {

BeamElement make_uniform_beam_element(const BeamProperties& beam) {
  const double l = beam.length / beam.elements;
  BeamElement element;
  element.mass(kAxial, kAxial) = beam.mass_per_length * axial_mass(l);
  element.mass(kBending, kBending) = beam.mass_per_length * bending_mass(l);
  element.stiffness(kAxial, kAxial) = beam.axial_stiffness * axial_stiffness(l);
  element.stiffness(kBending, kBending) = beam.bending_stiffness * bending_stiffness(l);
  return element;
}

}  // namespace

std::vector<BeamElement> make_beam_elements(const BeamProperties& beam) {
  assert(beam.length > 0.0 && beam.elements > 0);
  if (beam.pieces.empty()) return {make_uniform_beam_element(beam)};
  const double l = beam.length / beam.elements;
  std::vector<BeamElement> elements(static_cast<std::size_t>(beam.elements));
  const auto element_at = [&](const Place& at) -> BeamElement& {
    return elements[static_cast<std::size_t>(at.element)];
  };
  visit_gauss_points(beam, [&](const Place& at, double dx, const BeamPiece& piece) {
    BeamElement& element = element_at(at);
    const Vector4 curvature = bending_curvature(at.xi, l);
    add_mass(at, l, dx * piece.at(piece.mass_per_length, at.x), 0.0, element);
    element.stiffness(kAxial, kAxial) +=
        dx * piece.at(piece.axial_stiffness, at.x) / l * axial_stiffness(l);
    element.stiffness(kBending, kBending) +=
        dx * piece.at(piece.bending_stiffness, at.x) * curvature * curvature.transpose();
  });
  for (const BodyMass& point : beam.masses) {
    const Place at = place_at(beam, point.x);
    add_mass(at, l, point.mass, point.inertia, element_at(at));
  }
  return elements;
}

}  // namespace spoke::plane
