// Sums the tangents of the elements, and solves for the columns that stay for a step.

#include "engine/bodies/plane/implicit_strain.h"

#include <algorithm>
#include <cassert>

namespace spoke::plane {
namespace {

FlexLayout layout_of(const FlexibleBody& body) { return {body.axial(), body.bending()}; }

/// Sets how the tension of elements acts on the rotation of the frame; compression is left out.
void set_lean(const FlexibleBody& body, ImplicitStrain& strain) {
  const FlexLayout layout = layout_of(body);
  std::fill(strain.lean.begin(), strain.lean.end(), 0.0);
  strain.turn = 0.0;
  for (int e = 0; e < body.elements; ++e) {
    const double tension =
        strain.factors.geometric * strain.wrenches[static_cast<std::size_t>(e)][0];
    if (!(tension > 0.0)) continue;
    strain.turn += tension * body.length / body.elements;
    for (int side = 0; side < 2; ++side)
      if (const int at = layout.offset(body.coordinate(e + side, 1)); at > 0)
        strain.lean[static_cast<std::size_t>(at)] += side == 0 ? -tension : tension;
  }
}

/// Puts a unit force on a coordinate of a handle, in a column of a pair.
void set_unit(const FlexibleBody& body, const Handle& handle, int component, int column,
              std::vector<Double2>& pair) {
  if (const int at = place_by_node(body, handle.node, component); at >= 0)
    pair[static_cast<std::size_t>(at)][column] = 1.0;
}

void set_columns(const FlexibleBody& body, ImplicitStrain& strain) {
  auto& [W, Z_linear, Z_angular] = strain.columns;
  std::copy(strain.S.begin(), strain.S.end(), W.begin());
  for (auto* pair : {&Z_linear, &Z_angular}) std::fill(pair->begin(), pair->end(), Double2{});
  for (int c = 0; c < kPosition; ++c) set_unit(body, body.outboard, c, c, Z_linear);
  set_unit(body, body.outboard, kRotation, 0, Z_angular);
  set_unit(body, body.inboard, kRotation, 1, Z_angular);
  for (auto& pair : strain.columns) strain.factor.solve(pair.data());
  strain.S_W = {};
  for (std::size_t i = 0; i < W.size(); ++i) {
    strain.S_W.xx += strain.S[i][0] * W[i][0];
    strain.S_W.yx += strain.S[i][1] * W[i][0];
    strain.S_W.yy += strain.S[i][1] * W[i][1];
  }
}

}  // namespace

ImplicitStrain make_implicit_strain(const FlexibleBody& body, const TangentFactors& factors) {
  assert(body.is_nonlinear() && factors.geometric > 0.0);
  ImplicitStrain strain;
  strain.factors = factors;
  strain.mass = make_mass_band(body);
  strain.added = strain.factor = NodalBand(body);
  const auto n = static_cast<std::size_t>(body.coordinates());
  for (int i = 0; i < body.coordinates(); ++i) {
    const int k = strain.mass.coordinate(i), bending = k - body.axial();
    strain.S.push_back(bending < 0 ? Double2{body.S_axial[k], 0.0}
                                   : Double2{0.0, body.S_bending[bending]});
  }
  strain.wrenches.assign(static_cast<std::size_t>(body.elements), Twist::Zero());
  strain.lean.assign(static_cast<std::size_t>(layout_of(body).size()), 0.0);
  for (auto& pair : strain.columns) pair.assign(n, Double2{});
  follow_strain(body, std::vector<double>(strain.lean.size(), 0.0).data(), strain);
  return strain;
}

void keep_wrenches(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept {
  for (int e = 0; e < body.elements; ++e)
    strain.wrenches[static_cast<std::size_t>(e)] = calc_strain_wrench(body, layout_of(body), e, q);
}

void follow_strain(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept {
  strain.added.set_zero();
  add_tangents(body, layout_of(body), strain.factors, q, strain.wrenches.data(), strain.added);
  set_lean(body, strain);
  strain.factor.factorise(strain.mass, strain.added);
  set_columns(body, strain);
}

FrameShare add_implicit_strain(const ImplicitStrain& strain, const double* a, double alpha,
                               double* c_theta, double* Q_f) noexcept {
  strain.added.add_product(a, Q_f);
  FrameShare share{strain.turn, strain.turn * alpha};
  for (int i = 0; i < strain.mass.size(); ++i) {
    const int at = strain.mass.at(i);
    const double lean = strain.lean[static_cast<std::size_t>(at)];
    c_theta[at] += lean;
    Q_f[at] += lean * alpha;
    share.moment += lean * a[at];
  }
  return share;
}

}  // namespace spoke::plane
