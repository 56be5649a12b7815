// Reads [[load]], [[distributed_load]], [[drag]] and [[hub_load]].

#include "models/reader/scenario_loads.h"

#include <algorithm>
#include <string>
#include <utility>

#include "models/reader/blade_choice_reader.h"
#include "models/reader/curve_reader.h"
#include "models/reader/names.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using Blades = std::vector<Blade>;

/// Returns the keys of a load on blades.
template <class Load>
TomlSection::Keys keys_of_load(keys::Rows own) {
  return keys::keys_of(own, keys::kLoadedBladeRows, keys::kLoadNameRows,
                       keys::kLoadCourseRows<Load>);
}

Curve read_factor(const TomlSection& section) {
  if (!section.has("time") && !section.has("factor")) return Curve(1.0);
  return read_curve(section, "time", kTime, "factor", kFactor);
}

/// Reads the keys of a load by its rows, and what all loads have besides.
template <class Load>
void read_course(const TomlSection& section, Load& load) {
  keys::read(section, rows_of(load), &load);
  keys::read(section, keys::kLoadCourseRows<Load>, &load);
  load.factor = read_factor(section);
  load.name = read_load_name(section);
}

Position read_vector(const TomlSection& section, std::string_view key, const Quantity& quantity) {
  if (!section.has(key)) return Position::Zero();
  const std::vector<double> values = section.numbers(key, quantity, kPosition);
  return Position::Map(values.data());
}

std::optional<double> read_position(const TomlSection& section, BladeChoice loaded,
                                    const Blades& blades) {
  if (!section.has("position")) return std::nullopt;
  return section.number("position", place_on(shortest_loaded(loaded, blades)));
}

/// Reads the ends of a load that is per length.
template <class Load>
void read_ends(const TomlSection& section, const Blades& blades, Load& load) {
  const Blade& shortest = shortest_loaded(load.blade, blades);
  load.from = section.number("from", place_on(shortest), 0.0);
  if (section.has("to")) load.to = section.number("to", end_on(shortest, load.from));
  if (load.from >= load.to.value_or(shortest.length))
    section.fail("from", "is " + describe(load.from) + ", expected less than the blade's length, " +
                             describe(shortest.length) + " (m)");
}

/// Counts the points of loads, and refuses the load that makes them too many.
class PointCount {
 public:
  explicit PointCount(const Blades& blades) : blades_(blades) {}

  template <class Load>
  void add(const TomlSection& section, const Load& load, bool is_distributed) {
    points_ += count_points(load.blade, is_distributed, load.factor, blades_);
    const std::string fault = find_point_fault(points_);
    if (!fault.empty()) section.fail("", fault);
  }

 private:
  const Blades& blades_;
  std::size_t points_ = 0;
};

PointLoad read_load(const TomlSection& section, const Blades& blades) {
  if (!section.has("force") && !section.has("moment")) {
    section.fail("", "has neither force nor moment, expected force = [x, y] or moment = M");
  }
  PointLoad load;
  load.blade = read_blade(section, blades.size());
  load.force = read_vector(section, "force", kForce);
  read_course(section, load);
  return load;
}

/// Appends the load to `loads`, at the given place or the tip of every loaded blade.
void add_load(const TomlSection& section, const Blades& blades, PointLoad load,
              std::vector<PointLoad>& loads) {
  const double shortest = shortest_loaded(load.blade, blades).length;
  load.position = read_position(section, load.blade, blades).value_or(shortest);
  const bool is_alike = !load.blade.is_all() || section.has("position") ||
                        std::all_of(blades.begin(), blades.end(), [shortest](const Blade& blade) {
                          return blade.length == shortest;
                        });
  if (is_alike) {
    loads.push_back(std::move(load));
    return;
  }
  for (std::size_t i = 0; i < blades.size(); ++i) {
    load.blade = BladeChoice::number(static_cast<int>(i) + 1);
    load.position = blades[i].length;
    loads.push_back(load);
  }
}

