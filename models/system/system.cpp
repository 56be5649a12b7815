// Cuts blades into bodies.

#include "models/system/system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "models/plane/beam_elements.h"

namespace spoke {
namespace {

/// Makes constants once per distinct set of properties, so that equal bodies share them.
class BodyCatalogue {
 public:
  std::shared_ptr<const plane::FlexibleBody> body(const plane::BeamProperties& beam,
                                                  const plane::StrainDamping& damping) {
    auto& made = bodies_[{beam, damping}];
    if (made) return made;
    plane::FlexibleBody body = make_beam_body(beam);
    body.damping = damping;
    return made = std::make_shared<const plane::FlexibleBody>(std::move(body));
  }

  std::shared_ptr<const plane::SymmetricBand<3>> stiffness(const plane::BeamProperties& beam,
                                                           double distance, double outboard) {
    return shared(stiffnesses_[{beam, distance, outboard}],
                  [&] { return make_centrifugal_stiffness(beam, distance, outboard); });
  }

  std::shared_ptr<const plane::SymmetricBand<3>> outboard_mass(const plane::BeamProperties& beam,
                                                               double outboard) {
    return shared(outboard_masses_[{beam, outboard}],
                  [&] { return make_outboard_mass_stiffness(beam, outboard); });
  }

  std::shared_ptr<const plane::SymmetricBand<3>> slope_integral(const plane::BeamProperties& beam) {
    return shared(slope_integrals_[beam], [&] { return make_slope_integral(beam); });
  }

 private:
  using SharedBand = std::shared_ptr<const plane::SymmetricBand<3>>;
  template <class Make>
  static SharedBand shared(SharedBand& made, Make&& make) {
    if (!made) made = std::make_shared<const plane::SymmetricBand<3>>(make());
    return made;
  }

