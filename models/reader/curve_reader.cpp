// Compares the sizes of the two arrays.

#include "models/reader/curve_reader.h"

#include <iterator>
#include <string>

#include "models/count_text.h"

namespace spoke {

Curve read_curve(const TomlSection& section, std::string_view over, const Quantity& over_quantity,
                 std::string_view key, const Quantity& quantity) {
  const std::vector<double> places = section.increasing_numbers(over, over_quantity);
  const std::vector<double> values = section.numbers(key, quantity);
  if (values.size() != places.size()) {
    section.fail(key, "has " + counted(std::ssize(values), "number") + ", expected " +
                          std::to_string(places.size()) + ", one for each of " + section.path() +
                          '.' + std::string(over));
  }
  return {places, values};
}

}  // namespace spoke
