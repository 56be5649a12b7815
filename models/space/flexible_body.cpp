// Assembles elements into a body.

#include "models/space/flexible_body.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace spoke::space {
namespace {

using ElementMatrix = Eigen::Matrix<double, 2 * kTwist, 2 * kTwist>;
using ElementMap = Eigen::Matrix<double, kTwist, 2 * kTwist>;
using SlotMap = Eigen::Matrix<double, 3, 2 * kTwist>;

/// Returns Xi: the slots of an element as functions of (u, th) of its two nodes, in B.
std::array<SlotMap, kElementSlots> slot_maps(const BeamElement& element) {
  std::array<SlotMap, kElementSlots> maps;
  const Position e1 = element.axes.col(0);
  for (int node = 0; node < 2; ++node) {
    const auto at = [&](int slot) -> SlotMap& {
      return maps[static_cast<std::size_t>(kNodeSlots * node + slot)];
    };
    at(0).setZero();
    at(0).block<3, 3>(0, kTwist * node).setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      at(1 + axis).setZero();
      at(1 + axis).block<3, 3>(0, kTwist * node + kRotation) = -skew(element.axes.col(axis));
    }
    at(1).block<3, 3>(0, 0) = -e1 * e1.transpose() / element.length;
    at(1).block<3, 3>(0, kTwist) = e1 * e1.transpose() / element.length;
  }
  return maps;
}

/// Returns G: displacement and rotation of the outer node relative to the inner one.
ElementMap relative_motion(const BeamElement& element) {
  ElementMap G = ElementMap::Zero();
  G.leftCols<kTwist>() = -ElementMap::Identity().leftCols<kTwist>();
  G.block<3, 3>(0, kRotation) = skew(element.chord);
  G.rightCols<kTwist>() = ElementMap::Identity().leftCols<kTwist>();
  return G;
}

void add_elastic(const BeamElement& element, int e, FlexibleBody& body) {
  const ElementMap G = relative_motion(element);
  body.K.add(e, G.transpose() * element.stiffness * G);
  body.D.add(e, G.transpose() * element.damping * G);
}

void add_inertia(const BeamElement& element, int e, FlexibleBody& body) {
  const std::array<SlotMap, kElementSlots> Xi = slot_maps(element);
  std::array<Position, kElementSlots> rho;
  std::array<double, kElementSlots> is_place{};
  for (std::size_t node = 0; node < 2; ++node) {
    const std::size_t first = kNodeSlots * node;
    rho[first] = body.nodes[static_cast<std::size_t>(e) + node];
    is_place[first] = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      rho[first + 1 + axis] = element.axes.col(static_cast<Eigen::Index>(axis));
  }
  ElementMatrix M = ElementMatrix::Zero();
  Eigen::Matrix<double, 2 * kTwist, 3> C_t = Eigen::Matrix<double, 2 * kTwist, 3>::Zero();
  for (std::size_t i = 0; i < kElementSlots; ++i)
    for (std::size_t j = 0; j < kElementSlots; ++j) {
      const double m = element.mass(static_cast<int>(i), static_cast<int>(j));
      M += m * Xi[i].transpose() * Xi[j];
      C_t += (m * is_place[j]) * Xi[i].transpose();
      body.mass += m * is_place[i] * is_place[j];
      body.S0 += (m * is_place[i]) * rho[j];
      body.J0 += m * rho[i] * rho[j].transpose();
    }
  body.M.add(e, M);
  const auto k = static_cast<std::size_t>(e);
  body.C_t[k] += C_t.topRows<kTwist>();
  body.C_t[k + 1] += C_t.bottomRows<kTwist>();
}

void add_block(const Eigen::Ref<const Eigen::MatrixXd>& block, SlotMasses::NodeBlock& sum) {
  Eigen::Map<Eigen::Matrix<double, kNodeSlots, kNodeSlots, Eigen::RowMajor>>(sum.data()) += block;
}

/// Adds an element's slots to those of the body: from the element's directions to those of B.
void add_slots(const BeamElement& element, int e, SlotMasses& slots) {
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(kElementSlots, kElementSlots);
  Eigen::VectorXd tangents = Eigen::VectorXd::Zero(kElementSlots);
  for (int node = 0; node < 2; ++node) {
    T.block<3, 3>(kNodeSlots * node + 1, kNodeSlots * node + 1) = element.axes.transpose();
    tangents[kNodeSlots * node + 1] = 1.0;
  }
  const Eigen::MatrixXd m = T.transpose() * element.mass * T;
  const auto k = static_cast<std::size_t>(e);
  add_block(m.topLeftCorner<kNodeSlots, kNodeSlots>(), slots.own[k]);
  add_block(m.bottomRightCorner<kNodeSlots, kNodeSlots>(), slots.own[k + 1]);
  add_block(m.topRightCorner<kNodeSlots, kNodeSlots>(), slots.next[k]);
  Eigen::Map<Eigen::RowVectorXd>(slots.stretch[k].data(), kElementSlots) =
      tangents.transpose() * element.mass * T;
  slots.stretch_own[k] = tangents.dot(element.mass * tangents);
}

