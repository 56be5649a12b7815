#pragma once

// What FMI 2.0 and 3.0 ask alike: values, states, categories of messages. `function` is the name
// under which errors are told.

#include <cstddef>

#include "program/fmu/library/answers.h"

namespace spoke::fmu {

Answer set_logging(const void* handle, const char* function, bool is_on, std::size_t count,
                   const char* const categories[]);

Answer get_values(const void* handle, const char* function, const unsigned references[],
                  std::size_t count, double values[], std::size_t value_count);
Answer set_values(const void* handle, const char* function, const unsigned references[],
                  std::size_t count, const double values[], std::size_t value_count);

/// Saves the state to where `state` points: a new one for a null pointer there, else in its place.
Answer save_state(const void* handle, const char* function, void** state);
Answer go_back(const void* handle, const char* function, void* state);
Answer free_state(const void* handle, const char* function, void** state);
Answer size_state(const void* handle, const char* function, void* state, std::size_t* size);
Answer serialize_state(const void* handle, const char* function, void* state, void* bytes,
                       std::size_t size);
Answer deserialize_state(const void* handle, const char* function, const void* bytes,
                         std::size_t size, void** state);

}  // namespace spoke::fmu
