#pragma once

// Which values the parameters have in which run.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/sobol_sequence.h"
#include "engine/study/study.h"
#include "models/scenario.h"

namespace spoke::study {

/// The runs of a study, counted from 0. What a run is, is a function of its number alone: nothing
/// is kept of the others. `study` must outlive it.
class Sampling {
 public:
  explicit Sampling(const Study& study);

  /// By parameter: numbers, or places in the list of a parameter that is a choice.
  std::vector<double> values(std::int64_t run) const;
  /// Places in the unit cube, by sampled parameter, of a design that samples one.
  std::vector<double> point(std::int64_t run) const;
  /// The parameters that are no expressions, as indices.
  const std::vector<std::size_t>& sampled() const { return sampled_; }

 private:
  double unit_coordinate(std::int64_t run, std::size_t dimension) const;
  double sobol_coordinate(std::int64_t point, std::size_t dimension) const;
  double saltelli_coordinate(std::int64_t run, std::size_t dimension) const;
  double sampled_value(std::int64_t run, std::size_t dimension) const;

  const Study& study_;
  std::vector<std::size_t> sampled_;
  std::vector<std::int64_t> strides_;  ///< of a grid: runs between values of a sampled parameter
  std::vector<std::size_t> order_;     ///< of expressions: each behind those that it needs
  std::optional<SobolSequence> sobol_;
};

/// A value of a parameter as TOML writes it, whole numbers without a point.
std::string toml_text(const Parameter& parameter, double value);
/// The same as cells and tables show it: texts without quotes.
std::string plain_text(const Parameter& parameter, double value);

/// Values as "key=value" of the command line: those of parameters with a key.
Overrides make_overrides(const Study& study, const std::vector<double>& values);

}  // namespace spoke::study