DistributedLoad read_distributed_load(const TomlSection& section, const Blades& blades) {
  if (!section.has("force_per_length") && !section.has("moment_per_length")) {
    section.fail("",
                 "has neither force_per_length nor moment_per_length, expected "
                 "force_per_length = [x, y] or moment_per_length = M");
  }
  DistributedLoad load;
  load.blade = read_blade(section, blades.size());
  read_ends(section, blades, load);
  load.force_per_length = read_vector(section, "force_per_length", kForcePerLength);
  read_course(section, load);
  return load;
}

/// Refuses a key that would be ignored because none of those that need it is there.
void require_use(const TomlSection& section, std::string_view key, std::string_view first,
                 std::string_view second) {
  if (!section.has(key) || section.has(first) || section.has(second)) return;
  section.fail(key, "would be ignored, expected only with " + join_names({first, second}));
}

Drag read_drag(const TomlSection& section, const Blades& blades) {
  const TomlSection::Keys coefficients = {"linear", "quadratic", "linear_per_length",
                                          "quadratic_per_length"};
  if (std::none_of(coefficients.begin(), coefficients.end(),
                   [&](std::string_view key) { return section.has(key); }))
    section.fail("", "has no coefficient, expected " + join_names(coefficients));
  require_use(section, "position", "linear", "quadratic");
  require_use(section, "from", "linear_per_length", "quadratic_per_length");
  require_use(section, "to", "linear_per_length", "quadratic_per_length");
  Drag drag;
  drag.blade = read_blade(section, blades.size());
  drag.position = read_position(section, drag.blade, blades);
  read_ends(section, blades, drag);
  read_course(section, drag);
  return drag;
}

HubLoad read_hub_load(const TomlSection& section) {
  if (!section.has("force") && !section.has("torque")) {
    section.fail("", "has neither force nor torque, expected force = [x, y] or torque = M");
  }
  if (section.has("position") && !section.has("force"))
    section.fail("position", "would be ignored, expected only with \"force\"");
  HubLoad load;
  load.position = read_vector(section, "position", kLength);
  load.force = read_vector(section, "force", kForce);
  read_course(section, load);
  return load;
}

}  // namespace

std::string read_load_name(const TomlSection& section) {
  if (!section.has("name")) return {};
  std::string name = section.text("name", "");
  if (!is_name(name)) section.fail_expected("name", kNameExpected);
  if (const std::string fault = find_load_name_fault(name); !fault.empty())
    section.fail("name", fault);
  return name;
}

void read_loads(const TomlSection& root, Rotor& rotor) {
  const Blades& blades = rotor.blades;
  for (const char* key : {"load", "distributed_load", "drag"})
    if (blades.empty() && root.has(key)) root.fail(key, kNoBlades);
  PointCount count(blades);
  for (const TomlSection& section :
       root.sections("load", keys_of_load<PointLoad>(keys::kPointLoadRows))) {
    PointLoad load = read_load(section, blades);
    count.add(section, load, false);
    add_load(section, blades, std::move(load), rotor.loads);
  }
  for (const TomlSection& section : root.sections(
           "distributed_load", keys_of_load<DistributedLoad>(keys::kDistributedLoadRows))) {
    rotor.distributed_loads.push_back(read_distributed_load(section, blades));
    count.add(section, rotor.distributed_loads.back(), true);
  }
  for (const TomlSection& section : root.sections("drag", keys_of_load<Drag>(keys::kDragRows))) {
    rotor.drags.push_back(read_drag(section, blades));
    count.add(section, rotor.drags.back(), is_distributed(rotor.drags.back()));
  }
  for (const TomlSection& section : root.sections(
           "hub_load",
           keys::keys_of(keys::kLoadNameRows, keys::kHubLoadRows, keys::kLoadCourseRows<HubLoad>)))
    rotor.hub_loads.push_back(read_hub_load(section));
}

}  // namespace spoke
