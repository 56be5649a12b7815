// Makes the tables, files and page of an equilibrium.

#include "program/steady_report/static_files.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "models/space/rotation_vector.h"
#include "models/support/json.h"
#include "program/report/scene_markup.h"
#include "program/report/static_script.h"
#include "program/steady_report/static_air.h"
#include "program/steady_report/static_deflections.h"
#include "program/steady_report/steady_scene.h"

namespace spoke::steady_report {
namespace {

using Eigen::Vector3d;

std::string make_markup() {
  return R"(<div class="animation">
<div class="views">
<figure class="whole">)" +
         report::scene_canvas("steady", "view", "The model in equilibrium") + R"(</figure>
</div>
<div id="steady-colors" class="colors" hidden></div>
<div class="controls">
<label><span>Deflections</span><input type="range" id="steady-scale" min="0" max="200" value="0"><output id="steady-times"></output></label>
<label><span>Colour</span><select id="steady-color"><option value="tree">by blade or subsystem</option><option value="displacement">displacement</option><option value="von_mises">von Mises stress</option></select></label>
<label><input type="checkbox" id="steady-outline"> undeformed</label>
<label><input type="checkbox" id="steady-joints"> joints</label>
<label><input type="checkbox" id="steady-loads"> loads</label>
<label><input type="checkbox" id="steady-names"> names</label>
)" + report::scene_controls("steady") +
         R"(</div>
</div>
<noscript><p class="note warning">The picture needs JavaScript.</p></noscript>
)";
}

Json vector_json(const Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// Writes a number; a value that is only round-off beside `scale` becomes 0.
std::string number_text(double value, double scale) {
  constexpr double kRoundOff = 1e-10;
  return fmt::format("{:.6g}", std::abs(value) <= kRoundOff * scale ? 0.0 : plain_zero(value));
}

std::string vector_text(const Vector3d& v, double scale) {
  return fmt::format("[{}, {}, {}]", number_text(v.x(), scale), number_text(v.y(), scale),
                     number_text(v.z(), scale));
}

/// Returns how far a blade reaches from the hub [m].
double reach_of(const BladeEquilibrium& blade) {
  double reach = 0.0;
  for (const Vector3d& p : blade.nodes) reach = std::max(reach, p.norm());
  return reach;
}

/// Returns "blade 1 / body 2 by 12.3 % of its length".
std::string bending_text(const EquilibriumResult& result) {
  const steady::LargestBending largest = steady::find_largest_bending(result);
  if (largest.ratio == 0.0) return "none";
  return fmt::format("{} by {:.3g} % of its length", steady::name_body(result, largest),
                     100.0 * largest.ratio);
}

/// The size of the forces at the blades' roots [N], and of their moments about the hub [N m].
struct RootScale {
  double force = 0.0, moment = 0.0;
};
RootScale calc_root_scale(const EquilibriumResult& result) {
  RootScale scale;
  for (const BladeEquilibrium& blade : result.blades) {
    if (blade.loads.empty()) continue;
    const SectionLoad& root = blade.loads.front();
    const double force = root.force.norm();
    scale.force = std::max(scale.force, force);
    scale.moment = std::max(scale.moment, root.moment.norm() + reach_of(blade) * force);
  }
  return scale;
}

Json nodes_json(const std::vector<Vector3d>& nodes) {
  Json list = Json::array();
  for (const Vector3d& p : nodes) list.push_back(vector_json(p));
  return list;
}

Json blade_json(const BladeEquilibrium& blade) {
  Json joints = Json::array(), loads = Json::array();
  for (const JointPosition& joint : blade.joints)
    joints.push_back(
        {{"name", joint.name}, {"value", joint.value}, {"unit", joint.turns ? "rad" : "m"}});
  for (const SectionLoad& load : blade.loads)
    loads.push_back({{"body", load.body},
                     {"station_m", load.station},
                     {"force_N", vector_json(load.force)},
                     {"moment_N_m", vector_json(load.moment)}});
  Json loops = Json::array();
  for (const LoopLoad& loop : blade.loops) {
    Json load = {{"name", loop.name},
                 {"force_N", vector_json(loop.force)},
                 {"moment_N_m", vector_json(loop.moment)}};
    if (loop.tension) load.set("tension_N", *loop.tension);
    loops.push_back(std::move(load));
  }
  Json json = {{"name", blade.name},
               {"tip_displacement_m", vector_json(blade.tip_displacement)},
               {"tip_rotation_rad", vector_json(blade.tip_rotation)},
               {"joints", joints},
               {"section_forces", loads},
               {"loops", loops},
               {"bending", blade.bending},
               {"nodes_m", nodes_json(blade.nodes)},
               {"undeformed_nodes_m", nodes_json(blade.undeformed)}};
  if (!blade.air.empty()) json.set("air", section_air_json(blade));
  return json;
}

std::string make_data(const EquilibriumResult& result, const Scenario& scenario) {
  constexpr std::size_t kMostOfOne = 2000;
  const SteadyScene scene(scenario, result, kMostOfOne);
  const Json data = {{"scene", scene.describe()},
                     {"states", Json::array({scene.describe(result)})}};
  return data.dump();
}

}  // namespace

