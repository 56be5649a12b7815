#include "tests/program/foreign/samples.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "engine/modes.h"
#include "models/error.h"
#include "tests/file_text.h"

namespace spoke::test {

const Texts& samples() {
  static const Texts texts = [] {
    Texts all;
    for (const auto& entry : std::filesystem::directory_iterator(SPOKE_FOREIGN_FILES))
      all[entry.path().filename().string()] = file_text(entry.path());
    return all;
  }();
  return texts;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t place = text.find(from);
  REQUIRE(place != std::string::npos);
  return text.replace(place, from.size(), to);
}

namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string join(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

}  // namespace

std::string without_line(const std::string& text, int line) {
  auto lines = split_lines(text);
  lines.erase(lines.begin() + line - 1);
  return join(lines);
}

std::string up_to_line(const std::string& text, int line) {
  auto lines = split_lines(text);
  lines.resize(static_cast<std::size_t>(line));
  return join(lines);
}

std::string with_line(const std::string& text, int line, const std::string& replacement) {
  auto lines = split_lines(text);
  lines.at(static_cast<std::size_t>(line) - 1) = replacement;
  return join(lines);
}

foreign::Imported import_texts(const Texts& texts, const std::vector<std::string>& names,
                               const foreign::ImportOptions& options) {
  std::vector<foreign::SourceFile> files;
  for (const std::string& name : names) files.push_back({name, texts.at(name)});
  return foreign::import_files(
      files,
      [&](const std::string& name) {
        if (!texts.contains(name)) throw InputError(name + ": no such file, expected one");
        return texts.at(name);
      },
      options);
}

void check_refused(const std::string& name, const std::vector<std::string>& names,
                   const std::vector<WrongText>& wrong, const foreign::ImportOptions& options) {
  for (const WrongText& w : wrong) {
    Texts texts = samples();
    texts[name] = w.text;
    CAPTURE(w.message);
    try {
      import_texts(texts, names, options);
      FAIL_CHECK("is not refused");
    } catch (const InputError& error) {
      const std::string message = error.what();
      CAPTURE(message);
      CHECK(message.find('\n') == std::string::npos);
      CHECK(message.starts_with(name + ':'));
      CHECK(message.find(w.message) != std::string::npos);
      CHECK(message.find("expected") != std::string::npos);
      CHECK(error.place().file == name);
    }
  }
}

std::vector<std::vector<double>> numbers_by_line(const std::string& text) {
  std::vector<std::vector<double>> all;
  for (const std::string& line : split_lines(text)) {
    std::istringstream words(line);
    std::vector<double>& numbers = all.emplace_back();
    for (double number = 0.0; words >> number;) numbers.push_back(number);
  }
  return all;
}

DenseSpline::DenseSpline(std::vector<double> x, std::vector<std::vector<double>> columns)
    : x_(std::move(x)), values_(std::move(columns)) {
  const auto n = static_cast<Eigen::Index>(x_.size());
  const auto at = [](const std::vector<double>& v, Eigen::Index i) {
    return v[static_cast<std::size_t>(i)];
  };
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    A(i, i - 1) = (at(x_, i) - at(x_, i - 1)) / 6.0;
    A(i, i) = (at(x_, i + 1) - at(x_, i - 1)) / 3.0;
    A(i, i + 1) = (at(x_, i + 1) - at(x_, i)) / 6.0;
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
  for (const std::vector<double>& v : values_) {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 1; i + 1 < n; ++i)
      b(i) = (at(v, i + 1) - at(v, i)) / (at(x_, i + 1) - at(x_, i)) -
             (at(v, i) - at(v, i - 1)) / (at(x_, i) - at(x_, i - 1));
    const Eigen::VectorXd m = lu.solve(b);
    second_.emplace_back(m.data(), m.data() + n);
  }
}

std::size_t DenseSpline::piece(double x) const {
  std::size_t k = 0;
  while (k + 2 < x_.size() && x >= x_[k + 1]) ++k;
  return k;
}

