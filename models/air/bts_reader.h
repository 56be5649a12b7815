#pragma once

// TurbSim's full-field binary files (.bts), identifiers 7 (one pass) and 8 (periodic).

#include <string>
#include <string_view>

#include "models/air/wind_box.h"

namespace spoke::air {

/// The largest file that is read.
inline constexpr std::size_t kLargestBts = std::size_t{1} << 30;

/// Reads the bytes of a file; `file` names it in messages. Points of a tower below the grid are
/// skipped. Throws InputError "file: byte 42: what is wrong, what is expected".
WindBox parse_bts(std::string_view bytes, const std::string& file);

}  // namespace spoke::air