report::Table make_tip_table(const EquilibriumResult& result) {
  report::Table table{.caption = "Tips, in the hub's frame",
                      .columns = {{"blade"}, {"displacement [m]"}, {"rotation [rad]"}}};
  for (const BladeEquilibrium& blade : result.blades)
    table.rows.push_back({{blade.name, vector_text(blade.tip_displacement, reach_of(blade)),
                           vector_text(blade.tip_rotation, 1.0)}});
  return table;
}

report::Table make_joint_table(const EquilibriumResult& result) {
  report::Table table{
      .caption = "Joints",
      .columns = {{"blade"}, {"joint"}, {"value", report::Align::number}, {"unit"}}};
  for (const BladeEquilibrium& blade : result.blades)
    for (const JointPosition& joint : blade.joints)
      table.rows.push_back(
          {{blade.name, joint.name, number_text(joint.value, joint.turns ? 1.0 : reach_of(blade)),
            joint.turns ? "rad" : "m"}});
  return table;
}

report::Table make_loop_table(const EquilibriumResult& result) {
  const RootScale scale = calc_root_scale(result);
  report::Table table{.caption =
                          "Closed loops: what they exert on their place `from`, in the hub's "
                          "frame",
                      .columns = {{"blade"},
                                  {"loop"},
                                  {"force [N]"},
                                  {"moment [N m]"},
                                  {"tension [N]", report::Align::number}}};
  for (const BladeEquilibrium& blade : result.blades)
    for (const LoopLoad& loop : blade.loops)
      table.rows.push_back({{blade.name, loop.name,
                             vector_text(loop.force, std::max(scale.force, loop.force.norm())),
                             vector_text(loop.moment, std::max(scale.moment, loop.moment.norm())),
                             loop.tension ? number_text(*loop.tension, scale.force) : ""}});
  return table;
}

/// Returns the rotation vector of a hub [rad].
Eigen::Vector3d rotation_of(const HubPlace& hub) {
  return space::logarithm(space::Rotation{hub.axes});
}

std::string_view word_of(SmallMotions motions) {
  switch (motions) {
    case SmallMotions::decay:
      return "decay";
    case SmallMotions::grow:
      return "grow";
    case SmallMotions::persist:
      break;
  }
  return "persist";
}

/// Returns what small motions do, and which of them decays least.
std::string stability_text(const EquilibriumResult& result) {
  if (!result.stability) return "not known: " + result.stability_unknown;
  const Stability& stability = *result.stability;
  const std::string mode = stability.mode + " of " + stability.of;
  switch (stability.motions) {
    case SmallMotions::decay:
      return fmt::format("decay: the equilibrium is stable; least {}, by {:.3g} per s", mode,
                         -stability.rate);
    case SmallMotions::grow:
      return fmt::format("grow: the equilibrium is unstable, a run leaves it; {} by {:.3g} per s",
                         mode, stability.rate);
    case SmallMotions::persist:
      break;
  }
  return "neither grow nor decay: nothing damps " + mode;
}

Json stability_json(const EquilibriumResult& result) {
  if (!result.stability)
    return {{"small_motions", "unknown"}, {"reason", result.stability_unknown}};
  const Stability& stability = *result.stability;
  return {{"small_motions", std::string(word_of(stability.motions))},
          {"rate_per_s", plain_zero(stability.rate)},
          {"frequency_rad_per_s", stability.frequency},
          {"mode", stability.mode},
          {"of", stability.of}};
}

std::vector<report::Fact> make_facts(const EquilibriumResult& result) {
  const RootScale scale = calc_root_scale(result);
  std::vector<report::Fact> facts = {
      {"speed", fmt::format("{:.6g} rad/s", result.speed)},
      {"hub force", vector_text(result.hub_force, scale.force) + " N, of support and drive"},
      {"hub moment", vector_text(result.hub_moment, scale.moment) + " N m"},
      {"largest bending", bending_text(result)},
      {"small motions", stability_text(result)},
      {"found by", fmt::format("Newton's method, {} iterations in {} load step{}, last change "
                               "{:.1e}",
                               result.iterations, result.load_steps,
                               result.load_steps == 1 ? "" : "s", result.last_change)}};
  if (result.air)
    for (report::Fact& fact : make_air_facts(result))
      facts.insert(facts.end() - 3, std::move(fact));
  if (!result.hub) return facts;
  const double size = result.hub->position.norm();
  facts.insert(facts.begin() + 1,
               {{"hub", vector_text(result.hub->position, size) + " m, from the support's base"},
                {"hub rotation", vector_text(rotation_of(*result.hub), 1.0) + " rad"}});
  return facts;
}

