// ElastoDyn's tables of a blade and of a tower. Its beams bend, and neither stretch nor twist.

#include "program/foreign/elastodyn_reader.h"

#include <algorithm>
#include <numbers>
#include <span>

#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/named_table.h"

namespace spoke::foreign {
namespace {

/// Requires shares that ascend from 0 to 1 in the first column that is needed.
void check_shares(const NamedTable& table, const std::string& file, const char* name) {
  constexpr double least_gap = 1e-9;
  const std::vector<double> share = table.column(name);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const std::string is = std::string(name) + " is " + describe(share[i]);
    if (i == 0 && share[i] != 0.0)
      refuse(file, table.lines[i], is + ", expected 0 in the first row");
    if (i > 0 && !(share[i] > share[i - 1] + least_gap))
      refuse(file, table.lines[i],
             is + ", expected more than in the row before, " + describe(share[i - 1]));
    if (i + 1 == share.size() && share[i] != 1.0)
      refuse(file, table.lines[i], is + ", expected 1 in the last row");
  }
}

/// Returns a column of positive numbers times a factor.
std::vector<double> take_positive(const NamedTable& table, const std::string& file,
                                  const char* name, double factor = 1.0) {
  std::vector<double> values = table.column(name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0.0))
      refuse(file, table.lines[i],
             std::string(name) + " is " + describe(values[i]) + ", expected more than 0");
    values[i] *= factor;
  }
  return values;
}

bool is_positive(const NamedTable& table, const char* name) {
  if (!table.has(name)) return false;
  const std::vector<double> values = table.column(name);
  return std::all_of(values.begin(), values.end(), [](double value) { return value > 0.0; });
}

/// The names of columns that older files have besides.
struct OldColumns {
  const char *axial, *torsion, *flap_inertia, *lag_inertia;
};

/// Fills what ElastoDyn does without from columns of older files, or so stiff that it hardly shows.
void add_rigid_directions(const NamedTable& table, const OldColumns& old, BeamTable& beam) {
  const std::size_t n = beam.station.size();
  if (is_positive(table, old.axial) && is_positive(table, old.torsion)) {
    beam.axial_stiffness = table.column(old.axial);
    beam.torsion_stiffness = table.column(old.torsion);
    beam.remarks.push_back(std::string("Stretch and twist, which ElastoDyn does without, from the "
                                       "columns ") +
                           old.axial + " and " + old.torsion + ".");
  } else {
    const double most =
        std::max(*std::max_element(beam.flap_stiffness.begin(), beam.flap_stiffness.end()),
                 *std::max_element(beam.lag_stiffness.begin(), beam.lag_stiffness.end()));
    const double radius = 0.01 * beam.length.number;
    beam.axial_stiffness.assign(n, most / (radius * radius));
    beam.torsion_stiffness.assign(n, most);
    beam.remarks.emplace_back(
        "ElastoDyn's beams neither stretch nor twist: here they are stiff, by a radius of gyration "
        "of 1 % of the length and the largest EI.");
  }
  if (is_positive(table, old.flap_inertia) && is_positive(table, old.lag_inertia)) {
    beam.flap_inertia = table.column(old.flap_inertia);
    beam.lag_inertia = table.column(old.lag_inertia);
  }
}

/// Reads the number of stations and so many damping ratios, in per cent.
struct Head {
  int stations = 0;
  std::vector<double> ratios;
  int line = 0;
};
Head read_head(InputLines& lines, const char* count,
               std::span<const std::pair<const char*, const char*>> damping) {
  Head head;
  head.stations = lines.take_count(count, 2, kMostStations);
  for (const auto& [key, old] : damping) {
    const double percent = lines.take_number(lines.has(key) ? key : old);
    if (!(percent >= 0.0 && percent < 100.0))
      lines.refuse(std::string(key) + " is " + describe(percent) +
                   ", expected 0 or more and less than 100 (%)");
    head.ratios.push_back(0.01 * percent);
    head.line = lines.number();
  }
  return head;
}

double take_factor(InputLines& lines, const char* key) {
  const double factor = lines.take_number(key);
  if (!(factor > 0.0))
    lines.refuse(std::string(key) + " is " + describe(factor) + ", expected more than 0");
  return factor;
}

/// Makes stations of shares of a length.
BeamTable make_beam(const NamedTable& table, const std::string& file, const char* share,
                    const Value& length) {
  BeamTable beam;
  beam.length = length;
  const std::vector<double> shares = table.column(share);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    beam.station.push_back(i + 1 == shares.size() ? length.number : shares[i] * length.number);
    beam.station_from.push_back(std::string(share) + ' ' + describe(shares[i]) + ", " +
                                place(file, table.lines[i]));
  }
  return beam;
}

bool any_tuner(const std::vector<double>& tuners) {
  return std::any_of(tuners.begin(), tuners.end(), [](double tuner) { return tuner != 1.0; });
}

}  // namespace

