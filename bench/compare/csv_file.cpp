// The rows of compare.csv.

#include <spdlog/fmt/fmt.h>

#include "bench/compare/files.h"

namespace spoke::compare {
namespace {

constexpr const char* kHeader =
    "formulation,executor,outer_threads,inner_threads,wait,bind,oversubscribed,status,rounds,"
    "hash_equal,mean_s,standard_deviation_s,median_s,speedup,speedup_low,speedup_high,bound_s,"
    "ratio_to_bound,spin\n";

std::string figures_of(const std::optional<Figures>& figures) {
  if (!figures) return ",,,,,,,";
  return fmt::format("{},{},{},{},{},{},{},{}", figures->mean,
                     figures->deviation ? fmt::format("{}", *figures->deviation) : "",
                     figures->median, figures->speedup, figures->speedup_low, figures->speedup_high,
                     figures->bound, figures->ratio_to_bound);
}

}  // namespace

std::string make_csv(const Comparison& comparison) {
  std::string text = kHeader;
  for (const Result& result : comparison.results) {
    const Measurement& measurement = result.measurement;
    const Configuration& configuration = measurement.configuration;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", name_of(configuration.formulation),
                        name_of(configuration.executor), configuration.threads.outer,
                        configuration.threads.inner, name_of(configuration.wait),
                        configuration.bind, result.oversubscribed, name_of(measurement.status),
                        measurement.step_times.size(), result.hash_equal,
                        figures_of(result.figures), name_of(configuration.spin));
  }
  return text;
}

}  // namespace spoke::compare
