#pragma once

// The output of a benchmark run: tables and remarks on stdout as they come, a summary of the
// targets at the end, and all of it as JSON for machines.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/compare/interleaved.h"
#include "engine/support/machine.h"
#include "models/support/json.h"

namespace spoke::bench {

/// A table of texts; the first column is aligned left, the others right.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A promised figure.
struct Target {
  std::string text;
  double measured = 0.0;
  double least = 0.0;  ///< bounds of the promise; infinite ones do not count
  double greatest = 0.0;
  bool reached() const { return measured >= least && measured <= greatest; }
};

Target at_least(std::string text, double measured, double least);
Target at_most(std::string text, double measured, double greatest);

class Report {
 public:
  explicit Report(bool quick);

  /// Prints machine, version and how to read the figures.
  void print_header() const;
  void begin_question(const std::string& name, const std::string& text);
  void add_table(const Table& table);
  void add_remark(const std::string& text);
  void add_target(const Target& target);
  /// Adds one result, for the JSON only; its question is added.
  void add_result(Json result);
  /// Adds a timing as a result of `model`, for the JSON only.
  void add_timing(const std::string& model, const Timing& timing);

  void print_summary() const;
  /// Writes the figures. Throws std::runtime_error if the file cannot be written.
  void write_json(const std::filesystem::path& file) const;

 private:
  std::string question_;
  bool is_quick_;
  Machine machine_;
  double load_average_;  ///< negative: not known
  Json results_ = Json::array();
  Json targets_in_json_ = Json::array();
  std::vector<Target> targets_;
};

/// Returns three significant digits, no exponent below a million: "0.98", "13.4", "5420".
std::string figure(double value);
/// Returns a median ratio and its quartiles: "13.4 [13.1-13.9]".
std::string ratio_with_spread(const Timing& timing);

}  // namespace spoke::bench