void read_elastodyn_blade(const SourceFile& source, const Value& length, FoundModel& model) {
  InputLines lines(source.text, source.name);
  lines.take("the first line of a blade file of ElastoDyn");
  const std::string title = printable(lines.take("a title"));
  if (model.title.empty()) model.title = title;
  lines.take_filled("the headline BLADE PARAMETERS");
  constexpr std::pair<const char*, const char*> kDamping[] = {
      {"BldFlDmp1", "BldFlDmp(1)"}, {"BldFlDmp2", "BldFlDmp(2)"}, {"BldEdDmp1", "BldEdDmp(1)"}};
  const Head head = read_head(lines, "NBlInpSt", kDamping);
  lines.take_filled("the headline BLADE ADJUSTMENT FACTORS");
  std::vector<double> tuners;
  for (const char* key : {"FlStTunr1", "FlStTunr2"})
    tuners.push_back(lines.take_number(lines.has(key)   ? key
                                       : tuners.empty() ? "FlStTunr(1)"
                                                        : "FlStTunr(2)"));
  const double mass = take_factor(lines, "AdjBlMs"), flap = take_factor(lines, "AdjFlSt"),
               edge = take_factor(lines, "AdjEdSt");
  lines.take_filled("the headline DISTRIBUTED BLADE PROPERTIES");
  constexpr const char* kColumns[] = {"BlFract", "StrcTwst", "BMassDen", "FlpStff", "EdgStff"};
  const NamedTable table = read_named_table(lines, head.stations, kColumns);
  check_shares(table, source.name, "BlFract");
  BeamTable beam = make_beam(table, source.name, "BlFract", length);
  for (const double twist : table.column("StrcTwst"))
    beam.twist.push_back(twist == 0.0 ? 0.0 : -twist * std::numbers::pi / 180.0);
  beam.mass_per_length = take_positive(table, source.name, "BMassDen", mass);
  beam.flap_stiffness = take_positive(table, source.name, "FlpStff", flap);
  beam.lag_stiffness = take_positive(table, source.name, "EdgStff", edge);
  add_rigid_directions(table, {"EAStff", "GJStff", "FlpIner", "EdgIner"}, beam);
  beam.remarks.emplace_back(
      "mass_per_length is BMassDen times AdjBlMs, flap_stiffness FlpStff "
      "times AdjFlSt, lag_stiffness EdgStff times AdjEdSt, twist -StrcTwst.");
  model.blade = std::move(beam);
  // The order of frequencies of nearly all blades.
  model.damping.ratios = {head.ratios[0], head.ratios[2], head.ratios[1]};
  model.damping.from = "BldFlDmp1, BldEdDmp1, BldFlDmp2, " + place(source.name, head.line) +
                       " and before: first flap, first edge, second flap in this order";
  model.leave_out(Loss::detail,
                  source.name + ": mode shapes, since Spoke finds its own" +
                      (any_tuner(tuners) ? ", with FlStTunr, which belongs to them" : "") +
                      "; the blade is straight, as ElastoDyn has it");
}

void read_elastodyn_tower(const SourceFile& source, const Value& height, FoundModel& model) {
  InputLines lines(source.text, source.name);
  lines.take("the first line of a tower file of ElastoDyn");
  const std::string title = printable(lines.take("a title"));
  if (model.title.empty()) model.title = title;
  lines.take_filled("the headline TOWER PARAMETERS");
  constexpr std::pair<const char*, const char*> kDamping[] = {{"TwrFADmp(1)", "TwrFADmp1"},
                                                              {"TwrFADmp(2)", "TwrFADmp2"},
                                                              {"TwrSSDmp(1)", "TwrSSDmp1"},
                                                              {"TwrSSDmp(2)", "TwrSSDmp2"}};
  const Head head = read_head(lines, "NTwInpSt", kDamping);
  lines.take_filled("the headline TOWER ADJUSTMENT FACTORS");
  std::vector<double> tuners;
  for (const char* key : {"FAStTunr(1)", "FAStTunr(2)", "SSStTunr(1)", "SSStTunr(2)"})
    tuners.push_back(lines.take_number(key));
  const double mass = take_factor(lines, "AdjTwMa"), fore = take_factor(lines, "AdjFASt"),
               side = take_factor(lines, "AdjSSSt");
  lines.take_filled("the headline DISTRIBUTED TOWER PROPERTIES");
  constexpr const char* kColumns[] = {"HtFract", "TMassDen", "TwFAStif", "TwSSStif"};
  const NamedTable table = read_named_table(lines, head.stations, kColumns);
  check_shares(table, source.name, "HtFract");
  BeamTable beam = make_beam(table, source.name, "HtFract", height);
  beam.mass_per_length = take_positive(table, source.name, "TMassDen", mass);
  beam.flap_stiffness = take_positive(table, source.name, "TwFAStif", fore);
  beam.lag_stiffness = take_positive(table, source.name, "TwSSStif", side);
  add_rigid_directions(table, {"TwEAStif", "TwGJStif", "TwFAIner", "TwSSIner"}, beam);
  beam.remarks.emplace_back(
      "mass_per_length is TMassDen times AdjTwMa, flap_stiffness TwFAStif "
      "(fore-aft) times AdjFASt, lag_stiffness TwSSStif times AdjSSSt.");
  model.tower = std::move(beam);
  const std::vector<double> ratios = {head.ratios[0], head.ratios[2], head.ratios[1],
                                      head.ratios[3]};
  if (model.damping.ratios.empty() && model.damping.mu.empty()) {
    model.damping.ratios = ratios;
    model.damping.from = "TwrFADmp(1), TwrSSDmp(1), TwrFADmp(2), TwrSSDmp(2), " +
                         place(source.name, head.line) + " and before, in the order of frequencies";
  } else {
    model.leave_out(Loss::value, source.name +
                                     ": damping of the tower, since [damping] is of all "
                                     "beams and that of the blades is taken");
  }
  model.leave_out(Loss::detail,
                  source.name + ": mode shapes, since Spoke finds its own" +
                      (any_tuner(tuners) ? ", with the tuners that belong to them" : ""));
}

}  // namespace spoke::foreign
