// Parameters of the generator's side become laws of the hub's side.

#include "program/foreign/discon_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

constexpr double kOfDegree = std::numbers::pi / 180.0;
constexpr std::size_t kMostWords = 10000;  ///< of a line: tables are as long as one likes
constexpr double kMost = 1e30;             ///< as in scenarios

/// A line "values ! KEY comment".
struct KeyedLine {
  std::string_view values, key;
};

KeyedLine split_line(std::string_view line) {
  const std::size_t mark = line.find('!');
  if (mark == std::string_view::npos) return {};
  const std::vector<std::string_view> words = split_words(line.substr(mark + 1), 1);
  return {line.substr(0, mark), words.empty() ? std::string_view() : words.front()};
}

/// Calls visit(line, number) for the lines of a text, from 1, until it returns true.
template <class Visit>
void visit_lines(std::string_view text, const Visit& visit) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    if (visit(text.substr(0, end), number) || end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

/// Looks for keys, and checks their values.
class DisconLines {
 public:
  explicit DisconLines(const SourceFile& source) : source_(source) {}

  bool has(std::string_view key) const { return find(key).number > 0; }

  std::vector<double> numbers(std::string_view key, std::size_t count) const {
    const Found found = find(key);
    if (found.number == 0)
      refuse(
          source_.name, 0,
          "has no " + std::string(key) + ", expected a line \"value ! " + std::string(key) + "\"");
    const std::vector<std::string_view> words = split_words(found.values, kMostWords);
    std::vector<double> numbers;
    for (const std::string_view word : words) {
      double number = 0.0;
      if (!solid::read_number(word, number)) break;
      if (std::abs(number) > kMost) refuse_value(key, describe(number), "a number of at most 1e30");
      numbers.push_back(number);
    }
    if (numbers.size() < count)
      refuse(source_.name, found.number,
             std::string(key) + " has " + std::to_string(numbers.size()) + " numbers, expected " +
                 std::to_string(count));
    numbers.resize(count);
    return numbers;
  }

  double number(std::string_view key) const { return numbers(key, 1).front(); }
  double number_or(std::string_view key, double other) const {
    return has(key) ? number(key) : other;
  }
  double positive(std::string_view key) const {
    const double value = number(key);
    if (!(value > 0.0)) refuse_value(key, describe(value), "more than 0");
    return value;
  }
  /// Reads a switch, 0 where an older version has none.
  int mode(std::string_view key, int most) const {
    if (!has(key)) return 0;
    const double value = number(key);
    if (value != std::floor(value) || value < 0.0 || value > most)
      refuse_value(key, describe(value), "0 to " + std::to_string(most));
    return static_cast<int>(value);
  }
  std::size_t size(std::string_view key) const {
    const double value = number(key);
    if (value != std::floor(value) || value < 1.0 || value > static_cast<double>(kMostWords))
      refuse_value(key, describe(value), "1 to " + std::to_string(kMostWords));
    return static_cast<std::size_t>(value);
  }
  /// Returns "KEY, file:line".
  std::string place(std::string_view key) const {
    return std::string(key) + ", " + foreign::place(source_.name, find(key).number);
  }
  [[noreturn]] void refuse_value(std::string_view key, const std::string& value,
                                 const std::string& expected) const {
    refuse(source_.name, find(key).number,
           std::string(key) + " is " + value + ", expected " + expected);
  }

 private:
  struct Found {
    std::string_view values;
    int number = 0;  ///< of the line; 0: there is none
  };

  Found find(std::string_view key) const {
    Found found;
    visit_lines(source_.text, [&](std::string_view line, int number) {
      const KeyedLine split = split_line(line);
      if (!is_same_word(split.key, key) || split.values.empty()) return false;
      found = {split.values, number};
      return true;
    });
    return found;
  }

  const SourceFile& source_;
};

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// Requires places of a table that increase.
void check_increasing(const DisconLines& lines, std::string_view key,
                      const std::vector<double>& places) {
  for (std::size_t k = 1; k < places.size(); ++k)
    if (!(places[k] > places[k - 1]))
      lines.refuse_value(key, describe(places[k]) + " after " + describe(places[k - 1]),
                         "each greater than the one before");
}

void read_filter(const DisconLines& lines, TurbineLaws& laws) {
  SpeedFilter& filter = laws.filter.emplace();
  filter.frequency = lines.positive("F_LPFCornerFreq");
  if (lines.mode("F_LPFType", 2) == 2) filter.damping = lines.positive("F_LPFDamping");
}

void read_torque(const DisconLines& lines, double gear, FoundModel& model) {
  constexpr int most = 4;
  const int mode = lines.mode("VS_ControlMode", most);
  if (mode == 0) return;
  if (mode > 1)
    model.leave_out(Loss::theory, lines.place("VS_ControlMode") + ", which is " +
                                      std::to_string(mode) +
                                      ": the estimate of the wind by which it tracks the tip-speed "
                                      "ratio; the torque is VS_Rgn2K by the square of the speed");
  TorqueLaw& law = model.laws->torque.emplace();
  law.square = lines.positive("VS_Rgn2K") * gear * gear * gear;
  law.speed = lines.positive("VS_RefSpd") / gear;
  law.rated = lines.positive("VS_RtTq") * gear;
  law.above = lines.mode("VS_ConstPower", 1) == 1 ? AboveRated::power : AboveRated::torque;
  law.proportional = -lines.numbers("VS_KP", 1).front() * gear * gear;
  law.integral = -lines.numbers("VS_KI", 1).front() * gear * gear;
  if (!(law.proportional >= 0.0))
    lines.refuse_value("VS_KP", describe(lines.number("VS_KP")), "0 or less");
  if (!(law.integral >= 0.0))
    lines.refuse_value("VS_KI", describe(lines.number("VS_KI")), "0 or less");
  const double least = lines.number_or("VS_MinOMSpd", 0.0) / gear;
  if (law.has_gains() && least > 0.0) law.minimum = least;
  law.maximum = lines.positive("VS_MaxTq") * gear;
  law.rate = lines.positive("VS_MaxRat") * gear;
  if (mode == 1 && lines.number_or("PC_Switch", 0.0) > 0.0)
    law.switch_pitch = lines.number("PC_Switch");
}

void read_pitch_law(const DisconLines& lines, double gear, FoundModel& model) {
  if (lines.has("PC_ControlMode") && lines.mode("PC_ControlMode", 1) == 0) return;
  PitchLaw& law = model.laws->pitch.emplace();
  const std::size_t count = lines.size("PC_GS_n");
  law.speed = lines.positive("PC_RefSpd") / gear;
  law.angle = lines.numbers("PC_GS_angles", count);
  check_increasing(lines, "PC_GS_angles", law.angle);
  law.proportional = scaled(lines.numbers("PC_GS_KP", count), -gear);
  law.integral = scaled(lines.numbers("PC_GS_KI", count), -gear);
  if (lines.has("PC_GS_KD")) {
    const std::vector<double> gains = lines.numbers("PC_GS_KD", count);
    if (std::any_of(gains.begin(), gains.end(), [](double gain) { return gain != 0.0; }))
      model.leave_out(Loss::part, lines.place("PC_GS_KD") + ": gains of the derivative");
  }
  const bool is_scheduled = lines.mode("PS_Mode", 1) == 1;
  law.minimum = is_scheduled ? lines.number("PC_MinPit")
                             : lines.number_or("PC_FinePit", lines.number("PC_MinPit"));
  law.maximum = lines.number("PC_MaxPit");
  if (!(law.maximum > law.minimum))
    lines.refuse_value("PC_MaxPit", describe(law.maximum),
                       "more than the least pitch, " + describe(law.minimum));
  law.rate = lines.positive("PC_MaxRat");
  if (!is_scheduled) return;
  PitchSchedule& schedule = model.laws->schedule.emplace();
  const std::size_t points = lines.size("PS_BldPitchMin_N");
  schedule.wind = lines.numbers("PS_WindSpeeds", points);
  check_increasing(lines, "PS_WindSpeeds", schedule.wind);
  schedule.angle = lines.numbers("PS_BldPitchMin", points);
  if (const double corner = lines.number_or("F_WECornerFreq", 0.0); corner > 0.0)
    schedule.filter = corner;
  if (lines.mode("WE_Mode", 2) != 0)
    model.leave_out(Loss::theory, lines.place("WE_Mode") +
                                      ": the estimate of the wind; the least pitch goes by the "
                                      "measured one, filtered by F_WECornerFreq");
}

void read_smoothing(const DisconLines& lines, TurbineLaws& laws) {
  if (lines.mode("SS_Mode", 1) == 0 || !laws.torque || !laws.pitch) return;
  laws.smoothing = {lines.number("SS_VSGain"), lines.number("SS_PCGain"),
                    lines.positive("F_SSCornerFreq")};
}

void read_individual(const DisconLines& lines, FoundModel& model) {
  const int mode = lines.mode("IPC_ControlMode", 2);
  if (mode == 0 || !model.laws->pitch) return;
  if (mode == 2)
    model.leave_out(Loss::part,
                    lines.place("IPC_ControlMode") + ": individual pitch by the second harmonic");
  IndividualPitch& law = model.laws->individual.emplace();
  law.proportional = lines.number_or("IPC_KP", 0.0);
  law.integral = lines.number("IPC_KI");
  law.maximum = lines.positive("IPC_IntSat");
  law.offset = lines.number_or("IPC_aziOffset", 0.0);
  if (!lines.has("IPC_Vramp")) return;
  const std::vector<double> ramp = lines.numbers("IPC_Vramp", 2);
  if (!(ramp[1] > ramp[0])) return;
  law.wind_from = ramp[0];
  law.wind_to = ramp[1];
}

void read_actuator(const DisconLines& lines, FoundModel& model) {
  const int mode = lines.mode("PA_Mode", 2);
  if (mode == 0 || !model.laws->pitch) return;
  constexpr double kStiff = 10.0;  // of a second-order one that is as slow as one of first order
  const double corner = lines.positive("PA_CornerFreq");
  if (mode == 2) {
    model.laws->actuator = {corner, lines.positive("PA_Damping")};
    return;
  }
  // x'' + 2 z w x' + w^2 x with w = 10 corner and 2 z/w = 1/corner: the slow root is near -corner.
  model.laws->actuator = {kStiff * corner, 0.5 * kStiff};
  model.leave_out(Loss::theory, lines.place("PA_Mode") +
                                    ", which is 1: an actuator of first order; one of second order "
                                    "stands for it, with a root 1 % beyond PA_CornerFreq");
}

void read_yaw_law(const DisconLines& lines, FoundModel& model) {
  const int mode = lines.mode("Y_ControlMode", 2);
  if (mode == 0) return;
  if (mode == 2) {
    model.leave_out(Loss::part, lines.place("Y_ControlMode") +
                                    ", which is 2: yaw by individual pitch; the nacelle stays");
    return;
  }
  YawLaw& law = model.laws->yaw.emplace();
  law.rate = lines.positive("Y_Rate");
  const std::vector<double> errors = lines.numbers("Y_ErrThresh", 2);
  law.error = errors[1] * kOfDegree;
  if (!(law.error > 0.0))
    lines.refuse_value("Y_ErrThresh", describe(errors[1]), "more than 0 (degrees)");
  if (const double corner = lines.number_or("F_YawErr", 0.0); corner > 0.0) law.filter = corner;
}

/// Says which other switches are on.
void note_switches(const DisconLines& lines, FoundModel& model) {
  constexpr std::pair<const char*, const char*> kOthers[] = {
      {"VS_FBP", "a rotor of fixed pitch above rated"},
      {"PRC_Mode", "tracking of a power reference"},
      {"SU_Mode", "the start"},
      {"SD_Mode", "the shutdown; [[event]] makes one"},
      {"Fl_Mode", "feedback of a floater's motion"},
      {"TD_Mode", "damping of the tower by pitch"},
      {"TRA_Mode", "speeds that the tower's resonance excludes"},
      {"Flp_Mode", "flaps"},
      {"OL_Mode", "courses in open loop"},
      {"PF_Mode", "faults of the pitch; [[event]] makes one"},
      {"AWC_Mode", "control of the wake"},
      {"Ext_Mode", "a further library"},
      {"ZMQ_Mode", "commands of another program"},
      {"CC_Mode", "cables that are controlled"},
      {"StC_Mode", "structural control"},
      {"F_NumNotchFilts", "notch filters"}};
  constexpr int most = 1000;
  for (const auto& [key, what] : kOthers)
    if (const int mode = lines.mode(key, most); mode != 0)
      model.leave_out(Loss::part,
                      lines.place(key) + ", which is " + std::to_string(mode) + ": " + what);
}

}  // namespace

bool is_discon(std::string_view text) {
  bool found = false;
  visit_lines(text, [&](std::string_view line, int) {
    found = is_same_word(split_line(line).key, "VS_ControlMode");
    return found;
  });
  return found;
}

void read_discon(const SourceFile& source, FoundModel& model) {
  const DisconLines lines(source);
  const double gear = lines.positive("WE_GearboxRatio");
  model.laws.emplace();
  model.laws_from = source.name + ", by WE_GearboxRatio on the hub's side";
  read_filter(lines, *model.laws);
  read_torque(lines, gear, model);
  read_pitch_law(lines, gear, model);
  read_smoothing(lines, *model.laws);
  read_individual(lines, model);
  read_actuator(lines, model);
  read_yaw_law(lines, model);
  note_switches(lines, model);
  model.leave_out(Loss::detail, source.name + ": logs, interfaces, tables of the wind's estimate");
}

}  // namespace spoke::foreign
