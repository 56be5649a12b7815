// Prints tables and targets, and writes them as JSON.

#include "bench/report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "bench/progress.h"

namespace spoke::bench {
namespace {

/// Returns the mean number of runnable processes over the last minute; negative if it is not known.
double load_average() {
  double load = -1.0;
  return getloadavg(&load, 1) == 1 ? load : -1.0;
}

std::string bounds(const Target& target) {
  if (std::isinf(target.greatest)) return ">= " + figure(target.least);
  if (!std::isinf(target.least)) return figure(target.least) + " to " + figure(target.greatest);
  return "<= " + figure(target.greatest);
}

void print_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line = "  ";
  for (std::size_t c = 0; c < cells.size(); ++c)
    line += c == 0 ? fmt::format("{:<{}}", cells[c], widths[c])
                   : fmt::format("  {:>{}}", cells[c], widths[c]);
  fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

void print_table(const Table& table) {
  std::vector<std::size_t> widths(table.columns.size(), 0);
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], cells[c].size());
  };
  widen(table.columns);
  for (const auto& row : table.rows) widen(row);
  fmt::print("\n{}\n", table.title);
  print_row(table.columns, widths);
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  print_row(rule, widths);
  for (const auto& row : table.rows) print_row(row, widths);
}

}  // namespace

Target at_least(std::string text, double measured, double least) {
  return {std::move(text), measured, least, std::numeric_limits<double>::infinity()};
}

Target at_most(std::string text, double measured, double greatest) {
  return {std::move(text), measured, -std::numeric_limits<double>::infinity(), greatest};
}

Report::Report(bool quick)
    : is_quick_(quick), machine_(this_machine()), load_average_(load_average()) {}

void Report::print_header() const {
  fmt::print("Spoke {} benchmarks ({}, {})\n", SPOKE_VERSION, SPOKE_BUILD_FLAGS, machine_.compiler);
  fmt::print("{}, {} cores, load average {}\n", machine_.cpu, machine_.cores,
             load_average_ < 0.0 ? "unknown" : figure(load_average_));
  fmt::print(
      "Times are the least of all rounds. Ratios are medians of the ratios within interleaved "
      "rounds,\nin brackets their quartiles.\n");
  if (is_quick_)
    fmt::print("A quick run: few rounds, slow alternatives left out. Judge nothing by it.\n");
}

void Report::begin_question(const std::string& name, const std::string& text) {
  question_ = name;
  fmt::print("\n== {}: {}\n", name, text);
  std::fflush(stdout);
}

void Report::add_table(const Table& table) {
  show_progress("");
  print_table(table);
  std::fflush(stdout);
}

void Report::add_remark(const std::string& text) {
  show_progress("");
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

void Report::add_target(const Target& target) {
  targets_.push_back(target);
  Json json{{"question", question_},
            {"target", target.text},
            {"measured", target.measured},
            {"reached", target.reached()}};
  if (!std::isinf(target.least)) json.set("at_least", target.least);
  if (!std::isinf(target.greatest)) json.set("at_most", target.greatest);
  targets_in_json_.push_back(std::move(json));
}

void Report::add_result(Json result) {
  result.set("question", question_);
  results_.push_back(std::move(result));
}

void Report::add_timing(const std::string& model, const Timing& timing) {
  add_result({{"model", model},
              {"alternative", timing.name},
              {"rounds", timing.rounds},
              {"least_s", timing.least},
              {"median_s", timing.median},
              {"ratio", timing.ratio},
              {"ratio_quartiles", std::vector{timing.ratio_low, timing.ratio_high}}});
}

void Report::print_summary() const {
  Table table{"Targets", {"", "promised", "measured", ""}, {}};
  for (const Target& target : targets_)
    table.rows.push_back({target.text, bounds(target), figure(target.measured),
                          target.reached() ? "reached" : "MISSED"});
  if (!targets_.empty()) print_table(table);
}

void Report::write_json(const std::filesystem::path& file) const {
  const Json json{{"version", SPOKE_VERSION},
                  {"build", SPOKE_BUILD_FLAGS},
                  {"machine",
                   {{"cpu", machine_.cpu},
                    {"cores", machine_.cores},
                    {"memory", machine_.memory},
                    {"os", machine_.os},
                    {"compiler", machine_.compiler},
                    {"load_average", load_average_}}},
                  {"quick", is_quick_},
                  {"results", results_},
                  {"targets", targets_in_json_}};
  std::ofstream stream(file);
  stream << json.dump_lines();
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string figure(double value) {
  const double size = std::abs(value);
  return fmt::format("{:.{}f}", value, size >= 100.0 ? 0 : size >= 10.0 ? 1 : 2);
}

std::string ratio_with_spread(const Timing& timing) {
  if (timing.rounds < 2) return figure(timing.ratio);
  return fmt::format("{} [{}-{}]", figure(timing.ratio), figure(timing.ratio_low),
                     figure(timing.ratio_high));
}

}  // namespace spoke::bench
