// Lists the rotors whose matrices turn, and compares their speeds.

#include "engine/small_motions/vibration/require_period.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

/// Returns the numbers of the rotors that turn and have no constant matrices as seen from outside.
std::vector<std::size_t> list_uneven(const steady::SupportedModel& machine, const Linearised& all) {
  std::vector<std::size_t> uneven;
  for (std::size_t r = 0; r < machine.rotors(); ++r)
    if (machine.parts(r).speed != 0.0 && !is_even(r, all)) uneven.push_back(r);
  return uneven;
}

/// Whether those of some rotors that turn are equally fast, in either sense.
bool have_one_speed(const std::vector<std::size_t>& rotors, const steady::SupportedModel& machine) {
  constexpr double kSame = 1e-9;
  double fastest = 0.0;
  for (const std::size_t r : rotors) fastest = std::max(fastest, std::abs(machine.parts(r).speed));
  return std::all_of(rotors.begin(), rotors.end(), [&](std::size_t r) {
    const double speed = std::abs(machine.parts(r).speed);
    return speed == 0.0 || fastest - speed <= kSame * fastest;
  });
}

}  // namespace

std::vector<bool> require_period(const Linearised& all, const std::string& before) {
  const steady::SupportedModel* machine = all.model.on_support();
  if (!machine) return {};
  std::vector<bool> is_outside(machine->rotors(), false);
  std::vector<std::size_t> rotors(machine->rotors());
  std::iota(rotors.begin(), rotors.end(), std::size_t{0});
  if (have_one_speed(rotors, *machine)) return is_outside;
  const std::vector<std::size_t> uneven = list_uneven(*machine, all);
  if (!uneven.empty() && have_one_speed(uneven, *machine)) {
    for (const std::size_t r : rotors)
      is_outside[r] = !have_one_speed({uneven.front(), r}, *machine);
    return is_outside;
  }
  std::ostringstream text;
  text << before << "the frame \"floquet\" expects rotors that are equally fast";
  if (uneven.empty()) {
    text << ": of these the frame \"fixed\" has modes";
    throw InputError(text.str());
  }
  for (std::size_t k = 0; k < uneven.size(); ++k) {
    const steady::RotorParts& rotor = machine->parts(uneven[k]);
    text << (k == 0 ? ", of which " : ", ") << '"' << rotor.name << "\" (" << rotor.speed
         << " rad/s)";
  }
  text << " are not alike in all directions: speeds that differ have no common period, so that "
          "there are no modes; runs have them";
  throw InputError(text.str());
}

}  // namespace spoke::vibration
