// A beam in pictures: its nodes with their foreshortening, and the forces of its elements.

#include <array>

#include "engine/bodies/kernels/space/body_shape.h"
#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/nonlinear_strain.h"

namespace spoke {
namespace {

/// Coordinates of both nodes of an element, in the frame B of the body.
struct ElementFlex {
  std::array<double, 2 * space::kTwist> values;

  ElementFlex(const space::FlexibleBody& body, int element, const double* flex) : values{} {
    for (int node = 0; node < 2; ++node)
      for (int c = 0; c < space::kTwist; ++c) {
        const int at = body.coordinate(element + node, c);
        if (at >= 0) values[static_cast<std::size_t>(space::kTwist * node + c)] = flex[at];
      }
  }
  /// Returns (v, tz) of both nodes in the axes of the element, or (w, -ty).
  Eigen::Vector4d bending(const space::BeamElement& element, int direction) const {
    Eigen::Vector4d x;
    for (int node = 0; node < 2; ++node) {
      const double* q = values.data() + space::kTwist * node;
      const space::Position u(q[0], q[1], q[2]), th(q[3], q[4], q[5]);
      const double slope =
          direction == 1 ? element.axes.col(2).dot(th) : -element.axes.col(1).dot(th);
      x.segment<2>(2 * node) << element.axes.col(direction).dot(u), slope;
    }
    return x;
  }
};

/// Returns int (a' b') dx over an element, across it in both directions [m].
double integrate_slopes(const space::BeamElement& element, const ElementFlex& a,
                        const ElementFlex& b) {
  double sum = 0.0;
  for (const int direction : {1, 2})
    sum += a.bending(element, direction)
               .dot(element.stiffening.bending[0] * b.bending(element, direction));
  return sum;
}

/// Returns the load in the middle of an element, in its axes.
space::Twist calc_forces(const space::FlexibleBody& body, int e, const double* flex,
                         const ElementFlex& q) {
  const space::BeamElement& element = body.beam[static_cast<std::size_t>(e)];
  space::Twist d, outer;
  if (body.is_nonlinear())
    d = calc_strain(body, e, flex);
  else
    calc_relative(element, q.values.data(), d.data());
  space::multiply(element.stiffness.data(), d.data()).store_to(outer.data());
  const space::Position force = element.axes.transpose() * space::Position(linear(outer));
  const space::Position moment =
      element.axes.transpose() *
      space::Position(space::Position(angular(outer)) +
                      0.5 * cross(element.chord, space::Position(linear(outer))));
  return space::make_twist(force, moment);
}

/// Returns the motion of a node from its coordinates and their rates.
space::HandleMotion node_motion(const double* q, const double* v, const space::Position& place) {
  return {place + space::Position(q[0], q[1], q[2]), space::Position(v[0], v[1], v[2]),
          space::calc_rotation_vector_motion({q[3], q[4], q[5]}, {v[3], v[4], v[5]})};
}

}  // namespace

void BeamKind::add_shape(const Data& body, space::BodyShape& shape) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  const double *q = body.coordinates.q, *v = body.coordinates.v;
  double shortening = 0.0, rate = 0.0;
  for (int k = 0; k <= beam.elements; ++k) {
    const int e = std::max(0, k - 1);
    const space::BeamElement& element = beam.beam[static_cast<std::size_t>(e)];
    const ElementFlex flex(beam, e, q), speed(beam, e, v);
    if (k > 0) {
      shape.forces.push_back(calc_forces(beam, e, q, flex));
      if (body.model->stiffening) {
        shortening += 0.5 * integrate_slopes(element, flex, flex);
        rate += integrate_slopes(element, flex, speed);
      }
    }
    const std::size_t at = k == 0 ? 0 : space::kTwist;
    const space::Position& place = beam.nodes[static_cast<std::size_t>(k)];
    shape.nodes.push_back({beam.pose.R,
                           place,
                           node_motion(flex.values.data() + at, speed.values.data() + at, place),
                           {shortening, 0.0, 0.0},
                           {rate, 0.0, 0.0}});
  }
}

std::size_t BeamKind::node_of_handle(const space::Body& body, std::size_t handle) const {
  return static_cast<std::size_t>(body.flexible()->handles[handle]);
}

}  // namespace spoke
