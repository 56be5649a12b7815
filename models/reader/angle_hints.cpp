// Visits the angles of a scenario. Motions over time may make several turns; they are asked about
// only if all their values are whole numbers, as typed degrees usually are.

#include "models/reader/angle_hints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>
#include <variant>

#include "models/reader/spatial/spatial_fields.h"

namespace spoke {
namespace {

using std::numbers::pi;

/// A bound beyond which an angle is asked about.
struct Bound {
  double angle;       ///< [rad]
  const char* words;  ///< "a turn of 2 pi"
};
constexpr Bound kTurn{2.0 * pi, "a turn of 2 pi"};
constexpr Bound kHalfTurn{pi, "half a turn, pi"};
constexpr Bound kRightAngle{0.5 * pi, "a right angle, pi/2"};

/// The hints so far, one for each kind of angle.
class Hints {
 public:
  /// Looks at one angle. `kind`: "precone"; `of`: its owner, "blade 1".
  void look(const std::string& kind, const std::string& of, double angle, const Bound& bound) {
    if (!(std::abs(angle) > bound.angle) || !kinds_.insert(kind).second) return;
    std::ostringstream text;  // text in six digits, since azimuths are computed
    text << "the " << kind << " of " << of << " is " << angle << " rad, beyond " << bound.words
         << ": degrees?";
    texts_.push_back(text.str());
  }
  /// Looks at values over time.
  void look(const std::string& kind, const std::string& of, const Curve& curve) {
    const std::vector<double>& values = curve.values();
    const bool is_whole =
        std::all_of(values.begin(), values.end(), [](double v) { return v == std::floor(v); });
    if (values.size() > 1 && !is_whole) return;
    for (const double value : values) look(kind, of, value, kTurn);
  }

  std::vector<std::string> take() { return std::move(texts_); }

 private:
  std::set<std::string> kinds_;
  std::vector<std::string> texts_;
};

/// Looks at the angles of blades, in the plane or in space. An azimuth that is not given is that of
/// the first blade plus a share of a turn.
template <class Blade>
void look_at_azimuths(const std::vector<Blade>& blades, Hints& hints) {
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const double share = kTurn.angle * static_cast<double>(i) / static_cast<double>(blades.size());
    if (std::abs(blades[i].azimuth - share) > kTurn.angle)
      hints.look("azimuth", "blade " + std::to_string(i + 1), blades[i].azimuth, kTurn);
  }
}

void look_at_motion(const std::string& of, const spatial::Motion& motion, Hints& hints) {
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion))
    return hints.look("motion", of, table->value);
  if (const auto* program = std::get_if<spatial::ProgramMotion>(&motion))
    return hints.look("initial", of, program->initial, kTurn);
  const auto& pitch = std::get<spatial::AzimuthMotion>(motion);
  hints.look("mean", of, pitch.mean, kHalfTurn);
  hints.look("cosine", of, pitch.cosine, kHalfTurn);
  hints.look("sine", of, pitch.sine, kHalfTurn);
}

void look_at_joint(const std::string& of, const spatial::Joint& joint, Hints& hints) {
  hints.look("orientation", of, joint.orientation.norm(), kTurn);
  for (int i = 0; i < spatial::count_coordinates(joint.kind); ++i) {
    if (spatial::slides(joint.kind, i)) continue;
    const spatial::JointCoordinate& coordinate = joint.coordinates[static_cast<std::size_t>(i)];
    hints.look("rest", of, coordinate.rest, kTurn);
    hints.look("initial", of, coordinate.initial, kTurn);
    if (coordinate.motion) look_at_motion(of, *coordinate.motion, hints);
    if (!coordinate.stop) continue;
    hints.look("stop.lower", of, coordinate.stop->lower, kTurn);
    hints.look("stop.upper", of, coordinate.stop->upper, kTurn);
    hints.look("stop.width", of, coordinate.stop->width, kTurn);
  }
}

/// Returns "joint 2", or the joint's name.
std::string describe_joint(const spatial::Joint& joint, std::size_t index) {
  return joint.name.empty() ? "joint " + std::to_string(index + 1) : "joint \"" + joint.name + '"';
}

void look_at_loops(const std::string& of, const std::vector<Loop>& loops, Hints& hints) {
  for (const Loop& loop : loops)
    for (const LoopPlace* place : {&loop.from, &loop.to})
      if (place->orientation)
        hints.look("orientation", "loop \"" + loop.name + "\" of " + of, place->orientation->norm(),
                   kTurn);
}

void look_at_twist(const std::string& of, const spatial::Beam& beam, Hints& hints) {
  for (const double twist : beam.sections.twist) hints.look("twist", of, twist, kHalfTurn);
}

