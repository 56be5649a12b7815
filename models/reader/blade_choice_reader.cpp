// Reads a number or a word.

#include "models/reader/blade_choice_reader.h"

namespace spoke {

BladeChoice read_blade(const TomlSection& section, std::size_t blades) {
  if (!section.has("blade")) return BladeChoice::all();
  if (section.is_text("blade")) {
    section.choice("blade", {"all"});
    return BladeChoice::all();
  }
  return BladeChoice::number(section.integer("blade", {1, static_cast<int>(blades)}));
}

}  // namespace spoke
