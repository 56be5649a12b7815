// Rules for the laws of [control.turbine]: their numbers, and what belongs together.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/reader/keys/turbine_keys.h"
#include "models/reader/spatial/fault.h"

namespace spoke::spatial {
namespace {

/// Finds numbers of a part outside of their range.
template <class Part>
Fault find_part_fault(keys::Rows rows, const Part& part) {
  const FirstFault first;
  keys::visit_numbers<void>(rows, part, first);
  keys::visit_options(
      rows, part,
      [&](std::string_view key, const std::optional<double>& value, const Quantity& range) {
        if (value) first(key, *value, range);
      });
  keys::visit_stations(rows, part,
                       [&](std::string_view key, const std::vector<double>& values,
                           const Quantity& range) { first.numbers(key, values, range); });
  return first.found();
}

/// Finds what is wrong with a table: places that do not increase, values that are not as many.
Fault find_table_fault(const char* place_key, const std::vector<double>& places,
                       const char* value_key, const std::vector<double>& values) {
  for (std::size_t k = 1; k < places.size(); ++k)
    if (!(places[k] > places[k - 1]))
      return {place_key, "is " + describe(places[k]) + " after " + describe(places[k - 1]) +
                             ", expected each greater than the one before"};
  if (values.size() == places.size() || (values.size() == 1 && places.empty())) return {};
  return {value_key, "has " + std::to_string(values.size()) + " numbers, expected as many as " +
                         place_key + " has, " + std::to_string(places.size())};
}

Fault find_transition_fault(const TorqueLaw& law) {
  const auto is_slower = [&](const char* key, const std::optional<double>& speed) -> Fault {
    if (!speed || *speed < law.speed) return {};
    return {key, "is " + describe(*speed) + ", expected less than speed, " + describe(law.speed) +
                     " (rad/s)"};
  };
  const FirstFault first;
  first.add(is_slower("transition", law.transition));
  first.add(is_slower("minimum", law.minimum));
  if (law.transition && law.has_gains())
    first.add({"transition", "given along with gains, expected only one of them"});
  if (law.minimum && !law.has_gains())
    first.add({"minimum", "given without gains, expected proportional or integral"});
  return first.found();
}

Fault find_torque_fault(const TorqueLaw& law) {
  const FirstFault first;
  if ((law.square > 0.0) == !law.table_speed.empty())
    first.add({"square", law.square > 0.0
                             ? "given along with table_speed, expected only one of them"
                             : "is 0, expected more, or table_speed and table_torque"});
  first.add(find_table_fault("table_speed", law.table_speed, "table_torque", law.table_torque));
  first.add(find_transition_fault(law));
  return first.found();
}

Fault find_pitch_fault(const PitchLaw& law, double initial) {
  const FirstFault first;
  if (law.proportional.empty() && law.integral.empty())
    first.add({"integral", "is missing, as proportional is, expected one of them"});
  for (const auto& [key, gains] :
       {std::pair("proportional", &law.proportional), std::pair("integral", &law.integral)})
    if (!gains->empty()) first.add(find_table_fault("angle", law.angle, key, *gains));
  if (!(law.maximum > law.minimum))
    first.add({"maximum", "is " + describe(law.maximum) + ", expected more than minimum, " +
                              describe(law.minimum) + " (rad)"});
  if (!(initial >= law.minimum && initial <= law.maximum))
    first.add({"minimum", "is " + describe(law.minimum) + " and maximum " + describe(law.maximum) +
                              ", expected initial between them, " + describe(initial) + " (rad)"});
  return first.found();
}

/// Finds parts without what they act on.
Fault find_missing_fault(const OuterControl& control) {
  const TurbineLaws& laws = *control.laws;
  const FirstFault first;
  const auto needs = [&first](const char* key, bool has, const std::string& what) {
    if (!has) first.add({key, "is given without " + what});
  };
  const char* kJoint = "joint, expected the name of the joint that pitches a blade";
  if (laws.pitch) needs("pitch", !control.joints.empty(), kJoint);
  if (laws.individual) needs("individual", !control.joints.empty(), kJoint);
  if (laws.actuator)
    needs("actuator", laws.pitch || laws.individual, "pitch, expected that or individual");
  if (laws.schedule) needs("schedule", laws.pitch.has_value(), "pitch, expected that besides");
  if (laws.smoothing)
    needs("smoothing", laws.pitch && laws.torque, "pitch and torque, expected both besides");
  if (laws.yaw)
    needs("yaw", !control.yaw_joint.empty(),
          "yaw_joint, expected the name of the joint that turns the nacelle");
  return first.found();
}

}  // namespace

Fault find_laws_fault(const OuterControl& control) {
  const TurbineLaws& laws = *control.laws;
  const FirstFault first;
  keys::visit_laws(laws, [&](std::string_view key, keys::Rows rows, const auto& part) {
    if (part) first.add(find_part_fault(rows, *part).within(std::string(key)));
  });
  if (laws.torque) first.add(find_torque_fault(*laws.torque).within("torque"));
  if (laws.pitch) first.add(find_pitch_fault(*laws.pitch, control.initial).within("pitch"));
  if (laws.schedule && laws.schedule->wind.empty())
    first.add({"schedule.wind", "is missing, expected wind speeds (m/s)"});
  if (laws.schedule)
    first.add(find_table_fault("wind", laws.schedule->wind, "angle", laws.schedule->angle)
                  .within("schedule"));
  if (laws.individual) {
    const IndividualPitch& law = *laws.individual;
    if (law.wind_from.has_value() != law.wind_to.has_value())
      first.add({law.wind_from ? "individual.wind_from" : "individual.wind_to",
                 "is given alone, expected wind_from and wind_to"});
    else if (law.wind_from && !(*law.wind_to > *law.wind_from))
      first.add({"individual.wind_to", "is " + describe(*law.wind_to) +
                                           ", expected more than wind_from, " +
                                           describe(*law.wind_from) + " (m/s)"});
  }
  first.add(find_missing_fault(control));
  return first.found();
}

}  // namespace spoke::spatial
