#include "models/solid/assembly.h"

#include <algorithm>
#include <cassert>

#include "models/solid/elements.h"

namespace spoke::solid {
namespace {

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Returns the n x n matrix of zeros whose places are the pairs of nodes that share an element.
Sparse make_pattern(const spatial::SolidMesh& mesh) {
  const auto n = static_cast<Eigen::Index>(mesh.nodes.size());
  std::vector<std::vector<int>> elements_of(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int a = 0; a < spatial::count_nodes(mesh.elements[e].kind); ++a)
      elements_of[at(mesh.elements[e].nodes[at(a)])].push_back(static_cast<int>(e));

  Sparse pattern(n, n);
  std::vector<int> column, seen(mesh.nodes.size(), -1);
  std::vector<int> inner, outer{0};
  for (int j = 0; j < n; ++j) {
    column.clear();
    for (const int e : elements_of[at(j)]) {
      const spatial::SolidElement& element = mesh.elements[at(e)];
      for (int a = 0; a < spatial::count_nodes(element.kind); ++a) {
        const int i = element.nodes[at(a)];
        if (seen[at(i)] == j) continue;
        seen[at(i)] = j;
        column.push_back(i);
      }
    }
    std::sort(column.begin(), column.end());
    inner.insert(inner.end(), column.begin(), column.end());
    outer.push_back(static_cast<int>(inner.size()));
  }
  pattern.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(inner.begin(), inner.end(), pattern.innerIndexPtr());
  std::copy(outer.begin(), outer.end(), pattern.outerIndexPtr());
  std::fill_n(pattern.valuePtr(), inner.size(), 0.0);
  return pattern;
}

/// Returns the zeros of 3 x 3 blocks in the places of the entries of a scalar matrix.
Sparse make_block_pattern(const Sparse& m) {
  Sparse K(3 * m.rows(), 3 * m.cols());
  K.resizeNonZeros(9 * m.nonZeros());
  int* inner = K.innerIndexPtr();
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    const Eigen::Index first = m.outerIndexPtr()[j], count = m.outerIndexPtr()[j + 1] - first;
    for (Eigen::Index b = 0; b < 3; ++b) {
      K.outerIndexPtr()[3 * j + b] = static_cast<int>(9 * first + 3 * b * count);
      for (Eigen::Index l = 0; l < count; ++l)
        for (int a = 0; a < 3; ++a) *inner++ = 3 * m.innerIndexPtr()[first + l] + a;
    }
  }
  K.outerIndexPtr()[K.cols()] = static_cast<int>(9 * m.nonZeros());
  std::fill_n(K.valuePtr(), 9 * m.nonZeros(), 0.0);
  return K;
}

/// Returns the place of the entry (i, j) among the values of m.
Eigen::Index find_entry(const Sparse& m, int i, int j) {
  const int* first = m.innerIndexPtr() + m.outerIndexPtr()[j];
  const int* last = m.innerIndexPtr() + m.outerIndexPtr()[j + 1];
  const int* found = std::lower_bound(first, last, i);
  assert(found != last && *found == i);
  return found - m.innerIndexPtr();
}

void add_stiffness(const NodeStiffness& stiffness, const spatial::SolidElement& element,
                   const Sparse& m, Sparse& K) {
  const int count = spatial::count_nodes(element.kind);
  for (int b = 0; b < count; ++b) {
    const int j = element.nodes[at(b)];
    const Eigen::Index first = m.outerIndexPtr()[j], width = m.outerIndexPtr()[j + 1] - first;
    for (int a = 0; a < count; ++a) {
      const Eigen::Index l = find_entry(m, element.nodes[at(a)], j) - first;
      double* values = K.valuePtr() + 9 * first + 3 * l;
      for (Eigen::Index c = 0; c < 3; ++c)
        for (Eigen::Index k = 0; k < 3; ++k)
          values[3 * c * width + k] += stiffness(3 * a + k, 3 * b + c);
    }
  }
}

/// Adds the geometric stiffness of an element, a column of `values` for each displacement.
void add_geometric_stiffness(const spatial::SolidElement& element, const NodeColumns& x,
                             const Lame& material, const Eigen::MatrixXd& displacements,
                             const Sparse& m, Eigen::MatrixXd& values) {
  const int count = spatial::count_nodes(element.kind);
  std::vector<NodeColumns> gradients;
  std::vector<double> weights;
  for (const ShapePoint& point : stress_rule(element.kind)) {
    gradients.emplace_back(3, count);
    weights.push_back(point.weight * calc_gradients(point, x, gradients.back()));
  }
  NodeColumns u(3, count), force(3, count);
  NodeMatrix kg(count, count);
  for (Eigen::Index load = 0; load < displacements.cols(); ++load) {
    for (int a = 0; a < count; ++a)
      u.col(a) = displacements.col(load).segment<3>(3 * Eigen::Index{element.nodes[at(a)]});
    kg.setZero();
    for (std::size_t p = 0; p < gradients.size(); ++p) {
      force.noalias() = (weights[p] * calc_stress(gradients[p], u, material)) * gradients[p];
      kg.noalias() += gradients[p].transpose() * force;
    }
    for (int b = 0; b < count; ++b)  // of the lower triangle, so that kg is symmetric in its bits
      for (int a = b; a < count; ++a) {
        const int i = element.nodes[at(a)], j = element.nodes[at(b)];
        values(find_entry(m, i, j), load) += kg(a, b);
        if (a != b) values(find_entry(m, j, i), load) += kg(a, b);
      }
  }
}

}  // namespace

NodeMatrices assemble(const spatial::SolidMesh& mesh, const spatial::SolidMaterial& material) {
  NodeMatrices matrices;
  matrices.m = make_pattern(mesh);
  matrices.K = make_block_pattern(matrices.m);
  const Lame lame = lame_of(material);
  for (const spatial::SolidElement& element : mesh.elements) {
    const NodeColumns x = places_of(mesh, element);
    const NodeMatrix mass = calc_mass(element.kind, x, material.density);
    for (int b = 0; b < mass.cols(); ++b)
      for (int a = 0; a < mass.rows(); ++a)
        matrices.m.valuePtr()[find_entry(matrices.m, element.nodes[at(a)], element.nodes[at(b)])] +=
            mass(a, b);
    add_stiffness(calc_stiffness(element.kind, x, lame), element, matrices.m, matrices.K);
  }
  for (const auto& [node, mass] : mesh.masses)
    matrices.m.valuePtr()[find_entry(matrices.m, node, node)] += mass;
  return matrices;
}

Eigen::MatrixXd calc_geometric_stiffness(const spatial::SolidMesh& mesh,
                                         const spatial::SolidMaterial& material, const Sparse& m,
                                         const Eigen::MatrixXd& displacements) {
  assert(m.isCompressed() && displacements.rows() == 3 * m.rows());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(m.nonZeros(), displacements.cols());
  const Lame lame = lame_of(material);
  for (const spatial::SolidElement& element : mesh.elements)
    add_geometric_stiffness(element, places_of(mesh, element), lame, displacements, m, values);
  return values;
}

Sparse project(const Sparse& A, const Sparse& X) {
  const Sparse right = A * X;
  const Sparse product = Sparse(X.transpose()) * right;
  Sparse result = product.selfadjointView<Eigen::Lower>();
  result.makeCompressed();
  return result;
}

}  // namespace spoke::solid
