// Groups of mount and anchors, and the plates that anchors are drawn as.

#include "engine/output/scene/carriers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cstddef>

#include "engine/output/scene/solids.h"
#include "models/space/frame_course.h"
#include "models/space/rotation_vector.h"

namespace spoke::scene {
namespace {

constexpr double kLeastRadius = 0.03;  // of a plate, by the radius of the scene
constexpr double kThickness = 0.006;   // half of it, likewise

/// Returns the places of loops on a group.
std::vector<Vector> places_on(const Scene& scene, int group) {
  std::vector<Vector> places;
  for (const LoopMark& loop : scene.loops)
    for (const Place* place : {&loop.from, &loop.to})
      if (place->node < 0 && place->group == group) places.push_back(place->p);
  return places;
}

/// Returns the unit vector across the plane in which points are, about their centre; as near as can
/// be to `wanted` where they say nothing.
Vector find_normal(const std::vector<Vector>& points, const Vector& centre, const Vector& wanted) {
  spatial::Tensor spread = spatial::Tensor::Zero();
  for (const Vector& p : points) spread += (p - centre) * (p - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<spatial::Tensor> principal(spread);
  const Vector& moments = principal.eigenvalues();
  if (moments[1] > 1e-6 * moments[2]) return principal.eigenvectors().col(0);
  if (moments[2] == 0.0) return wanted;
  const Vector along = principal.eigenvectors().col(2);
  const Vector across = wanted - along.dot(wanted) * along;
  return across.norm() > 1e-3 ? across.normalized() : along.unitOrthogonal();
}

}  // namespace

void add_carriers(const std::vector<Anchor>& anchors, const std::vector<const Loop*>& loops,
                  Scene& scene) {
  const bool any = std::any_of(loops.begin(), loops.end(), [](const Loop* loop) {
    return loop->to.carrier == LoopPlace::Carrier::mount ||
           loop->to.carrier == LoopPlace::Carrier::anchor || loop->to.moved_by >= 0;
  });
  if (!any) return;
  for (int anchor = -1; anchor < static_cast<int>(anchors.size()); ++anchor)
    scene.carriers.push_back(
        {anchor, anchor < 0 ? 0 : anchors[static_cast<std::size_t>(anchor)].rotor, scene.groups++});
}

bool is_sprung(const Loop& loop) {
  return loop.matrices || std::any_of(loop.stiffness.begin(), loop.stiffness.end(),
                                      [](double k) { return k > 0.0; });
}

int find_group(const Scene& scene, LoopPlace::Carrier carrier, int anchor) {
  assert(carrier != LoopPlace::Carrier::body && carrier != LoopPlace::Carrier::elsewhere);
  if (carrier == LoopPlace::Carrier::hub) return 0;
  const int wanted = carrier == LoopPlace::Carrier::mount ? -1 : anchor;
  for (const Carrier& carried : scene.carriers)
    if (carried.anchor == wanted) return carried.group;
  assert(false && "carriers are added before loops");
  return 0;
}

int group_of_hub(const Scene& scene, const Carrier& carrier) {
  return carrier.rotor == 0 ? 0 : scene.hubs[static_cast<std::size_t>(carrier.rotor)].group;
}

void add_plates(const std::vector<Anchor>& anchors, Scene& scene) {
  const double size = scene.radius();
  for (const Carrier& carrier : scene.carriers) {
    const std::vector<Vector> places = places_on(scene, carrier.group);
    if (carrier.anchor < 0 || places.empty()) continue;
    Vector centre = Vector::Zero();
    for (const Vector& p : places) centre += p / static_cast<double>(places.size());
    double radius = kLeastRadius * size;
    for (const Vector& p : places) radius = std::max(radius, (p - centre).norm());
    Solid plate = make_cylinder(find_normal(places, centre, scene.axis), radius, kThickness * size);
    place(centre, spatial::Tensor::Identity(), plate);
    plate.name = anchors[static_cast<std::size_t>(carrier.anchor)].name;
    plate.group = carrier.group;
    scene.solids.push_back(std::move(plate));
  }
}

namespace {

/// Translation and rotation vector of an anchor.
struct AnchorPlace {
  Vector translation, rotation;
};

AnchorPlace calc_place(const Anchor& anchor, double t) {
  if (const auto* course = std::get_if<spatial::MountMotion>(&anchor.motion))
    return {space::follow(course->translation, t).value, space::follow(course->rotation, t).value};
  const auto& program = std::get<ProgramAnchorMotion>(anchor.motion);
  return {program.translation, program.rotation};
}

/// Returns a time behind the points of a course that is a table; 0 for others.
double end_of(const spatial::VectorCourse& course) {
  double end = 0.0;
  if (const auto* table = std::get_if<spatial::VectorTable>(&course))
    for (const Curve& curve : table->components) end = std::max(end, curve.times().back());
  return end;
}

}  // namespace

spatial::Placement calc_first_place(const Anchor& anchor) {
  const AnchorPlace place = calc_place(anchor, 0.0);
  return {place.translation, space::exponential(place.rotation).axes};
}

spatial::Placement calc_last_place(const Anchor& anchor, const Vector* axis) {
  double end = 0.0;
  if (const auto* course = std::get_if<spatial::MountMotion>(&anchor.motion))
    end = std::max(end_of(course->translation), end_of(course->rotation));
  AnchorPlace place = calc_place(anchor, end);
  if (axis)
    for (Vector* vector : {&place.translation, &place.rotation})
      *vector = axis->dot(*vector) * *axis;
  return {place.translation, space::exponential(place.rotation).axes};
}

}  // namespace spoke::scene
