// Calculates positions, velocities and tensions along a blade from the coordinates of its bodies.

#include "engine/shape.h"

#include <array>
#include <cmath>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/plane/nonlinear_strain.h"

namespace spoke {
namespace {

/// Returns the coordinates u, v, psi of a node, or their rates.
std::array<double, kTwist> node_values(const BodyData<Plane>& body, int node, const double* flex) {
  std::array<double, kTwist> values;
  for (int c = 0; c < kTwist; ++c)
    values[c] = flex[body.layout.offset(body.model->body->coordinate(node, c))];
  return values;
}

/// Returns int a'(x) b'(x) dx over one element of length l, for Hermite deflections a and b.
double integrate_slopes(double l, const std::array<double, kTwist>& a1,
                        const std::array<double, kTwist>& a2, const std::array<double, kTwist>& b1,
                        const std::array<double, kTwist>& b2) {
  const double a = a2[1] - a1[1], b = b2[1] - b1[1];
  const double turned = a * (b1[2] + b2[2]) + b * (a1[2] + a2[2]);
  const double own = 4.0 * (a1[2] * b1[2] + a2[2] * b2[2]) - a1[2] * b2[2] - a2[2] * b1[2];
  return (36.0 * a * b / l - 3.0 * turned + l * own) / 30.0;
}

/// Reduction of places and velocities by foreshortening, in the hub frame.
struct Offset {
  Position p = Position::Zero();
  Position v = Position::Zero();
};

/// Walks along one body, node by node.
class BodyWalk {
 public:
  /// `turned`: the frame of the body from that of the undeformed blade.
  BodyWalk(const BodyData<Plane>& body, const plane::Pose& pose, const plane::Rotation& turned,
           const Twist& twist, const Offset& before)
      : body_(body),
        pose_(pose),
        angle_(std::atan2(turned.sine, turned.cosine)),
        twist_(twist),
        before_(before) {}

  /// Returns place and velocity of a node. Must be called for nodes in order from 0.
  ShapeNode node(int k) {
    const auto q = node_values(body_, k, body_.coordinates.q);
    const auto v = node_values(body_, k, body_.coordinates.v);
    const double l = element_length();
    if (k > 0 && body_.model->stiffening.slope_integral) {
      shortening_ += 0.5 * integrate_slopes(l, last_q_, q, last_q_, q);
      shortening_rate_ += integrate_slopes(l, last_q_, q, last_v_, v);
    }
    stretch_ = q[0] - last_q_[0];
    turn_ = q[2] - last_q_[2];
    last_q_ = q;
    last_v_ = v;
    const Position s{k * l + q[0], q[1]};
    const Position rate =
        Position(twist_.head<kPosition>()) + speed() * quarter_turn(s) + Position{v[0], v[1]};
    const Offset off = offset();
    ShapeNode node;
    node.p = pose_.p + pose_.R * s - off.p;
    node.velocity = pose_.R * rate - off.v;
    node.angle = angle_ + q[2];
    return node;
  }
  /// Returns the stretch of the element before the last node [m].
  double stretch() const { return stretch_; }
  /// Returns the angle by which this element bends [rad].
  double turn() const { return turn_; }
  double element_length() const { return body_.model->body->length / body_.model->body->elements; }
  /// Returns the offset of the last node.
  Offset offset() const {
    const Position shortened{shortening_, 0.0}, rate{shortening_rate_, 0.0};
    return {before_.p + pose_.R * shortened,
            before_.v + pose_.R * Position(rate + speed() * quarter_turn(shortened))};
  }

 private:
  double speed() const { return twist_[kRotation]; }

  const BodyData<Plane>& body_;
  const plane::Pose& pose_;
  double angle_;
  const Twist& twist_;
  Offset before_;
  std::array<double, kTwist> last_q_{}, last_v_{};
  double shortening_ = 0.0, shortening_rate_ = 0.0, stretch_ = 0.0, turn_ = 0.0;
};

/// Returns the mean EA of an element [N].
double mean_axial_stiffness(const Blade& blade, const plane::FlexibleBody& body, int element) {
  if (body.pieces.empty()) return blade.youngs_modulus * blade.area;
  const double l = body.length / body.elements;
  return mean_axial_stiffness(body.pieces, element * l, (element + 1) * l);
}

/// Returns EI in the middle of an element [N m^2].
double bending_stiffness(const Blade& blade, const plane::FlexibleBody& body, int element) {
  if (body.pieces.empty()) return blade.youngs_modulus * blade.second_moment;
  const double middle = (element + 0.5) * body.length / body.elements;
  const plane::BeamPiece& piece = piece_at(body.pieces, middle);
  return piece.at(piece.bending_stiffness, middle);
}

}  // namespace

void calc_shape(const Blade& blade, const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data,
                BladeShape& shape) {
  update_kinematics(subsystem, data);
  calc_poses(subsystem, data, data.poses);
  shape.bodies = blade.bodies;
  shape.elements = blade.elements;
  shape.nodes.clear();
  shape.axial_forces.clear();
  shape.bending_moments.clear();
  Offset offset;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const plane::FlexibleBody& body = *data.bodies[j].model->body;
    const plane::Rotation turned = subsystem.root.R.inverse() * data.poses[j].R;
    BodyWalk walk(data.bodies[j], data.poses[j], turned, data.twists[j], offset);
    const ShapeNode first = walk.node(0);
    if (j == 0) shape.nodes.push_back(first);
    for (int k = 1; k <= blade.elements; ++k) {
      shape.nodes.push_back(walk.node(k));
      const double l = walk.element_length();
      const double stretch =
          has_nonlinear_strain(data.bodies[j])
              ? calc_strain(body, data.bodies[j].layout, k - 1, data.bodies[j].coordinates.q)[0]
              : walk.stretch();
      shape.axial_forces.push_back(mean_axial_stiffness(blade, body, k - 1) * stretch / l);
      shape.bending_moments.push_back(bending_stiffness(blade, body, k - 1) * walk.turn() / l);
    }
    offset = walk.offset();
  }
  const auto count = static_cast<double>(shape.axial_forces.size());
  for (std::size_t k = 0; k < shape.nodes.size(); ++k) {
    const Position along{subsystem.length * (static_cast<double>(k) / count), 0.0};
    shape.nodes[k].displacement = shape.nodes[k].p - (subsystem.root.p + subsystem.root.R * along);
  }
}

}  // namespace spoke
