// Evaluates the formulas of the paper's Table 2.

#include "bench/reproduce/paper.h"

namespace spoke::reproduce::paper {
namespace {

std::int64_t cube(std::int64_t n) { return n * n * n; }

}  // namespace

std::vector<Count> table_2(const RotorSize& size) {
  const std::int64_t N = size.blades, M = size.bodies, E = size.elements;
  const std::int64_t C1 = 3 * M, C2 = 3;           // constraints of a subsystem, of the hub
  const std::int64_t n = (3 * M) * (3 * (E + 1));  // as printed
  return {{Stage::kinematics, "N (3·756 + 402)", N * (3 * 756 + 402), 8010},
          {Stage::kinematics, "N·1785", N * 1785, 5355},
          {Stage::terms, "N M E·1022", N * M * E * 1022, 49056},
          {Stage::inverse, "N ((3M)(3(E+1)))³/3", N * cube(n) / 3, 5832000},
          {Stage::effective, "2 N C1 (3M)(3(E+1))·143", 2 * N * C1 * n * 143, 1853280},
          {Stage::effective, "N C1³/3 + N C1·269", N * cube(C1) / 3 + N * C1 * 269, 11412},
          {Stage::hub, "(3 C2)³/3 + 3 C2·6", cube(3 * C2) / 3 + 3 * C2 * 6, 297},
          {Stage::accelerations, "N C2·72 + (3M)(3(E+1))·167", N * C2 * 72 + n * 167, 30708}};
}

InverseSizes inverse_sizes(const RotorSize& size) {
  const std::int64_t N = size.blades, M = size.bodies, E = size.elements;
  const std::int64_t body = 3 + 3 * E;
  return {N * cube((3 * M) * (3 * (E + 1))) / 3, N * cube(M * body) / 3, N * M * cube(body) / 3};
}

}  // namespace spoke::reproduce::paper
