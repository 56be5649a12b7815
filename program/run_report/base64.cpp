// Encodes three bytes as four letters.

#include "program/run_report/base64.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace spoke::run_report {
namespace {

static_assert(std::endian::native == std::endian::little, "scripts read the lowest byte first");

/// Puts the four letters of three bytes' 24 bits.
[[gnu::always_inline]] inline void put_letters(std::uint32_t bits, char* letters) {
  constexpr const char* kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  letters[0] = kLetters[bits >> 18];
  letters[1] = kLetters[bits >> 12 & 63U];
  letters[2] = kLetters[bits >> 6 & 63U];
  letters[3] = kLetters[bits & 63U];
}

std::string encode_bytes(std::span<const std::byte> bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '\0');
  const auto byte = [data = bytes.data()](std::size_t k) {
    return std::to_integer<std::uint32_t>(data[k]);
  };
  const std::size_t rest = bytes.size() % 3, whole = bytes.size() - rest;
  char* letters = text.data();
  for (std::size_t k = 0; k < whole; k += 3, letters += 4)
    put_letters(byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2), letters);
  if (rest > 0) {
    put_letters(byte(whole) << 16 | (rest == 2 ? byte(whole + 1) << 8 : 0U), letters);
    std::fill(letters + rest + 1, letters + 4, '=');
  }
  return text;
}

}  // namespace

std::string encode(std::span<const float> numbers) { return encode_bytes(std::as_bytes(numbers)); }

std::string encode(std::span<const std::int16_t> numbers) {
  return encode_bytes(std::as_bytes(numbers));
}

}  // namespace spoke::run_report
