// Puts nouns into the plural by the rules that the words of this program follow.

#include "models/count_text.h"

namespace spoke {
namespace {

std::string plural_of(std::string_view noun) {
  constexpr std::string_view kVowels = "aeiou";
  const std::string stem(noun);
  const bool ends_in_y = noun.size() > 1 && noun.back() == 'y' &&
                         kVowels.find(noun[noun.size() - 2]) == std::string_view::npos;
  if (ends_in_y) return stem.substr(0, stem.size() - 1) + "ies";
  for (const std::string_view hissing : {"s", "x", "ch", "sh"})
    if (noun.ends_with(hissing)) return stem + "es";
  return stem + 's';
}

}  // namespace

std::string counted(std::int64_t number, std::string_view noun) {
  return std::to_string(number) + ' ' + (number == 1 ? std::string(noun) : plural_of(noun));
}

std::string range_text(std::int64_t first, std::int64_t last) {
  if (last < first) return "none";
  if (last == first) return std::to_string(first);
  return std::to_string(first) + " to " + std::to_string(last);
}

}  // namespace spoke
