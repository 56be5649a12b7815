#pragma once

// Hashes and checksums of bytes.

#include <cstdint>
#include <string_view>

#include "models/support/hash_bytes.h"

namespace spoke {

/// Returns CRC-32 of bytes behind those that have given `before`.
std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace spoke
