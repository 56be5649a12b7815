// Types of elements: a family, a number of nodes and letters for how they are integrated.

#include "models/solid/inp_elements.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace spoke::solid {
namespace {

using spatial::ElementKind;

// Of families of which one name begins another's the longer comes first.
constexpr std::array<std::string_view, 12> kFaceFamilies{
    "CPEG", "CPS", "CPE", "CAX", "STRI", "SFM3D", "M3D", "R3D", "DC2D", "DCAX", "DS", "S"};
constexpr std::array<std::string_view, 9> kLineFamilies{"T2D",   "T3D", "B2",  "B3", "PIPE",
                                                        "FRAME", "R2D", "RAX", "SAX"};
constexpr int kMostLineNodes = 4;  // with one of a beam's normal

/// Splits "10R" into 10 and its letters; false if it does not begin with a number or goes on with
/// others than letters.
bool split_number(std::string_view text, int& number, std::string_view& letters) {
  std::size_t digits = 0;
  number = 0;
  while (digits < text.size() && digits < 3 && text[digits] >= '0' && text[digits] <= '9')
    number = 10 * number + (text[digits++] - '0');
  letters = text.substr(digits);
  const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  return digits > 0 && letters.size() <= 4 &&
         std::all_of(letters.begin(), letters.end(), is_letter);
}

}  // namespace

InpElement find_inp_element(std::string_view type) {
  int number = 0;
  std::string_view letters;
  if (type.starts_with("C3D")) {
    if (!split_number(type.substr(3), number, letters)) return {};
    for (const ElementKind kind :
         {ElementKind::tet4, ElementKind::tet10, ElementKind::hex8, ElementKind::hex20})
      if (count_nodes(kind) == number) return {InpRole::volume, number, kind};
    return {};
  }
  for (const std::string_view family : kFaceFamilies) {
    if (!type.starts_with(family)) continue;
    if (!split_number(type.substr(family.size()), number, letters)) continue;
    if (number == 65) number = 6;  // STRI65: 5 degrees of freedom
    if (number == 3 || number == 4 || number == 6 || number == 8)
      return {InpRole::face, number, {}};
    return {};
  }
  for (const std::string_view family : kLineFamilies)
    if (type.starts_with(family)) return {InpRole::line, kMostLineNodes, {}};
  if (type == "MASS") return {InpRole::mass, 1, {}};
  return {};
}

}  // namespace spoke::solid
