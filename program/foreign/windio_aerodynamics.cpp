// Stations are the places of all grids of the outer shape. Between two aerofoils polars are linear
// along the grid of their positions, so that each station in between has an aerofoil of its own.

#include "program/foreign/windio_aerodynamics.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "models/support/quantity.h"
#include "program/foreign/beam_twist.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/windio_polars.h"

namespace spoke::foreign {
namespace {

/// An aerofoil at a place of the axis.
struct PlacedAirfoil {
  double place = 0.0;
  WindioAirfoil airfoil;
};

Entry shape_of(const Entry& root, bool is_version_2) {
  return root.at("components").at("blade").at(is_version_2 ? "outer_shape" : "outer_shape_bem");
}

std::vector<PlacedAirfoil> place_airfoils_1(const Entry& root, const Entry& shape) {
  const Entry position = shape.at("airfoil_position"), labels = position.at("labels");
  const std::vector<double> grid = read_grid(position);
  const std::vector<Entry> names = labels.elements();
  check_count(labels, names.size(), grid.size());
  std::vector<PlacedAirfoil> placed;
  for (std::size_t k = 0; k < grid.size(); ++k)
    placed.push_back({grid[k], read_windio_airfoil(root.at("airfoils"), names[k], names[k],
                                                   180.0 / std::numbers::pi)});
  return placed;
}

std::vector<PlacedAirfoil> place_airfoils_2(const Entry& root, const Entry& shape) {
  std::vector<PlacedAirfoil> placed;
  const Entry list = shape.at("airfoils");
  for (const Entry& use : list.elements()) {
    const Entry at = use.at("spanwise_position");
    const double place = at.number();
    if (!(place >= 0.0 && place <= 1.0)) at.refuse("is " + describe(place) + ", expected 0 to 1");
    constexpr double least_gap = 1e-9;
    if (!placed.empty() && !(place > placed.back().place + least_gap))
      at.refuse("is " + describe(place) + ", expected more than that of the one before, " +
                describe(placed.back().place));
    placed.push_back({place, read_windio_airfoil(root.at("airfoils"), use.at("name"), use, 1.0)});
  }
  if (placed.empty()) list.refuse("has no elements, expected one or more");
  return placed;
}

/// The aerofoils of stations, which are made when they are needed.
class Airfoils {
 public:
  Airfoils(std::vector<PlacedAirfoil> placed, std::string from, FoundAir& air)
      : placed_(std::move(placed)), from_(std::move(from)), air_(&air) {}

  std::vector<double> places() const {
    std::vector<double> all;
    for (const PlacedAirfoil& one : placed_) all.push_back(one.place);
    return all;
  }
  bool has_more() const {
    return std::any_of(placed_.begin(), placed_.end(),
                       [](const PlacedAirfoil& one) { return one.airfoil.has_more; });
  }
  /// Adds the aerofoil at a place to the blade. Returns the place of its aerodynamic centre, from
  /// the leading edge by the chord.
  double add(double place) {
    const auto above =
        std::upper_bound(placed_.begin(), placed_.end(), place,
                         [](double at, const PlacedAirfoil& one) { return at < one.place; });
    const auto k = static_cast<std::size_t>(above - placed_.begin());
    if (k == 0) return add_own(placed_.front());
    if (k == placed_.size()) return add_own(placed_.back());
    const PlacedAirfoil &a = placed_[k - 1], &b = placed_[k];
    const double share = (place - a.place) / (b.place - a.place);
    constexpr double small = 1e-6;
    if (share < small || a.airfoil.name == b.airfoil.name) return add_own(a);
    if (share > 1.0 - small) return add_own(b);
    std::vector<FoundAirfoil>& all = air_->airfoils;
    const std::string name =
        choose_airfoil_name(fmt::format("station_{:02}", air_->blade.station.size()), all);
    all.push_back(make_airfoil(mix_polars(a.airfoil.polars, b.airfoil.polars, share), name,
                               fmt::format("{:.4f} of {} and {:.4f} of {}, {}", 1.0 - share,
                                           a.airfoil.name, share, b.airfoil.name, from_)));
    air_->blade.airfoil.push_back(name);
    return (1.0 - share) * a.airfoil.center + share * b.airfoil.center;
  }

