// Conditions of events, and their names.

#include "models/event.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace spoke {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::optional<EventCondition> parse_condition(const std::string& when) {
  const std::size_t sign = when.find_first_of("<>");
  if (sign == std::string::npos) return std::nullopt;
  EventCondition condition{trimmed(when.substr(0, sign)), when[sign] == '>'};
  std::istringstream stream(when.substr(sign + 1));
  stream.imbue(std::locale::classic());
  if (condition.sensor.empty() || !(stream >> condition.limit) || !(stream >> std::ws).eof() ||
      !std::isfinite(condition.limit))
    return std::nullopt;
  return condition;
}

std::string name_of_event(const Event& event, std::size_t index) {
  return event.name.empty() ? "event " + std::to_string(index + 1) : event.name;
}

}  // namespace spoke
