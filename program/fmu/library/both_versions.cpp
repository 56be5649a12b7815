// Checks the pointers of an importer, and asks its instance.

#include "program/fmu/library/both_versions.h"

#include <algorithm>
#include <string>
#include <vector>

#include "models/error.h"
#include "program/fmu/library/instance.h"

namespace spoke::fmu {

Answer set_logging(const void* handle, const char* function, bool is_on, std::size_t count,
                   const char* const categories[]) {
  return call(handle, function, [&](Instance& own) {
    require_pointers(count == 0 || categories, "categories");
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) names.push_back(text_or_empty(categories[k]));
    own.set_logging(is_on, names);
  });
}

Answer get_values(const void* handle, const char* function, const unsigned references[],
                  std::size_t count, double values[], std::size_t value_count) {
  return call(handle, function, [&](Instance& own) {
    if (value_count != count) throw InputError("expected a value for each reference");
    require_pointers(count == 0 || (references && values), "references or values");
    own.get({references, count}, {values, count});
  });
}

Answer set_values(const void* handle, const char* function, const unsigned references[],
                  std::size_t count, const double values[], std::size_t value_count) {
  return call(handle, function, [&](Instance& own) {
    if (value_count != count) throw InputError("expected a value for each reference");
    require_pointers(count == 0 || (references && values), "references or values");
    own.set({references, count}, {values, count});
  });
}

Answer save_state(const void* handle, const char* function, void** state) {
  return call(handle, function, [&](Instance& own) {
    require_pointers(state, "the place of the state");
    *state = own.save(*state);
  });
}

Answer go_back(const void* handle, const char* function, void* state) {
  return call(handle, function, [&](Instance& own) { own.go_back(state); });
}

Answer free_state(const void* handle, const char* function, void** state) {
  return call(handle, function, [&](Instance& own) {
    if (!state || !*state) return;
    own.forget(*state);
    *state = nullptr;
  });
}

Answer size_state(const void* handle, const char* function, void* state, std::size_t* size) {
  return call(handle, function, [&](Instance& own) {
    require_pointers(size, "the place of the size");
    *size = own.serialize(state).size();
  });
}

Answer serialize_state(const void* handle, const char* function, void* state, void* bytes,
                       std::size_t size) {
  return call(handle, function, [&](Instance& own) {
    require_pointers(bytes, "the place of the bytes");
    const std::string made = own.serialize(state, size);
    std::copy(made.begin(), made.end(), static_cast<char*>(bytes));
  });
}

Answer deserialize_state(const void* handle, const char* function, const void* bytes,
                         std::size_t size, void** state) {
  return call(handle, function, [&](Instance& own) {
    require_pointers(bytes && state, "the bytes or the place of the state");
    *state = own.deserialize({static_cast<const char*>(bytes), size});
  });
}

}  // namespace spoke::fmu
