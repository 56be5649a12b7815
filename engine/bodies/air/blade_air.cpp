// Evaluates the air on a blade: at each station flow, states, coefficients and loads by length;
// then what the stations bear of loads that are linear between them.

#include "engine/bodies/air/blade_air.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/bodies/air/annulus.h"
#include "engine/bodies/air/inflow.h"
#include "engine/bodies/air/section_flow.h"

namespace spoke::air {
namespace {

using Eigen::Vector3d;

/// The wind against the hub.
struct WindAgainstHub {
  Vector3d in_plane;
  double along, across;  // along the axis, in the plane

  explicit WindAgainstHub(const RotorPlace& rotor) {
    const Vector3d wind = rotor.wind - rotor.velocity;
    const double size =
        rotor.wind.lpNorm<Eigen::Infinity>() + rotor.velocity.lpNorm<Eigen::Infinity>();
    along = without_rounding(wind.dot(rotor.axis), size);
    in_plane = wind - along * rotor.axis;
    across = without_rounding(in_plane.norm(), size);
    if (across == 0.0) in_plane.setZero();
  }
};

/// Shares and speeds, by half chords of travel, of the wake that a section sheds: Wagner's function
/// 1 - sum share exp(-speed s) by Jones (NACA report 681, 1940).
struct WagnerPart {
  double share, speed;
};
constexpr std::array<WagnerPart, 2> kWagner{{{0.165, 0.0455}, {0.335, 0.3}}};

/// Returns the size of a vector; unlike std::hypot(), of speeds whose squares are finite.
double find_size(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

/// Returns an angle within half a turn.
double wrap(double angle) noexcept {
  if (angle > std::numbers::pi) return angle - 2.0 * std::numbers::pi;
  return angle < -std::numbers::pi ? angle + 2.0 * std::numbers::pi : angle;
}

/// Turns loads by length, linear between stations, into those of the stations, by linear shapes:
/// the sum and the first moment are kept.
void lump(std::span<const double> places, std::span<Wrench> loads) noexcept {
  Wrench inner;  // by length, at the station before
  double before = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double after = i + 1 < loads.size() ? places[i + 1] - places[i] : 0.0;
    const Wrench here = loads[i];
    const double own = (before + after) / 3.0;
    loads[i].force = own * here.force + before / 6.0 * inner.force;
    loads[i].moment = own * here.moment + before / 6.0 * inner.moment;
    if (i + 1 < loads.size()) {
      loads[i].force += after / 6.0 * loads[i + 1].force;
      loads[i].moment += after / 6.0 * loads[i + 1].moment;
    }
    inner = here;
    before = after;
  }
}

}  // namespace

/// How far the states go on from those before.
struct BladeAir::Advance {
  double elapsed;
  bool to_rest;  // to equilibrium

