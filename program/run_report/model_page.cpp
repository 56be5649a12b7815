// Makes one view of the scene, and tables of its parts.

#include "program/run_report/model_page.h"

#include <spdlog/fmt/fmt.h>

#include "engine/output/scene/make_scene.h"
#include "models/count_text.h"
#include "program/report/model_script.h"
#include "program/report/page.h"
#include "program/report/scene_markup.h"
#include "program/run_report/animation.h"
#include "program/run_report/base64.h"
#include "program/run_report/scene_data.h"

namespace spoke::run_report {
namespace {

std::string make_markup() {
  return R"(<div class="animation">
<div class="views">
<figure class="whole">)" +
         report::scene_canvas("model", "view", "The model at t = 0") + R"(</figure>
</div>
<div class="controls">
<label><input type="checkbox" id="model-axes" checked> section axes (<span class="y-axis">y</span>, <span class="z-axis">z</span>)</label>
<label><input type="checkbox" id="model-joints" checked> joints</label>
<label><input type="checkbox" id="model-loads" checked> loads</label>
<label><input type="checkbox" id="model-sensors" checked> sensors</label>
<label><input type="checkbox" id="model-names" checked> names</label>
)" + report::scene_controls("model") +
         R"(</div>
</div>
<noscript><p class="note warning">The drawing needs JavaScript.</p></noscript>
)";
}

/// Values that are only round-off beside 1 become 0.
std::string vector_text(const scene::Vector& v) {
  const auto number = [](double x) { return fmt::format("{:.4g}", std::abs(x) < 1e-9 ? 0.0 : x); };
  return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]";
}

report::Table joint_table(const scene::Scene& scene) {
  report::Table table{"Places and axes in the hub's frame, all joint coordinates zero.",
                      {{"joint"}, {"kind"}, {"place [m]"}, {"axes"}, {"coordinates"}},
                      {}};
  for (const scene::JointMark& joint : scene.joints) {
    std::string axes, coordinates;
    for (const scene::Vector& axis : joint.axes)
      axes += (axes.empty() ? "" : ", ") + vector_text(axis);
    for (const std::string& coordinate : joint.coordinates)
      coordinates += (coordinates.empty() ? "" : ", ") + coordinate;
    const scene::Vector& place = scene.nodes[static_cast<std::size_t>(joint.node)].p;
    table.rows.push_back({{joint.name, joint.kind, vector_text(place), axes, coordinates}});
  }
  return table;
}

report::Table body_table(const scene::Scene& scene) {
  report::Table table{
      "Sections are drawn by chord and thickness, where they are given; else as "
      "full ellipses of the section's inertias. Rigid bodies are drawn as boxes of "
      "their mass and inertia. What would be too thin to be seen is drawn thicker.",
      {{"body"},
       {"inboard end [m]"},
       {"outboard end [m]"},
       {"section at its root, y and z [m]"},
       {"at its tip [m]"}},
      {}};
  const auto size_of = [](const scene::Ring& ring) {
    return fmt::format("{:.4g} by {:.4g}", 2.0 * ring.half_y, 2.0 * ring.half_z);
  };
  for (const scene::Strip& strip : scene.strips) {
    const auto first = static_cast<std::size_t>(strip.first);
    const auto last = first + static_cast<std::size_t>(strip.nodes) - 1;
    table.rows.push_back(
        {{strip.name, vector_text(scene.nodes[first].p), vector_text(scene.nodes[last].p),
          size_of(strip.rings.front()), size_of(strip.rings.back())}});
  }
  return table;
}

report::Table loop_table(const scene::Scene& scene) {
  report::Table table{
      "Places and axes in the frames of what carries them, all joint coordinates "
      "zero; drawn as the simulation starts, with all loops closed.",
      {{"loop"}, {"kind"}, {"from [m]"}, {"to [m]"}, {"axes"}},
      {}};
  for (const scene::LoopMark& loop : scene.loops) {
    std::string axes;
    for (const scene::Vector& axis : loop.axes)
      axes += (axes.empty() ? "" : ", ") + vector_text(axis);
    table.rows.push_back({{loop.name, loop.kind + (loop.is_sprung ? ", sprung" : ""),
                           vector_text(loop.from.p), vector_text(loop.to.p), axes}});
  }
  return table;
}

