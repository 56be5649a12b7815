#pragma once

#include <doctest/doctest.h>

#include <string>

namespace spoke::test {

/// Returns the text with `to` in place of `from`, which it has.
inline std::string exchange(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace spoke::test
