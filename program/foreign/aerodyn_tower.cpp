// The tower in the air: its drag, the flow around it and the deficit behind it.

#include <algorithm>
#include <cmath>

#include "models/support/quantity.h"
#include "program/foreign/aerodyn_reader.h"
#include "program/foreign/named_table.h"

namespace spoke::foreign {
namespace {

constexpr int kMostTowerNodes = 10000;

/// A node of the table: height over the ground, diameter and coefficient of drag.
struct TowerNode {
  double height, diameter, coefficient;
};

/// Reads a switch that some versions have as a flag; 0 if it is missing.
int read_flag_or_switch(KeyedLines& reader, const char* key, int most) {
  if (!reader.has(key)) return 0;
  const std::string word = reader.text(key);
  for (const char* off : {"False", "F", ".false."})
    if (is_same_word(word, off)) return 0;
  for (const char* on : {"True", "T", ".true."})
    if (is_same_word(word, on)) return 1;
  return reader.count(key, 0, most);
}

std::vector<TowerNode> read_nodes(KeyedLines& reader) {
  InputLines& lines = reader.lines();
  const int count = reader.count("NumTwrNds", 2, kMostTowerNodes);
  constexpr const char* kColumns[] = {"TwrElev", "TwrDiam", "TwrCd"};
  const NamedTable table = read_named_table(lines, count, kColumns, LastColumns::may_be_missing);
  std::vector<TowerNode> nodes;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto at = [&](const char* name) { return table.rows[row][table.find(name)]; };
    const int line = table.lines[row];
    const TowerNode node{at("TwrElev"), at("TwrDiam"), at("TwrCd")};
    if (row > 0 && !(node.height > nodes.back().height))
      refuse(lines.file(), line,
             "TwrElev is " + describe(node.height) + ", expected more than in the row before, " +
                 describe(nodes.back().height));
    if (!(node.diameter > 0.0))
      refuse(lines.file(), line,
             "TwrDiam is " + describe(node.diameter) + ", expected more than 0");
    if (!(node.coefficient >= 0.0))
      refuse(lines.file(), line, "TwrCd is " + describe(node.coefficient) + ", expected 0 or more");
    nodes.push_back(node);
  }
  return nodes;
}

/// Returns the node at a height between two.
TowerNode node_at(const std::vector<TowerNode>& nodes, double height) {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, height,
                                      [](double h, const TowerNode& n) { return h < n.height; });
  const TowerNode &b = *above, &a = *(above - 1);
  const double t = (height - a.height) / (b.height - a.height);
  return {height, std::lerp(a.diameter, b.diameter, t), std::lerp(a.coefficient, b.coefficient, t)};
}

/// The part of the nodes along the tower, from its foot on.
void add_stations(const std::vector<TowerNode>& nodes, double foot, double length,
                  FoundTowerAir& tower) {
  const double low = std::max(nodes.front().height, foot),
               high = std::min(nodes.back().height, foot + length);
  const double close = 1e-6 * length;  // nodes that are so close to an end are that end
  const auto add = [&](const TowerNode& node) {
    tower.station.push_back(std::clamp(node.height - foot, 0.0, length));
    tower.diameter.push_back(node.diameter);
    tower.coefficient.push_back(node.coefficient);
  };
  add(node_at(nodes, low));
  for (const TowerNode& node : nodes)
    if (node.height > low + close && node.height < high - close) add(node);
  add(node_at(nodes, high));
}

/// Bak's correction and the deficit need the coefficient, with which there is drag.
void check_drag(bool has_drag, const std::string& from, FoundTowerAir& tower, FoundModel& model) {
  if (has_drag) return;
  if (tower.potential.word == "bak" || tower.shadow.word != "none")
    model.leave_out(Loss::value, from +
                                     ", which is False: what the tower does to the wind needs "
                                     "its drag, which is there");
  else
    std::fill(tower.coefficient.begin(), tower.coefficient.end(), 0.0);
}

}  // namespace

void read_aerodyn_tower(const SourceFile& source, double foot, FoundModel& model) {
  KeyedLines reader(source);
  reader.take_head("a primary file of AeroDyn");
  constexpr std::string_view kPotentials[] = {"none", "cylinder", "bak"};
  FoundTowerAir tower;
  const auto from = [&reader](const char* key) {
    if (!reader.has(key)) return std::string("not in the files");
    reader.text(key);
    return key + (", " + reader.lines().place());
  };
  const int potential = read_flag_or_switch(reader, "TwrPotent", 2);
  tower.potential = {kPotentials[potential], from("TwrPotent")};
  const int shadow = read_flag_or_switch(reader, "TwrShadow", 2);
  tower.shadow = {shadow == 0 ? "none" : "powles", from("TwrShadow")};
  if (shadow == 2)
    model.leave_out(Loss::theory, from("TwrShadow") +
                                      ", which is 2: the deficit after Eames; the scenario has "
                                      "that of Powles");
  const bool has_drag = read_flag_or_switch(reader, "TwrAero", 2) != 0;
  const std::string drag_from = from("TwrAero");
  if (potential == 0 && shadow == 0 && !has_drag) return;
  const std::vector<TowerNode> nodes = read_nodes(reader);
  const double length = model.tower->length.number;
  if (!(nodes.front().height < foot + length && nodes.back().height > foot))
    reader.lines().refuse("no node is on the tower, expected TwrElev from " + describe(foot) +
                          " to " + describe(foot + length));
  reader.count("NumTwrNds", 2, kMostTowerNodes);
  tower.from = "TwrElev less the height of the foot, " + reader.lines().place();
  add_stations(nodes, foot, length, tower);
  check_drag(has_drag, drag_from, tower, model);
  model.air->tower = std::move(tower);
}

}  // namespace spoke::foreign
