#include "models/tree/axle_carrier.h"

#include <cassert>
#include <charconv>
#include <string_view>

namespace spoke::spatial {
namespace {

constexpr std::string_view kBlade = "blade ";

}  // namespace

std::string name_of_blade(std::size_t number) {
  return std::string(kBlade) + std::to_string(number);
}

int find_blade_of(const Axle& axle) {
  if (!axle.subsystem.starts_with(kBlade)) return 0;
  const std::string_view digits = std::string_view(axle.subsystem).substr(kBlade.size());
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::vector<int> find_rotors_on(const Model& model, const Blade& blade) {
  const Blade* const first = model.blades.data();
  assert(&blade >= first && &blade < first + model.blades.size());
  return find_rotors_on(model, name_of_blade(static_cast<std::size_t>(&blade - first) + 1));
}

std::size_t find_tip_body(const Tree& tree) {
  std::size_t tip = tree.bodies.size() - 1;
  if (tree.name == kSupportName) return tip;
  while (tip > 0 && (tree.bodies[tip].is_hub() || tree.bodies[tip].is_generator())) --tip;
  return tip;
}

}  // namespace spoke::spatial
