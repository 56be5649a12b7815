#include "models/tree/beam_cuts.h"

#include <doctest/doctest.h>

using namespace spoke::spatial;

namespace {

Beam beam_of(double length, int bodies, int elements) {
  Beam beam;
  beam.length = length;
  beam.bodies = bodies;
  beam.elements = elements;
  return beam;
}

using Nodes = std::vector<std::vector<double>>;

}  // namespace

TEST_CASE("a beam without joints is cut into equal bodies of equal elements") {
  CHECK(cut_beam(beam_of(8.0, 2, 2), {}, {}) == Nodes{{0, 2, 4}, {4, 6, 8}});
}

TEST_CASE("joints part a beam, and no body is longer than its share of the beam") {
  // Parts of 1, 2 and 5 m, bodies of 2 m at most.
  CHECK(cut_beam(beam_of(8.0, 4, 1), {1.0, 3.0}, {}) == Nodes{{0, 1},
                                                              {1, 3},
                                                              {3, 3.0 + 5.0 / 3},
                                                              {3.0 + 5.0 / 3, 3.0 + 10.0 / 3},
                                                              {3.0 + 10.0 / 3, 8}});
  CHECK(cut_beam(beam_of(8.0, 1, 1), {1.0}, {}) == Nodes{{0, 1}, {1, 8}});
}

TEST_CASE("a joint at the root parts nothing") {
  CHECK(cut_beam(beam_of(8.0, 1, 1), {0.0}, {}) == Nodes{{0, 8}});
}

TEST_CASE("places within a body are nodes, and the number of elements stays if it can") {
  CHECK(cut_beam(beam_of(8.0, 1, 4), {}, {3.0}) == Nodes{{0, 1.5, 3, 5.5, 8}});
  CHECK(cut_beam(beam_of(8.0, 1, 4), {}, {4.0, 4.0}) == Nodes{{0, 2, 4, 6, 8}});
  CHECK(cut_beam(beam_of(8.0, 1, 1), {}, {1.0, 7.0, 8.0}) == Nodes{{0, 1, 7, 8}});
  CHECK(cut_beam(beam_of(8.0, 2, 1), {}, {4.0}) == Nodes{{0, 4}, {4, 8}});
  CHECK(cut_beam(beam_of(8.0, 1, 3), {}, {0.001, 7.999}) == Nodes{{0, 0.001, 7.999, 8}});
}
