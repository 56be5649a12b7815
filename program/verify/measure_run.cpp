// Follows sensors through a run: values at times, extremes, periods, changes.

#include "program/verify/measure_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/simulation.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke::verify {
namespace {

constexpr std::array<std::string_view, 8> kQuantities = {
    "end", "at", "largest", "least", "largest time", "period", "drift", "mean"};

/// A sensor of a run, as a figure sees it.
class Follower {
 public:
  Follower(const Figure& figure, const Simulation& simulation)
      : figure_(figure), column_(simulation.sensor_index(figure.of)) {
    if (std::find(kQuantities.begin(), kQuantities.end(), figure.quantity) == kQuantities.end())
      throw InputError("figure \"" + figure.name + "\": quantity " +
                       describe_unknown(figure.quantity, kQuantities));
    see(simulation.time(), simulation.sensor_values());
  }

  void see(double t, std::span<const double> sensors) {
    const double value = sensors[column_];
    if (count_ == 0) first_ = value;
    if (count_ > 0 && before_ <= figure_.at && figure_.at <= t)
      at_ = last_ + (value - last_) * (figure_.at - before_) / (t - before_);
    if (count_ > 0 && last_ < 0.0 && value >= 0.0)
      note_rise(before_ - last_ / (value - last_) * (t - before_));
    if (value > largest_) largest_ = value, largest_time_ = t;
    least_ = std::min(least_, value);
    drift_ = std::max(drift_, std::abs(value - first_));
    if (t >= figure_.at) sum_ += value, ++summed_;
    before_ = t;
    last_ = value;
    ++count_;
  }

  double result() const {
    const std::string& quantity = figure_.quantity;
    if (quantity == "at") return at_;
    if (quantity == "largest") return largest_;
    if (quantity == "least") return least_;
    if (quantity == "largest time") return largest_time_;
    if (quantity == "drift") return drift_;
    if (quantity == "mean") return sum_ / summed_;
    if (quantity == "end") return last_;
    return rises_ > 1 ? (last_rise_ - first_rise_) / (rises_ - 1)
                      : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  void note_rise(double t) {
    if (rises_++ == 0) first_rise_ = t;
    last_rise_ = t;
  }

  const Figure& figure_;
  std::size_t column_;
  int count_ = 0, rises_ = 0, summed_ = 0;
  double first_ = 0.0, last_ = 0.0, before_ = 0.0, sum_ = 0.0, drift_ = 0.0;
  double at_ = std::numeric_limits<double>::quiet_NaN();
  double largest_ = -std::numeric_limits<double>::infinity(), largest_time_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
  double first_rise_ = 0.0, last_rise_ = 0.0;
};

}  // namespace

std::vector<double> measure_run(const Case& one, const Scenario& scenario) {
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  std::vector<Follower> followers;
  for (const Figure& figure : one.figures) followers.emplace_back(figure, simulation);
  simulation.run_until(scenario.integration.duration,
                       [&](double t, std::span<const double> sensors) {
                         for (Follower& follower : followers) follower.see(t, sensors);
                       });
  std::vector<double> values;
  for (const Follower& follower : followers) values.push_back(follower.result());
  return values;
}

}  // namespace spoke::verify
