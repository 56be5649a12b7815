#include "tests/program/report/xml.h"

#include <algorithm>
#include <array>
#include <regex>
#include <vector>

namespace {

bool has_stray_letters(const std::string& text) {
  static const std::regex kEntity("&(amp|lt|gt|quot|#39);");
  const std::string rest = std::regex_replace(text, kEntity, "");
  return rest.find_first_of("&<>") != std::string::npos;
}

}  // namespace

std::string xml_fault(std::string_view text) {
  static const std::regex kTag(R"re(<(/?)([a-zA-Z][\w:-]*)((?:\s+[\w:-]+="[^"<]*")*)\s*(/?)>)re");
  std::vector<std::string> open;
  const std::string all(text);
  std::size_t end = 0;
  for (std::sregex_iterator tag(all.begin(), all.end(), kTag), none; tag != none; ++tag) {
    const auto begin = static_cast<std::size_t>(tag->position());
    if (has_stray_letters(all.substr(end, begin - end))) return "stray letter before " + tag->str();
    if (has_stray_letters((*tag)[3].str())) return "stray letter in " + tag->str();
    end = begin + static_cast<std::size_t>(tag->length());
    const std::string name = (*tag)[2].str();
    if ((*tag)[1].length() > 0) {
      if (open.empty() || open.back() != name) return "unexpected end of " + name;
      open.pop_back();
    } else if ((*tag)[4].length() == 0) {
      open.push_back(name);
    }
  }
  if (has_stray_letters(all.substr(end))) return "stray letter at the end";
  return open.empty() ? "" : open.back() + " does not end";
}

int count_of(std::string_view text, std::string_view part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}
