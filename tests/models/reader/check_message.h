#pragma once

#include <doctest/doctest.h>

#include <string>

namespace spoke::test {

/// Checks that an error has this message, in one line.
inline void check_message(const std::string& message, const std::string& expected) {
  CHECK(message == expected);
  CHECK(message.find('\n') == std::string::npos);
}

}  // namespace spoke::test
