// Checks the letters of names.

#include "models/reader/names.h"

#include <algorithm>
#include <cstddef>

namespace spoke {

bool is_name(const std::string& text) {
  constexpr std::size_t longest = 64;
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '.';
         });
}

std::string find_load_name_fault(const std::string& name) {
  if (name == kGravityName) return "is \"gravity\", the name of [gravity], expected another one";
  if (name.empty() || is_name(name)) return {};
  return "is \"" + name + "\", expected " + kNameExpected;
}

}  // namespace spoke
