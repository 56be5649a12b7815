// Operations of one evaluation, summed over the kernels of each formulation.

#include "bench/reproduce/operation_counts.h"

// Each function counts one node of the step graph, in the order of its statements; the kernels'
// names stand for theirs. d = 3; handles have 2 d rows, the right-hand sides of (P 10) are 2 d + 1.

namespace spoke::reproduce {
namespace {

constexpr std::int64_t d = 3;

/// Returns the number of unknowns of a body: d of its frame and d for each element.
std::int64_t dense_size(const RotorSize& size) { return d + d * size.elements; }

/// Returns the number of unknowns of the whole: hub, bodies, d multipliers for each, and the hub's
/// three constraints.
std::int64_t augmented_size(const RotorSize& size) {
  return d + size.blades * size.bodies * (dense_size(size) + d) + d;
}

Operations count_kinematics(const RotorSize& size) {
  const Operations body = Operations{4, 2, 0} + rotate();  // orientation, twist
  const Operations joint{2, 7, 2};  // handle's place and twist; sine and cosine of its rotation
  const Operations root{2, 2, 0};
  return size.blades * (size.bodies * body + (size.bodies - 1) * joint + root);
}

Operations count_terms(const RotorSize& size) {
  const std::int64_t E = size.elements;
  const std::int64_t H = 6 * E - 4;  // entries of H: six a row, less those of the fixed node
  const Operations axial = 2 * band_product(E, 1) + Operations{2 * H, 2 * (H - E), 0} +
                           E * Operations{6, 8, 0};  // M, K; H v, H v'; combined, and four sums
  const Operations bending = 2 * band_product(2 * E, 3) + Operations{2 * H, 2 * (H - 2 * E), 0} +
                             2 * E * Operations{6, 7, 0};
  const Operations rest{7, 7, 0};  // Q, first moment, rotary inertia
  return size.blades * size.bodies * (axial + bending + rest);
}

Operations count_structured_body(const RotorSize& size) {
  const std::int64_t E = size.elements;
  const Operations solves = 2 * (band_solve(E, 1) + band_solve(2 * E, 3));  // W_w, z
  const Operations sums = 4 * (dot(E) + dot(2 * E));  // S and c times W_w and z
  const Operations condensed{0, 10, 0};               // S_R, p
  const Operations maps{0, 8, 0};                     // X_o, x_i
  const Operations compliances{30, 21, 0};            // P_io, P_oo
  const Operations free{12, 10, 0};                   // handle's acceleration without wrenches
  return solves + sums + condensed + twist_inverse() + product(d, d, 1) + maps + compliances + free;
}

Operations count_structured_effective(const RotorSize& size) {
  const Operations matrix_vector = product(d, d, 1);
  const Operations joint = twist_turn() + Operations{0, 6, 0} + twist_inverse() + rotate() +
                           Operations{0, 3, 0} + matrix_vector + twist_eliminate() + matrix_vector +
                           Operations{0, 3, 0};
  const Operations root = twist_inverse() + twist_turn() + Operations{6, 8, 0} + matrix_vector +
                          rotate() + Operations{5, 5, 0};  // moved to the hub; bias, wrench
  return size.blades * ((size.bodies - 1) * joint + root);
}

Operations count_structured_accelerations(const RotorSize& size) {
  const Operations matrix_vector = product(d, d, 1);
  const Operations root = Operations{5, 4, 0} + rotate() + Operations{0, 3, 0} + matrix_vector;
  const Operations joint = 2 * matrix_vector + Operations{0, 3, 0} + rotate();
  const Operations frame = Operations{9, 11, 0} + matrix_vector;
  const std::int64_t E = size.elements;
  const Operations body = frame + E * Operations{3, 3, 0} + 2 * E * Operations{4, 4, 0};
  return size.blades * (root + (size.bodies - 1) * joint + size.bodies * body);
}

/// Counts M^-1 [J^T, Q] and [J] M^-1 [J^T, Q] of each body, then Phi M^-1 Phi^T as a whole.
Operations count_subsystem_effective(const RotorSize& size) {
  const std::int64_t n = dense_size(size);
  const std::int64_t C1 = d * size.bodies;
  const Operations bias{6, 4, 0};
  const Operations body = bias + cholesky_solve(n, 2 * d + 1) + product(2 * d, n, 2 * d + 1);
  const Operations joint =
      3 * product(d, d, d) + Operations{0, 9, 0} + product(d, d, 1) + Operations{0, 6, 0};
  const Operations solve = cholesky(C1) + cholesky_solve(C1, d + 1);
  const Operations to_hub = 3 * product(d, d, d) + product(d, d, 1) + Operations{3, 3, 0};
  return size.blades * (size.bodies * body + (size.bodies - 1) * joint + solve + to_hub);
}

Operations count_subsystem_accelerations(const RotorSize& size) {
  const std::int64_t C1 = d * size.bodies;
  const Operations multipliers = product(d, d, 1) + rotate() + product(C1, d, 1) +
                                 Operations{0, C1, 0} + (size.bodies - 1) * rotate();
  const std::int64_t n = dense_size(size);
  const Operations body{2 * d * n, 2 * d * n, 0};
  return size.blades * (multipliers + size.bodies * body);
}

/// Counts (P 9): the hub's three coordinates are given, so only the reaction is left.
Operations count_hub(const RotorSize& size) {
  return size.blades * (product(d, d, 1) + Operations{3, 8, 0});
}

Operations count_structured(Stage stage, const RotorSize& size) {
  if (stage == Stage::inverse) return size.blades * size.bodies * count_structured_body(size);
  if (stage == Stage::effective) return count_structured_effective(size);
  return stage == Stage::hub ? count_hub(size) : count_structured_accelerations(size);
}

Operations count_subsystem(Stage stage, const RotorSize& size) {
  if (stage == Stage::inverse) return size.blades * size.bodies * cholesky(dense_size(size));
  if (stage == Stage::effective) return count_subsystem_effective(size);
  return stage == Stage::hub ? count_hub(size) : count_subsystem_accelerations(size);
}

/// Counts the solution for all unknowns at once: there is no effective mass, and the hub is among
/// them.
Operations count_augmented(Stage stage, const RotorSize& size) {
  const std::int64_t joints = size.blades * (size.bodies - 1);
  if (stage == Stage::inverse)
    return lu(augmented_size(size)) + joints * dense_size(size) * rotate();
  if (stage != Stage::accelerations) return {};
  return lu_solve(augmented_size(size), 1) + joints * rotate();
}

}  // namespace

std::string_view name_of(Stage stage) {
  switch (stage) {
    case Stage::kinematics:
      return "position and velocity";
    case Stage::terms:
      return "mass, inertia, force";
    case Stage::inverse:
      return "inverse of M_sub";
    case Stage::effective:
      return "effective mass and force";
    case Stage::hub:
      return "hub";
    case Stage::accelerations:
      break;
  }
  return "blade accelerations";
}

Operations count(Formulation formulation, Stage stage, const RotorSize& size) {
  if (stage == Stage::kinematics) return count_kinematics(size);
  if (stage == Stage::terms) return count_terms(size);
  switch (formulation) {
    case Formulation::structured:
      return count_structured(stage, size);
    case Formulation::subsystem:
      return count_subsystem(stage, size);
    case Formulation::augmented:
      break;
  }
  return count_augmented(stage, size);
}

Operations count(Formulation formulation, const RotorSize& size) {
  Operations sum;
  for (const Stage stage : kStages) sum = sum + count(formulation, stage, size);
  return sum;
}

}  // namespace spoke::reproduce
