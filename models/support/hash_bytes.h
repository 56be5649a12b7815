#pragma once

// The hash of bytes.

#include <cstddef>
#include <cstdint>

namespace spoke {

/// Returns FNV-1a of 64 bits, of `size` bytes behind those that have given `value`.
inline std::uint64_t hash_bytes(const void* first, std::size_t size,
                                std::uint64_t value = 14695981039346656037u) {
  constexpr std::uint64_t kPrime = 1099511628211u;
  const auto* bytes = static_cast<const unsigned char*>(first);
  for (std::size_t k = 0; k < size; ++k) value = (value ^ bytes[k]) * kPrime;
  return value;
}

}  // namespace spoke