  explicit Advance(double time) : elapsed(std::max(time, 0.0)), to_rest(std::isinf(time)) {}
  /// Returns elapsed time times a rate that is linear between its values at begin and end.
  double turns(double begin, double end) const { return elapsed * 0.5 * (begin + end); }
  bool stands() const { return elapsed == 0.0; }
};

/// A station at one time.
struct BladeAir::Point {
  const Station& station;
  SectionAxes axes;
  SectionFlow flow;
  SectionPolar::Level level{};
  StationState state{};
  double turning = 0.0;             // see find_turning_angle()
  double rise = 0.0;                // see find_rise() [m/s]
  double axial = 0.0, ahead = 0.0;  // flow with induction
  double relative = 0.0;            // its size
};

BladeAir::Point BladeAir::find_point(const RotorPlace& rotor, const Station& station,
                                     const MarkerMotion& section, const Vector3d& wind,
                                     double in_plane) const noexcept {
  const SectionAxes axes = find_axes(rotor, section, station.sine, station.cosine, side_);
  const SectionFlow flow = find_flow(axes, section, wind, station.center, in_plane);
  const double speed = find_size(flow.axial, flow.ahead);
  Point point{station, axes, flow};
  point.level = station.polar->level(speed * station.chord / viscosity_, speed / sound_speed_);
  point.rise = find_rise(axes, section, station.chord);
  point.turning = find_turning_angle(axes, flow, point.rise);
  return point;
}

InducedFlow BladeAir::solve_momentum(const Point& point) const noexcept {
  constexpr double least_radius = 0.01;  // of the rotor's: nearer the axis annuli are no smaller
  const Station& station = point.station;
  const double radius = std::max(point.axes.radius, least_radius * radius_);
  const Annulus annulus{blades_ * station.chord / (2.0 * std::numbers::pi * radius),
                        station.tip,
                        station.root,
                        inflow_factor_,
                        high_thrust_,
                        mass_flow_};
  const double pitch = std::atan2(point.axes.pitch_sine, point.axes.pitch_cosine) + point.turning;
  return solve_annulus(annulus, point.flow, [&](double angle) {
    return station.polar->lift(point.level, angle + pitch);
  });
}

void BladeAir::advance_induced(const Advance& advance, Point& point) const noexcept {
  StationState& state = point.state;
  const InducedFlow steady = solve_momentum(point);
  const double now = lags_inflow_ && !advance.to_rest ? state.axial.induced : steady.axial;
  const double rate =
      calc_inflow_rate(point.flow.axial, point.flow.in_plane, steady.axial, now, radius_);
  if (advance.to_rest || !lags_inflow_) {
    state.axial = rest_inflow(steady.axial);
    state.tangential = rest_inflow(steady.tangential);
  } else {
    const double turns = advance.turns(state.inflow_rate, rate);
    const double ratio = calc_inflow_ratio(point.station.span_ratio);
    state.axial = advance_inflow(state.axial, state.steady.axial, steady.axial, turns, ratio);
    state.tangential =
        advance_inflow(state.tangential, state.steady.tangential, steady.tangential, turns, ratio);
  }
  state.steady = steady;
  state.inflow_rate = rate;
}

void BladeAir::advance_shed(const Advance& advance, Point& point) const noexcept {
  StationState& state = point.state;
  const double chord = point.station.chord;
  const double across = point.axes.find_across(point.axial, point.ahead) + point.rise;
  const double rate =
      chord > 0.0 ? 2.0 / chord * find_size(point.axial, point.ahead) : 0.0;  // half chords
  double induced = 0.0;
  for (std::size_t k = 0; k < kWagner.size(); ++k) {
    const auto [share, speed] = kWagner[k];
    if (advance.to_rest)
      state.shed[k] = share * across;
    else if (!advance.stands())
      state.shed[k] = advance_filter(state.shed[k], share * state.across, share * across,
                                     speed * advance.turns(state.shed_rate, rate));
    induced += share * across - state.shed[k];
  }
  if (advance.to_rest || !advance.stands()) {
    state.across = across;
    state.shed_rate = rate;
  }
  point.axial -= induced * point.axes.pitch_cosine;
  point.ahead -= induced * point.axes.pitch_sine;
}

double BladeAir::advance_lift(const Advance& advance, const PolarValues& polar,
                              Point& point) const noexcept {
  constexpr double chords = 4.0;  // that the flow travels in the time constant of separation
  StationState& state = point.state;
  const double chord = point.station.chord;
  if (lags_stall_ && advance.stands())
    return polar.lift + (state.separation - polar.separation) * polar.recovery;
  const double rate = chord > 0.0 ? point.relative / (chords * chord) : 0.0;
  if (lags_stall_ && !advance.to_rest)
    state.separation = advance_filter(state.separation, state.steady_separation, polar.separation,
                                      advance.turns(state.stall_rate, rate));
  else
    state.separation = polar.separation;
  state.steady_separation = polar.separation;
  state.stall_rate = rate;
  return polar.lift + (state.separation - polar.separation) * polar.recovery;
}

void BladeAir::evaluate(const RotorPlace& rotor, std::span<const MarkerMotion> sections,
                        std::span<const Vector3d> wind, double elapsed, const double* before,
                        double* after, std::span<Wrench> out, std::span<StationAir> seen,
                        bool held) const noexcept {
  assert(sections.size() == count() && wind.size() == count() && out.size() == count());
  assert((seen.empty() || seen.size() == count()) && !(elapsed < 0.0));
  const WindAgainstHub hub(rotor);
  const Advance advance(elapsed);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    Point point = find_point(rotor, stations_[i], sections[i], wind[i], hub.across);
    const std::size_t first = i * states_of_station();
    if (!advance.to_rest) point.state = load_state(before + first, lags_attached_);
    if (held)
      point.state.take_inflow(load_state(after + first, lags_attached_));
    else if (!induces_)
      point.state.take_inflow({});
    else if (!(lags_inflow_ && advance.stands()))
      advance_induced(advance, point);
    const double skew =
        calc_skew_factor(hub.along - point.state.axial.induced, hub.across,
                         hub.in_plane.dot(point.axes.outward), point.station.span_ratio);
    const InducedFlow induced{skew * point.state.axial.induced, point.state.tangential.induced};
    point.axial = point.flow.axial - induced.axial;
    point.ahead = point.flow.ahead + induced.tangential;
    if (lags_attached_) advance_shed(advance, point);
    point.relative = find_size(point.axial, point.ahead);
    const double attack = wrap(point.axes.find_attack(point.axial, point.ahead) + point.turning);
    PolarValues polar = point.station.polar->values(point.level, attack);
    polar.lift = advance_lift(advance, polar, point);
    polar.moment += calc_turning_moment(point.turning, polar.separation);
    save_state(point.state, lags_attached_, after + first);
    out[i] = find_load(point, polar);
    if (!seen.empty()) seen[i] = describe(rotor, point, induced, attack, polar, out[i]);
  }
  lump(places_, out);
}

Wrench BladeAir::find_load(const Point& point, const PolarValues& polar) const noexcept {
  const SectionAxes& axes = point.axes;
  const double relative = point.relative;
  const double pressure = 0.5 * density_ * point.station.chord * relative;  // by speed
  const Vector3d lift = polar.lift * (point.ahead * axes.axial + point.axial * axes.tangential);
  const Vector3d drag = polar.drag * (point.axial * axes.axial - point.ahead * axes.tangential);
  const Vector3d force = pressure * (lift + drag);
  const double moment = pressure * relative * point.station.chord * polar.moment;
  return {force, (point.station.center * axes.chord).cross(force) + moment * axes.nose_up};
}

StationAir BladeAir::describe(const RotorPlace& rotor, const Point& point,
                              const InducedFlow& induced, double attack, const PolarValues& polar,
                              const Wrench& load) const noexcept {
  const auto by = [](double speed, double flow) { return flow != 0.0 ? speed / flow : 0.0; };
  const SectionAxes& axes = point.axes;
  return {.radius = axes.radius,
          .attack = attack,
          .relative_speed = point.relative,
          .axial_induction = by(induced.axial, point.flow.axial),
          .tangential_induction = by(induced.tangential, point.flow.ahead),
          .induced_axial = -induced.axial,
          .induced_tangential = -induced.tangential,
          .lift = polar.lift,
          .drag = polar.drag,
          .moment = polar.moment,
          .axial_force = load.force.dot(rotor.axis),
          .tangential_force = load.force.dot(axes.around),
          .pitching_moment = side_ * load.moment.dot(axes.nose_up),
          .axial_moment = side_ * load.moment.dot(rotor.axis)};
}

}  // namespace spoke::air
