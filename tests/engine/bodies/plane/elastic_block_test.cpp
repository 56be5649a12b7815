#include "engine/bodies/plane/elastic_block.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>

#include "engine/bodies/kernels/dense_body.h"
#include "models/plane/beam_elements.h"
#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

template <int Half>
plane::SymmetricBand<Half> random_band(int n, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  plane::SymmetricBand<Half> band(n);
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - Half); j <= i; ++j)
      band.add(i, j, i == j ? 2.0 * Half + 1.0 : unit(random));
  return band;
}

/// A system with two random right-hand sides.
template <int Half>
struct RandomSystem {
  plane::SymmetricBand<Half> band;
  plane::BandFactor<Half> factor;
  Eigen::VectorXd a, b, x, y;

  RandomSystem(int n, std::mt19937& random)
      : band(random_band<Half>(n, random)),
        factor(band),
        a(Eigen::VectorXd::Random(n)),
        b(Eigen::VectorXd::Random(n)),
        x(n + n % 2),
        y(n + n % 2) {}

  plane::BandSystem<Half> system() { return {&factor, a.data(), b.data(), x.data(), y.data()}; }
  void check() const {
    const Eigen::Index n = a.size();
    CHECK((band.to_dense() * x.head(n) - a).norm() < 1e-13 * n);
    CHECK((band.to_dense() * y.head(n) - b).norm() < 1e-13 * n);
    CHECK((band.to_dense() * factor.solve(a).head(n) - a).norm() < 1e-13 * n);
  }
};

}  // namespace

TEST_CASE("axial and bending systems are solved together, two right-hand sides each") {
  for (const int n : {1, 2, 3, 4, 5, 8, 33}) {
    CAPTURE(n);
    std::mt19937 random(n);
    std::srand(n);
    RandomSystem<1> axial(n, random);
    RandomSystem<3> bending(2 * n, random);
    std::vector<Double2> scratch(3 * n);
    solve_together(axial.system(), bending.system(), scratch.data());
    axial.check();
    bending.check();
  }
}

TEST_CASE("an elastic block holds the inverse of its matrix at the handles") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 5}) {
      const plane::FlexibleBody body =
          plane::make_beam_body({2.0, elements, 0.2, 5e6, 566.0, frame});
      const plane::ElasticBlock block = make_elastic_block(body, 1.1, 3e-5);
      const Eigen::MatrixXd inverse = make_dense_elastic_block(body, 1.1, 3e-5).inverse();
      const auto rows = [&](const plane::Handle& handle) {
        Eigen::MatrixXd E = Eigen::MatrixXd::Zero(kTwist, body.coordinates());
        for (int c = 0; c < kTwist; ++c)
          if (handle.coordinate[c] >= 0) E(c, handle.coordinate[c]) = 1.0;
        return E;
      };
      const Eigen::MatrixXd E_i = rows(body.inboard), E_o = rows(body.outboard);
      const double scale = (E_o * inverse * E_o.transpose()).norm();
      const Eigen::MatrixXd Z_ii = E_i * inverse * E_i.transpose();
      const Eigen::MatrixXd Z_io = E_i * inverse * E_o.transpose();
      CHECK(std::abs(block.Z_ii - Z_ii(2, 2)) < 1e-10 * scale);
      CHECK((block.Z_io.transpose() - Z_io.row(2)).norm() < 1e-10 * scale);
      CHECK(Z_ii.topRows(2).norm() + Z_io.topRows(2).norm() == 0.0);
      CHECK((block.Z_oo.matrix() - E_o * inverse * E_o.transpose()).norm() < 1e-10 * scale);
      Eigen::VectorXd S_x = Eigen::VectorXd::Zero(body.coordinates());
      S_x.head(body.axial()) = body.S_axial.head(body.axial());
      CHECK(block.S_Wx == approx(S_x.dot(inverse * S_x)).epsilon(1e-10));
    }
}
