#pragma once

// Numbers as files and the terminal show them.

namespace spoke {

/// Returns the number, but no zero with a sign: "-0" says nothing.
inline double plain_zero(double number) { return number + 0.0; }

}  // namespace spoke
