// The list of formulations, and their names.

#include "engine/formulation.h"

#include <array>
#include <string>

#include "models/error.h"

namespace spoke {

std::span<const Formulation> formulations() {
  static constexpr std::array kAll{Formulation::structured, Formulation::subsystem,
                                   Formulation::augmented};
  return kAll;
}

std::string_view name_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::structured:
      return "structured";
    case Formulation::subsystem:
      return "subsystem";
    case Formulation::augmented:
      break;
  }
  return "augmented";
}

Formulation formulation_of(std::string_view name) {
  std::string names;
  for (const Formulation formulation : formulations()) {
    if (name == name_of(formulation)) return formulation;
    names += (names.empty() ? "\"" : ", \"") + std::string(name_of(formulation)) + '"';
  }
  throw InputError("formulation: \"" + std::string(name) + "\", expected one of " + names,
                   {.key = "formulation"});
}

}  // namespace spoke
