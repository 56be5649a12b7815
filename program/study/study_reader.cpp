// Reads the top of a study file: scenario, design, and the number of runs.

#include "program/study/study_reader.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "models/count_text.h"
#include "models/error.h"
#include "models/text_file.h"
#include "program/study/load_cases.h"
#include "program/study/parameter_reader.h"
#include "program/study/response_reader.h"
#include "program/study/sampling.h"
#include "program/study/sobol_sequence.h"
#include "program/study/table_reader.h"

namespace spoke::study {
namespace {

namespace fs = std::filesystem;

constexpr Count kRuns{1, static_cast<int>(kMostRuns)};
constexpr Count kSeeds{0, std::numeric_limits<int>::max()};

/// Returns the path of a file that the study names, relative to the folder of the study.
std::string beside(const std::string& study, const std::string& name) {
  const fs::path file = fs::path(study).parent_path() / name, shorter = file.lexically_normal();
  std::error_code error;  // since ".." behind a link is another folder
  return fs::equivalent(file, shorter, error) ? shorter.string() : file.string();
}

/// Refuses keys that only other kinds of design have.
void require_fitting_keys(const TomlSection& section, DesignKind kind) {
  const auto allow = [&](std::string_view key, bool is_allowed, const char* expected) {
    if (section.has(key) && !is_allowed)
      section.fail(key,
                   "does not go with \"" + std::string(name_of(kind)) + "\", expected " + expected);
  };
  using K = DesignKind;
  const bool is_sobol = kind == K::sobol || kind == K::saltelli;
  allow("runs", kind == K::latin_hypercube || kind == K::sobol,
        kind == K::saltelli ? "\"points\": there are as many runs for each as parameters, and 2"
                            : "none: the values say how many runs there are");
  allow("points", kind == K::saltelli, "it with \"saltelli\" alone");
  allow("seed", kind == K::latin_hypercube || is_sobol, "none: nothing is random");
  allow("scramble", is_sobol, "it with \"sobol\" and \"saltelli\" alone");
  allow("file", kind == K::table, "it with \"table\" alone");
}

Design read_design(const TomlSection& root, const std::string& file) {
  if (!root.has("design"))
    root.fail("design", "is missing, expected a table such as { kind = \"sobol\", runs = 256 }");
  const TomlSection section =
      root.section("design", {"kind", "runs", "points", "seed", "scramble", "file"});
  using K = DesignKind;
  constexpr std::array kinds = {K::grid, K::latin_hypercube, K::sobol, K::saltelli, K::table};
  TomlSection::Keys names;
  for (const K kind : kinds) names.push_back(name_of(kind));
  Design design;
  design.kind = kinds[section.choice("kind", names)];
  require_fitting_keys(section, design.kind);
  if (design.kind == K::latin_hypercube || design.kind == K::sobol)
    design.runs = section.integer("runs", kRuns);
  if (design.kind == K::saltelli) design.points = section.integer("points", kRuns);
  design.seed = static_cast<std::uint64_t>(section.integer("seed", kSeeds, 0));
  design.is_scrambled = section.flag("scramble", true);
  if (design.kind == K::table) {
    const std::string table = section.text("file", "");
    if (table.empty()) section.fail("file", "is missing, expected the name of a CSV file");
    design.table = beside(file, table);
  }
  return design;
}

/// Reads the statistics that are kept of each run; those of load cases begin where runs count.
std::optional<StatisticsPlan> read_statistics(const TomlSection& root,
                                              const std::optional<LoadCases>& cases) {
  if (!root.has("statistics") && !cases) return {};
  const TomlSection section =
      root.section("statistics", {"sensors", "exponents", "from", "cycles"});
  constexpr std::size_t kMostExponents = 20;
  StatisticsPlan plan;
  plan.place = section.place(section.has("sensors") ? "sensors" : "");
  if (section.has("sensors"))
    for (const TomlValue& value : section.values("sensors")) {
      const auto* text = value.as_text();
      if (text == nullptr || text->empty())
        section.fail_at("sensors." + std::to_string(plan.asked.size() + 1),
                        "is " + describe(value) +
                            ", expected a text, the name of a sensor or its beginning with \"*\"");
      plan.asked.push_back(*text);
    }
  plan.exponents = {4.0, 10.0};
  if (section.has("exponents"))
    plan.exponents = section.increasing_numbers("exponents", Quantity{"", 1.0, 50.0});
  if (plan.exponents.size() > kMostExponents)
    section.fail("exponents", "has " + counted(std::ssize(plan.exponents), "number") +
                                  ", expected at most " + std::to_string(kMostExponents));
  plan.from = section.number("from", Quantity::not_negative("s"), cases ? cases->settle : 0.0);
  plan.cycles = section.number("cycles", Quantity::positive(""), 1e7);
  return plan;
}

/// Checks what a table says about runs: partial factors are positive, hours not negative.
void check_columns(const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name != kPartialFactor && parameter.name != kHours) continue;
    if (!parameter.key.empty() || parameter.kind != ParameterKind::column) continue;
    const bool is_factor = parameter.name == kPartialFactor;
    for (std::size_t run = 0; run < parameter.column.size(); ++run) {
      const double value = parameter.column[run];
      const bool is_good =
          std::isnan(value) || (!parameter.is_choice() && (is_factor ? value > 0.0 : value >= 0.0));
      if (!is_good)
        throw InputError(parameter.place + ": " + parameter.name + ": is " +
                         plain_text(parameter, value) + " in run " + std::to_string(run + 1) +
                         ", expected a number " + (is_factor ? "above 0" : "from 0 on"));
    }
  }
}

