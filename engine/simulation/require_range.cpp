// Words the refusal of a number.

#include "engine/simulation/require_range.h"

#include <string>

#include "models/count_text.h"
#include "models/error.h"

namespace spoke {

void require_range(const char* what, std::int64_t value, std::int64_t least,
                   std::int64_t greatest) {
  if (value < least || value > greatest)
    throw InputError(std::string(what) + " is " + std::to_string(value) + ", expected " +
                     range_text(least, greatest));
}

}  // namespace spoke
