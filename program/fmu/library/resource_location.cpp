// URIs of files as RFC 8089 has them.

#include "program/fmu/library/resource_location.h"

#include <charconv>
#include <cstddef>
#include <string_view>

#include "models/error.h"

namespace spoke::fmu {
namespace {

/// Returns the text with the bytes that "%20" and the like stand for.
std::string decode(std::string_view text) {
  std::string decoded;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned char byte = 0;
    if (text[k] == '%' && k + 3 <= text.size()) {
      const char* digits = text.data() + k + 1;
      const auto read = std::from_chars(digits, digits + 2, byte, 16);
      if (read.ec == std::errc() && read.ptr == digits + 2) {
        decoded += static_cast<char>(byte);
        k += 2;
        continue;
      }
    }
    decoded += text[k];
  }
  return decoded;
}

}  // namespace

std::string path_of_location(const std::string& location) {
  std::string_view rest = location;
  if (rest.empty() || rest.starts_with('/')) return location;
  for (const std::string_view start : {"file://localhost/", "file:///", "file:/"}) {
    if (!rest.starts_with(start)) continue;
    rest.remove_prefix(start.size() - 1);
    if (rest.starts_with("//")) break;
    return decode(rest);
  }
  throw InputError("the location of the resources is \"" + location +
                   "\", expected a URI of a folder on this machine, file:///...");
}

}  // namespace spoke::fmu
