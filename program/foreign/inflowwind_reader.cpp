// Steady and uniform winds, and the names of files of TurbSim. InflowWind's x is downwind and z up,
// as in Spoke; its angles turn from x towards -y.

#include "program/foreign/inflowwind_reader.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/support/quantity.h"

namespace spoke::foreign {
namespace {

constexpr double kPerDegree = std::numbers::pi / 180.0;
constexpr const char* kUniformColumns[] = {
    "time",         "speed", "direction", "vertical", "horizontal shear", "exponent of shear",
    "linear shear", "gust"};

/// Returns 0 without a sign.
double plain_zero(double number) { return number == 0.0 ? 0.0 : number; }

Value read_exponent(KeyedLines& reader, const char* key) {
  Value exponent = reader.number(key);
  if (!(exponent.number >= 0.0 && exponent.number <= 1.0))
    reader.lines().refuse(std::string(key) + " is " + describe(exponent.number) +
                          ", expected a number from 0 to 1");
  return exponent;
}

void read_steady(KeyedLines& reader, FoundWind& wind, FoundAir& air) {
  const Value speed = reader.at_least("HWindSpeed", 0.0);
  wind.velocity *= speed.number;
  wind.velocity_from = speed.from + ", " + wind.velocity_from;
  air.reference_height = reader.positive("RefHt");
  air.shear = read_exponent(reader, reader.has("PLExp") ? "PLExp" : "PLexp");
  wind.has_profile = air.shear.number > 0.0;
}

/// Reads the direction of the mean wind.
void read_direction(KeyedLines& reader, FoundWind& wind) {
  const Value turn = reader.number("PropagationDir");
  const double angle = turn.number * kPerDegree;
  double upwards = 0.0;
  wind.velocity_from = "by " + turn.from;
  if (reader.has("VFlowAng")) {
    const Value up = reader.number("VFlowAng");
    if (std::abs(up.number) >= 90.0)
      reader.lines().refuse("VFlowAng is " + describe(up.number) +
                            ", expected an angle between -90 and 90 degrees");
    upwards = up.number * kPerDegree;
    wind.velocity_from += " and " + up.from;
  }
  wind.velocity = {std::cos(upwards) * std::cos(angle),
                   plain_zero(-std::cos(upwards) * std::sin(angle)), std::sin(upwards)};
}

/// A row of a table of a uniform wind in the scenario's terms.
struct UniformRow {
  double time, speed, direction, vertical, exponent, vertical_shear, horizontal_shear;
  bool has_gust_and_profile;
};

UniformRow convert(const std::vector<double>& row, double upwards, double reference_length) {
  UniformRow r{};
  r.time = row[0];
  const double along = row[1];
  r.speed = along * std::cos(upwards) + row[7];
  r.direction = plain_zero(-row[2] * kPerDegree);
  r.vertical = row[3] + along * std::sin(upwards);
  r.horizontal_shear = row[4] / reference_length;
  r.exponent = row[5];
  r.vertical_shear = row[6] / reference_length;
  r.has_gust_and_profile = row[7] != 0.0 && (row[4] != 0.0 || row[5] != 0.0 || row[6] != 0.0);
  return r;
}

/// Reads the next row; returns none at the end. Comments and blank lines are passed over.
std::vector<double> take_row(InputLines& lines, int last_line) {
  constexpr std::size_t count = std::size(kUniformColumns);
  while (lines.number() < last_line) {
    const std::string_view line = lines.take("a row of the table");
    if (line.empty() || line[0] == '!' || line[0] == '#' || line[0] == '%') continue;
    lines.step_back();
    // Newer tables have the angle of the flow upwards besides.
    const std::size_t words = std::min(split_words(line).size(), count + 1);
    std::vector<double> row = lines.take_numbers(words > count ? words : count, "time and wind");
    row.resize(count + 1, 0.0);
    return row;
  }
  return {};
}

void check_row(const InputLines& lines, const UniformRow& row, const UniformRow* before) {
  if (before && !(row.time > before->time))
    lines.refuse("time is " + describe(row.time) + ", expected more than in the row before, " +
                 describe(before->time));
  if (!(row.speed >= 0.0))
    lines.refuse("speed with gust is " + describe(row.speed) + ", expected 0 or more");
  if (!(row.exponent >= 0.0 && row.exponent <= 1.0))
    lines.refuse("exponent of shear is " + describe(row.exponent) +
                 ", expected a number from 0 to 1");
}

void write_wind_rows(const std::vector<UniformRow>& rows, const SourceFile& source,
                     FoundWind& wind) {
  wind.table =
      "time  speed  direction  vertical_speed  shear_exponent   # s, m/s, rad, m/s; written by "
      "spoke import of " +
      printable(source.name) + '\n';
  for (const UniformRow& row : rows)
    wind.table += fmt::format("{}  {}  {}  {}  {}\n", row.time, row.speed, row.direction,
                              row.vertical, row.exponent);
}

}  // namespace

InflowWindFile read_inflowwind(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  FoundAir& air = *model.air;
  FoundWind& wind = air.wind.emplace();
  InflowWindFile file;
  reader.take_head("a file of InflowWind");
  const int type = reader.count("WindType", 1, 7);
  if (type > 3)
    reader.lines().refuse("WindType is " + std::to_string(type) +
                          ", expected 1, steady, 2, uniform, or 3, of TurbSim");
  read_direction(reader, wind);
  if (type == 1) read_steady(reader, wind, air);
  if (type == 2) {
    file.uniform = reader.file("Filename_Uni", "FilenameUni");
    air.reference_height = reader.positive("RefHt_Uni");
    file.reference_length = reader.positive("RefLength").number;
    wind.has_profile = true;
  }
  if (type == 3) {
    file.turbsim = reader.file("FileName_BTS", "FileNameBTS");
    if (wind.velocity.z() != 0.0) {
      reader.seek("VFlowAng");
      reader.number("VFlowAng");
      reader.lines().refuse("VFlowAng is not 0, expected 0 with a file of TurbSim");
    }
  }
  if (type == 1 && wind.velocity.z() != 0.0)
    model.leave_out(Loss::theory, source.name +
                                      ": heights of the profile are along the inclined wind in "
                                      "InflowWind, from the ground up in the scenario");
  model.leave_out(Loss::detail, source.name + ": points of output, lidar");
  return file;
}

void read_uniform_wind(const SourceFile& source, const InflowWindFile& file, FoundModel& model) {
  FoundAir& air = *model.air;
  FoundWind& wind = *air.wind;
  InputLines lines(source.text, source.name);
  const int last_line = lines.count();
  std::vector<UniformRow> rows;
  const double upwards = std::asin(std::clamp(wind.velocity.z(), -1.0, 1.0));
  bool has_gust_and_profile = false, changes_shear = false;
  for (auto row = take_row(lines, last_line); !row.empty(); row = take_row(lines, last_line)) {
    rows.push_back(convert(row, upwards + row.back() * kPerDegree, file.reference_length));
    const UniformRow* before = rows.size() > 1 ? &rows[rows.size() - 2] : nullptr;
    check_row(lines, rows.back(), before);
    has_gust_and_profile = has_gust_and_profile || rows.back().has_gust_and_profile;
    changes_shear = changes_shear || rows.back().vertical_shear != rows.front().vertical_shear ||
                    rows.back().horizontal_shear != rows.front().horizontal_shear;
  }
  if (rows.empty()) lines.refuse("the file ends here, expected rows of time and wind");
  wind.vertical_shear = rows.front().vertical_shear;
  wind.horizontal_shear = rows.front().horizontal_shear;
  wind.velocity.z() = 0.0;  // the table has what goes upwards
  wind.velocity.normalize();
  write_wind_rows(rows, source, wind);
  if (rows.size() > 1)
    model.leave_out(Loss::theory, source.name +
                                      ": wind that is linear between rows; the scenario's goes "
                                      "through the same rows by monotone cubics");
  if (changes_shear)
    model.leave_out(Loss::value, source.name +
                                     ": linear shears that change over time; they stay as they "
                                     "begin");
  if (has_gust_and_profile)
    model.leave_out(Loss::value, source.name +
                                     ": gusts that are the same at all heights; the scenario's "
                                     "have the profile of the wind");
}

}  // namespace spoke::foreign
