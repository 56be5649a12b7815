// Makes points in the unit cube, and maps them by the parameters' distributions.

#include "program/study/sampling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "program/study/portable_math.h"
#include "program/study/random_bits.h"

namespace spoke::study {
namespace {

// Streams of random numbers, so that no two uses of a seed draw the same ones.
constexpr std::uint64_t kWithinPart = 0, kOrderOfParts = 1000, kShift = 2000;

/// Adds an expression behind those that it needs.
void add_in_order(std::size_t index, const std::vector<Parameter>& parameters,
                  std::vector<std::size_t>& order) {
  if (parameters[index].kind != ParameterKind::expression ||
      std::find(order.begin(), order.end(), index) != order.end())
    return;
  for (const std::size_t other : parameters[index].expression.variables())
    add_in_order(other, parameters, order);
  order.push_back(index);
}

/// Returns the value that a parameter stays below with probability u, 0 < u < 1.
double value_at(const Parameter& parameter, double u) {
  switch (parameter.kind) {
    case ParameterKind::uniform:
      return (1.0 - u) * parameter.low + u * parameter.high;
    case ParameterKind::normal:
      return parameter.low + parameter.high * normal_quantile(u);
    case ParameterKind::log_uniform: {
      const double low = portable_log(parameter.low), high = portable_log(parameter.high);
      return portable_exp((1.0 - u) * low + u * high);
    }
    default: {
      const auto count = parameter.levels.size();
      const auto index = static_cast<std::size_t>(u * static_cast<double>(count));
      return parameter.levels[std::min(index, count - 1)].number;
    }
  }
}

}  // namespace

Sampling::Sampling(const Study& study) : study_(study) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    add_in_order(i, study.parameters, order_);
    if (study.parameters[i].kind != ParameterKind::expression) sampled_.push_back(i);
  }
  const DesignKind kind = study.design.kind;
  if (kind == DesignKind::sobol) sobol_.emplace(static_cast<int>(sampled_.size()));
  if (kind == DesignKind::saltelli) sobol_.emplace(static_cast<int>(2 * sampled_.size()));
  // The last parameter of a grid changes from run to run.
  strides_.assign(sampled_.size(), 1);
  if (kind == DesignKind::grid)
    for (std::size_t d = sampled_.size(); d-- > 1;)
      strides_[d - 1] = strides_[d] * std::ssize(study.parameters[sampled_[d]].levels);
}

std::vector<double> Sampling::values(std::int64_t run) const {
  assert(0 <= run && run < study_.design.runs);
  std::vector<double> values(study_.parameters.size());
  for (std::size_t d = 0; d < sampled_.size(); ++d) values[sampled_[d]] = sampled_value(run, d);
  for (const std::size_t i : order_) values[i] = study_.parameters[i].expression.value(values);
  return values;
}

std::vector<double> Sampling::point(std::int64_t run) const {
  std::vector<double> point;
  for (std::size_t d = 0; d < sampled_.size(); ++d) point.push_back(unit_coordinate(run, d));
  return point;
}

double Sampling::sampled_value(std::int64_t run, std::size_t dimension) const {
  const Parameter& parameter = study_.parameters[sampled_[dimension]];
  if (study_.design.kind == DesignKind::table)
    return parameter.column[static_cast<std::size_t>(run)];
  if (study_.design.kind == DesignKind::grid) {
    const std::int64_t place = run / strides_[dimension] % std::ssize(parameter.levels);
    return parameter.levels[static_cast<std::size_t>(place)].number;
  }
  return value_at(parameter, unit_coordinate(run, dimension));
}

double Sampling::unit_coordinate(std::int64_t run, std::size_t dimension) const {
  const Design& design = study_.design;
  if (design.kind == DesignKind::sobol) return sobol_coordinate(run, dimension);
  if (design.kind == DesignKind::saltelli) return saltelli_coordinate(run, dimension);
  assert(design.kind == DesignKind::latin_hypercube);
  const auto index = static_cast<std::uint64_t>(run),
             count = static_cast<std::uint64_t>(design.runs);
  const std::uint64_t part = permuted(design.seed, kOrderOfParts + dimension, index, count);
  const double within = random_number(design.seed, kWithinPart + dimension, index);
  return (static_cast<double>(part) + within) / static_cast<double>(count);
}

/// Returns the middle of the interval of 2^-32 that the sequence's 32 bits leave open, shifted
/// without carry.
double Sampling::sobol_coordinate(std::int64_t point, std::size_t dimension) const {
  const Design& design = study_.design;
  std::uint32_t bits =
      sobol_->coordinate(static_cast<std::uint64_t>(point), static_cast<int>(dimension));
  if (design.is_scrambled)
    bits ^= static_cast<std::uint32_t>(random_bits(design.seed, kShift, dimension) >> 32);
  return (static_cast<double>(bits) + 0.5) * 0x1p-32;
}

/// Returns a coordinate. The runs of a point are A, B, then A with one coordinate of B, for each
/// coordinate.
double Sampling::saltelli_coordinate(std::int64_t run, std::size_t dimension) const {
  const auto count = std::ssize(sampled_);
  const std::int64_t which = run % (count + 2);
  const bool is_of_b = which == 1 || which == static_cast<std::int64_t>(dimension) + 2;
  return sobol_coordinate(run / (count + 2),
                          dimension + (is_of_b ? static_cast<std::size_t>(count) : 0));
}

bool is_left_out(const Parameter& parameter, double value) {
  return parameter.kind == ParameterKind::column && std::isnan(value);
}

std::string toml_text(const Parameter& parameter, double value) {
  assert(!is_left_out(parameter, value));
  if (parameter.is_choice()) return parameter.levels[static_cast<std::size_t>(value)].text;
  constexpr double kWhole = 9007199254740992.0;  // 2^53
  std::array<char, 32> buffer;
  const bool is_whole = value == std::floor(value) && std::abs(value) < kWhole &&
                        !(value == 0.0 && std::signbit(value));
  const auto end = is_whole ? std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                            static_cast<std::int64_t>(value))
                            : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::string plain_text(const Parameter& parameter, double value) {
  if (is_left_out(parameter, value)) return {};
  std::string text = toml_text(parameter, value);
  if (!text.starts_with('"')) return text;
  std::string plain;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '\\') ++i;
    plain += text[i];
  }
  return plain;
}

Overrides make_overrides(const Study& study, const std::vector<double>& values) {
  Overrides overrides = study.replaced;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& parameter = study.parameters[i];
    if (!parameter.key.empty() && !is_left_out(parameter, values[i]))
      overrides.push_back(parameter.key + '=' + toml_text(parameter, values[i]));
  }
  return overrides;
}

}  // namespace spoke::study
