#pragma once

// The values of the parameters in each run.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/scenario.h"
#include "program/study/sobol_sequence.h"
#include "program/study/study.h"

namespace spoke::study {

/// The runs of a study, counted from 0. A run's values depend on its number alone; no run is
/// stored. `study` must outlive it.
class Sampling {
 public:
  explicit Sampling(const Study& study);

  /// Returns values by parameter: numbers, or places in the list of a parameter that is a choice.
  std::vector<double> values(std::int64_t run) const;
  /// Returns places in the unit cube, by sampled parameter, for a design that samples one.
  std::vector<double> point(std::int64_t run) const;
  /// Returns the indices of the parameters that are no expressions.
  const std::vector<std::size_t>& sampled() const { return sampled_; }

 private:
  double unit_coordinate(std::int64_t run, std::size_t dimension) const;
  double sobol_coordinate(std::int64_t point, std::size_t dimension) const;
  double saltelli_coordinate(std::int64_t run, std::size_t dimension) const;
  double sampled_value(std::int64_t run, std::size_t dimension) const;

  const Study& study_;
  std::vector<std::size_t> sampled_;
  std::vector<std::int64_t> strides_;  ///< runs between values of each sampled parameter of a grid
  std::vector<std::size_t> order_;     ///< indices of expressions, each behind those that it needs
  std::optional<SobolSequence> sobol_;
};

/// Whether a value of a parameter is an empty cell of a table: the scenario's own value.
bool is_left_out(const Parameter& parameter, double value);
/// Returns a value of a parameter as TOML writes it, whole numbers without a point.
/// Precondition: it is not left out.
std::string toml_text(const Parameter& parameter, double value);
/// Returns a value of a parameter as cells and tables show it: texts without quotes, and
/// nothing for one that is left out.
std::string plain_text(const Parameter& parameter, double value);

/// Returns the values of parameters with a key as "key=value" of the command line.
Overrides make_overrides(const Study& study, const std::vector<double>& values);

}  // namespace spoke::study
