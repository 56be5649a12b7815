// A tower is a tube of layers, the outermost first. WISDEM, which writes these files, has x
// downwind and z up, tensors with six entries as scenarios have them.

#include "program/foreign/windio_turbine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

constexpr const char* kMasses = "elastic_properties_mb";

/// A layer of the tower: its thickness over the height, and its material.
struct Layer {
  Course thickness;
  double youngs_modulus, shear_modulus, density;
};

/// Returns a property of a material that is the same in all directions.
double isotropic(const Entry& material, const char* key) { return material.at(key).positive(); }

Layer read_layer(const Entry& entry, const Entry& root) {
  const Entry name = entry.at("material");
  for (const Entry& material : root.at("materials").elements())
    if (material.at("name").text() == name.text())
      return {read_course(entry.at("thickness")), isotropic(material, "E"),
              isotropic(material, "G"), isotropic(material, "rho")};
  name.refuse("is \"" + printable(name.text()) + "\", expected a name of materials");
}

/// The area, and the second moment of it about a diameter, of a ring.
struct Ring {
  double area, second;
  Ring(double outer, double inner)
      : area(0.25 * std::numbers::pi * (outer * outer - inner * inner)),
        second(std::numbers::pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4))) {}
};

void add_section(const std::vector<Layer>& layers, double place, double diameter, double outfitting,
                 const Entry& entry, BeamTable& tower) {
  double mass = 0.0, axial = 0.0, bending = 0.0, torsion = 0.0, inertia = 0.0;
  for (const Layer& layer : layers) {
    const double inner = diameter - 2.0 * layer.thickness.at(place);
    if (!(inner >= 0.0 && inner < diameter))
      entry.refuse("layers are " + describe(0.5 * (diameter - inner)) + " m thick at " +
                   describe(place) + ", expected more than 0 and less than the radius there, " +
                   describe(0.5 * diameter));
    const Ring ring(diameter, inner);
    mass += layer.density * ring.area * outfitting;
    inertia += layer.density * ring.second * outfitting;
    axial += layer.youngs_modulus * ring.area;
    bending += layer.youngs_modulus * ring.second;
    torsion += 2.0 * layer.shear_modulus * ring.second;
    diameter = inner;
  }
  tower.mass_per_length.push_back(mass);
  tower.axial_stiffness.push_back(axial);
  tower.flap_stiffness.push_back(bending);
  tower.lag_stiffness.push_back(bending);
  tower.torsion_stiffness.push_back(torsion);
  tower.flap_inertia.push_back(inertia);
  tower.lag_inertia.push_back(inertia);
}

/// Refuses a tower that leans or bends.
void check_straight(const Entry& axis) {
  for (const char* key : {"x", "y"})
    for (const double value : read_course(axis.at(key)).values)
      if (value != 0.0)
        axis.at(key).refuse("is " + describe(value) + ", expected 0: a tower that stands upright");
}

void read_tower_air(const Entry& shape, const Course& diameter, const BeamTable& tower,
                    FoundModel& model) {
  const Entry table = shape.at("drag_coefficient");
  const Course drag = read_course(table);
  FoundTowerAir air;
  for (const double x : tower.station) {
    const double place = x / tower.length.number;
    air.station.push_back(x);
    air.diameter.push_back(diameter.at(place));
    air.coefficient.push_back(drag.at(place));
    if (!(air.coefficient.back() >= 0.0))
      table.refuse("is " + describe(air.coefficient.back()) + ", expected 0 or more");
  }
  air.from = "that of the tower; diameter and coefficient are outer_diameter and " + table.from();
  model.air->tower = std::move(air);
}