void look_at_blades(const std::vector<spatial::Blade>& blades, Hints& hints) {
  look_at_azimuths(blades, hints);
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const std::string of = "blade " + std::to_string(i + 1);
    hints.look("precone", of, blades[i].precone, kRightAngle);
    look_at_twist(of, blades[i].beam, hints);
    if (blades[i].aerodynamics)
      for (const double twist : blades[i].aerodynamics->twist)
        hints.look("aerodynamics.twist", of, twist, kHalfTurn);
    for (std::size_t k = 0; k < blades[i].joints.size(); ++k) {
      const spatial::Joint& joint = blades[i].joints[k].joint;
      look_at_joint(describe_joint(joint, k) + " of " + of, joint, hints);
    }
    look_at_loops(of, blades[i].loops, hints);
  }
}

void look_at_subsystem(const spatial::Subsystem& subsystem, Hints& hints) {
  const std::string of = " of subsystem \"" + subsystem.name + '"';
  // The last of several copies is nearly a turn beyond the first.
  if (std::abs(subsystem.azimuth) > 2.0 * kTurn.angle)
    hints.look("azimuth", of.substr(sizeof(" of ") - 1), subsystem.azimuth, kTurn);
  for (const spatial::Body& body : subsystem.bodies)
    if (const auto* beam = std::get_if<spatial::Beam>(&body.shape))
      look_at_twist("body \"" + body.name + '"' + of, *beam, hints);
  for (std::size_t k = 0; k < subsystem.joints.size(); ++k)
    look_at_joint(describe_joint(subsystem.joints[k].joint, k) + of, subsystem.joints[k].joint,
                  hints);
  look_at_loops("subsystem \"" + subsystem.name + '"', subsystem.loops, hints);
}

void look_at_support(const spatial::Support& support, Hints& hints) {
  hints.look("attitude", "the support", support.fuselage.attitude.norm(), kTurn);
  hints.look("orientation", "the support's axle", support.axle.orientation.norm(), kTurn);
}

/// Looks at a rotation vector over time; `of`: "the rotation of the hub's mount".
void look_at_rotation(const std::string& of, const spatial::VectorCourse& rotation, Hints& hints) {
  if (const auto* table = std::get_if<spatial::VectorTable>(&rotation)) {
    for (const Curve& component : table->components) hints.look("table", of, component);
    return;
  }
  const auto& harmonic = std::get<spatial::VectorHarmonic>(rotation);
  hints.look("constant", of, harmonic.constant.norm(), kTurn);
  hints.look("amplitude", of, harmonic.amplitude.norm(), kTurn);
  hints.look("phase", of, harmonic.phase, kTurn);
}

void look_at_anchors(const std::vector<Anchor>& anchors, Hints& hints) {
  for (const Anchor& anchor : anchors) {
    const std::string of = "anchor \"" + anchor.name + '"';
    if (const auto* motion = std::get_if<spatial::MountMotion>(&anchor.motion))
      look_at_rotation("the rotation of " + of, motion->rotation, hints);
    else
      hints.look("rotation", of, std::get<ProgramAnchorMotion>(anchor.motion).rotation.norm(),
                 kTurn);
  }
}

void look_at_pitch(const PitchControl& control, Hints& hints) {
  const std::string of = "[control.pitch]";
  hints.look("minimum", of, control.minimum, kHalfTurn);
  hints.look("maximum", of, control.maximum, kHalfTurn);
  hints.look("initial", of, control.initial, kHalfTurn);
}

}  // namespace

std::vector<std::string> find_angle_hints(const Scenario& scenario) {
  Hints hints;
  if (!scenario.space) {
    look_at_azimuths(scenario.rotor.blades, hints);
    for (std::size_t i = 0; i < scenario.rotor.blades.size(); ++i)
      look_at_loops("blade " + std::to_string(i + 1), scenario.rotor.blades[i].loops, hints);
    look_at_anchors(scenario.rotor.anchors, hints);
    return hints.take();
  }
  const spatial::Model& model = *scenario.space;
  if (model.support) look_at_support(*model.support, hints);
  look_at_blades(model.blades, hints);
  for (const spatial::Subsystem& subsystem : model.subsystems) look_at_subsystem(subsystem, hints);
  if (model.hub.mount)
    look_at_rotation("the rotation of the hub's mount", model.hub.mount->rotation, hints);
  look_at_anchors(model.anchors, hints);
  if (model.pitch_control) look_at_pitch(*model.pitch_control, hints);
  return hints.take();
}

}  // namespace spoke
