// Goes through a spectrum from its lowest end.

#include "engine/small_motions/vibration/choose_roots.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Returns x^H A x.
template <class Product>
Complex calc_form(const VectorXcd& x, const Product& product) {
  const VectorXd real = product(x.real()), imag = product(x.imag());
  return {x.real().dot(real) + x.imag().dot(imag), x.real().dot(imag) - x.imag().dot(real)};
}

/// A root, and the estimates from its shape.
struct Judged {
  Complex s;
  VectorXcd x;             ///< of unit mass
  Complex quotient;        ///< root of x^H P x near s, of second order for undamped vibrations
  double slope = 0.0;      ///< |x^H P'(s) x|
  double round_off = 0.0;  ///< that of x^H P(s) x
};
Judged judge(const Pencil& pencil, const Spectrum& spectrum, Index k) {
  const Complex s = spectrum.values[k];
  const VectorXcd x = to_unit_mass(pencil, spectrum.vector(k));
  const auto times_damping = [&](const VectorXd& y) -> VectorXd { return pencil.damping(0.0, y); };
  const auto times_stiffness = [&](const VectorXd& y) -> VectorXd { return pencil.stiffness(y); };
  const Complex half = 0.5 * calc_form(x, times_damping);
  const Complex root = std::sqrt(half * half - calc_form(x, times_stiffness));
  const Complex one = -half + root, other = -half - root;
  return {s, x, std::abs(one - s) < std::abs(other - s) ? one : other, 2.0 * std::abs(s + half),
          pencil.calc_round_off(x, std::abs(s)) + spectrum.lost(s)};
}

/// Whether a root belongs to a rigid motion: it has the shape of one, and is zero up to the digits
/// that are lost where two roots meet. A root that damping or gyroscopic forces slow down has that
/// shape, too.
bool is_rigid(const Judged& root, const Pencil& pencil, const MatrixXd& rigid) {
  constexpr double kLost = 1e4, kOfShape = 1e-4;
  if (rigid.cols() == 0 || std::abs(root.s) * root.slope > kLost * root.round_off) return false;
  const MatrixXd momentum = pencil.mass(rigid);
  const VectorXcd left = root.x - rigid * (momentum.transpose() * root.x);
  const auto times_mass = [&](const VectorXd& y) -> VectorXd { return pencil.mass(y); };
  return calc_form(left, times_mass).real() < kOfShape;
}

/// Returns the root without the parts that are round-off.
Complex clear(const Judged& root) {
  constexpr double kReal = 1e-9;      // below this imaginary parts are zero
  constexpr double kUndamped = 1e-7;  // below this real parts are taken from the quotient
  const double size = std::abs(root.s);
  const double unknown = root.slope * root.slope > root.round_off ? root.round_off / root.slope
                                                                  : std::sqrt(root.round_off);
  double real = root.s.real(), imag = root.s.imag();
  if (std::abs(imag) <= std::max(unknown, kReal * size)) imag = 0.0;
  const bool is_undamped =
      std::abs(real) <= kUndamped * size && std::abs(root.quotient.real()) <= unknown;
  if (std::abs(real) <= unknown || is_undamped) real = 0.0;
  return {real, imag};
}

}  // namespace

VectorXcd to_unit_mass(const Pencil& pencil, const VectorXcd& x) {
  const auto times_mass = [&](const VectorXd& y) -> VectorXd { return pencil.mass(y); };
  return x / std::sqrt(calc_form(x, times_mass).real());
}

ChosenRoots choose_roots(const Pencil& pencil, const Spectrum& spectrum, const MatrixXd& rigid,
                         Index count) {
  constexpr double kNear = 1e-3;
  const VectorXcd& values = spectrum.values;
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return std::abs(values[a]) < std::abs(values[b]); });
  ChosenRoots chosen;
  std::vector<VectorXcd> spare;
  for (Index k = 0; k < std::min(count, rigid.cols()); ++k)
    chosen.roots.push_back({0.0, rigid.col(k).cast<Complex>()});
  for (const Index k : order) {
    if (std::ssize(chosen.roots) == count) break;
    if (values[k].imag() < -1e-9 * std::abs(values[k])) continue;
    const Judged root = judge(pencil, spectrum, k);
    if (is_rigid(root, pencil, rigid)) {
      spare.push_back(root.x);
      continue;
    }
    chosen.checked.push_back({k, root.slope < kNear * std::abs(root.s)});
    chosen.roots.push_back({clear(root), root.x});
  }
  // More than two roots of zero may belong to a motion where forces are not in balance.
  const bool is_all = values.size() == 2 * pencil.size();
  while (is_all && !spare.empty() && std::ssize(chosen.roots) < std::min(count, pencil.size())) {
    chosen.roots.insert(chosen.roots.begin() + rigid.cols(), {0.0, spare.back()});
    spare.pop_back();
  }
  return chosen;
}

}  // namespace spoke::vibration