void read_tower(const Entry& root, FoundModel& model) {
  const Entry tower = root.at("components").at("tower"), shape = tower.at("outer_shape_bem"),
              structure = tower.at("internal_structure_2d_fem"), axis = shape.at("reference_axis");
  check_straight(axis);
  const Entry z = axis.at("z");
  const Course height = read_course(z), diameter = read_course(shape.at("outer_diameter"));
  std::vector<Layer> layers;
  for (const Entry& layer : structure.at("layers").elements())
    layers.push_back(read_layer(layer, root));
  std::vector<double> places = unite_grids({&height.grid, &diameter.grid});
  for (const Layer& layer : layers) places = unite_grids({&places, &layer.thickness.grid});
  const double outfitting =
      structure.has("outfitting_factor") ? structure.at("outfitting_factor").positive() : 1.0;
  BeamTable beam;
  const double foot = height.at(0.0);
  beam.length = {height.at(1.0) - foot, "z of " + axis.from()};
  if (!(beam.length.number > 0.0)) z.refuse("does not rise, expected a tower that stands upright");
  for (const double place : places) {
    const double x = place == 1.0 ? beam.length.number : height.at(place) - foot;
    if (!beam.station.empty() && !(x > beam.station.back()))
      z.refuse("is " + describe(x + foot) + ", expected more than before, " +
               describe(beam.station.back() + foot));
    beam.station.push_back(x);
    beam.station_from.push_back("grid " + describe(place) + " of " + tower.path());
    add_section(layers, place, diameter.at(place), outfitting, structure, beam);
  }
  beam.remarks.emplace_back(
      "Sections are tubes of the layers, the outermost first; their mass is by outfitting_factor.");
  model.ground = {foot == 0.0 ? 0.0 : -foot, z.from() + ", below the foot of the tower"};
  model.tower = std::move(beam);
  if (model.air && shape.has("drag_coefficient"))
    read_tower_air(shape, diameter, *model.tower, model);
}

/// Reads three moments of inertia, or six entries of a tensor.
std::vector<double> read_inertia(const Entry& entry) {
  std::vector<double> inertia = entry.numbers();
  if (inertia.size() != 3 && inertia.size() != 6)
    entry.refuse("has " + std::to_string(inertia.size()) + " elements, expected 3 or 6");
  return inertia;
}

/// Returns the masses of the nacelle, of the drive train or of the nacelle itself; none.
std::optional<Entry> find_masses(const Entry& nacelle) {
  if (nacelle.at("drivetrain").has(kMasses)) return nacelle.at("drivetrain").at(kMasses);
  if (nacelle.has(kMasses)) return nacelle.at(kMasses);
  return std::nullopt;
}

void read_masses(const Entry& masses, Nacelle& nacelle, FoundModel& model) {
  const Entry mass = masses.at("system_mass");
  nacelle.mass = {mass.positive(), mass.from()};
  const Entry center = masses.at("system_center_mass"), inertia = masses.at("system_inertia");
  const std::vector<double> place = center.numbers();
  if (place.size() != 3)
    center.refuse("has " + std::to_string(place.size()) + " elements, expected 3");
  nacelle.center = {place[0], place[1], place[2]};
  nacelle.center_from = center.from();
  nacelle.inertia = read_inertia(inertia);
  nacelle.inertia_from = inertia.from();
  if (!masses.has("yaw_mass")) return;
  const Entry yaw = masses.at("yaw_mass");
  if (!(yaw.number() >= 0.0)) yaw.refuse("is " + describe(yaw.number()) + ", expected 0 or more");
  model.tower->tip_mass = {yaw.number(), yaw.from()};
}