/// Whether two slots of nodes are of one kind: places and x axes, y axes, or z axes.
bool is_one_kind(std::size_t a, std::size_t b) { return (a < 2 && b < 2) || a == b; }

bool are_decoupled(const SlotMasses& slots) {
  for (const auto* blocks : {&slots.own, &slots.next})
    for (const SlotMasses::NodeBlock& block : *blocks)
      for (std::size_t i = 0; i < kNodeSlots; ++i)
        for (std::size_t j = 0; j < kNodeSlots; ++j)
          if (!is_one_kind(i, j) && block[kNodeSlots * i + j] != 0.0) return false;
  for (const auto& row : slots.stretch)
    for (std::size_t j = 0; j < kElementSlots; ++j)
      if (!is_one_kind(0, j % kNodeSlots) && row[j] != 0.0) return false;
  return true;
}

bool is_decoupled(const TwistMatrix& m) {
  for (int i = 0; i < kTwist; ++i)
    for (int j = 0; j < kTwist; ++j)
      if (!is_one_direction(i, j) && m(i, j) != 0.0) return false;
  return true;
}

bool find_decoupled(const FlexibleBody& body) {
  return body.is_straight && are_decoupled(body.slots) &&
         std::all_of(body.beam.begin(), body.beam.end(), [](const BeamElement& element) {
           return is_decoupled(element.stiffness) && is_decoupled(element.damping);
         });
}

/// Whether small masses turn with the body.
bool has_inertias(const FlexibleBody& body) {
  return std::any_of(body.beam.begin(), body.beam.end(),
                     [](const BeamElement& element) { return !element.inertias.empty(); });
}

/// Makes a body of the right sizes, its sums still zero.
FlexibleBody make_empty_body(int elements) {
  assert(elements > 0);
  FlexibleBody body;
  body.elements = elements;
  const auto E = static_cast<std::size_t>(elements);
  body.slots.own.resize(E + 1);
  body.slots.next.resize(E);
  body.slots.stretch.resize(E);
  body.slots.stretch_own.resize(E);
  body.C_t.assign(E + 1, NodeMomentum::Zero());
  body.M = body.K = body.D = BlockTridiagonal(elements + 1);
  return body;
}

}  // namespace

int FlexibleBody::coordinate(int node, int component) const {
  assert(node >= 0 && node <= elements && component >= 0 && component < kTwist);
  if (reference_frame == ReferenceFrame::clamped)
    return node == 0 ? -1 : kTwist * (node - 1) + component;
  if (node == 0) return component < 4 ? -1 : component - 4;
  const int first = 2 + kTwist * (node - 1);
  if (node < elements) return first + component;
  if (component == 0) return first;
  return component < kRotation ? -1 : first + component - 2;
}

FlexibleBody make_beam_body(const Beam& beam, std::vector<double> stations,
                            ReferenceFrame reference_frame, std::vector<int> handles) {
  assert(!handles.empty() && handles.front() == 0);
  assert(std::all_of(handles.begin(), handles.end(),
                     [&](int node) { return node >= 0 && std::cmp_less(node, stations.size()); }));
  const BodyGeometry geometry = make_body_geometry(beam, std::move(stations));
  FlexibleBody body = make_empty_body(static_cast<int>(geometry.nodes.size()) - 1);
  body.reference_frame = reference_frame;
  body.pose = geometry.pose;
  body.nodes = geometry.nodes;
  body.stations = geometry.station;
  body.handles = std::move(handles);
  body.beam = make_beam_elements(beam, geometry);
  body.is_straight = beam.curve.is_straight();
  body.is_damped = beam.is_damped();
  for (int e = 0; e < body.elements; ++e) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    add_elastic(element, e, body);
    add_inertia(element, e, body);
    add_slots(element, e, body.slots);
  }
  if (beam.is_nonlinear) body.second_order = make_second_order(beam, geometry, body.beam);
  body.is_decoupled = !beam.is_nonlinear && find_decoupled(body);
  if (body.is_decoupled && !has_inertias(body))
    body.directions =
        make_directions({body.nodes, body.beam, body.slots, body.C_t, body.first_node()});
  return body;
}

std::vector<double> equal_stations(double from, double to, int elements) {
  assert(from < to && elements > 0);
  std::vector<double> stations;
  for (int k = 0; k < elements; ++k) stations.push_back(from + (to - from) * k / elements);
  stations.push_back(to);
  return stations;
}

}  // namespace spoke::space
