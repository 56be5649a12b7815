#pragma once

// Licences that go with an FMU. Their texts become part of the program when it is built.

#include <string_view>

namespace spoke::fmu {

/// Returns the licence of Spoke.
std::string_view licence_text();
/// Returns what is said of the other libraries whose code is in an FMU.
std::string_view third_party_licences();

}  // namespace spoke::fmu
