// Integrals of the shape functions over an element (docs/formulation.md, section 2), assembled into
// a body.

#include "models/system/beam_elements.h"

#include <cassert>
#include <cmath>

namespace spoke {
namespace {

using Vector4 = Eigen::Vector4d;

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

void add_coupling(const FlexibleBody& body, int element, double rhoA, double l,
                  AxialBendingCoupling& H) {
  const Vector4 outer = rhoA * bending_moment(l);        // times N_u2 = xi
  const Vector4 inner = rhoA * bending_area(l) - outer;  // times N_u1 = 1 - xi
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

void add_first_moments(FlexibleBody& body, int element, double rhoA, double l) {
  const double x0 = element * l;
  for (int side = 0; side < 2; ++side) {
    const int u = body.coordinate(element + side, 0);
    if (u < 0) continue;
    body.S_axial[u] += rhoA * l / 2.0;
    body.d_axial[u] += rhoA * (x0 * l / 2.0 + l * l / (side == 0 ? 6.0 : 3.0));
  }
  const Vector4 area = bending_area(l);
  const Vector4 moment = bending_moment(l);
  for (int k = 0; k < 4; ++k) {
    const int v = body.coordinate(element + k / 2, 1 + k % 2);
    if (v < 0) continue;
    body.S_bending[v - body.axial()] += rhoA * area[k];
    body.c_bending[v - body.axial()] += rhoA * (x0 * area[k] + l * moment[k]);
  }
}

Handle make_handle(const FlexibleBody& body, int node) {
  Handle handle;
  handle.node = node;
  handle.p = Position{body.length * node / body.elements, 0.0};
  for (int c = 0; c < kTwist; ++c) handle.coordinate[c] = body.coordinate(node, c);
  return handle;
}

/// A body of the right sizes, its integrals still zero.
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

}  // namespace

int FlexibleBody::coordinate(int node, int component) const {
  if (component == 0) return node == 0 ? -1 : node - 1;
  const int psi = component - 1;  // 0: deflection v, 1: rotation psi
  if (reference_frame == ReferenceFrame::clamped)
    return node == 0 ? -1 : elements + 2 * (node - 1) + psi;
  if (node == 0) return psi ? elements : -1;
  if (node == elements) return psi ? elements + 2 * elements - 1 : -1;
  return elements + 2 * node - 1 + psi;
}

BeamProperties make_beam_properties(const Blade& blade) {
  BeamProperties beam;
  beam.length = blade.length / blade.bodies;
  beam.elements = blade.elements;
  beam.mass_per_length = blade.density * blade.area;
  beam.axial_stiffness = blade.youngs_modulus * blade.area;
  beam.bending_stiffness = blade.youngs_modulus * blade.second_moment;
  beam.reference_frame = blade.reference_frame;
  return beam;
}

void AxialBendingCoupling::transpose() {
  const int n = static_cast<int>(pairs.size()) / (2 * kHeight);
  for (int i = 0; i < n; ++i)
    for (int place = 0; place < kWidth; ++place) {
      const int column = 2 * i + offset + place;
      if (column < 0 || column >= 2 * n) continue;
      const int k = column / 2;
      pairs[(k * kHeight + (i - k + 2)) * 2 + column % 2] = rows[i * kWidth + place];
    }
}

FlexibleBody make_beam_body(const BeamProperties& beam) {
  assert(beam.length > 0.0 && beam.mass_per_length > 0.0 && beam.elements > 0);
  assert(beam.axial_stiffness > 0.0 && beam.bending_stiffness > 0.0);
  FlexibleBody body = make_empty_body(beam);
  const double rhoA = beam.mass_per_length;
  const double l = beam.length / beam.elements;
  body.mass = rhoA * beam.length;
  body.S0 = Position{body.mass * beam.length / 2.0, 0.0};
  body.I0 = body.mass * beam.length * beam.length / 3.0;
  for (int e = 0; e < beam.elements; ++e) {
    add_axial(body, e, rhoA * axial_mass(l), body.M_axial);
    add_axial(body, e, beam.axial_stiffness * axial_stiffness(l), body.K_axial);
    add_bending(body, e, rhoA * bending_mass(l), body.M_bending);
    add_bending(body, e, beam.bending_stiffness * bending_stiffness(l), body.K_bending);
    add_coupling(body, e, rhoA, l, body.H);
    add_first_moments(body, e, rhoA, l);
  }
  body.H.transpose();
  return body;
}

namespace {

/// int tension(x) N_v'^T N_v' dx by four Gauss points an element: exact up to a quadratic tension.
template <class Tension>
SymmetricBand<3> integrate_slopes(const BeamProperties& beam, Tension&& tension) {
  const FlexibleBody body = make_empty_body(beam);
  const double a = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double b = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double weight_a = (18.0 + std::sqrt(30.0)) / 72.0;
  const double weight_b = (18.0 - std::sqrt(30.0)) / 72.0;
  const std::array<std::array<double, 2>, 4> gauss{{{(1 - b) / 2, weight_b},
                                                    {(1 - a) / 2, weight_a},
                                                    {(1 + a) / 2, weight_a},
                                                    {(1 + b) / 2, weight_b}}};
  const double l = beam.length / beam.elements;
  SymmetricBand<3> sum(body.bending());
  for (int e = 0; e < beam.elements; ++e) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    for (const auto& [xi, weight] : gauss) {
      const Vector4 slope = bending_slope(xi, l);
      matrix += (weight * l * tension((e + xi) * l)) * slope * slope.transpose();
    }
    add_bending(body, e, matrix, sum);
  }
  return sum;
}

}  // namespace

SymmetricBand<3> make_centrifugal_stiffness(const BeamProperties& beam, double distance,
                                            double outboard) {
  const double L = beam.length;
  return integrate_slopes(beam, [&](double x) {
    return beam.mass_per_length * ((L * L - x * x) / 2.0 + distance * (L - x)) + outboard;
  });
}

SymmetricBand<3> make_slope_integral(const BeamProperties& beam) {
  return integrate_slopes(beam, [](double) { return 1.0; });
}

BeamElement make_beam_element(const BeamProperties& beam) {
  constexpr std::array<int, 2> axial{0, 3};
  constexpr std::array<int, 4> bending{1, 2, 4, 5};
  const double l = beam.length / beam.elements;
  BeamElement element{BeamElement::Matrix::Zero(), BeamElement::Matrix::Zero()};
  element.mass(axial, axial) = beam.mass_per_length * axial_mass(l);
  element.mass(bending, bending) = beam.mass_per_length * bending_mass(l);
  element.stiffness(axial, axial) = beam.axial_stiffness * axial_stiffness(l);
  element.stiffness(bending, bending) = beam.bending_stiffness * bending_stiffness(l);
  return element;
}

}  // namespace spoke
