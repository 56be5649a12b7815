// Writes sparse matrices, and the names of their rows and columns.

#include "program/steady_report/linear_files.h"

#include <spdlog/fmt/fmt.h>

#include "engine/support/plain_zero.h"
#include "models/support/json.h"
#include "program/steady_report/mode_files.h"

namespace spoke::steady_report {
namespace {

Json signals_json(const std::vector<LinearSignal>& signals) {
  Json list = Json::array();
  for (const LinearSignal& signal : signals)
    list.push_back({{"name", signal.name}, {"unit", signal.unit}});
  return list;
}

}  // namespace

std::string make_matrix_market(const Eigen::SparseMatrix<double>& matrix) {
  std::string text = fmt::format("%%MatrixMarket matrix coordinate real general\n{} {} {}\n",
                                 matrix.rows(), matrix.cols(), matrix.nonZeros());
  for (Eigen::Index k = 0; k < matrix.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, k); entry; ++entry)
      text +=
          fmt::format("{} {} {}\n", entry.row() + 1, entry.col() + 1, plain_zero(entry.value()));
  return text;
}

std::string make_json(const LinearSystem& system) {
  Json left_out = Json::array();
  for (const std::string& name : system.left_out) left_out.push_back(name);
  Json left_out_inputs = Json::array();
  for (const std::string& name : system.left_out_inputs) left_out_inputs.push_back(name);
  Json json = {
      {"speed_rad_per_s", system.equilibrium.speed}, {"frame", name_of(system.frame)},
      {"states", signals_json(system.states)},       {"inputs", signals_json(system.inputs)},
      {"outputs", signals_json(system.outputs)},     {"left_out", left_out},
      {"left_out_inputs", left_out_inputs}};
  if (!system.equilibrium.rotors.empty()) json.set("rotors", speeds_json(system.equilibrium));
  return json.dump_lines();
}

}  // namespace spoke::steady_report
