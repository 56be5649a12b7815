// Who turns the hub, the blades and the nacelle.

#include "program/foreign/control_writer.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "models/reader/keys/turbine_keys.h"

namespace spoke::foreign {
namespace {

void write_initial_speed(const FoundModel& model, Toml& toml) {
  toml.key("initial_speed", digits(model.speed.number), model.speed.from + ", in rad/s");
}

/// Returns a motion that goes from one angle to another at a constant rate. Points beside the
/// corners keep the smooth curve through all of them from cutting these.
std::string write_maneuver(double from, const FoundManeuver& maneuver) {
  const double way = maneuver.angle - from, last = std::abs(way) / maneuver.rate;
  if (way == 0.0) return "{ constant = " + digits(from) + " }";
  constexpr double beside = 0.01;
  std::vector<double> time, value;
  const auto add = [&](double t, double share) {
    if (t < 0.0) return;
    time.push_back(t);
    value.push_back(share == 1.0 ? maneuver.angle : from + share * way);
  };
  add(maneuver.start - beside * last, 0.0);
  for (const double share : {0.0, beside, 1.0 - beside, 1.0})
    add(maneuver.start + share * last, share);
  add(maneuver.start + (1.0 + beside) * last, 1.0);
  return "{ time = " + digits(time) + ", value = " + digits(value) + " }";
}

void write_motion(const Value& angle, const std::optional<FoundManeuver>& maneuver,
                  const std::string& note, Toml& toml) {
  if (maneuver)
    toml.key("motion", write_maneuver(angle.number, *maneuver), maneuver->from + note);
  else
    toml.key("motion", "{ constant = " + digits(angle.number) + " }",
             angle.from.empty() ? "not in the files" : angle.from + note);
}

/// The joints that a controller moves.
void write_moved(const FoundModel& model, bool pitches, bool yaws, Toml& toml) {
  if (pitches) {
    toml.key("joint", "\"pitch\"");
    toml.key("sign", "-1", "twist of these blades falls towards feather");
    if (model.pitch.number != 0.0)
      toml.key("initial", digits(-model.pitch.number), model.pitch.from + ", in rad");
  }
  if (yaws) toml.key("yaw_joint", "\"yaw\"");
}

/// What the library moves, and what it is said besides.
void write_controlled(const FoundModel& model, Toml& toml) {
  const FoundLibrary& library = *model.library;
  write_moved(model, library.pitches, library.yaws, toml);
  if (library.brake_torque.number > 0.0)
    toml.key("brake_torque", digits(library.brake_torque.number),
             library.brake_torque.from + ", by GBRatio");
  if (library.period.number > 0.0)
    toml.key("period", digits(library.period.number), library.period.from);
}

/// Writes what of a structure is not its default, by the rows of its keys.
void write_rows(keys::Rows rows, const void* of, Toml& toml) {
  using Kind = keys::Row::Kind;
  for (const keys::Row& row : rows) {
    const std::string key(row.key);
    if (row.kind == Kind::number) {
      const double value = keys::member_of<double>(row, of);
      if (value != keys::member_of<double>(row, row.standard())) toml.key(key, digits(value));
    } else if (row.kind == Kind::option) {
      if (const auto& value = keys::member_of<std::optional<double>>(row, of))
        toml.key(key, digits(*value));
    } else if (row.kind == Kind::numbers) {
      toml.numbers(key, keys::member_of<std::vector<double>>(row, of));
    } else if (row.kind == Kind::choice) {
      toml.key(key, quoted(std::string(row.word(row.chosen(of)))));
    }
  }
}

void write_laws(const FoundModel& model, Toml& toml) {
  toml.table("[control.turbine]");
  toml.comment(model.laws_from);
  write_moved(model, model.laws->pitch || model.laws->individual, model.laws->yaw.has_value(),
              toml);
  keys::visit_laws(*model.laws, [&](std::string_view key, keys::Rows rows, const auto& part) {
    if (!part) return;
    toml.table("[control.turbine." + std::string(key) + "]");
    write_rows(rows, &*part, toml);
  });
}

void write_library(const FoundModel& model, const std::string& folder, Toml& toml) {
  const FoundLibrary& library = *model.library;
  toml.table("[control.library]");
  toml.key("file", quoted(path_from(folder, library.file)), library.from);
  if (!library.input.empty()) toml.key("input", quoted(path_from(folder, library.input)));
  if (!library.gear_ratio.from.empty())
    toml.key("gear_ratio", digits(library.gear_ratio.number), library.gear_ratio.from);
  if (!library.efficiency.from.empty())
    toml.key("efficiency", digits(library.efficiency.number), library.efficiency.from);
  if (library.has_individual_pitch) toml.key("individual_pitch", "true", "Ptch_Cntrl");
  write_controlled(model, toml);
}

}  // namespace

std::string path_from(const std::string& folder, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path there = fs::absolute(file).lexically_normal();
  const fs::path here = fs::absolute(folder.empty() ? "." : folder).lexically_normal();
  return there.lexically_relative(here).generic_string();
}

void write_drive(const FoundModel& model, Toml& toml) {
  toml.table("[hub.drive]");
  if (model.generator && model.generator->speed.empty()) {
    toml.key("kind", "\"free\"", model.generator->from);
    write_initial_speed(model, toml);
  } else if (model.generator) {
    toml.comment(model.generator->from + "; against the rotation, on the hub's side");
    toml.key("kind", "\"torque_by_speed\"");
    write_initial_speed(model, toml);
    toml.numbers("speed", model.generator->speed);
    toml.numbers("torque", model.generator->torque);
  } else if (model.sets_torque()) {
    toml.key("kind", "\"torque\"", "that of the controller takes its place");
    toml.key("torque", "0");
    write_initial_speed(model, toml);
  } else if (model.speed.number != 0.0) {
    toml.key("kind", "\"constant\"");
    toml.key("speed", digits(model.speed.number), model.speed.from + ", in rad/s");
  } else {
    toml.key("kind", "\"fixed\"", model.speed.from.empty() ? "not in the files" : model.speed.from);
  }
}

void write_pitch(const FoundModel& model, Toml& toml) {
  toml.table("[[blade.joint]]");
  toml.key("name", "\"pitch\"");
  toml.key("station", "0");
  toml.key("kind", "\"revolute\"");
  toml.key("axis", "[1, 0, 0]");
  if (model.controls_pitch())
    toml.key("motion", "{ constant = 0 }", "rad, what the controller adds to");
  else
    write_motion(model.pitch, model.pitch_maneuver, ", in rad, negative to feather", toml);
}

void write_yaw(const FoundModel& model, const std::string& orientation, Toml& toml) {
  const FoundYaw& yaw = model.yaw;
  const bool follows = model.controls_yaw();
  const bool turns = yaw.moves || yaw.maneuver || follows || yaw.angle.number != 0.0;
  toml.table("[[support.joint]]");
  if (turns) toml.key("name", "\"yaw\"");
  toml.key("parent", "\"tower\"");
  toml.key("child", "\"nacelle\"");
  toml.key("kind", turns ? "\"revolute\"" : "\"fixed\"");
  toml.key("orientation", orientation, "back: z is up");
  if (!turns) return;
  toml.key("axis", "[0, 0, 1]");
  if (!yaw.moves) return write_motion(yaw.angle, yaw.maneuver, ", in rad", toml);
  toml.key("stiffness", digits(yaw.stiffness.number), yaw.stiffness.from);
  toml.key("damping", digits(yaw.damping.number), yaw.damping.from);
  if (yaw.rest.number != 0.0) toml.key("rest", digits(yaw.rest.number), yaw.rest.from + ", in rad");
  if (yaw.angle.number != 0.0)
    toml.key("initial", digits(yaw.angle.number), yaw.angle.from + ", in rad");
}

void write_control(const FoundModel& model, const std::string& folder, bool stands_alone,
                   Toml& toml) {
  if (model.laws) return write_laws(model, toml);
  if (!model.library) return;
  if (!model.library->is_there) {
    Toml lines;
    write_library(model, folder, lines);
    toml.comment_out(lines.take());
  } else if (stands_alone) {
    toml.table("[control.program]");
    write_controlled(model, toml);
  } else {
    write_library(model, folder, toml);
  }
}

}  // namespace spoke::foreign
