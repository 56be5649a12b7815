#pragma once

#include <string>

#include "models/error.h"

namespace spoke::test {

/// Returns the text of the error of this type (an InputError) that `function` throws, or "no
/// error".
template <class Thrown = InputError, class Function>
std::string message_of(const Function& function) {
  try {
    function();
  } catch (const Thrown& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace spoke::test
