#pragma once

// What modes of all frames are made of: whose they are, names with numbers, shapes and energies.

#include <map>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/steady/linear_model.h"
#include "engine/vibration/equal_roots.h"
#include "engine/vibration/mode_count.h"
#include "engine/vibration/mode_shapes.h"

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

/// Numbers modes of one name in their order; a name that is alone is numbered, too.
class Numbering {
 public:
  void name(const std::string& what, Mode& mode) {
    mode.name = what + ' ' + std::to_string(++counts_[what]);
  }
  /// As name(), but the first has no number.
  void name_further(const std::string& what, Mode& mode) {
    const int count = ++counts_[what];
    mode.name = count > 1 ? what + ' ' + std::to_string(count) : what;
  }

 private:
  std::map<std::string, int> counts_;
};

/// Returns how many of `size` modes to find. Throws InputError if they are too few.
Eigen::Index find_count(const ModeCount& count, Eigen::Index size, const std::string& why = "");

/// Returns a mode with the frequency and damping of a root.
Mode make_mode(const Root& root);
bool is_rigid(const Mode& mode);
/// Scales a mode to a largest displacement of 1.
void normalise(Mode& mode);
/// Sets the motion of the hub's frame by its free coordinates, or by those of its support.
void set_hub_motion(const Eigen::VectorXcd& x, const Linearised& all, Mode& mode);
/// Adds the shape of a subsystem, which moves with the hub unless it stands.
void add_shape(std::size_t subsystem, const SubsystemShape& shape, steady::SteadyModel& model,
               Mode& mode);

/// Returns x^H M x of a motion x, real.
inline double calc_mass(const Eigen::VectorXcd& x, const Eigen::MatrixXd& M) {
  return x.real().dot(M * x.real()) + x.imag().dot(M * x.imag());
}

/// Returns the mass of a motion of the hub's coordinates: x^H M x, without that of a support on
/// which the rotor stands.
double calc_hub_energy(const Eigen::VectorXcd& hub, const steady::LinearModel& linear);

/// Returns flap, lag, torsion and axial motion of a shape, by which modes of equal roots are told
/// apart.
Features list_features(const SubsystemShape& shape);

/// Returns the names of bodies for ModesResult::bodies.
std::vector<std::string> list_bodies(const Linearised& all);

/// Sums the energies of a mode.
class EnergySum {
 public:
  explicit EnergySum(const Linearised& all);
  void add(std::size_t subsystem, const SubsystemShape& shape);
  /// Returns the shares, with that of a motion of the hub.
  ModeEnergy share_out(double of_hub) const;

 private:
  const steady::SteadyModel& model_;
  std::vector<std::size_t> starts_;  ///< in ModesResult::bodies, by subsystem
  ModeEnergy sum_;
};

}  // namespace spoke::vibration