double DenseSpline::at(std::size_t c, double x) const {
  const std::size_t k = piece(x);
  const double h = x_[k + 1] - x_[k], l = x - x_[k], r = x_[k + 1] - x;
  return second_[c][k] * r * r * r / (6.0 * h) + second_[c][k + 1] * l * l * l / (6.0 * h) +
         (values_[c][k] / h - second_[c][k] * h / 6.0) * r +
         (values_[c][k + 1] / h - second_[c][k + 1] * h / 6.0) * l;
}

double DenseSpline::slope(std::size_t c, double x) const {
  const std::size_t k = piece(x);
  const double h = x_[k + 1] - x_[k], l = x - x_[k], r = x_[k + 1] - x;
  return -second_[c][k] * r * r / (2.0 * h) + second_[c][k + 1] * l * l / (2.0 * h) +
         (values_[c][k + 1] - values_[c][k]) / h - (second_[c][k + 1] - second_[c][k]) * h / 6.0;
}

double DenseSpline::arc_length(double from, double to) const {
  const auto speed = [&](double x) { return std::hypot(1.0, slope(0, x), slope(1, x)); };
  double length = 0.0, start = from;
  while (start < to) {  // piece by piece, within which the slope is smooth
    const double end = std::min(to, x_[piece(start) + 1]);
    constexpr int parts = 200;
    const double h = (end - start) / parts;
    const auto inner = [&](double x) { return speed(std::min(x, std::nextafter(end, start))); };
    for (int i = 0; i < parts; ++i)
      length +=
          h / 6.0 *
          (speed(start + i * h) + 4.0 * speed(start + (i + 0.5) * h) + inner(start + (i + 1) * h));
    if (end == to) break;
    start = end;
  }
  return length;
}

double DenseSpline::find_x(double arc_length) const {
  double low = x_.front(), high = x_.back();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (this->arc_length(x_.front(), middle) < arc_length ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Eigen::Matrix<double, 6, 6> rotate_from_beamdyn(const Eigen::Matrix<double, 6, 6>& matrix) {
  Eigen::Matrix3d R;  // its rows are Spoke's axes in BeamDyn's
  R << 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0;
  Eigen::Matrix<double, 6, 6> T = Eigen::Matrix<double, 6, 6>::Zero();
  T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = R;
  return T * matrix * T.transpose();
}

namespace {

void check_close(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  double size = 0.0;
  for (const double value : expected) size = std::max(size, std::abs(value));
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(std::abs(found[i] - expected[i]) <= 1e-10 * size);
}

void check_close(const std::vector<spatial::SectionMatrix>& found,
                 const std::vector<spatial::SectionMatrix>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        CHECK(std::abs(found[i](r, c) - expected[i](r, c)) <=
              1e-10 * std::sqrt(expected[i](r, r) * expected[i](c, c)));
}

}  // namespace

void check_same(const spatial::Sections& found, const spatial::Sections& expected) {
  check_close(found.station, expected.station);
  check_close(found.sweep, expected.sweep);
  check_close(found.prebend, expected.prebend);
  check_close(found.twist, expected.twist);
  check_close(found.mass_per_length, expected.mass_per_length);
  check_close(found.axial_stiffness, expected.axial_stiffness);
  check_close(found.flap_stiffness, expected.flap_stiffness);
  check_close(found.lag_stiffness, expected.lag_stiffness);
  check_close(found.torsion_stiffness, expected.torsion_stiffness);
  check_close(found.stiffness_6x6, expected.stiffness_6x6);
  check_close(found.mass_6x6, expected.mass_6x6);
}

std::vector<double> frequencies_of(const Scenario& scenario, int count) {
  std::vector<double> frequencies;
  for (const Mode& mode : solve_modes(scenario, {{0.0}, count}).modes)
    frequencies.push_back(std::abs(mode.eigenvalue) / (2.0 * std::numbers::pi));
  return frequencies;
}

void check_same_frequencies(const Scenario& found, const Scenario& expected, int count) {
  const auto a = frequencies_of(found, count), b = frequencies_of(expected, count);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-9));
}

Scenario held_blade(const spatial::Beam& beam) {
  Scenario scenario;
  scenario.space.emplace();
  scenario.space->hub.drive = FixedDrive{};
  scenario.space->blades.resize(1);
  scenario.space->blades[0].beam = beam;
  return scenario;
}

}  // namespace spoke::test