  std::map<std::pair<plane::BeamProperties, plane::StrainDamping>,
           std::shared_ptr<const plane::FlexibleBody>>
      bodies_;
  std::map<std::tuple<plane::BeamProperties, double, double>, SharedBand> stiffnesses_;
  std::map<std::tuple<plane::BeamProperties, double>, SharedBand> outboard_masses_;
  std::map<plane::BeamProperties, SharedBand> slope_integrals_;
};

/// Returns int rhoA r dr over a body that begins at r = `distance`, its point masses included [kg
/// m].
double first_moment(const plane::BeamProperties& beam, double distance) {
  if (beam.pieces.empty())
    return beam.mass_per_length * beam.length * (distance + beam.length / 2.0);
  const plane::BeamPiece& first = beam.pieces.front();
  return first_moment_beyond(first, first.begin, distance) +
         first_moments_outboard(beam.pieces, beam.masses, distance).front();
}

/// Returns, for each body of a blade that is not uniform, int rhoA r dr over the bodies outboard of
/// it and their point masses [kg m].
std::vector<double> find_outboard_moments(const Hub& hub, const Blade& blade) {
  if (plane::is_uniform(blade)) return {};
  std::vector<double> moments(static_cast<std::size_t>(blade.bodies));
  double sum = 0.0;
  for (int j = blade.bodies - 1; j >= 0; --j) {
    moments[static_cast<std::size_t>(j)] = sum;
    const plane::BeamProperties beam = plane::make_beam_properties(blade, j);
    sum += first_moment(beam, hub.radius + j * beam.length);
  }
  return moments;
}

/// Makes a place of a loop; one on the blade is at the outboard end of one of its bodies.
LoopPlaceModel make_place(const LoopPlace& place, const Rotor& rotor, const Blade& blade) {
  LoopPlaceModel made;
  made.carrier = place.carrier;
  const spatial::Vector rotation = place.orientation.value_or(spatial::Vector::Zero());
  made.offset = {space::Position(place.point), space::exponential(space::Angular(rotation))};
  if (place.carrier != LoopPlace::Carrier::body) {
    const space::Rotation turn = space::exponential(space::Angular(0.0, 0.0, blade.azimuth));
    made.offset = {turn * made.offset.p, turn * made.offset.R};
  }
  if (place.carrier == LoopPlace::Carrier::anchor) {
    const auto anchor =
        std::find_if(rotor.anchors.begin(), rotor.anchors.end(),
                     [&place](const Anchor& known) { return known.name == place.name; });
    assert(anchor != rotor.anchors.end());
    made.anchor = static_cast<int>(anchor - rotor.anchors.begin());
  } else if (place.carrier == LoopPlace::Carrier::body) {
    const double length = blade.length / blade.bodies;
    made.body = static_cast<int>(std::lround(place.station.value_or(blade.length) / length)) - 1;
    made.handle = 1;
    assert(made.body >= 0 && made.body < blade.bodies);
  }
  return made;
}

void add_loops(const Rotor& rotor, std::size_t i, Subsystem<Plane>& subsystem) {
  const Blade& blade = rotor.blades[i];
  for (const Loop& loop : blade.loops) {
    LoopModel& made = subsystem.loops.emplace_back(make_loop(loop, true));
    made.owner = "blade " + std::to_string(i + 1);
    made.key =
        "blades." + std::to_string(i + 1) + ".loop." + std::to_string(subsystem.loops.size());
    made.from = make_place(loop.from, rotor, blade);
    made.to = make_place(loop.to, rotor, blade);
  }
}

/// Returns the strain of a blade: its own, or where that leaves the choice the one that suits it.
/// Linear strains know all tension but that of loops.
BeamStrain choose_strain(const Blade& blade) {
  if (blade.strain != BeamStrain::automatic) return blade.strain;
  return blade.geometric_stiffening && !blade.loops.empty() ? BeamStrain::nonlinear
                                                            : BeamStrain::linear;
}

/// Whether bodies have the tension of the undeformed blade; strains of second order have their own.
bool is_stiffened(const Blade& blade) {
  return blade.geometric_stiffening && blade.strain == BeamStrain::linear;
}

Subsystem<Plane> make_subsystem(const Hub& hub, const Blade& blade, const Damping& damping,
                                BodyCatalogue& catalogue) {
  assert(blade.bodies > 0 && blade.length > 0.0);
  const plane::BeamProperties first = plane::make_beam_properties(blade, 0);
  const std::vector<double> moments = find_outboard_moments(hub, blade);
  const double tip = hub.radius + blade.length;
  Subsystem<Plane> subsystem;
  subsystem.root.R = plane::Rotation::from_angle(blade.azimuth);
  subsystem.root.p = subsystem.root.R * Position{hub.radius, 0.0};
  subsystem.length = blade.length;
  plane::StrainDamping strains{damping.directions.axial, damping.directions.lag};
  BeamModes modes;
  if (!damping.modes.ratios.empty()) {
    modes = find_damped_modes(blade, damping.modes);
    strains.axial += modes.stiffness_factor;
    strains.bending += modes.stiffness_factor;
    subsystem.modal_factors = modes.factors;
  }
  for (int j = 0; j < blade.bodies; ++j) {
    const plane::BeamProperties beam =
        plane::is_uniform(blade) ? first : plane::make_beam_properties(blade, j);
    TreeBody<Plane> member;
    member.parent = j - 1;
    if (j + 1 < blade.bodies) member.children = {j + 1};
    member.body = catalogue.body(beam, strains);
    if (!modes.factors.empty()) member.modal = make_modal_share(modes, blade, *member.body, j);
    if (is_stiffened(blade)) {
      const double distance = hub.radius + j * beam.length;
      const double end = distance + beam.length;
      const double of_uniform =
          j + 1 == blade.bodies ? 0.0 : beam.mass_per_length * (tip * tip - end * end) / 2.0;
      const double outboard = moments.empty() ? of_uniform : moments[static_cast<std::size_t>(j)];
      member.stiffening.centrifugal = catalogue.stiffness(beam, distance, outboard);
      member.stiffening.slope_integral = catalogue.slope_integral(beam);
    }
    subsystem.bodies.push_back(std::move(member));
  }
  return subsystem;
}

/// Returns the undeformed centre of mass of a rotor in the hub's frame [m].
Position find_mass_centre(const Rotor& rotor, const System<Plane>& system) {
  double mass = rotor.hub.mass, extent = 0.0;
  Position moment = Position::Zero();
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    const Blade& blade = rotor.blades[i];
    double along = 0.0;
    for (int j = 0; j < blade.bodies; ++j) {
      const plane::BeamProperties beam = plane::make_beam_properties(blade, j);
      const double distance = rotor.hub.radius + j * beam.length;
      along += first_moment(beam, distance);
      for (const plane::BodyMass& point :
           beam.masses)  // at the inboard end, where a mass does not pull on the body
        if (point.x < 0.5 * beam.pieces.front().end) along += point.mass * distance;
      mass += system.subsystems[i].bodies[static_cast<std::size_t>(j)].body->mass;
    }
    moment += system.subsystems[i].root.R * Position{along, 0.0};
    extent += along;
  }
  // Where the blades balance one another, only round-off remains.
  return moment.norm() > 1e-12 * extent ? Position(moment / mass) : Position::Zero();
}

/// Adds the stiffness due to a field to a blade's bodies: gravity, or for a free hub the applied
/// loads; the blade then turns about the mass centre of the whole.
void add_field_stiffness(const Blade& blade, const Position& centre, BodyCatalogue& catalogue,
                         Subsystem<Plane>& subsystem) {
  if (!is_stiffened(blade)) return;
  const double nearer = (subsystem.root.R.inverse() * centre).x();
  double outboard = 0.0;
  for (int j = blade.bodies - 1; j >= 0; --j) {
    TreeBody<Plane>& body = subsystem.bodies[static_cast<std::size_t>(j)];
    plane::Stiffening& stiffening = body.stiffening;
    stiffening.outboard_mass =
        catalogue.outboard_mass(plane::make_beam_properties(blade, j), outboard);
    outboard += body.body->mass;
    if (nearer == 0.0) continue;
    auto centrifugal = std::make_shared<plane::SymmetricBand<3>>(*stiffening.centrifugal);
    centrifugal->add_scaled(-nearer, *stiffening.outboard_mass);
    stiffening.centrifugal = std::move(centrifugal);
  }
}

void put_loads(std::vector<BodyLoads<Plane>> placed, Subsystem<Plane>& subsystem) {
  for (std::size_t j = 0; j < placed.size(); ++j) {
    subsystem.bodies[j].loads = std::move(placed[j].loads);
    subsystem.bodies[j].drags = std::move(placed[j].drags);
  }
}

}  // namespace