/// Names of those that begin with `prefix`, without it.
std::string names_of(const std::vector<std::string>& names, const std::string& prefix) {
  std::string text;
  for (const std::string& name : names)
    if (name.starts_with(prefix)) text += (text.empty() ? "" : ", ") + name.substr(prefix.size());
  return text;
}

report::Table freedom_table(const LoopsAtStart& start) {
  report::Table table{
      "Free coordinates less independent rows are the mobility; redundant rows take no part. "
      "Moved: "
      "joints that left their initial coordinates, or their initial speeds, so that loops are "
      "closed.",
      {{"of"},
       {"joint coordinates"},
       {"of deformation"},
       {"rows"},
       {"mobility"},
       {"redundant"},
       {"moved"}},
      {}};
  for (const SubsystemFreedoms& own : start.subsystems) {
    const std::string prefix = own.name + " / ";
    std::vector<std::string> moved;
    for (const MovedJoint& joint : start.moved)
      moved.push_back(fmt::format("{} by {:.4g} {}", joint.joint, joint.by, joint.unit));
    for (const ChangedSpeed& speed : start.speeds)
      moved.push_back(fmt::format("{} to {:.4g} {}", speed.joint, speed.to, speed.unit));
    table.rows.push_back({{own.name, std::to_string(own.joints), std::to_string(own.deformations),
                           std::to_string(own.rows), std::to_string(own.mobility),
                           names_of(start.redundant, prefix), names_of(moved, prefix)}});
  }
  return table;
}

/// Returns the frame in which the model is drawn. Loops close where the simulation starts.
scene::Frame find_frame(const Simulation& simulation, const scene::Scene& scene) {
  if (scene.loops.empty()) return make_first_frame(simulation.scenario(), scene);
  scene::Frame frame;
  scene::FrameReader(scene).read(simulation, frame);
  return frame;
}

std::string make_data(const Simulation& simulation, const scene::Scene& scene) {
  const scene::Frame frame = find_frame(simulation, scene);
  const spatial::Placement hub{frame.hub.position, frame.hub.rotation};
  const bool stands = scene.support >= 0;
  std::vector<float> groups;
  for (std::size_t g = 1; g < frame.groups.size(); ++g)
    append_pose(stands ? hub * frame.groups[g] : frame.groups[g], groups);
  Json data = {{"scene", describe_scene(scene)}, {"groups", encode(groups)}};
  if (stands) {  // it is drawn in the inertial frame
    std::vector<float> pose;
    append_pose(hub, pose);
    data.set("hub", encode(pose));
  }
  return data.dump();
}

}  // namespace

std::string make_model_page(const Simulation& simulation) {
  const Scenario& scenario = simulation.scenario();
  const scene::Scene scene = scene::make_scene(simulation, Animation::kMostNodes);
  report::Page page(scenario.title.empty() ? scenario.name : scenario.title,
                    std::string("The model at t = 0, before it is simulated: ") +
                        counted(std::ssize(scene.subsystems), "tree") + ", " +
                        counted(std::ssize(scene.joints), "joint"));
  page.widen();
  page.add_markup(make_markup());
  if (!scene.joints.empty()) {
    page.add_heading("Joints");
    page.add_table(joint_table(scene));
  }
  if (!scene.loops.empty()) {
    page.add_heading("Loops");
    page.add_table(loop_table(scene));
    page.add_table(freedom_table(simulation.loops_at_start()));
  }
  if (!scene.strips.empty()) {
    page.add_heading("Flexible bodies");
    page.add_table(body_table(scene));
  }
  page.add_data("model-data", make_data(simulation, scene));
  page.add_script(report::model_script());
  return page.html();
}

}  // namespace spoke::run_report
