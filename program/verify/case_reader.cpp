// Reads cases and their figures, key by key.

#include "program/verify/case_reader.h"

#include <array>
#include <cmath>

#include "engine/modes.h"
#include "models/reader/toml_section.h"

namespace spoke::verify {
namespace {

using enum AnalysisKind;

constexpr Count kFirst{1, 10000};
constexpr Quantity kNumber = Quantity::any("");

std::string required_text(const TomlSection& section, std::string_view key, const char* expected) {
  std::string text = section.text(key, "");
  if (text.empty()) section.fail(key, std::string("is missing or empty, expected ") + expected);
  return text;
}

Figure read_figure(const TomlSection& section, const Analysis& analysis) {
  constexpr std::array kUsual = {"tip x", "frequency", "value", "power", "answer", "end"};
  Figure figure;
  figure.name = required_text(section, "name", "what the number is");
  figure.quantity = section.text("quantity", kUsual.at(static_cast<std::size_t>(analysis.kind)));
  figure.of = section.text("of", "");
  figure.number = section.integer("number", kFirst, 1);
  figure.at = section.number("at", Quantity::not_negative(""), 0.0);
  figure.exact = section.number("exact", kNumber);
  figure.unit = section.text("unit", "");
  if (factor_of_unit(figure.unit) == 0.0)
    section.fail_expected("unit", "one of those in program/verify/case.cpp: \"rad/s\", \"kN\"");
  figure.error = section.number("error", Quantity::positive(""));
  figure.scale = section.number("scale", Quantity::positive(""),
                                figure.exact == 0.0 ? 1.0 : std::abs(figure.exact));
  if (figure.exact == 0.0 && !section.has("scale"))
    section.fail("scale", "is missing, expected a number, since the exact value is 0");
  figure.times = section.number("times", kNumber, 1.0);
  return figure;
}

/// Refuses a key that only some analyses have.
void require_fitting_key(const TomlSection& section, std::string_view key, bool fits,
                         AnalysisKind kind) {
  if (section.has(key) && !fits)
    section.fail(key, "does not go with \"" + std::string(name_of(kind)) + '"');
}

void read_critical(const TomlSection& section, CriticalOptions& critical) {
  constexpr Count kPoints{2, 1000};
  critical.of = required_text(section, "vary", "\"speed\" or \"load=NAME\"");
  critical.from = section.number("from", kNumber, 0.0);
  critical.to = section.number("to", kNumber);
  critical.points = section.integer("points", kPoints, 21);
}

void read_performance(const TomlSection& section, PerformanceOptions& performance) {
  const auto list = [&](std::string_view key, std::string_view unit, std::vector<double>& values) {
    if (section.has(key)) values = section.numbers(key, Quantity::any(unit));
  };
  list("wind", "m/s", performance.wind);
  list("tip_speed_ratio", "", performance.tip_speed_ratio);
  list("pitch", "rad", performance.pitch);
  performance.is_rigid = section.flag("rigid", false);
}

Analysis read_analysis(const TomlSection& section) {
  constexpr std::array kKinds = {steady, modes, critical, performance, linearize, run};
  constexpr std::array kFrames = {ModeFrame::turning, ModeFrame::fixed, ModeFrame::floquet};
  TomlSection::Keys names;
  for (const AnalysisKind kind : kKinds) names.push_back(name_of(kind));
  Analysis analysis;
  const AnalysisKind kind = analysis.kind = kKinds.at(section.choice("analysis", names));
  for (const char* key : {"vary", "from", "to", "points"})
    require_fitting_key(section, key, kind == critical, kind);
  for (const char* key : {"wind", "tip_speed_ratio", "pitch", "rigid"})
    require_fitting_key(section, key, kind == performance, kind);
  for (const char* key : {"count", "frame"})
    require_fitting_key(section, key, kind == modes || kind == critical, kind);
  require_fitting_key(section, "speed", kind != run && kind != performance, kind);
  if (section.has("speed")) analysis.state.speed = section.number("speed", Quantity::any("rad/s"));
  if (section.has("count")) analysis.count = section.integer("count", kFirst);
  if (section.has("frame"))
    analysis.frame = kFrames.at(section.choice("frame", {"turning", "fixed", "floquet"}));
  if (kind == critical) read_critical(section, analysis.critical);
  if (kind == performance) read_performance(section, analysis.performance);
  return analysis;
}

Overrides read_overrides(const TomlSection& section) {
  Overrides overrides;
  if (!section.has("set")) return overrides;
  for (const TomlValue& value : section.values("set")) {
    const std::string* text = value.as_text();
    if (text == nullptr)
      section.fail_at("set." + std::to_string(overrides.size() + 1),
                      "is " + describe(value) + ", expected a text such as \"blade.bodies=8\"");
    overrides.push_back(*text);
  }
  return overrides;
}

Case read_case(const TomlSection& section, const std::string& group) {
  Case one;
  one.group = group;
  one.name = required_text(section, "name", "a word");
  one.title = required_text(section, "title", "a sentence");
  one.source = required_text(section, "source", "who published it");
  one.by = required_text(section, "by", "how the value was got");
  one.scenario = required_text(section, "scenario", "the name of a scenario");
  one.overrides = read_overrides(section);
  one.analysis = read_analysis(section);
  for (const TomlSection& figure : section.sections(
           "figure",
           {"name", "quantity", "of", "number", "at", "exact", "unit", "error", "scale", "times"}))
    one.figures.push_back(read_figure(figure, one.analysis));
  if (one.figures.empty())
    section.fail("figure", "is missing, expected a number to compare with, or several");
  return one;
}

}  // namespace

std::vector<Case> read_cases(const std::string& text, const std::string& name) {
  const TomlDocument document(text, name);
  const TomlSection root(document, {"group", "case"});
  const std::string group = required_text(root, "group", "a heading");
  std::vector<Case> cases;
  for (const TomlSection& section :
       root.sections("case", {"name", "title", "source", "by", "scenario", "set", "analysis",
                              "speed", "count", "frame", "vary", "from", "to", "points", "wind",
                              "tip_speed_ratio", "pitch", "rigid", "figure"}))
    cases.push_back(read_case(section, group));
  return cases;
}

}  // namespace spoke::verify
