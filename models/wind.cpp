// Compares descriptions of wind, and names their choices.

#include "models/wind.h"

#include <array>
#include <cstddef>

namespace spoke {
namespace {

bool is_same(const std::optional<Curve>& a, const std::optional<Curve>& b) {
  if (!a || !b) return !a && !b;
  return a->times() == b->times() && a->values() == b->values();
}

}  // namespace

bool operator==(const Wind& a, const Wind& b) {
  return a.velocity == b.velocity && is_same(a.speed, b.speed) && a.file == b.file &&
         a.shear_exponent == b.shear_exponent && a.vertical_shear == b.vertical_shear &&
         a.horizontal_shear == b.horizontal_shear && a.reference_height == b.reference_height &&
         a.up == b.up && a.ground == b.ground && a.gusts == b.gusts &&
         a.turbulence == b.turbulence && a.by_program == b.by_program && a.field == b.field;
}

std::string_view name_of(GustShape shape) {
  constexpr std::array<std::string_view, 3> names{"one_minus_cosine", "operating", "rise"};
  return names[static_cast<std::size_t>(shape)];
}

std::string_view name_of(GustOf of) {
  constexpr std::array<std::string_view, 4> names{"speed", "direction", "vertical_shear",
                                                  "horizontal_shear"};
  return names[static_cast<std::size_t>(of)];
}

std::string_view name_of(TurbulenceSpectrum) { return "kaimal"; }

std::string_view name_of(TurbulenceScale scale) {
  return scale == TurbulenceScale::centre ? "centre" : "none";
}

std::string_view name_of(Coherence coherence) {
  return coherence == Coherence::longitudinal ? "longitudinal" : "all";
}

}  // namespace spoke
