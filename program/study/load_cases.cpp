// Expands classes, speeds and seeds into rows of keys of a scenario.

#include "program/study/load_cases.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "models/air/iec_wind.h"
#include "program/study/study.h"

namespace spoke::study {
namespace {

/// The speeds of the wind in a case.
enum class Speeds {
  all,            ///< those of the study, from cut-in to cut-out
  around_rated,   ///< rated, and 2 m/s beside it
  start,          ///< cut-in, rated, cut-out
  gust_at_start,  ///< cut-in, 2 m/s beside rated, cut-out
  beside_rated,   ///< 2 m/s beside rated, cut-out
  of_class        ///< that of the class
};

/// A case of the standard's table 2.
struct Rule {
  std::string_view name;
  IecCase wind;
  Speeds speeds;
  std::optional<double> factor;  ///< partial safety factor of loads; none: of fatigue alone
  int period = 0;                ///< of recurrence, of EWM
};

constexpr double kNormal = 1.35, kAbnormal = 1.1;

constexpr std::array kRules = {
    Rule{"1.1", IecCase::ntm, Speeds::all, kNormal},
    Rule{"1.2", IecCase::ntm, Speeds::all, {}},
    Rule{"1.3", IecCase::etm, Speeds::all, kNormal},
    Rule{"1.4", IecCase::ecd, Speeds::around_rated, kNormal},
    Rule{"1.5", IecCase::ews, Speeds::all, kNormal},
    Rule{"2.1", IecCase::ntm, Speeds::all, kNormal},
    Rule{"2.2", IecCase::ntm, Speeds::all, kAbnormal},
    Rule{"2.3", IecCase::eog, Speeds::beside_rated, kAbnormal},
    Rule{"2.4", IecCase::ntm, Speeds::all, {}},
    Rule{"3.1", IecCase::nwp, Speeds::start, {}},
    Rule{"3.2", IecCase::eog, Speeds::gust_at_start, kNormal},
    Rule{"3.3", IecCase::edc, Speeds::gust_at_start, kNormal},
    Rule{"4.1", IecCase::nwp, Speeds::start, {}},
    Rule{"4.2", IecCase::eog, Speeds::beside_rated, kNormal},
    Rule{"5.1", IecCase::ntm, Speeds::beside_rated, kNormal},
    Rule{"6.1", IecCase::ewm, Speeds::of_class, kNormal, 50},
    Rule{"6.2", IecCase::ewm, Speeds::of_class, kAbnormal, 50},
    Rule{"6.3", IecCase::ewm, Speeds::of_class, kNormal, 1},
    Rule{"7.1", IecCase::ewm, Speeds::of_class, kAbnormal, 1},
};

constexpr std::array kClasses = {IecClass::i_a,   IecClass::i_b,   IecClass::i_c,
                                 IecClass::ii_a,  IecClass::ii_b,  IecClass::ii_c,
                                 IecClass::iii_a, IecClass::iii_b, IecClass::iii_c};

/// A cell, by the head of its column.
using Row = std::map<std::string, std::string>;

const std::array<std::string, 12> kHeads = {std::string(kLoadCase), std::string(kPartialFactor),
                                            std::string(kHours),    "wind.iec.class",
                                            "wind.iec.case",        "wind.iec.speed",
                                            "wind.iec.seed",        "wind.iec.start",
                                            "wind.iec.sign",        "wind.iec.direction",
                                            "wind.iec.period",      "integration.duration"};

std::string table_number(double number) { return fmt::format("{:.10g}", number); }

std::string case_name(std::string_view name) { return "DLC " + std::string(name); }

/// Returns a text as a cell, in quotes where it needs them.
std::string table_text(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

const Rule& read_rule(const TomlSection& section, const std::string& place,
                      const TomlValue& value) {
  const auto* text = value.as_text();
  for (const Rule& rule : kRules)
    if (text != nullptr && *text == rule.name) return rule;
  TomlSection::Keys names;
  for (const Rule& rule : kRules) names.push_back(rule.name);
  section.fail_at(place, "is " + describe(value) + ", expected " + join_names(names));
}

/// Reads an array of names of cases, each once.
std::vector<Rule> read_rules(const TomlSection& section) {
  std::vector<Rule> rules;
  for (const TomlValue& value : section.values("cases")) {
    const std::string place = "cases." + std::to_string(rules.size() + 1);
    const Rule& rule = read_rule(section, place, value);
    for (const Rule& other : rules)
      if (other.name == rule.name)
        section.fail_at(
            place, "is \"" + std::string(rule.name) + "\" a second time, expected different cases");
    rules.push_back(rule);
  }
  return rules;
}

/// Keys that a study sets in the runs of some cases.
struct Override {
  std::vector<Rule> rules;
  std::vector<std::pair<std::string, std::string>> cells;  ///< key and value

  bool is_of(const Rule& rule) const {
    return std::any_of(rules.begin(), rules.end(),
                       [&](const Rule& other) { return other.name == rule.name; });
  }
};

/// Reads "key=value", as --set takes it.
std::pair<std::string, std::string> read_assignment(const TomlSection& section,
                                                    const std::string& place,
                                                    const TomlValue& given) {
  const auto* text = given.as_text();
  const std::size_t equals = text == nullptr ? std::string::npos : text->find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text->size())
    section.fail_at(place, "is " + describe(given) +
                               ", expected a text \"KEY=VALUE\" such as \"hub.drive.speed=0\"");
  const std::string key = text->substr(0, equals);
  std::string value = text->substr(equals + 1);
  if (!is_column_name(key))
    section.fail_at(place,
                    "has a comma, quote or control character in its key, expected a key of "
                    "the scenario");
  if (value.starts_with('[') || value.starts_with('{') || value.find('\n') != std::string::npos)
    section.fail_at(place,
                    "sets an array or a table, expected a number, a text, true or false; "
                    "elements have keys of their own, as \"load.1.force.2\"");
  if (value.size() > 2 && value.starts_with('"') && value.ends_with('"'))
    value = value.substr(1, value.size() - 2);
  return {key, value};
}

std::vector<Override> read_overrides(const TomlSection& section, const std::vector<Rule>& rules) {
  std::vector<Override> overrides;
  for (const TomlSection& one : section.sections("override", {"cases", "set"})) {
    Override read{read_rules(one), {}};
    for (const Rule& rule : read.rules)
      if (std::none_of(rules.begin(), rules.end(),
                       [&](const Rule& other) { return other.name == rule.name; }))
        one.fail("cases", "has \"" + std::string(rule.name) +
                              "\", which is none of the study's, expected some of its \"cases\"");
    for (const TomlValue& value : one.values("set"))
      read.cells.push_back(
          read_assignment(one, "set." + std::to_string(read.cells.size() + 1), value));
    overrides.push_back(std::move(read));
  }
  return overrides;
}

/// The numbers of [load_cases].
struct Plan {
  std::vector<std::size_t> turbines;  ///< places in kClasses
  double cut_in = 0.0, rated = 0.0, cut_out = 0.0;
  std::vector<double> speeds;
  int seeds = 0, first_seed = 0;
  double duration = 0.0, settle = 0.0, gust_duration = 0.0;
  double lifetime = 0.0;  ///< [hours]
  double weibull_shape = 0.0;
  std::optional<double> weibull_mean;  ///< none: that of each class [m/s]
  std::vector<Rule> rules;
  std::vector<Override> overrides;
};

std::vector<double> read_speeds(const TomlSection& section, const Plan& plan) {
  if (!section.has("speeds")) {
    std::vector<double> speeds;
    for (int k = 0; plan.cut_in + 2.0 * k <= plan.cut_out; ++k)
      speeds.push_back(plan.cut_in + 2.0 * k);
    return speeds;
  }
  std::vector<double> speeds = section.increasing_numbers("speeds", Quantity::positive("m/s"));
  for (std::size_t i = 0; i < speeds.size(); ++i)
    if (speeds[i] < plan.cut_in || speeds[i] > plan.cut_out)
      section.fail_at("speeds." + std::to_string(i + 1),
                      "is " + describe(speeds[i]) + ", expected a speed from \"cut_in\", " +
                          describe(plan.cut_in) + ", to \"cut_out\", " + describe(plan.cut_out));
  return speeds;
}

void read_range(const TomlSection& section, Plan& plan) {
  plan.cut_in = section.number("cut_in", Quantity::positive("m/s"));
  plan.rated = section.number("rated", Quantity::positive("m/s"));
  plan.cut_out = section.number("cut_out", Quantity::positive("m/s"));
  if (!(plan.rated > plan.cut_in))
    section.fail_expected("rated", "a speed above \"cut_in\", " + describe(plan.cut_in) + " m/s");
  if (!(plan.cut_out > plan.rated))
    section.fail_expected("cut_out", "a speed above \"rated\", " + describe(plan.rated) + " m/s");
  if (plan.cut_out > 100.0) section.fail_expected("cut_out", "at most 100 m/s");
  plan.speeds = read_speeds(section, plan);
}

/// Reads the distribution of speeds over a lifetime; by default Rayleigh's, with the class' mean.
void read_lifetime(const TomlSection& section, Plan& plan) {
  constexpr double kHoursPerYear = 8766.0;
  plan.lifetime = kHoursPerYear * section.number("lifetime", Quantity::positive("years"), 20.0);
  plan.weibull_shape = section.number("weibull_shape", {"", 0.5, 20.0}, 2.0);
  if (section.has("weibull_mean"))
    plan.weibull_mean = section.number("weibull_mean", Quantity::positive("m/s"));
}

/// Reads the classes of the turbine, each once.
std::vector<std::size_t> read_classes(const TomlSection& section) {
  std::vector<std::size_t> turbines;
  TomlSection::Keys names;
  for (const IecClass turbine : kClasses) names.push_back(name_of(turbine));
  for (const TomlValue& value : section.values("classes")) {
    const std::string place = "classes." + std::to_string(turbines.size() + 1);
    const auto* text = value.as_text();
    const auto found = text == nullptr ? names.end() : std::find(names.begin(), names.end(), *text);
    if (found == names.end())
      section.fail_at(place, "is " + describe(value) + ", expected " + join_names(names));
    const auto turbine = static_cast<std::size_t>(found - names.begin());
    if (std::find(turbines.begin(), turbines.end(), turbine) != turbines.end())
      section.fail_at(place, "is \"" + *text + "\" a second time, expected different classes");
    turbines.push_back(turbine);
  }
  return turbines;
}

Plan read_plan(const TomlSection& section) {
  Plan plan;
  section.choice("standard", {"IEC 61400-1"});
  plan.turbines = read_classes(section);
  read_range(section, plan);
  plan.seeds = section.integer("seeds", {1, 1000}, 6);
  plan.first_seed = section.integer("first_seed", {0, 1'000'000'000}, 1);
  plan.duration = section.number("duration", Quantity::positive("s"), 600.0);
  plan.settle = section.number("settle", Quantity::not_negative("s"), 30.0);
  plan.gust_duration = section.number("gust_duration", Quantity::positive("s"), 60.0);
  read_lifetime(section, plan);
  plan.rules = read_rules(section);
  plan.overrides = read_overrides(section, plan.rules);
  return plan;
}

std::vector<std::optional<double>> speeds_of(const Rule& rule, const Plan& plan) {
  const double below = plan.rated - 2.0, above = plan.rated + 2.0;
  std::vector<double> speeds;
  switch (rule.speeds) {
    case Speeds::all:
      speeds = plan.speeds;
      break;
    case Speeds::around_rated:
      speeds = {below, plan.rated, above};
      break;
    case Speeds::start:
      speeds = {plan.cut_in, plan.rated, plan.cut_out};
      break;
    case Speeds::gust_at_start:
      speeds = {plan.cut_in, below, above, plan.cut_out};
      break;
    case Speeds::beside_rated:
      speeds = {below, above, plan.cut_out};
      break;
    case Speeds::of_class:
      return {std::nullopt};
  }
  std::vector<std::optional<double>> within;
  for (const double speed : speeds)
    if (speed >= plan.cut_in && speed <= plan.cut_out &&
        std::find(within.begin(), within.end(), speed) == within.end())
      within.emplace_back(speed);
  return within;
}

/// Returns the mean speed of the wind at the hub [m/s].
double mean_speed(std::size_t turbine, const Plan& plan) {
  constexpr std::array kReferenceSpeeds = {50.0, 42.5, 37.5};
  return plan.weibull_mean.value_or(0.2 * kReferenceSpeeds[turbine / 3]);
}

/// Returns the hours of a lifetime in which the wind is nearest to a speed of the plan, between
/// cut-in and cut-out. The lifetime is divided among the classes.
double hours_at(std::size_t place, std::size_t turbine, const Plan& plan) {
  const double scale = mean_speed(turbine, plan) / std::tgamma(1.0 + 1.0 / plan.weibull_shape);
  const auto probability_below = [&](double speed) {
    return -std::expm1(-std::pow(speed / scale, plan.weibull_shape));
  };
  const std::vector<double>& speeds = plan.speeds;
  const double from = place == 0 ? plan.cut_in : 0.5 * (speeds[place - 1] + speeds[place]);
  const double to =
      place + 1 == speeds.size() ? plan.cut_out : 0.5 * (speeds[place] + speeds[place + 1]);
  return plan.lifetime / static_cast<double>(plan.turbines.size()) *
         (probability_below(to) - probability_below(from));
}

/// Whether the hours of the lifetime are those of a case: 1.2, or in its place 1.1, whose wind is
/// the same.
bool has_lifetime(const Rule& rule, const Plan& plan) {
  const bool has_fatigue = std::any_of(plan.rules.begin(), plan.rules.end(),
                                       [](const Rule& other) { return other.name == "1.2"; });
  return rule.name == (has_fatigue ? "1.2" : "1.1");
}

/// Makes the table row by row.
class TableMaker {
 public:
  explicit TableMaker(const Plan& plan) : plan_(plan), seed_(plan.first_seed) {
    heads_.assign(kHeads.begin(), kHeads.end());
    for (const Override& one : plan.overrides)
      for (const auto& [key, value] : one.cells)
        if (std::find(heads_.begin(), heads_.end(), key) == heads_.end()) heads_.push_back(key);
    add_line([](const std::string& head) { return head; });
  }

  void add(const Rule& rule) {
    const std::vector<std::optional<double>> speeds = speeds_of(rule, plan_);
    for (const std::size_t turbine : plan_.turbines)
      for (std::size_t i = 0; i < speeds.size(); ++i) add_speed(rule, turbine, speeds[i], i);
  }
  const std::string& text() const { return text_; }

 private:
  void add_speed(const Rule& rule, std::size_t turbine, const std::optional<double>& speed,
                 std::size_t place) {
    const std::string turbine_name(name_of(kClasses[turbine]));
    const std::string of = plan_.turbines.size() > 1 ? ' ' + turbine_name : "";
    const bool is_turbulent = has_turbulence({.condition = rule.wind, .speed = speed});
    const bool has_gust = !is_turbulent && rule.wind != IecCase::nwp && rule.wind != IecCase::ewm;
    Row row = {{kHeads[0], case_name(rule.name) + of},
               {"wind.iec.class", turbine_name},
               {"wind.iec.case", std::string(name_of(rule.wind))}};
    if (rule.factor) row[kHeads[1]] = table_number(*rule.factor);
    if (speed) row["wind.iec.speed"] = table_number(*speed);
    if (rule.period > 0) row["wind.iec.period"] = std::to_string(rule.period);
    if (has_gust) row["wind.iec.start"] = table_number(plan_.settle);
    row["integration.duration"] =
        table_number(plan_.settle + (is_turbulent ? plan_.duration : plan_.gust_duration));
    if (has_lifetime(rule, plan_))
      row[kHeads[2]] = table_number(hours_at(place, turbine, plan_) / plan_.seeds);
    if (is_turbulent)
      add_seeds(rule, row);
    else
      add_signs(rule, row);
  }

  /// Adds a row for each seed; no two rows of the table have the same.
  void add_seeds(const Rule& rule, Row& row) {
    for (int k = 0; k < plan_.seeds; ++k) {
      row["wind.iec.seed"] = std::to_string(seed_++);
      add_row(rule, row);
    }
  }

  /// Adds rows of both signs and directions, where the wind has them.
  void add_signs(const Rule& rule, const Row& row) {
    const bool has_direction = rule.wind == IecCase::ews;
    const bool has_sign = has_direction || rule.wind == IecCase::ecd || rule.wind == IecCase::edc;
    const std::vector<std::string> directions =
        has_direction ? std::vector<std::string>{"vertical", "horizontal"}
                      : std::vector<std::string>{""};
    const std::vector<std::string> signs =
        has_sign ? std::vector<std::string>{"1", "-1"} : std::vector<std::string>{""};
    for (const std::string& direction : directions)
      for (const std::string& sign : signs) {
        Row one = row;
        one["wind.iec.direction"] = direction;
        one["wind.iec.sign"] = sign;
        add_row(rule, one);
      }
  }

  void add_row(const Rule& rule, Row row) {
    for (const Override& one : plan_.overrides) {
      if (!one.is_of(rule)) continue;
      for (const auto& [key, value] : one.cells) row[key] = value;
    }
    add_line([&](const std::string& head) { return row[head]; });
  }

  template <class CellOf>
  void add_line(const CellOf& cell_of) {
    for (std::size_t k = 0; k < heads_.size(); ++k)
      text_ += (k == 0 ? "" : ",") + table_text(cell_of(heads_[k]));
    text_ += '\n';
  }

  const Plan& plan_;
  int seed_;
  std::vector<std::string> heads_;
  std::string text_;
};

}  // namespace

LoadCases read_load_cases(const TomlSection& root) {
  const TomlSection section = root.section(
      "load_cases", {"standard", "classes", "cut_in", "rated", "cut_out", "speeds", "cases",
                     "seeds", "first_seed", "duration", "settle", "gust_duration", "lifetime",
                     "weibull_mean", "weibull_shape", "override"});
  const Plan plan = read_plan(section);
  TableMaker maker(plan);
  for (const Rule& rule : plan.rules) maker.add(rule);
  return {maker.text(), plan.settle};
}

}  // namespace spoke::study