bool is_prescribed(const Hub& hub, int c) {
  assert(c >= 0 && c < kTwist);
  return c < kPosition ? hub.support == HubSupport::axle : prescribes_motion(hub.drive);
}

System<Plane> make_system(const Rotor& description) {
  Rotor rotor = description;
  for (Blade& blade : rotor.blades) blade.strain = choose_strain(blade);
  System<Plane> system;
  system.hub = rotor.hub;
  system.gravity = rotor.gravity;
  system.gravity_ramp = rotor.gravity_ramp;
  system.damping = rotor.damping;
  system.hub_loads = rotor.hub_loads;
  for (const Anchor& anchor : rotor.anchors) system.anchors.push_back(make_anchor(anchor, {}));
  BodyCatalogue catalogue;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    system.subsystems.push_back(
        make_subsystem(rotor.hub, rotor.blades[i], rotor.damping, catalogue));
    put_loads(make_body_loads(rotor, i), system.subsystems.back());
    add_loops(rotor, i, system.subsystems.back());
  }
  const bool flies = rotor.hub.support == HubSupport::free;
  if (!flies && rotor.gravity.isZero(0.0)) return system;
  const Position centre = flies ? find_mass_centre(rotor, system) : Position::Zero();
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    add_field_stiffness(rotor.blades[i], centre, catalogue, system.subsystems[i]);
  return system;
}

}  // namespace spoke