namespace {

Json rotors_json(const EquilibriumResult& result) {
  Json rotors = Json::array();
  for (const RotorEquilibrium& rotor : result.rotors) {
    Json json = {{"name", rotor.name},
                 {"speed_rad_per_s", rotor.speed},
                 {"position_m", vector_json(rotor.hub.position)},
                 {"rotation_rad", vector_json(rotation_of(rotor.hub))},
                 {"force_N", vector_json(rotor.force)},
                 {"moment_N_m", vector_json(rotor.moment)}};
    if (rotor.air) json.set("air", air_json(*rotor.air, rotor.speed));
    rotors.push_back(std::move(json));
  }
  return rotors;
}

}  // namespace

std::string make_json(const EquilibriumResult& result) {
  Json blades = Json::array();
  for (const BladeEquilibrium& blade : result.blades) blades.push_back(blade_json(blade));
  Json warnings = Json::array();
  for (const Warning& warning : result.warnings) warnings.push_back(warning.text);
  Json json = {{"speed_rad_per_s", result.speed},
               {"hub_force_N", vector_json(result.hub_force)},
               {"hub_moment_N_m", vector_json(result.hub_moment)},
               {"iterations", result.iterations},
               {"load_steps", result.load_steps},
               {"last_change", result.last_change},
               {"stability", stability_json(result)},
               {"warnings", warnings},
               {"blades", blades}};
  if (result.air) json.set("air", air_json(*result.air, result.speed));
  if (!result.rotors.empty()) json.set("rotors", rotors_json(result));
  if (result.hub)
    json.set("hub", {{"position_m", vector_json(result.hub->position)},
                     {"rotation_rad", vector_json(rotation_of(*result.hub))}});
  return json.dump_lines();
}

report::Table make_rotor_table(const EquilibriumResult& result) {
  report::Table table{
      .caption = "Rotors: hubs from the support's base, forces and moments of support and drive",
      .columns = {{"rotor"},
                  {"speed [rad/s]", report::Align::number},
                  {"hub [m]"},
                  {"rotation [rad]"},
                  {"force [N]"},
                  {"moment [N m]"}}};
  double size = 0.0, force = 0.0, moment = 0.0;
  for (const RotorEquilibrium& rotor : result.rotors) {
    size = std::max(size, rotor.hub.position.norm());
    force = std::max(force, rotor.force.norm());
    moment = std::max(moment, rotor.moment.norm());
  }
  moment = std::max(moment, size * force);
  for (const RotorEquilibrium& rotor : result.rotors)
    table.rows.push_back(
        {{rotor.name, fmt::format("{:.6g}", rotor.speed), vector_text(rotor.hub.position, size),
          vector_text(rotation_of(rotor.hub), 1.0), vector_text(rotor.force, force),
          vector_text(rotor.moment, moment)}});
  return table;
}

std::string make_section_csv(const EquilibriumResult& result) {
  std::string text = "blade,body,station_m,Fx_N,Fy_N,Fz_N,Mx_N_m,My_N_m,Mz_N_m\n";
  for (const BladeEquilibrium& blade : result.blades)
    for (const SectionLoad& load : blade.loads) {
      text += fmt::format("{},{},{}", csv_cell(blade.name), csv_cell(load.body),
                          plain_zero(load.station));
      for (const Vector3d* v : {&load.force, &load.moment})
        for (const double value : *v) text += fmt::format(",{}", plain_zero(value));
      text += '\n';
    }
  return text;
}

std::string make_html(const EquilibriumResult& result, const Scenario& scenario,
                      const std::string& title) {
  report::Page page(title, fmt::format("Equilibrium at {:.6g} rad/s", result.speed));
  page.widen();
  page.add_markup(make_markup());
  for (const Warning& warning : result.warnings)
    page.add_note(warning.text + ".", report::Tone::warning);
  if (result.stability && result.stability->motions == SmallMotions::grow)
    page.add_note("Small motions " + stability_text(result) + ".", report::Tone::warning);
  page.add_facts(make_facts(result));
  page.add_markup("<div class=\"side\">\n");
  add_deflection_charts(result, page);
  if (has_air(result)) add_air_charts(result, page);
  page.add_markup("</div>\n");
  if (!result.rotors.empty()) page.add_table(make_rotor_table(result));
  page.add_table(make_tip_table(result));
  if (const report::Table joints = make_joint_table(result); !joints.rows.empty())
    page.add_table(joints);
  if (const report::Table loops = make_loop_table(result); !loops.rows.empty())
    page.add_table(loops);
  page.add_data("steady-data", make_data(result, scenario));
  page.add_script(report::static_script());
  return page.html();
}

}  // namespace spoke::steady_report
