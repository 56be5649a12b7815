#pragma once

// Scenarios of arms that loops or couplings tie to one another: as subsystems of their own, or all
// as one.

#include <string>
#include <vector>

namespace spoke::test {

constexpr int kArms = 4;
inline const std::string kWeight = "[gravity]\nacceleration=[0.3,0.2,-9.81]\n";
inline const std::string kOfASecond = "[integration]\nstep=1e-3\nduration=1\n";

/// Returns a number with all its digits.
std::string number(double value);

struct HubCase {
  std::string name, text;
};
/// Hubs that are driven, turned by a torque, free, and driven on a support.
extern const std::vector<HubCase> kHubs;

/// The arms, each a subsystem or all of them one, with ties from the first `ties` ones: closures,
/// or couplings of what is behind "coupling".
std::string make_tied_arms(const std::string& hub, bool is_apart, const std::string& tie, int ties);

/// Hammond's rotor of 1974 on its hub, which is heavier along x, with a ring of dampers between the
/// blades in place of his lag dampers, each of half their rate; `missing`: so many of the ring.
/// `more`: keys of the hinges.
std::string make_hammond(double speed, int missing, const std::string& more = "");

}  // namespace spoke::test
