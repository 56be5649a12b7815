#include "models/space/body.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>

namespace spoke::space {

double Body::mass() const {
  if (const FlexibleBody* body = flexible()) return body->mass;
  return rigid() ? rigid()->mass : solid()->constants->mass;
}

int Body::handle_count() const {
  if (const FlexibleBody* body = flexible()) return static_cast<int>(body->handles.size());
  return static_cast<int>(rigid() ? 1 + rigid()->outboard.size() : solid()->handles.size());
}

Position Body::handle_at_rest(std::size_t handle) const {
  assert(handle < static_cast<std::size_t>(handle_count()));
  if (const FlexibleBody* body = flexible())
    return body->nodes[static_cast<std::size_t>(body->handles[handle])];
  if (const Solid* body = solid()) return body->handle(handle).p;
  return handle == 0 ? Position(Position::Zero()) : rigid()->outboard[handle - 1];
}

int Body::coordinates() const {
  if (const FlexibleBody* body = flexible()) return body->coordinates();
  return solid() ? solid()->coordinates() : 0;
}

double Body::extent() const {
  if (const FlexibleBody* body = flexible()) return body->length();
  return solid() ? solid()->constants->extent : std::numeric_limits<double>::infinity();
}

double Body::coordinate_limit() const {
  return solid() ? solid()->constants->least_limit : std::min(extent(), std::numbers::pi);
}

}  // namespace spoke::space
