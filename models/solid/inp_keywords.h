#pragma once

// What the keywords of .inp files that no reader takes mean for a mesh.

#include <string_view>

namespace spoke::solid {

/// What becomes of a keyword that is not read.
enum class InpMeaning {
  harmless,   ///< says nothing of a linear, isotropic body
  left_out,   ///< says something that a solid has in another way: passed over, and told
  not_built,  ///< makes another body of it: refused
};
struct InpKeywordMeaning {
  InpMeaning meaning = InpMeaning::left_out;
  const char* instead = "";  ///< of what is not built: what to do
};

/// Returns what a keyword means, by its name in capitals without blanks: "SHELLSECTION". One that
/// is not known is left out, in a step harmless.
InpKeywordMeaning find_inp_meaning(std::string_view key, bool is_in_step);

}  // namespace spoke::solid
