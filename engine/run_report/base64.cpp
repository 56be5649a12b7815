// Encodes three bytes as four letters.

#include "engine/run_report/base64.h"

#include <bit>
#include <string_view>
#include <vector>

namespace spoke::run_report {
namespace {

std::string encode_bytes(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) bits = bits << 8 | (i < count ? bytes[k + i] : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= count ? kLetters[bits >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

template <class Bits>
void append_bytes(Bits bits, std::vector<std::uint8_t>& bytes) {
  for (std::size_t i = 0; i < sizeof bits; ++i)
    bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 0xFFU));
}

}  // namespace

std::string encode(std::span<const float> numbers) {
  std::vector<std::uint8_t> bytes;
  for (const float number : numbers) append_bytes(std::bit_cast<std::uint32_t>(number), bytes);
  return encode_bytes(bytes);
}

std::string encode(std::span<const std::int16_t> numbers) {
  std::vector<std::uint8_t> bytes;
  for (const std::int16_t number : numbers) append_bytes(static_cast<std::uint16_t>(number), bytes);
  return encode_bytes(bytes);
}

}  // namespace spoke::run_report
