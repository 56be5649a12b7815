#pragma once

#include <string>

#include "models/error.h"

namespace spoke::test {

/// What the InputError says that `function` throws, or "no error".
template <class Function>
std::string message_of(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace spoke::test