 private:
  double add_own(const PlacedAirfoil& one) {
    std::string& name = names_[one.airfoil.name];
    if (name.empty()) {
      name = choose_airfoil_name(one.airfoil.name, air_->airfoils);
      air_->airfoils.push_back(
          make_airfoil(one.airfoil.polars, name, one.airfoil.name + ", " + from_));
    }
    air_->blade.airfoil.push_back(name);
    return one.airfoil.center;
  }

  std::vector<PlacedAirfoil> placed_;
  std::string from_;
  FoundAir* air_;
  std::map<std::string, std::string> names_;
};

void read_environment(const Entry& root, FoundAir& air) {
  if (root.has("environment")) {
    const Entry all = root.at("environment");
    const auto read = [&](const char* key, Value& value) {
      if (all.has(key)) value = {all.at(key).positive(), all.at(key).from()};
    };
    read("air_density", air.density);
    read("air_dyn_viscosity", air.viscosity);
    if (all.has("shear_exp"))
      air.shear = {all.at("shear_exp").number(), all.at("shear_exp").from()};
    if (air.viscosity.number > 0.0) {
      air.viscosity.number /= air.density.number > 0.0 ? air.density.number : 1.225;
      air.viscosity.from += ", by the density";
    }
  }
  if (root.has("assembly") && root.at("assembly").has("hub_height")) {
    const Entry height = root.at("assembly").at("hub_height");
    air.reference_height = {height.positive(), height.from()};
  }
}

/// What the chord's twist is against the sections, which have their own.
std::vector<double> find_twist(const Course& outer, const Course& sections, double unit,
                               const std::vector<double>& places, const FoundModel& model) {
  std::vector<double> twist;
  if (outer.grid == sections.grid && outer.values == sections.values) return twist;
  for (std::size_t i = 0; i < places.size(); ++i)
    twist.push_back(-unit * outer.at(places[i]) -
                    twist_at(*model.blade, model.air->blade.station[i]));
  return twist;
}

}  // namespace

bool has_windio_aerodynamics(const Entry& root, bool is_version_2) {
  const char* key = is_version_2 ? "outer_shape" : "outer_shape_bem";
  return root.has("airfoils") && root.at("components").at("blade").has(key) &&
         shape_of(root, is_version_2).has(is_version_2 ? "airfoils" : "airfoil_position");
}

void read_windio_aerodynamics(const Entry& root, bool is_version_2, const Entry& axis,
                              const Entry& twist, FoundModel& model) {
  FoundAir& air = model.air.emplace();
  const Entry shape = shape_of(root, is_version_2);
  const Course chord = read_course(shape.at("chord")), outer = read_course(shape.at("twist")),
               offset = read_course(shape.at(is_version_2 ? "section_offset_y" : "pitch_axis")),
               z = read_course(axis.at("z"));
  for (const double value : chord.values)
    if (!(value >= 0.0))
      shape.at("chord").at("values").refuse("has " + describe(value) + ", expected 0 or more");
  const char* key = is_version_2 ? "airfoils" : "airfoil_position";
  Airfoils airfoils(is_version_2 ? place_airfoils_2(root, shape) : place_airfoils_1(root, shape),
                    shape.at(key).from(), air);
  const std::vector<double> own = airfoils.places();
  const auto places = unite_grids({&chord.grid, &outer.grid, &offset.grid, &own});
  for (const double place : places) {
    constexpr double small = 1e-6;  // [m]; what rounding leaves at the root
    const double x = std::min(z.at(place), model.blade->length.number);
    air.blade.station.push_back(std::abs(x) < small ? 0.0 : x);
    air.station_from.push_back("at " + describe(place) + " of the axis");
    const double size = chord.at(place), center = airfoils.add(place) * size;
    air.blade.chord.push_back(size);
    air.blade.center.push_back((is_version_2 ? offset.at(place) : offset.at(place) * size) -
                               center);
  }
  air.blade.twist = find_twist(outer, read_course(twist),
                               is_version_2 ? std::numbers::pi / 180.0 : 1.0, places, model);
  air.remarks.push_back("Stations are the places of all grids of " + shape.from() +
                        "; between two aerofoils polars are linear along the blade.");
  read_environment(root, air);
  if (airfoils.has_more())
    model.leave_out(Loss::theory,
                    root.at("airfoils").from() +
                        ": sets of polars (configuration) but the first of each aerofoil");
}

}  // namespace spoke::foreign
