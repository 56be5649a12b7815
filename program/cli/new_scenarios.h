#pragma once

// Commented scenarios to begin with, from models/templates.

#include <array>
#include <string_view>

namespace spoke::cli {

/// A file of a template, in which NAME stands for the name of the scenario.
struct TemplateFile {
  std::string_view ending;  ///< ".toml"
  std::string_view text;
};

/// A scenario to begin with.
struct Template {
  std::string_view kind;  ///< "rotor"
  std::string_view about;
  TemplateFile scenario;
  TemplateFile mesh{};  ///< empty: there is none
};

const std::array<Template, 5>& templates();

}  // namespace spoke::cli