/// A shaft with torsion, if both its spring and the generator are there.
void read_shaft(const Entry& nacelle, const Entry& masses, FoundModel& model) {
  const Entry train = nacelle.at("drivetrain");
  if (train.has("gear_ratio")) {
    const Entry ratio = train.at("gear_ratio");
    model.gear_ratio = {ratio.positive(), ratio.from()};
  }
  if (!masses.has("spring_constant") || !nacelle.has("generator")) return;
  const Entry generator = nacelle.at("generator");
  if (!generator.has(kMasses) || !generator.at(kMasses).has("rotor_inertia")) return;
  const Entry spring = masses.at("spring_constant"),
              rotor = generator.at(kMasses).at("rotor_inertia");
  const std::vector<double> inertia = read_inertia(rotor);
  if (!(inertia[0] > 0.0)) rotor.refuse("is " + describe(inertia[0]) + ", expected more than 0");
  FoundTrain found{{spring.positive(), spring.from()},
                   {},
                   model.gear_ratio,
                   {inertia[0], rotor.from() + ", about the axis"}};
  if (found.gear_ratio.from.empty()) found.gear_ratio.from = "not in the files";
  if (masses.has("damping_coefficient")) {
    const Entry damping = masses.at("damping_coefficient");
    found.damping = {damping.number(), damping.from()};
    if (!(damping.number() >= 0.0))
      damping.refuse("is " + describe(damping.number()) + ", expected 0 or more");
  }
  model.train = std::move(found);
}

void read_nacelle_of_windio(const Entry& root, bool is_upwind, FoundModel& model) {
  const Entry nacelle = root.at("components").at("nacelle"), train = nacelle.at("drivetrain");
  const Entry overhang = train.at("overhang"), height = train.at("distance_tt_hub");
  const double side = is_upwind ? -1.0 : 1.0;
  Nacelle found;
  found.hub = {side * overhang.number(), 0.0, height.number()};
  found.hub_from = overhang.from() + ", and distance_tt_hub";
  if (train.has("uptilt")) {
    const Entry tilt = train.at("uptilt");
    found.tilt = tilt.number() == 0.0 ? 0.0 : -side * tilt.number();
    found.tilt_from = tilt.from();
  }
  if (const std::optional<Entry> masses = find_masses(nacelle)) {
    read_masses(*masses, found, model);
    read_shaft(nacelle, *masses, model);
  } else {
    found.mass = {1.0, "not in the file: next to nothing"};
    found.inertia = {1.0, 1.0, 1.0};
    found.inertia_from = found.center_from = "not in the file";
    model.leave_out(Loss::part,
                    train.from() + ": has no " + kMasses + ", so that the nacelle is without mass");
  }
  model.nacelle = std::move(found);
}

void read_hub_of_windio(const Entry& root, FoundModel& model) {
  const Entry components = root.at("components");
  if (!components.has("hub") || !components.at("hub").has(kMasses)) {
    model.leave_out(Loss::part, std::string("components.hub: has no ") + kMasses +
                                    ", so that the hub is without mass");
    return;
  }
  const Entry masses = components.at("hub").at(kMasses), mass = masses.at("system_mass"),
              inertia = masses.at("system_inertia");
  model.hub_mass = {mass.positive(), mass.from()};
  model.hub_tensor = read_inertia(inertia);
  model.hub_inertia = {0.0, inertia.from()};
}

/// The rotor turns at its rated speed.
void read_speed(const Entry& root, FoundModel& model) {
  if (root.has("control") && root.at("control").has("torque") &&
      root.at("control").at("torque").has("VS_maxspd")) {
    const Entry speed = root.at("control").at("torque").at("VS_maxspd");
    model.speed = {speed.positive(), speed.from() + ", the rated one"};
  }
}

}  // namespace

bool has_windio_turbine(const Entry& root) {
  const Entry components = root.at("components");
  if (!components.has("tower") || !components.has("nacelle")) return false;
  const Entry tower = components.at("tower"), nacelle = components.at("nacelle");
  return tower.has("outer_shape_bem") && tower.has("internal_structure_2d_fem") &&
         nacelle.has("drivetrain") && nacelle.at("drivetrain").has("overhang") &&
         nacelle.at("drivetrain").has("distance_tt_hub");
}

void read_windio_turbine(const Entry& root, bool is_upwind, FoundModel& model) {
  read_tower(root, model);
  read_nacelle_of_windio(root, is_upwind, model);
  read_hub_of_windio(root, model);
  read_speed(root, model);
}

}  // namespace spoke::foreign
