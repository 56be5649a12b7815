#pragma once

// What files of other programs say of a beam and of the turbine around it, in Spoke's terms, each
// with where it came from.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/spatial_model.h"
#include "models/turbine_control.h"
#include "program/foreign/found_air.h"
#include "program/foreign/found_control.h"
#include "program/foreign/left_out.h"
#include "program/foreign/value.h"

namespace spoke::foreign {

using spatial::SectionMatrix;

/// The most stations that a table may have.
inline constexpr int kMostStations = 100000;

/// A beam by its stations. Arrays have a value for each station, or are empty.
struct BeamTable {
  Value length;                           ///< [m]
  std::vector<double> station;            ///< [m]
  std::vector<std::string> station_from;  ///< "section 3, blade.dat:40"
  std::vector<double> sweep, prebend;     ///< [m]
  std::vector<double> twist;              ///< about +x [rad]
  // Either matrices in BeamDyn's axes ...
  std::vector<SectionMatrix> stiffness, mass;
  // ... or these, as of spatial::Sections.
  std::vector<double> mass_per_length, axial_stiffness, flap_stiffness, lag_stiffness,
      torsion_stiffness, flap_inertia, lag_inertia;
  Value tip_mass;                    ///< at the outer end [kg]; 0: none
  std::vector<std::string> remarks;  ///< how its numbers were made, a sentence each
};

/// What damps beams: either is empty.
struct FoundDamping {
  std::vector<double> mu;      ///< BeamDyn's six factors of the stiffness [s]
  std::vector<double> ratios;  ///< of the lowest modes
  std::string from;
};

/// What stands between the tower and the rotor.
struct Nacelle {
  Value mass;                             ///< [kg], > 0
  Eigen::Vector3d center{0.0, 0.0, 0.0};  ///< from the tower's top, x downwind, z up [m]
  std::vector<double> inertia;  ///< about its centre: xx, yy, zz, or with xy, xz, yz [kg m^2]
  Eigen::Vector3d hub{0.0, 0.0, 0.0};  ///< the hub's place, likewise [m]
  double tilt = 0.0;                   ///< rotation of the shaft about +y [rad]
  std::string inertia_from, center_from, hub_from, tilt_from;
};

/// A shaft that twists, between the hub and a generator behind a gearbox.
struct FoundTrain {
  Value stiffness, damping;  ///< on the hub's side [N m/rad, N m s/rad]
  Value gear_ratio;          ///< turns of the generator for one of the hub
  Value generator_inertia;   ///< at its own speed [kg m^2]
};

/// All that was found. What is left out has the scenario's default, or what the writer says.
struct FoundModel {
  std::string title;
  std::vector<std::string> sources;  ///< "blade.dat: BeamDyn, blade file: TITLE"
  std::optional<BeamTable> blade, tower;
  Value blade_count{1.0, {}}, hub_radius, precone;  ///< -, m, rad towards downwind
  Value hub_mass, hub_inertia;                      ///< kg, kg m^2 about the axis
  std::vector<double> hub_tensor;  ///< in place of the inertia about the axis, as of the nacelle
  double hub_center = 0.0;         ///< downwind of the hub's origin [m]
  Value speed;                     ///< of the rotor [rad/s]
  bool has_rotor = false;          ///< whether the axis is horizontal
  Value gravity;  ///< downwards [m/s^2]; not in the files: 0, the writer takes the standard value
  Value ground;   ///< its coordinate, upwards from the tower's foot [m]
  std::optional<Nacelle> nacelle;
  std::optional<FoundTrain> train;  ///< only with a nacelle; none: the shaft is rigid
  FoundDamping damping;
  std::optional<FoundAir> air;
  /// Of the blades at the start about +x [rad]; used where there is air or control.
  Value pitch;
  std::optional<FoundManeuver> pitch_maneuver;  ///< likewise about +x
  Value azimuth;                                ///< of blade 1 at the start, 0: upright [rad]
  FoundYaw yaw;
  Value gear_ratio{1.0, {}};    ///< turns of the generator for one of the hub
  bool holds_speed = false;     ///< whether the generator turns at one speed, whatever acts on it
  bool has_yaw_spring = false;  ///< whether the nacelle moves on its yaw spring
  std::optional<FoundGenerator> generator;  ///< none: the drive holds `speed`
  std::optional<FoundLibrary> library;
  std::optional<TurbineLaws> laws;  ///< in the place of a library
  std::string laws_from;
  Value duration, interval;       ///< of a run and of its results [s]; 0: not in the files
  std::vector<LeftOut> left_out;  ///< what could not be carried over

  /// Whether the blades have a pitch joint.
  bool has_pitch() const {
    return air || library || controls_pitch() || pitch_maneuver || pitch.number != 0.0;
  }
  /// Whether the controller moves these, or has the torque of the generator.
  bool controls_pitch() const {
    return laws ? laws->pitch || laws->individual
                : library && library->is_there && library->pitches;
  }
  bool controls_yaw() const {
    return laws ? laws->yaw.has_value() : library && library->is_there && library->yaws;
  }
  bool sets_torque() const {
    return laws ? laws->torque.has_value() : library && library->is_there;
  }
  void leave_out(Loss loss, std::string text) { left_out.push_back({loss, std::move(text)}); }
};

}  // namespace spoke::foreign
