#include "models/solid/made_constants.h"

#include <algorithm>
#include <chrono>

namespace spoke::solid {
namespace {

/// Makes constants, and measures how long that takes.
MadeConstants make_and_measure(const spatial::SolidBody& body, const SolidGeometry& at_rest,
                               const LoadedSets& sets, const Control& control, bool anew) {
  const auto start = std::chrono::steady_clock::now();
  MadeConstants made;
  made.cache.reads = !anew;
  made.constants = make_constants(body, at_rest, sets, control, &made.cache);
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return made;
}

}  // namespace

MadeConstants ConstantsShelf::find_or_make(const spatial::SolidBody& body,
                                           const SolidGeometry& at_rest, const LoadedSets& sets,
                                           const Control& control, bool anew) {
  const std::lock_guard lock(mutex_);
  const auto at = std::find_if(made_.begin(), made_.end(),
                               [&](const auto& made) { return made.first == sets; });
  if (at != made_.end() && !anew) return at->second;
  MadeConstants made = make_and_measure(body, at_rest, sets, control, anew);
  if (at == made_.end()) return made_.emplace_back(sets, std::move(made)).second;
  return at->second = std::move(made);
}

}  // namespace spoke::solid
