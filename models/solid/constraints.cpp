#include "models/solid/constraints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>

namespace spoke::solid {
namespace {

using space::Position;
using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using WideMatrix6 = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Of a node that is no interface's, and of one that the frame fixes.
constexpr int kFree = -1, kFixed = -2;

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Second moments of weighted nodes about their mean.
struct Spread {
  Position mean = Position::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  ///< sum w (|r|^2 1 - r r^T)
};

Spread find_spread(const std::vector<int>& nodes, const std::vector<double>& weights,
                   const std::vector<Position>& x) {
  Spread spread;
  for (std::size_t k = 0; k < nodes.size(); ++k) spread.mean += weights[k] * x[index(nodes[k])];
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Eigen::Vector3d r = x[index(nodes[k])] - spread.mean;
    spread.moments += weights[k] * (r.squaredNorm() * Eigen::Matrix3d::Identity() -
                                    Eigen::Matrix3d(r * r.transpose()));
  }
  return spread;
}

/// Moments of inertia below this part of the largest are taken as 0: the nodes are on one line.
constexpr double kLine = 1e-10;

/// Returns the inverse, 0 in the directions in which the matrix is singular.
Eigen::Matrix3d invert_moments(const Eigen::Matrix3d& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments);
  const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (std::abs(eigen.eigenvalues()[k]) > kLine * largest && largest > 0.0)
      inverse[k] = 1.0 / eigen.eigenvalues()[k];
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

bool is_held_by_frame(std::size_t interface, spatial::SolidFrame frame) {
  return interface == 0 && frame == spatial::SolidFrame::clamped;
}

/// Finds what holds each node: kFree, kFixed, or the number of a rigid interface.
std::vector<int> find_owners(std::size_t n, const std::vector<HeldNodes>& interfaces,
                             spatial::SolidFrame frame) {
  std::vector<int> owners(n, kFree);
  for (std::size_t k = 0; k < interfaces.size(); ++k) {
    if (interfaces[k].kind != spatial::InterfaceKind::rigid) continue;
    for (const int node : interfaces[k].chosen.nodes) {
      assert(owners[index(node)] == kFree);
      owners[index(node)] = is_held_by_frame(k, frame) ? kFixed : static_cast<int>(k);
    }
  }
  return owners;
}

/// Finds six displacements (3 node + axis) that the conditions E u = 0 determine best, and writes
/// by a row each how they follow from the others of `candidates`.
void find_dependent(const WideMatrix6& E, double length, std::vector<int>& dependent,
                    WideMatrix6& follows) {
  WideMatrix6 scaled = E;
  scaled.bottomRows<3>() *= length;
  const Eigen::ColPivHouseholderQR<WideMatrix6> qr(scaled);
  const Eigen::VectorXi order = qr.colsPermutation().indices();
  Matrix6 chosen;
  dependent.clear();
  for (int k = 0; k < 6; ++k) {
    dependent.push_back(order[k]);
    chosen.col(k) = scaled.col(order[k]);
  }
  follows = -chosen.fullPivLu().solve(scaled);
}

/// Builds Xi.
class CoordinateBuilder {
 public:
  CoordinateBuilder(const std::vector<Position>& nodes, const std::vector<HeldNodes>& interfaces,
                    spatial::SolidFrame frame)
      : nodes_(nodes), interfaces_(interfaces), frame_(frame) {}

  Constraints build() {
    const std::size_t n = nodes_.size();
    owners_ = find_owners(n, interfaces_, frame_);
    columns_.assign(3 * n, -1);
    hold_mean();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t a = 0; a < 3; ++a)
        if (owners_[i] == kFree && !is_dependent_[3 * i + a]) columns_[3 * i + a] = count_++;
    for (std::size_t d = 0; d < 3 * n; ++d)
      if (columns_[d] >= 0) entries_.emplace_back(static_cast<int>(d), columns_[d], 1.0);
    add_dependent();
    Constraints result;
    for (std::size_t k = 0; k < interfaces_.size(); ++k)
      if (interfaces_[k].kind == spatial::InterfaceKind::rigid && !is_held_by_frame(k, frame_))
        add_rigid(interfaces_[k], result.boundary);
    result.Xi.resize(static_cast<Eigen::Index>(3 * n), count_);
    result.Xi.setFromTriplets(entries_.begin(), entries_.end());
    for (const int d : dependent_) result.dependent.push_back(displacement(d));
    if (frame_ == spatial::SolidFrame::mean_axis) result.rigid = make_rigid(result.boundary);
    return result;
  }

 private:
  /// Chooses the displacements that follow from the others where the frame is that of a mean.
  void hold_mean() {
    is_dependent_.assign(3 * nodes_.size(), false);
    if (frame_ != spatial::SolidFrame::clamped ||
        interfaces_[0].kind != spatial::InterfaceKind::average)
      return;
    const ChosenNodes& chosen = interfaces_[0].chosen;
    const WideMatrix6 E = make_average(chosen, nodes_);
    double length = 0.0;
    for (const int node : chosen.nodes)
      length = std::max(length, (nodes_[index(node)] - chosen.point).norm());
    find_dependent(E, length, dependent_, follows_);
    for (const int d : dependent_) is_dependent_[index(displacement(d))] = true;
  }

  /// Returns the displacement of a node that is entry `d` of those of the first interface.
  int displacement(int d) const { return 3 * interfaces_[0].chosen.nodes[index(d / 3)] + d % 3; }

