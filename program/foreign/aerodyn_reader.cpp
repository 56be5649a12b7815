// AeroDyn's primary file, of versions 15 (WakeMod, AFAeroMod) and later (Wake_Mod, DBEMT_Mod,
// UA_Mod), its blade files and its aerofoils.

#include "program/foreign/aerodyn_reader.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "models/air/aerodyn_airfoil.h"
#include "models/air/airfoil_reader.h"
#include "program/foreign/named_table.h"

namespace spoke::foreign {
namespace {

constexpr int kMostAirfoils = 10000;
/// What WakeMod of OpenFAST 3.5 is larger by for the momentum balance that later versions call
/// BEM_Mod 2.
constexpr int kOtherBalance = 10;

/// Reads a positive number, or "default".
Value read_or_default(KeyedLines& reader, const char* key) {
  if (is_same_word(reader.text(key), "default"))
    return {0.0, std::string(key) + " is \"default\", " + reader.lines().place()};
  return reader.positive(key);
}

/// Reads a switch; one that is missing or "default" has another value.
int read_switch(KeyedLines& reader, const char* key, int least, int most, int missing) {
  if (!reader.has(key) || is_same_word(reader.text(key), "default")) return missing;
  return reader.count(key, least, most);
}

/// What models of the wake and of unsteady sections become.
void read_models(KeyedLines& reader, FoundModel& model) {
  FoundAir& air = *model.air;
  const bool is_new = reader.has("Wake_Mod");
  const char* key = is_new ? "Wake_Mod" : "WakeMod";
  int wake = reader.count(key, 0, is_new ? 3 : 12);
  const std::string from = std::string(key) + ", " + reader.lines().place();
  if (wake > 3 && wake < kOtherBalance)
    reader.lines().refuse("WakeMod is \"" + std::to_string(wake) +
                          "\", expected a whole number from 0 to 3, or from 10 to 12");
  if (wake >= kOtherBalance) {
    wake -= kOtherBalance;
    model.leave_out(Loss::theory,
                    from + ": momentum theory for large cone and prebend (BEM_Mod 2)");
  }
  air.induction = {wake == 0 ? "none" : "momentum", from};
  if (wake == 3)
    model.leave_out(Loss::theory, from + ": the free vortex wake; induction is by momentum theory");
  air.inflow = {wake == 2 ? "dynamic" : "quasi_steady", from};
  if (is_new && reader.has("DBEMT_Mod"))
    air.inflow = {read_switch(reader, "DBEMT_Mod", -1, 3, 0) > 0 ? "dynamic" : "quasi_steady",
                  "DBEMT_Mod, " + reader.lines().place()};
  const char* unsteady = is_new ? "UA_Mod" : "AFAeroMod";
  const bool is_static = reader.count(unsteady, is_new ? 0 : 1, is_new ? 9 : 2) == (is_new ? 0 : 1);
  air.stall = {is_static ? "static" : "dynamic",
               std::string(unsteady) + ", " + reader.lines().place()};
  if (!is_static) air.stall.from += "; by Oye's model";
}

/// Says which parts of AeroDyn's theory are not in the scenario.
void note_theory(KeyedLines& reader, FoundModel& model) {
  const std::string file = reader.lines().file();
  model.leave_out(Loss::theory, file +
                                    ": drag in the induction, interpolation of polars that is not "
                                    "linear, parameters of the unsteady models, constants of "
                                    "the skewed wake, direction of the sections (BlCrvAng), which "
                                    "is that of the blade's axis; "
                                    "blade 1 stands for all");
  model.leave_out(Loss::detail, file + ": noise, cavitation, outputs");
  constexpr std::pair<const char*, const char*> kLoads[] = {
      {"Buoyancy", "buoyancy"}, {"NacelleDrag", "drag of the nacelle"}, {"TFinAero", "a tail fin"}};
  for (const auto& [key, what] : kLoads)
    if (reader.has(key) && !reader.is_off(key))
      model.leave_out(Loss::part,
                      std::string(key) + " True, " + reader.lines().place() + ": " + what);
  for (const char* key : {"TipLoss", "HubLoss", "TanInd"})
    if (reader.is_off(key))
      model.leave_out(Loss::theory,
                      std::string(key) + " False, " + reader.lines().place() +
                          ": the scenario's momentum theory has losses at tip and root, and "
                          "swirl");
}

/// Requires that a quantity stands in the column in which tables are read.
void check_column(KeyedLines& reader, const char* key, int column) {
  if (!reader.has(key)) return;
  const int found = reader.count(key, 0, 100);
  if (found != column)
    reader.lines().refuse(std::string(key) + " is " + std::to_string(found) + ", expected " +
                          std::to_string(column));
}

/// Reads the names of the aerofoils' files, a line each.
std::vector<NamedFile> read_airfoil_names(KeyedLines& reader) {
  const int count = reader.count("NumAFfiles", 1, kMostAirfoils);
  std::vector<NamedFile> files;
  files.push_back({reader.text("AFNames"), reader.lines().number()});
  for (int number = 2; number <= count; ++number) {
    const std::string what =
        "the name of aerofoil file " + std::to_string(number) + " of " + std::to_string(count);
    const auto words = split_words(reader.lines().take_filled(what), 1);
    if (words.empty() || words[0].starts_with("==") || words[0].starts_with("--"))
      reader.lines().refuse("found a headline, expected " + what);
    files.push_back({std::string(words[0]), reader.lines().number()});
  }
  return files;
}

AeroDynNode make_node(const NamedTable& table, std::size_t row, std::size_t airfoils,
                      const std::string& file) {
  const int line = table.lines[row];
  const auto at = [&](const char* name) { return table.rows[row][table.find(name)]; };
  AeroDynNode node{at("BlSpn"), at("BlCrvAC"), at("BlSwpAC"), at("BlTwist"), at("BlChord"),
                   0,           line};
  if (row == 0 && node.span < 0.0)
    refuse(file, line, "BlSpn is " + describe(node.span) + ", expected 0 or more");
  constexpr double least_gap = 1e-6;  // [m]
  if (row > 0 && !(node.span > table.rows[row - 1][table.find("BlSpn")] + least_gap))
    refuse(file, line,
           "BlSpn is " + describe(node.span) + ", expected more than in the row before, " +
               describe(table.rows[row - 1][table.find("BlSpn")]));
  if (!(node.chord >= 0.0))
    refuse(file, line, "BlChord is " + describe(node.chord) + ", expected 0 or more");
  const double id = at("BlAFID");
  if (!(id >= 1.0 && id <= static_cast<double>(airfoils)) || id != std::floor(id))
    refuse(file, line,
           "BlAFID is " + describe(id) + ", expected a whole number from 1 to NumAFfiles, " +
               std::to_string(airfoils));
  node.airfoil = static_cast<std::size_t>(id) - 1;
  return node;
}

}  // namespace

AeroDynPrimary read_aerodyn_primary(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  AeroDynPrimary primary;
  reader.take_head("a primary file of AeroDyn");
  read_models(reader, model);
  model.air->density = read_or_default(reader, "AirDens");
  model.air->viscosity = read_or_default(reader, "KinVisc");
  note_theory(reader, model);
  primary.is_by_table = read_switch(reader, "AFTabMod", 1, 3, 1) > 1;
  check_column(reader, "InCol_Alfa", 1);
  check_column(reader, "InCol_Cl", 2);
  check_column(reader, "InCol_Cd", 3);
  primary.has_moment = read_switch(reader, "InCol_Cm", 0, 100, 4) > 0 && !reader.is_off("UseBlCm");
  if (primary.has_moment) check_column(reader, "InCol_Cm", 4);
  primary.airfoils = read_airfoil_names(reader);
  primary.blade = reader.file("ADBlFile(1)", "ADBlFile1");
  return primary;
}

std::vector<AeroDynNode> read_aerodyn_blade(const SourceFile& source, std::size_t airfoils) {
  InputLines lines(source.text, source.name);
  lines.take("the first line of a blade file of AeroDyn");
  lines.take("a title");
  lines.take_filled("the headline BLADE PROPERTIES");
  const int count = lines.take_count("NumBlNds", 2, kMostStations);
  constexpr const char* kColumns[] = {"BlSpn",   "BlCrvAC", "BlSwpAC",
                                      "BlTwist", "BlChord", "BlAFID"};
  const NamedTable table = read_named_table(lines, count, kColumns, LastColumns::may_be_missing);
  std::vector<AeroDynNode> nodes;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    nodes.push_back(make_node(table, row, airfoils, source.name));
  return nodes;
}

AeroDynPolars read_aerodyn_polars(const SourceFile& source, const AeroDynPrimary& primary) {
  if (!air::is_aerodyn_airfoil(source.text))
    refuse(source.name, 1,
           "is no aerofoil file of AeroDyn 15, expected a line of a value and then \"NumTabs\"");
  air::parse_airfoil(source.text, source.name, "aerofoil");  // refuses what is wrong, with lines
  AeroDynPolars read;
  for (const air::AerodynTable& table : air::read_aerodyn_airfoil(source.text, source.name)) {
    read.has_more = !read.polars.empty() && !primary.is_by_table;
    if (read.has_more) break;
    FoundPolar& polar = read.polars.emplace_back();
    polar.reynolds = table.reynolds;
    for (const std::vector<double>& row : table.rows.rows) {
      polar.angle.push_back(row[0]);
      polar.lift.push_back(row[1]);
      polar.drag.push_back(row[2]);
      if (primary.has_moment && row.size() > 3) polar.moment.push_back(row[3]);
    }
  }
  return read;
}

}  // namespace spoke::foreign