/// Reads the rows of a table as parameters: of the design's file, or of load cases.
void read_rows(const TomlSection& root, const std::optional<LoadCases>& cases, Study& study) {
  if (cases) {
    study.table_text = cases->table;
    study.parameters = read_table(study.table_text, study.file);
    const std::string place = root.place("load_cases");
    for (Parameter& parameter : study.parameters) parameter.place = place + '.' + parameter.name;
  } else {
    study.table_text = read_text(study.design.table, "a table (CSV)");
    study.parameters = read_table(study.table_text, study.design.table);
  }
  check_columns(study.parameters);
  if (std::ssize(study.parameters.front().column) > kMostRuns)
    root.fail(cases ? "load_cases" : "design",
              "has more rows, expected at most " + std::to_string(kMostRuns) + " runs");
}

/// Returns what takes away the scenario's own gusts and turbulence, which load cases replace.
Overrides list_replaced(const Study& study) {
  const TomlDocument scenario(study.scenario_text, study.scenario_file);
  const TomlValue* wind = scenario.root().find("wind");
  const TomlTable* table = wind == nullptr ? nullptr : wind->as_table();
  Overrides replaced;
  for (const char* key : {"gust", "turbulence"})
    if (table != nullptr && table->find(key) != nullptr)
      replaced.push_back(std::string("wind.") + key + "={}");
  return replaced;
}

std::int64_t count_sampled(const std::vector<Parameter>& parameters) {
  std::int64_t count = 0;
  for (const Parameter& parameter : parameters)
    if (parameter.kind != ParameterKind::expression) ++count;
  return count;
}

[[noreturn]] void fail_too_many(const TomlSection& root, const std::string& what) {
  root.fail("design", what + ", expected at most " + std::to_string(kMostRuns) + " runs");
}

/// Counts the runs that values, points or rows make.
void count_runs(const TomlSection& root, Study& study) {
  Design& design = study.design;
  const std::int64_t sampled = count_sampled(study.parameters);
  if (sampled == 0)
    root.fail("parameter", "has expressions alone, expected others that they are of");
  if (design.kind == DesignKind::grid) {
    design.runs = 1;
    for (const Parameter& parameter : study.parameters) {
      if (parameter.kind == ParameterKind::expression) continue;
      design.runs *= std::ssize(parameter.levels);
      if (design.runs > kMostRuns) fail_too_many(root, "all combinations are more runs");
    }
  } else if (design.kind == DesignKind::table) {
    design.runs = std::ssize(study.parameters.front().column);
  } else if (design.kind == DesignKind::saltelli) {
    design.runs = design.points * (sampled + 2);
    if (design.runs > kMostRuns)
      fail_too_many(root, "makes " + std::to_string(design.runs) + " runs, " +
                              std::to_string(sampled + 2) + " for each point");
  }
  const std::int64_t dimensions = design.kind == DesignKind::saltelli ? 2 * sampled
                                  : design.kind == DesignKind::sobol  ? sampled
                                                                      : 0;
  if (dimensions > kMostSobolDimensions)
    root.fail("design", "has " + counted(dimensions, "dimension") + ", expected at most " +
                            std::to_string(kMostSobolDimensions) + ", one for each parameter" +
                            (design.kind == DesignKind::saltelli ? " and two for each here" : ""));
}

}  // namespace

Study read_study(const std::string& file) {
  Study study;
  study.file = file;
  study.text = read_text(file, "a study file (TOML)");
  study.name = fs::path(file).stem().string();
  const TomlDocument document(study.text, file);
  const TomlSection root(document, {"title", "scenario", "design", "load_cases", "parameter",
                                    "response", "statistics"});
  study.title = root.text("title", study.name);
  if (study.title.size() > kMostNameBytes)
    root.fail("title", "is " + std::to_string(study.title.size()) +
                           " bytes long, expected at most " + std::to_string(kMostNameBytes));
  const std::string scenario = root.text("scenario", "");
  if (scenario.empty())
    root.fail("scenario", "is missing, expected the name of a scenario file (TOML)");
  std::optional<LoadCases> cases;
  if (root.has("load_cases")) {
    if (root.has("design"))
      root.fail("design", "stands beside load_cases, which are a design, expected one of the two");
    cases = read_load_cases(root);
    study.design.kind = DesignKind::table;
  } else {
    study.design = read_design(root, file);
  }
  study.scenario_file = beside(file, scenario);
  study.scenario_text = read_text(study.scenario_file);
  if (cases) study.replaced = list_replaced(study);
  if (study.design.kind == DesignKind::table) read_rows(root, cases, study);
  read_parameters(root, study.design.kind, study.parameters);
  count_runs(root, study);
  study.statistics = read_statistics(root, cases);
  study.responses = read_responses(root, !study.statistics);
  return study;
}

}  // namespace spoke::study
