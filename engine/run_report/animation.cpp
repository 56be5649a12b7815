// Collects the positions of nodes, of every few nodes where there are many.

#include "engine/run_report/animation.h"

#include <algorithm>
#include <cmath>

namespace spoke::run_report {
namespace {

std::size_t count_nodes(const Simulation& simulation) {
  std::size_t nodes = 0;
  for (const spoke::Blade& blade : simulation.scenario().rotor.blades)
    nodes += static_cast<std::size_t>(blade.bodies) * blade.elements + 1;
  return nodes;
}

bool are_finite(const std::vector<float>& numbers, std::size_t from) {
  return std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(from), numbers.end(),
                     [](float number) { return std::isfinite(number); });
}

}  // namespace

template <class Visit>
void Animation::each_shown(Visit visit) const {
  const std::size_t last = shape_.nodes.size() - 1;
  for (std::size_t k = 0; k < last; k += stride_) visit(shape_.nodes[k]);
  visit(shape_.nodes[last]);
}

Animation::Animation(const Simulation& simulation)
    : stride_((count_nodes(simulation) + kMostNodes - 1) / kMostNodes) {
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < simulation.scenario().rotor.blades.size(); ++i) {
    simulation.calc_shape(static_cast<int>(i), shape_);
    Blade blade;
    each_shown(
        [&](const ShapeNode& node) { blade.undeformed.emplace_back(node.p - node.displacement); });
    const auto stride = static_cast<int>(stride_);
    if (shape_.elements % stride == 0) blade.nodes_per_body = shape_.elements / stride;
    nodes += blade.undeformed.size();
    blades_.push_back(std::move(blade));
  }
  // A model in space has no planar shapes, and no frames.
  if (nodes > 0) most_frames_ = std::clamp(kMostNumbers / (2 * nodes), kFewestFrames, kMostFrames);
}

void Animation::add(const Simulation& simulation) {
  if (blades_.empty()) return;
  if (!times_.empty() && times_.back() == simulation.time()) return;
  const std::size_t before = displacements_.size(), hub_before = hub_.size();
  for (std::size_t i = 0; i < blades_.size(); ++i) {
    simulation.calc_shape(static_cast<int>(i), shape_);
    each_shown([&](const ShapeNode& node) {
      displacements_.push_back(static_cast<float>(node.displacement.x()));
      displacements_.push_back(static_cast<float>(node.displacement.y()));
    });
  }
  const Twist hub = simulation.hub().position;
  for (int c = 0; c < kTwist; ++c) hub_.push_back(static_cast<float>(hub[c]));
  if (are_finite(displacements_, before) && are_finite(hub_, hub_before)) {
    times_.push_back(simulation.time());
  } else {
    displacements_.resize(before);
    hub_.resize(hub_before);
  }
}

float Animation::largest_displacement() const {
  float largest = 0.0F;
  for (const float number : displacements_) largest = std::max(largest, std::abs(number));
  return largest;
}

}  // namespace spoke::run_report
