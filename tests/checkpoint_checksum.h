#pragma once

// The checksum of a checkpoint, for tests that change one.

#include <cstddef>
#include <cstdint>
#include <string>

namespace spoke::test {

/// Returns the bytes of a checkpoint with a checksum that fits them: a CRC-32, calculated bit by
/// bit, unlike in the engine.
inline std::string with_fitting_checksum(std::string bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t k = 0; k + 4 < bytes.size(); ++k) {
    crc ^= static_cast<unsigned char>(bytes[k]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc % 2 != 0 ? 0xEDB88320 : 0);
  }
  for (std::size_t k = 0; k < 4; ++k)
    bytes[bytes.size() - 4 + k] = static_cast<char>(~crc >> (8 * k) & 0xFF);
  return bytes;
}

}  // namespace spoke::test
