// Cuts blades into bodies.

#include "models/system/system.h"

#include <map>
#include <tuple>
#include <utility>

#include "models/system/beam_elements.h"

namespace spoke {
namespace {

/// Makes constants once per distinct set of properties, so that equal bodies share them.
class BodyCatalogue {
 public:
  std::shared_ptr<const FlexibleBody> body(const BeamProperties& beam) {
    auto& made = bodies_[beam];
    if (!made) made = std::make_shared<const FlexibleBody>(make_beam_body(beam));
    return made;
  }

  std::shared_ptr<const SymmetricBand<3>> stiffness(const BeamProperties& beam, double distance,
                                                    double outboard) {
    return shared(stiffnesses_[{beam, distance, outboard}],
                  [&] { return make_centrifugal_stiffness(beam, distance, outboard); });
  }

  std::shared_ptr<const SymmetricBand<3>> slope_integral(const BeamProperties& beam) {
    return shared(slope_integrals_[beam], [&] { return make_slope_integral(beam); });
  }

 private:
  using SharedBand = std::shared_ptr<const SymmetricBand<3>>;
  template <class Make>
  static SharedBand shared(SharedBand& made, Make&& make) {
    if (!made) made = std::make_shared<const SymmetricBand<3>>(make());
    return made;
  }

  std::map<BeamProperties, std::shared_ptr<const FlexibleBody>> bodies_;
  std::map<std::tuple<BeamProperties, double, double>, SharedBand> stiffnesses_;
  std::map<BeamProperties, SharedBand> slope_integrals_;
};

Subsystem make_subsystem(const Hub& hub, const Blade& blade, BodyCatalogue& catalogue) {
  const BeamProperties beam = make_beam_properties(blade);
  const double tip = hub.radius + blade.length;
  Subsystem subsystem;
  subsystem.root.R = Rotation::from_angle(blade.azimuth);
  subsystem.root.p = subsystem.root.R * Position{hub.radius, 0.0};
  subsystem.length = blade.length;
  for (int j = 0; j < blade.bodies; ++j) {
    ChainBody member;
    member.body = catalogue.body(beam);
    if (blade.geometric_stiffening) {
      const double distance = hub.radius + j * beam.length;
      const double end = distance + beam.length;
      const double outboard =
          j + 1 == blade.bodies ? 0.0 : beam.mass_per_length * (tip * tip - end * end) / 2.0;
      member.centrifugal_stiffness = catalogue.stiffness(beam, distance, outboard);
      member.slope_integral = catalogue.slope_integral(beam);
    }
    subsystem.bodies.push_back(std::move(member));
  }
  return subsystem;
}

void put_loads(std::vector<BodyLoads> placed, Subsystem& subsystem) {
  for (std::size_t j = 0; j < placed.size(); ++j) {
    subsystem.bodies[j].loads = std::move(placed[j].loads);
    subsystem.bodies[j].drags = std::move(placed[j].drags);
  }
}

}  // namespace

int System::body_count() const {
  int count = 0;
  for (const Subsystem& s : subsystems) count += static_cast<int>(s.bodies.size());
  return count;
}

int System::deformation_count() const {
  int count = 0;
  for (const Subsystem& s : subsystems)
    for (const ChainBody& member : s.bodies) count += member.body->coordinates();
  return count;
}

bool is_prescribed(const Hub& hub, int c) {
  return c < kPosition ? hub.support == HubSupport::axle : prescribes_motion(hub.drive);
}

System make_system(const Rotor& rotor) {
  System system;
  system.hub = rotor.hub;
  system.gravity = rotor.gravity;
  system.gravity_ramp = rotor.gravity_ramp;
  system.damping = rotor.damping;
  system.hub_loads = rotor.hub_loads;
  BodyCatalogue catalogue;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    system.subsystems.push_back(make_subsystem(rotor.hub, rotor.blades[i], catalogue));
    put_loads(make_body_loads(rotor, i), system.subsystems.back());
  }
  return system;
}

}  // namespace spoke
