#pragma once

// The constants of a solid, made once for a description and all its copies.

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "models/solid/solid.h"

namespace spoke::solid {

/// Constants, and how they were come by.
struct MadeConstants {
  std::shared_ptr<const space::SolidConstants> constants;
  CacheUse cache;
  double seconds = 0.0;  ///< wall time that it took to make or to read them [s]
};

/// Constants of one description, by the sets that loads act on.
class ConstantsShelf {
 public:
  /// Returns what was made before with these sets, or else makes it; threads that ask meanwhile
  /// wait for it. `anew`: makes it in any case, without the cache.
  MadeConstants find_or_make(const spatial::SolidBody& body, const SolidGeometry& at_rest,
                             const LoadedSets& sets, const Control& control, bool anew);

 private:
  std::mutex mutex_;
  std::vector<std::pair<LoadedSets, MadeConstants>> made_;
};

}  // namespace spoke::solid
