#pragma once

// What modes of all frames are made of: whose they are, names with numbers, shapes and energies.

#include <complex>
#include <map>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/equal_roots.h"
#include "engine/small_motions/vibration/mode_count.h"
#include "engine/small_motions/vibration/mode_shapes.h"

namespace spoke::vibration {

/// All data that modes are made from.
struct Linearised {
  steady::SteadyModel& model;
  const steady::Equilibrium& equilibrium;
  const steady::LinearModel& linear;
};

/// Returns the names of subsystems as "blade 1", "blades 1 to 3" or "blade 1, blade 3".
std::string name_subsystems(const std::vector<std::size_t>& subsystems,
                            const steady::SteadyModel& model);
/// Returns the subsystems that subsystem `i` stands for.
std::vector<std::size_t> find_like(std::size_t i, const std::vector<std::size_t>& alike);

/// Returns the kind of a mode by its kind of motion: "overdamped flap" where it creeps back at the
/// rate s.real() without vibrating, with more than 99.87 % of critical damping. `rate`: at which it
/// vibrates, in the frame in which its forces are constant [rad/s].
std::string kind_with_damping(const std::string& kind, std::complex<double> s, double rate);
/// Returns how many vibrations are overdamped, by the number of their roots, of which each has two,
/// the faster one perhaps beyond those that were sought.
inline int count_overdamped(int roots) { return (roots + 1) / 2; }

/// Numbers modes of one name in their order; a name that is alone is numbered, too.
class Numbering {
 public:
  /// Counts a root of an overdamped vibration of this name, before any is named: those that vibrate
  /// have the numbers behind.
  void count_root(const std::string& what) { ++roots_[what]; }
  void name(const std::string& what, Mode& mode) {
    const auto found = roots_.find(what);
    const int before = found == roots_.end() ? 0 : count_overdamped(found->second);
    mode.name = what + ' ' + std::to_string(before + ++counts_[what]);
  }
  /// As name(), but the first has no number.
  void name_further(const std::string& what, Mode& mode) {
    const int count = ++counts_[what];
    mode.name = count > 1 ? what + ' ' + std::to_string(count) : what;
  }

 private:
  std::map<std::string, int> counts_;
  std::map<std::string, int> roots_;  ///< of overdamped vibrations, by the name of a vibration
};

/// Returns how many of the `size` modes that there are to find. Where more are asked for, adds a
/// note to the result, with what they are `of`.
Eigen::Index find_count(const ModeCount& count, Eigen::Index size, const std::string& of,
                        ModesResult& result);

/// Returns a mode with the frequency and damping of a root.
Mode make_mode(const Root& root);
bool is_rigid(const Mode& mode);
/// Scales a mode to a largest displacement of 1.
void normalise(Mode& mode);
/// Sets the motion of the frame of the hub, or of all, by its free coordinates, or by those of its
/// support.
void set_hub_motion(const Eigen::VectorXcd& x, const Linearised& all, Mode& mode);
/// Adds the shape of a subsystem, which moves with the hub unless it stands.
void add_shape(std::size_t subsystem, const SubsystemShape& shape, steady::SteadyModel& model,
               Mode& mode);

/// Returns x^H M x of a motion x, real.
inline double calc_mass(const Eigen::VectorXcd& x, const Eigen::MatrixXd& M) {
  return x.real().dot(M * x.real()) + x.imag().dot(M * x.imag());
}

/// Returns the mass matrix of the hub's coordinates, without that of a support on which the rotor
/// stands.
Eigen::MatrixXd calc_carried_mass(const steady::LinearModel& linear);

/// Returns flap, lag, torsion and axial motion of a shape, by which modes of equal roots are told
/// apart.
Features list_features(const SubsystemShape& shape);

/// Returns what is before the name of a mode of several rotors on a support, see
/// SupportedModel::name_rotors(). `motions`: by subsystem, as large as energies.
std::string name_rotors(const std::vector<double>& motions, const steady::SteadyModel& model);

/// Takes the shapes of subsystems that loops tie apart, so that each of the scenario has its own,
/// in the order of these.
void split_shapes(steady::SteadyModel& model, ModesResult& result);

/// Returns the names of bodies for ModesResult::bodies.
std::vector<std::string> list_bodies(const Linearised& all);

/// Sums the energies of a mode, and lists its motions by mass.
class EnergySum {
 public:
  explicit EnergySum(const Linearised& all);
  void add(std::size_t subsystem, const SubsystemShape& shape);
  /// Returns the shares, with that of a motion of the hub.
  ModeEnergy share_out(double of_hub) const;
  /// Returns Mode::weighed, with a motion of the hub's coordinates and what these carry as a mass
  /// matrix.
  Eigen::VectorXcd weigh(const Eigen::VectorXcd& hub, const Eigen::MatrixXd& carried) const;

 private:
  const steady::SteadyModel& model_;
  std::vector<std::size_t> starts_;  ///< in ModesResult::bodies, by subsystem
  ModeEnergy sum_;
  Eigen::VectorXcd weighed_;
};

}  // namespace spoke::vibration
