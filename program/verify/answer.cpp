// Solves (s - A) x = B u at s = i w.

#include "program/verify/answer.h"

#include <Eigen/Dense>
#include <complex>

#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke::verify {
namespace {

Eigen::Index find_signal(const std::vector<LinearSignal>& signals, const std::string& name,
                         const Figure& figure) {
  std::vector<std::string_view> names;
  for (const LinearSignal& signal : signals) {
    if (signal.name == name) return static_cast<Eigen::Index>(names.size());
    names.emplace_back(signal.name);
  }
  throw InputError("figure \"" + figure.name + "\": signal " + describe_unknown(name, names));
}

}  // namespace

double read_answer(const LinearSystem& system, const Figure& figure) {
  constexpr std::string_view kArrow = " -> ";
  const std::size_t arrow = figure.of.find(kArrow);
  if (figure.quantity != "answer" || arrow == std::string::npos)
    throw InputError("figure \"" + figure.name +
                     "\": expected the quantity \"answer\" of \"INPUT -> OUTPUT\"");
  const Eigen::Index input = find_signal(system.inputs, figure.of.substr(0, arrow), figure);
  const Eigen::Index output =
      find_signal(system.outputs, figure.of.substr(arrow + kArrow.size()), figure);
  const Eigen::Index size = system.A.rows();
  const std::complex<double> s(0.0, figure.at);
  const Eigen::MatrixXcd resolvent = s * Eigen::MatrixXcd::Identity(size, size) -
                                     Eigen::MatrixXd(system.A).cast<std::complex<double>>();
  const Eigen::VectorXcd input_column =
      Eigen::MatrixXd(system.B).col(input).cast<std::complex<double>>();
  const Eigen::VectorXcd state = resolvent.partialPivLu().solve(input_column);
  const Eigen::RowVectorXd row = Eigen::MatrixXd(system.C).row(output);
  return std::abs((row.cast<std::complex<double>>() * state).value() +
                  system.D.coeff(output, input));
}

}  // namespace spoke::verify
