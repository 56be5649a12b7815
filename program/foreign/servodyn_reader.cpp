// Generators become a torque by the speed on the hub's side of the gearbox.

#include "program/foreign/servodyn_reader.h"

#include <cmath>
#include <numbers>

#include "models/support/quantity.h"
#include "program/foreign/generator_curve.h"

namespace spoke::foreign {
namespace {

constexpr double kPerTurn = std::numbers::pi / 30.0;  ///< rad/s of 1/min
constexpr double kOfDegree = std::numbers::pi / 180.0;
constexpr int kLibrary = 5;  ///< the switch of what a library controls

/// Returns how the drive's curve came about.
std::string note_curve(const std::string& what, const Value& first) {
  return what + ", from " + first.from + ", by GBRatio";
}

/// Puts a generator's curve on the hub's side.
void set_generator(const TorqueCurve& curve, std::string from, FoundModel& model) {
  const double n = model.gear_ratio.number;
  FoundGenerator& generator = model.generator.emplace();
  for (std::size_t i = 0; i < curve.speed.size(); ++i) {
    generator.speed.push_back(curve.speed[i] / n);
    generator.torque.push_back(curve.torque[i] == 0.0 ? 0.0 : -n * curve.torque[i]);
  }
  generator.from = std::move(from);
}

void read_variable_speed(KeyedLines& reader, FoundModel& model) {
  VariableSpeed law;
  const Value speed = reader.positive("VS_RtGnSp");
  law.rated_speed = speed.number * kPerTurn;
  law.rated_torque = reader.positive("VS_RtTq").number;
  law.slip = 0.01 * reader.at_least("VS_SlPc", 0.0).number;
  const Value square = reader.at_least("VS_Rgn2K", 0.0);
  if (square.number * speed.number * speed.number > law.rated_torque)
    reader.lines().refuse("VS_Rgn2K is " + describe(square.number) +
                          ", expected no more than VS_RtTq by VS_RtGnSp squared, " +
                          describe(law.rated_torque / (speed.number * speed.number)));
  law.square = square.number / (kPerTurn * kPerTurn);
  set_generator(law.points(), note_curve("simple variable-speed control", speed), model);
}

void read_induction(KeyedLines& reader, FoundModel& model) {
  InductionGenerator generator;
  const Value slip = reader.positive("SIG_SlPc");
  generator.slip = 0.01 * slip.number;
  generator.synchronous_speed = reader.positive("SIG_SySp").number * kPerTurn;
  generator.rated_torque = reader.positive("SIG_RtTq").number;
  generator.pull_out = reader.positive("SIG_PORt").number;
  set_generator(generator.points(), note_curve("simple induction generator", slip), model);
}

void read_thevenin(KeyedLines& reader, FoundModel& model) {
  TheveninGenerator generator;
  const Value frequency = reader.positive("TEC_Freq");
  generator.frequency = frequency.number;
  constexpr int most_poles = 10000;
  generator.poles = reader.count("TEC_NPol", 2, most_poles);
  generator.stator_resistance = reader.positive("TEC_SRes").number;
  generator.rotor_resistance = reader.positive("TEC_RRes").number;
  generator.line_voltage = reader.positive("TEC_VLL").number;
  generator.stator_reactance = reader.positive("TEC_SLR").number;
  generator.rotor_reactance = reader.positive("TEC_RLR").number;
  generator.magnetizing_reactance = reader.positive("TEC_MR").number;
  set_generator(generator.points(), note_curve("induction generator after Thevenin", frequency),
                model);
}

/// Says that something is made by what is in none of the files.
void note_user(KeyedLines& reader, const char* key, int mode, const char* instead,
               FoundModel& model) {
  model.leave_out(Loss::part, std::string(key) + ", " + reader.lines().place() + ", which is " +
                                  std::to_string(mode) + ": is in none of the files; " + instead);
}

/// Requires a gearbox that turns the generator as the hub.
void check_gear(KeyedLines& reader, const FoundModel& model) {
  if (!(model.gear_ratio.number > 0.0))
    reader.lines().refuse("is of a generator behind a gear ratio of " +
                          describe(model.gear_ratio.number) + " (" + model.gear_ratio.from +
                          "), expected more than 0");
}

/// Returns the switch, which must be one of the program's.
int read_mode(KeyedLines& reader, const char* key) { return reader.count(key, 0, kLibrary); }

/// Whether a time comes in the course of the run.
bool is_within_run(const Value& time, const FoundModel& model) {
  return time.number < model.duration.number;
}

void note_start_of_generator(KeyedLines& reader, FoundModel& model) {
  const char* key = reader.has("GenTiStr") && !reader.is_off("GenTiStr") ? "TimGenOn" : nullptr;
  const auto note = [&](const Value& value) {
    model.leave_out(Loss::part, value.from + ", which is " + describe(value.number) +
                                    ": the generator is on from the start to the end");
  };
  if (key && reader.has(key)) {
    if (const Value on = reader.number(key); on.number > 0.0) note(on);
  } else if (!key && reader.has("SpdGenOn")) {
    note(reader.number("SpdGenOn"));
  }
  if (reader.has("GenTiStp") && !reader.is_off("GenTiStp") && reader.has("TimGenOf"))
    if (const Value off = reader.number("TimGenOf"); is_within_run(off, model)) note(off);
}

void read_generator(KeyedLines& reader, FoundModel& model) {
  const int mode = read_mode(reader, "VSContrl");
  if (model.holds_speed || mode == kLibrary) return;
  if (mode > 1) return note_user(reader, "VSContrl", mode, "the drive holds RotSpeed", model);
  check_gear(reader, model);
  if (mode == 1) {
    read_variable_speed(reader, model);
  } else {
    const int kind = reader.count("GenModel", 1, 3);
    if (kind == 3) return note_user(reader, "GenModel", kind, "the drive holds RotSpeed", model);
    kind == 1 ? read_induction(reader, model) : read_thevenin(reader, model);
  }
  note_start_of_generator(reader, model);
}

/// Reads an override maneuver, if it begins in the course of the run.
std::optional<FoundManeuver> read_maneuver(KeyedLines& reader, const char* start, const char* rate,
                                           const char* angle, double sign,
                                           const FoundModel& model) {
  if (!reader.has(start)) return std::nullopt;
  const Value begin = reader.at_least(start, 0.0);
  if (!is_within_run(begin, model)) return std::nullopt;
  FoundManeuver maneuver;
  maneuver.start = begin.number;
  maneuver.rate = reader.positive(rate).number * kOfDegree;
  maneuver.angle = sign * reader.number(angle).number * kOfDegree;
  maneuver.from = begin.from + ", with " + rate + " and " + angle;
  return maneuver;
}

/// Says that an override is left to the controller.
void note_maneuver(const std::optional<FoundManeuver>& maneuver, const char* what,
                   FoundModel& model) {
  if (maneuver) model.leave_out(Loss::part, maneuver->from + ": " + what);
}

void read_pitch(KeyedLines& reader, FoundModel& model) {
  const int mode = read_mode(reader, "PCMode");
  if (mode != 0 && mode != kLibrary)
    note_user(reader, "PCMode", mode, "the blades stay at BlPitch(1)", model);
  auto maneuver = read_maneuver(reader, "TPitManS(1)", "PitManRat(1)", "BlPitchF(1)", -1.0, model);
  if (mode == 0)
    model.pitch_maneuver = std::move(maneuver);
  else
    note_maneuver(maneuver, "the override of the controlled pitch", model);
  for (const char* other : {"TPitManS(2)", "TPitManS(3)"})
    if (reader.has(other) && reader.has("TPitManS(1)")) {
      const double first = reader.number("TPitManS(1)").number;
      const Value time = reader.number(other);
      if (time.number != first && (is_within_run(time, model) || first < model.duration.number))
        model.leave_out(Loss::value, time.from + ", which is " + describe(time.number) +
                                         ": all blades move as blade 1 does");
    }
}

void read_yaw(KeyedLines& reader, FoundModel& model) {
  FoundYaw& yaw = model.yaw;
  const int mode = read_mode(reader, "YCMode");
  if (mode != 0 && mode != kLibrary)
    note_user(reader, "YCMode", mode, "the nacelle stays at NacYaw", model);
  auto maneuver = read_maneuver(reader, "TYawManS", "YawManRat", "NacYawF", 1.0, model);
  if (mode != 0) {
    note_maneuver(maneuver, "the override of the controlled yaw", model);
    maneuver.reset();
  }
  if (model.has_yaw_spring && !maneuver && mode != kLibrary) {
    yaw.moves = true;
    yaw.stiffness = reader.at_least("YawSpr", 0.0);
    yaw.damping = reader.at_least("YawDamp", 0.0);
    yaw.rest = reader.number("YawNeut");
    yaw.rest.number *= kOfDegree;
    return;
  }
  yaw.maneuver = std::move(maneuver);
  if (model.has_yaw_spring)
    model.leave_out(Loss::value, "YawSpr and YawDamp, " + reader.lines().file() +
                                     ": the nacelle follows what yaws it without a spring");
}

void read_library(KeyedLines& reader, ServoDynFile& file, FoundModel& model) {
  const int pitch = read_mode(reader, "PCMode"), torque = read_mode(reader, "VSContrl"),
            yaw = read_mode(reader, "YCMode");
  const bool brakes = reader.has("HSSBrMode") && read_mode(reader, "HSSBrMode") == kLibrary;
  if (pitch != kLibrary && torque != kLibrary && yaw != kLibrary) return;
  file.library = reader.file("DLL_FileName", "DLL_FileName");
  const std::string from = "DLL_FileName, " + reader.lines().place();
  const auto refuse_part = [&](const std::string& why) {
    model.leave_out(Loss::part, from + ": the library, " + why);
    file.library = {};
  };
  if (model.holds_speed) return refuse_part("since GenDOF False holds the speed");
  if (torque != kLibrary)
    return refuse_part("which does not have the torque of the generator (VSContrl is " +
                       std::to_string(torque) + "): in the scenario it would take it");
  FoundLibrary library;
  library.from = from;
  file.input = reader.file("DLL_InFile", "DLL_InFile");
  library.pitches = pitch == kLibrary;
  library.yaws = yaw == kLibrary;
  library.has_individual_pitch = reader.has("Ptch_Cntrl") && reader.count("Ptch_Cntrl", 0, 1) == 1;
  if (reader.has("GenEff")) library.efficiency = reader.at_least("GenEff", 0.0);
  library.efficiency.number /= 100.0;  // per cent
  if (reader.has("DLL_DT") && !is_same_word(reader.text("DLL_DT"), "default"))
    library.period = reader.positive("DLL_DT");
  if (brakes) library.brake_torque = reader.at_least("HSSBrTqF", 0.0);
  library.brake_torque.number *= model.gear_ratio.number;
  if (!model.train) library.gear_ratio = model.gear_ratio;
  check_gear(reader, model);
  model.library = std::move(library);
}

/// Dampers, brakes and flaps.
void note_other_servos(KeyedLines& reader, FoundModel& model) {
  constexpr std::pair<const char*, const char*> kOthers[] = {
      {"NumBStC", "dampers in the blades"}, {"NumNStC", "dampers in the nacelle"},
      {"NumTStC", "dampers in the tower"},  {"NumSStC", "dampers in the substructure"},
      {"AfCmode", "flaps of the blades"},   {"CCmode", "cables that are controlled"}};
  constexpr int most = 1000;
  for (const auto& [key, what] : kOthers)
    if (reader.has(key))
      if (const int value = reader.count(key, 0, most); value != 0)
        model.leave_out(Loss::part, std::string(key) + ", " + reader.lines().place() +
                                        ", which is " + std::to_string(value) + ": " + what);
  if (!reader.has("HSSBrMode") || !reader.has("THSSBrDp")) return;
  if (const int mode = read_mode(reader, "HSSBrMode"); mode != 0 && mode != kLibrary)
    if (const Value time = reader.number("THSSBrDp"); is_within_run(time, model))
      model.leave_out(Loss::part, time.from + ": the brake of the shaft");
}

}  // namespace

ServoDynFile read_servodyn(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  ServoDynFile file;
  reader.take_head("a file of ServoDyn");
  read_generator(reader, model);
  read_pitch(reader, model);
  read_yaw(reader, model);
  read_library(reader, file, model);
  note_other_servos(reader, model);
  model.leave_out(Loss::detail,
                  source.name + ": electrical power of a generator without a library, outputs");
  return file;
}

}  // namespace spoke::foreign
