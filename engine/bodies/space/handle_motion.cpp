// Calculates handles from the coordinates of their nodes.

#include "engine/bodies/space/handle_motion.h"

#include <cassert>

namespace spoke::space {
namespace {

HandleMotion calc_handle(const FlexibleBody& body, int node, const double* q, const double* v) {
  assert(node >= body.first_node() && node < body.node_count());
  Twist place = Twist::Zero(), rate = Twist::Zero();
  for (int c = 0; c < kTwist; ++c)
    if (const int at = body.coordinate(node, c); at >= 0) {
      place[c] = q[at];
      rate[c] = v[at];
    }
  return {body.nodes[static_cast<std::size_t>(node)] + linear(place), linear(rate),
          calc_rotation_vector_motion(angular(place), angular(rate))};
}

}  // namespace

Twist HandleMotion::bias(const Angular& w) const {
  return make_twist(cross(w, cross(w, s) + 2.0 * velocity),
                    cross(w, turn.velocity) + turn.convective);
}

void calc_handles(const FlexibleBody& body, const double* q, const double* v,
                  HandleMotion* handles) noexcept {
  // A handle inboard of the first node is the section in which the frame is clamped.
  for (const int node : body.handles)
    *handles++ = node < body.first_node() ? make_fixed_handle(Position::Zero())
                                          : calc_handle(body, node, q, v);
}

HandleMotion make_fixed_handle(const Position& s) noexcept {
  return {s, Position::Zero(), {{}, Matrix3::Identity(), Angular::Zero(), Angular::Zero()}};
}

}  // namespace spoke::space
