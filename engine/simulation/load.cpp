// Makes a load of a function, and finds markers by their distance from the root.

#include "engine/load.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "models/count_text.h"
#include "models/error.h"
#include "models/scenario.h"
#include "models/support/quantity.h"
#include "models/tree/axle_carrier.h"
#include "models/tree/tree.h"

namespace spoke {
namespace {

class FunctionLoad final : public Load {
 public:
  FunctionLoad(std::string name, std::vector<Marker> markers, LoadFunction function)
      : name_(std::move(name)), markers_(std::move(markers)), function_(std::move(function)) {}

  std::string name() const override { return name_; }
  std::vector<Marker> markers() const override { return markers_; }
  void evaluate(double t, std::span<const MarkerMotion> in, std::span<Wrench> out) const override {
    function_(t, in, out);
  }

 private:
  std::string name_;
  std::vector<Marker> markers_;
  LoadFunction function_;
};

void require_blade(int blade, std::size_t count) {
  if (blade < 0 || static_cast<std::size_t>(blade) >= count)
    throw InputError("markers_at(): blade index " + std::to_string(blade) + ", expected " +
                     range_text(0, static_cast<std::int64_t>(count) - 1));
}

/// Returns the stations at which the bodies of a blade end, from its root on [m].
std::vector<double> find_ends(const Blade& blade) {
  std::vector<double> ends{0.0};
  for (int j = 1; j <= blade.bodies; ++j)
    ends.push_back(j == blade.bodies ? blade.length : j * blade.length / blade.bodies);
  return ends;
}
std::vector<double> find_ends(const spatial::Tree& tree) {
  std::vector<double> ends{0.0};
  for (std::size_t j = 0; j <= find_tip_body(tree); ++j)
    ends.push_back(std::get<spatial::FlexibleBody>(tree.bodies[j].shape).nodes.back());
  return ends;
}

std::vector<double> find_ends(const Scenario& scenario, int blade) {
  const auto index = static_cast<std::size_t>(blade);
  if (!scenario.space) {
    require_blade(blade, scenario.rotor.blades.size());
    return find_ends(scenario.rotor.blades[index]);
  }
  require_blade(blade, scenario.space->blades.size());
  return find_ends(spatial::build_trees(*scenario.space)[index]);
}

}  // namespace

std::shared_ptr<const Load> make_load(std::string name, std::vector<Marker> markers,
                                      LoadFunction function) {
  return std::make_shared<const FunctionLoad>(std::move(name), std::move(markers),
                                              std::move(function));
}

std::vector<Marker> markers_at(const Scenario& scenario, int blade,
                               std::span<const double> positions) {
  const std::vector<double> ends = find_ends(scenario, blade);
  std::vector<Marker> markers;
  for (const double position : positions) {
    if (!(position >= 0.0 && position <= ends.back()))
      throw InputError("markers_at(): position " + describe(position) + ", expected 0 to " +
                       describe(ends.back()) + " (m)");
    const auto end = std::lower_bound(ends.begin() + 1, ends.end(), position);
    const double begin = *(end - 1);
    markers.push_back({blade, static_cast<int>(end - ends.begin()) - 1,
                       std::min((position - begin) / (*end - begin), 1.0)});
  }
  return markers;
}

}  // namespace spoke
