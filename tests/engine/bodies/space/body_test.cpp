#include "engine/bodies/space/body.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/table/body_kind.h"
#include "tests/engine/bodies/space/bodies.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {

TEST_CASE("all formulations have one constant block of a body, with the damping of its sections") {
  std::mt19937 random(91);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const auto test = make_decoupled_body(4, frame, random);
    REQUIRE(test->body.is_damped);
    const Body body{test->body, nullptr};
    const Eigen::MatrixXd inverse = spoke::make_dense_elastic_block(body, kImplicit).inverse();
    const Block block = kind_of(body).make_block(body, kImplicit);
    for (std::size_t h = 0; h < test->body.handles.size(); ++h) {
      TwistMatrix expected = TwistMatrix::Zero();
      for (int i = 0; i < kTwist; ++i)
        for (int k = 0; k < kTwist; ++k) {
          const int row = test->body.coordinate(test->body.handles[h], i);
          const int column = test->body.coordinate(test->body.handles[h], k);
          if (row >= 0 && column >= 0) expected(i, k) = inverse(row, column);
        }
      const TwistMatrix found = block.elastic->Z_diagonal[h].matrix();
      CHECK((found - expected).norm() <= 1e-10 * inverse.norm());
    }
  }
}

}  // namespace spoke::space::test
