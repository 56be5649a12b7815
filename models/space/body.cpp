#include "models/space/body.h"

#include <limits>

namespace spoke::space {

double Body::extent() const {
  return flexible() ? flexible()->length() : std::numeric_limits<double>::infinity();
}

}  // namespace spoke::space