  void add_dependent() {
    for (std::size_t row = 0; row < dependent_.size(); ++row) {
      const std::vector<int>& chosen = interfaces_[0].chosen.nodes;
      const int held = displacement(dependent_[row]);
      for (Eigen::Index c = 0; c < follows_.cols(); ++c) {
        const int column = columns_[index(3 * chosen[index(c / 3)] + c % 3)];
        const double value = follows_(static_cast<Eigen::Index>(row), c);
        if (column >= 0 && value != 0.0) entries_.emplace_back(held, column, value);
      }
    }
  }

  /// u_i = u_p - r_i~ th.
  void add_rigid(const HeldNodes& interface, int& boundary) {
    for (const int node : interface.chosen.nodes) {
      const Position r = nodes_[index(node)] - Position(interface.chosen.point);
      const space::Matrix3 turned = -space::skew(r);
      for (int a = 0; a < 3; ++a) {
        entries_.emplace_back(3 * node + a, count_ + a, 1.0);
        for (int b = 0; b < 3; ++b)
          if (turned(a, b) != 0.0)
            entries_.emplace_back(3 * node + a, count_ + 3 + b, turned(a, b));
      }
    }
    count_ += 6;
    boundary += 6;
  }

  Eigen::MatrixXd make_rigid(int boundary) const {
    Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(count_, 6);
    for (std::size_t d = 0; d < columns_.size(); ++d) {
      if (columns_[d] < 0) continue;
      const auto axis = static_cast<Eigen::Index>(d % 3);
      rigid(columns_[d], axis) = 1.0;
      rigid.row(columns_[d]).tail<3>() = -space::skew(nodes_[d / 3]).row(axis);
    }
    Eigen::Index row = count_ - boundary;
    for (const HeldNodes& interface : interfaces_) {
      if (interface.kind != spatial::InterfaceKind::rigid) continue;
      rigid.middleRows<6>(row).setIdentity();
      rigid.block<3, 3>(row, 3) = -space::skew(Position(interface.chosen.point));
      row += 6;
    }
    return rigid;
  }

  const std::vector<Position>& nodes_;
  const std::vector<HeldNodes>& interfaces_;
  spatial::SolidFrame frame_;
  std::vector<int> owners_, columns_;
  std::vector<bool> is_dependent_;
  std::vector<int> dependent_;
  WideMatrix6 follows_;
  std::vector<Eigen::Triplet<double>> entries_;
  int count_ = 0;
};

/// Makes a place that follows a mean.
space::SolidPlace make_mean_place(const HeldNodes& held, const std::vector<Position>& nodes,
                                  const Row& Xi) {
  space::SolidPlace place;
  const WideMatrix6 E = make_average(held.chosen, nodes);
  std::vector<std::pair<int, space::Twist>> parts;  // by coordinate
  for (std::size_t k = 0; k < held.chosen.nodes.size(); ++k)
    for (int a = 0; a < 3; ++a)
      for (Row::InnerIterator entry(Xi, 3 * held.chosen.nodes[k] + a); entry; ++entry)
        parts.emplace_back(static_cast<int>(entry.col()),
                           space::Twist(entry.value() * E.col(3 * static_cast<int>(k) + a)));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [coordinate, column] : parts) {
    if (place.at.empty() || place.at.back() != coordinate) {
      place.at.push_back(coordinate);
      place.columns.emplace_back(space::Twist::Zero());
    }
    place.columns.back() += column;
  }
  return place;
}

}  // namespace

WideMatrix6 make_average(const ChosenNodes& chosen, const std::vector<Position>& x) {
  const Spread spread = find_spread(chosen.nodes, chosen.weights, x);
  const Eigen::Matrix3d inverse = invert_moments(spread.moments);
  const Eigen::Matrix3d arm = space::skew(Position(chosen.point) - spread.mean);
  WideMatrix6 E(6, 3 * static_cast<Eigen::Index>(chosen.nodes.size()));
  for (std::size_t k = 0; k < chosen.nodes.size(); ++k) {
    const Eigen::Matrix3d r = space::skew(Position(x[index(chosen.nodes[k])] - spread.mean));
    const Eigen::Matrix3d turn = chosen.weights[k] * inverse * r;
    const auto column = static_cast<Eigen::Index>(3 * k);
    E.block<3, 3>(3, column) = turn;
    E.block<3, 3>(0, column) = chosen.weights[k] * Eigen::Matrix3d::Identity() - arm * turn;
  }
  return E;
}

Constraints make_constraints(const std::vector<Position>& nodes,
                             const std::vector<HeldNodes>& interfaces,
                             const std::vector<HeldNodes>& sets, spatial::SolidFrame frame) {
  assert(!interfaces.empty());
  Constraints result = CoordinateBuilder(nodes, interfaces, frame).build();
  const Row Xi = result.Xi;
  int next = static_cast<int>(Xi.cols()) - result.boundary;
  const auto add = [&](const HeldNodes& held, bool is_rigid, bool is_fixed) {
    space::SolidPlace place;
    if (is_rigid && !is_fixed) {
      for (int c = 0; c < 6; ++c) {
        place.at.push_back(next++);
        place.columns.emplace_back(space::Twist::Unit(c));
      }
    } else if (!is_fixed) {
      place = make_mean_place(held, nodes, Xi);
    }
    place.name = held.name;
    place.p = held.chosen.point;
    place.area = held.chosen.area;
    result.places.push_back(std::move(place));
  };
  for (std::size_t k = 0; k < interfaces.size(); ++k)
    add(interfaces[k], interfaces[k].kind == spatial::InterfaceKind::rigid,
        is_held_by_frame(k, frame));
  for (const HeldNodes& set : sets) add(set, false, false);
  return result;
}

}  // namespace spoke::solid
