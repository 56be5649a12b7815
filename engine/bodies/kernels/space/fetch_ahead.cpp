// Goes through the stretches of memory of a body.

#include "engine/bodies/kernels/space/fetch_ahead.h"

#include "engine/bodies/table/body_kind.h"
#include "engine/support/prefetch.h"

namespace spoke {
namespace {

/// Fetches the data of the bodies behind, and returns the next one if it has rows; else null.
const BodyData<Space>* find_next(const SubsystemData<Space>& data, std::size_t j) {
  if (!data.outgrows_cache || j + 2 >= data.bodies.size()) return nullptr;
  prefetch(&data.bodies[j + 2], sizeof data.bodies[j + 2]);
  const BodyData<Space>& next = data.bodies[j + 1];
  return next.kind->rows_of(next).empty() ? nullptr : &next;
}

/// Fetches the coordinates of a body with their history, which stand together.
void fetch_state(const BodyData<Space>& body) {
  constexpr std::size_t kVectors = 8;
  prefetch(body.coordinates.q,
           kVectors * sizeof(double) * static_cast<std::size_t>(body.layout.stride()));
}

/// Returns the bytes of the rows of a body, and of its half solutions.
std::size_t bytes_of_rows(const BodyData<Space>& body) {
  return body.kind->rows_of(body).size_bytes();
}

}  // namespace

void fetch_for_terms(const SubsystemData<Space>& data, std::size_t j) noexcept {
  const BodyData<Space>* next = find_next(data, j);
  if (!next) return;
  fetch_state(*next);
  const auto handles = static_cast<std::size_t>(next->work.port.handles);
  prefetch(next->work.rows, 2 * bytes_of_rows(*next));
  prefetch(next->work.handles, handles * sizeof(space::HandleMotion));
  prefetch(next->work.port.diagonal, handles * sizeof(space::SymmetricTwistMatrix));
  prefetch(next->work.condensed.X, handles * sizeof(space::TwistMatrix));
}

void fetch_for_recovery(const SubsystemData<Space>& data, std::size_t j) noexcept {
  const BodyData<Space>* next = find_next(data, j);
  if (!next) return;
  fetch_state(*next);
  const auto handles = static_cast<std::size_t>(next->work.port.handles);
  prefetch(next->work.half, bytes_of_rows(*next));
  prefetch(next->work.handles, handles * sizeof(space::HandleMotion));
  prefetch(next->work.condensed.X, handles * sizeof(space::TwistMatrix));
}

}  // namespace spoke
