// Lays out a body's work memory, and takes flex vectors apart by nodes.

#include "engine/bodies/space/body_data.h"

#include <algorithm>
#include <cassert>
#include <memory>

#include "engine/bodies/space/reduced_products.h"

namespace spoke::space {
namespace {

/// Hands out stretches of memory, each beginning at an even place.
class Places {
 public:
  explicit Places(double* memory) : memory_(memory) {}

  double* take(std::size_t count) {
    double* place = memory_ ? memory_ + used_ : nullptr;
    used_ += count + count % 2;
    return place;
  }
  template <class T>
  T* take_objects(std::size_t count) {
    static_assert(sizeof(T) % sizeof(double) == 0 && alignof(T) <= alignof(double));
    double* place = take(count * sizeof(T) / sizeof(double));
    if (!place) return nullptr;
    T* objects = reinterpret_cast<T*>(place);
    std::uninitialized_default_construct_n(objects, count);
    return objects;
  }
  std::size_t used() const { return used_; }

 private:
  double* memory_;
  std::size_t used_ = 0;
};

/// Places the memory that any body has for so many handles.
void place_port(std::size_t handles, Places& places, BodyWork& work) {
  work.handles = places.take_objects<HandleMotion>(handles);
  work.port.handles = static_cast<int>(handles);
  work.port.diagonal = places.take_objects<SymmetricTwistMatrix>(handles);
  work.port.pairs = places.take_objects<TwistMatrix>(
      static_cast<std::size_t>(tree::MultiPort<Space>::count_pairs(work.port.handles)));
  work.port.free = places.take_objects<Twist>(handles);
  work.wrenches = places.take_objects<Twist>(handles);
}

BodyWork place(const RigidBody& body, Places& places) {
  BodyWork work;
  place_port(body.outboard.size() + 1, places, work);
  return work;
}

BodyWork place(const FlexibleBody& body, Places& places) {
  const auto nodes = static_cast<std::size_t>(body.node_count());
  const std::size_t handles = body.handles.size();
  BodyWork work;
  work.rows = places.take(kNodeRows * nodes);
  work.half = places.take(kNodeRows * nodes);
  place_port(handles, places, work);
  work.condensed.X = places.take_objects<TwistMatrix>(handles);
  if (const std::size_t count = count_scratch(body); count > 0) work.scratch = places.take(count);
  return work;
}

BodyWork place(const Solid& body, Places& places) {
  const bool is_nodal = body.constants->nodal();
  const auto n = static_cast<std::size_t>(is_nodal ? 0 : body.coordinates());
  BodyWork work;
  work.rows = places.take(4 * n);
  work.half = places.take(4 * n);
  place_port(body.handles.size(), places, work);
  work.condensed.X = places.take_objects<TwistMatrix>(body.handles.size());
  work.scratch = places.take(count_scratch(body));
  return work;
}

/// Calls `visit(place by node, place in the flex vector, count)` for stretches of coordinates that
/// are neighbours in both.
template <class Visit>
void visit_stretches(const FlexibleBody& body, Visit&& visit) {
  const int E = body.elements;
  if (body.reference_frame == ReferenceFrame::clamped) return visit(kTwist, 0, kTwist * E);
  // These are ty and tz of node 0, all of the inner nodes and u of the last, then its rotation.
  visit(4, 0, 2 + kTwist * (E - 1) + 1);
  visit(kTwist * E + kRotation, kTwist * E - 3, 3);
}

}  // namespace

std::size_t count_work(const FlexibleBody& body) {
  Places places(nullptr);
  place(body, places);
  return places.used();
}

BodyWork place_work(const FlexibleBody& body, double* memory) {
  assert(memory && is_aligned(memory));
  Places places(memory);
  BodyWork work = place(body, places);
  std::fill_n(work.rows, kNodeRows * body.node_count(), 0.0);
  std::fill_n(work.half, kNodeRows * body.node_count(), 0.0);
  return work;
}

std::size_t count_work(const RigidBody& body) {
  Places places(nullptr);
  place(body, places);
  return places.used();
}

BodyWork place_work(const RigidBody& body, double* memory) {
  assert(memory && is_aligned(memory));
  Places places(memory);
  return place(body, places);
}

std::size_t count_scratch(const Solid& body) {
  if (body.constants->nodal()) return 0;
  const auto stride = static_cast<std::size_t>(padded_size(body.coordinates()));
  return kSolidVectors * stride;
}

std::size_t count_work(const Solid& body) {
  Places places(nullptr);
  place(body, places);
  return places.used();
}

BodyWork place_work(const Solid& body, double* memory) {
  assert(memory && is_aligned(memory));
  Places places(memory);
  return place(body, places);
}

void expand(const FlexibleBody& body, const double* flex, double* nodal) noexcept {
  const bool is_clamped = body.reference_frame == ReferenceFrame::clamped;
  std::fill_n(nodal, kTwist * (is_clamped ? 1 : body.node_count()), 0.0);
  visit_stretches(
      body, [&](int at, int first, int count) { std::copy_n(flex + first, count, nodal + at); });
}

void expand_element(const FlexibleBody& body, int element, const double* flex,
                    double* nodal) noexcept {
  assert(element >= 0 && element < body.elements);
  if (body.reference_frame == ReferenceFrame::clamped) {
    if (element > 0) {
      std::copy_n(flex + kTwist * (element - 1), 2 * kTwist, nodal);
      return;
    }
    std::fill_n(nodal, kTwist, 0.0);
    std::copy_n(flex, kTwist, nodal + kTwist);
    return;
  }
  for (int i = 0; i < 2 * kTwist; ++i) {
    const int at = body.coordinate(element + i / kTwist, i % kTwist);
    nodal[i] = at < 0 ? 0.0 : flex[at];
  }
}

void compress(const FlexibleBody& body, const double* nodal, double* flex) noexcept {
  visit_stretches(
      body, [&](int at, int first, int count) { std::copy_n(nodal + at, count, flex + first); });
}

}  // namespace spoke::space
