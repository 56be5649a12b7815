// Makes the rows of each kind of closure.

#include "models/system/loop_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace spoke {
namespace space {
namespace {

using Kind = LoopRow::Kind;

/// Two directions across an axis, right-handed with it.
struct Across {
  Position first, second;
};

/// Chooses the first one nearest to the axis of the frame that is the most across.
Across find_across(const Position& axis) {
  int most = 0;
  for (int c = 1; c < 3; ++c)
    if (std::abs(axis[c]) < std::abs(axis[most])) most = c;
  const Position unit = Position::Unit(most);
  const Position first = Position(unit - axis.dot(unit) * axis).normalized();
  return {first, cross(axis, first)};
}

class RowMaker {
 public:
  RowMaker(const Loop& loop, bool in_plane) : loop_(loop), in_plane_(in_plane) {
    if (count_axes(loop.kind) == 0 || loop.axes[0].isZero(0.0)) return;
    axis_ = Position(loop.axes[0].normalized());
    across_ = find_across(axis_);
  }

  std::vector<LoopRow> make() && {
    switch (loop_.kind) {
      case LoopKind::fixed:
        hold_place();
        hold_frame();
        break;
      case LoopKind::revolute:
        hold_place();
        align();
        break;
      case LoopKind::prismatic:
        slide();
        hold_frame();
        break;
      case LoopKind::universal:
        hold_place();
        cross_axes();
        break;
      case LoopKind::spherical:
        hold_place();
        break;
      case LoopKind::cylindrical:
        slide();
        align();
        break;
      case LoopKind::bearing:
        slide();
        break;
      case LoopKind::distance:
        rows_.push_back({Kind::distance, {}, {}, loop_.length.value_or(0.0)});
        rows_.back().axis = rows_.back().other = Position::Zero();
        break;
    }
    give();
    return std::move(rows_);
  }

 private:
  void add(Kind kind, const Position& axis) { rows_.push_back({kind, axis, Position::Zero()}); }

  void hold_place() {
    for (int c = 0; c < (in_plane_ ? 2 : 3); ++c) add(Kind::displacement, Position::Unit(c));
  }
  void hold_frame() {
    if (in_plane_) return add(Kind::rotation, Position::UnitZ());
    if (loop_.kind == LoopKind::fixed) {
      for (int c = 0; c < 3; ++c) add(Kind::rotation, Position::Unit(c));
      return;
    }
    for (const Position& axis : {across_.first, across_.second, axis_}) add(Kind::rotation, axis);
  }
  void slide() {
    if (in_plane_) return add(Kind::displacement, cross(Position(Position::UnitZ()), axis_));
    add(Kind::displacement, across_.first);
    add(Kind::displacement, across_.second);
  }
  /// A small rotation about one direction across the axis tilts the axis towards the other one.
  void align() {
    if (in_plane_) return;
    rows_.push_back({Kind::alignment, -across_.second, axis_});
    rows_.push_back({Kind::alignment, across_.first, axis_});
  }
  void cross_axes() {
    const Position other = loop_.axes[1].normalized();
    rows_.push_back({Kind::alignment, axis_, other, axis_.dot(other)});
  }
  /// Gives the rows their springs and dampers.
  void give() {
    const auto value = [](const std::vector<double>& values, std::size_t i) {
      return i < values.size() ? values[i] : 0.0;
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i].stiffness = value(loop_.stiffness, i);
      rows_[i].damping = rows_[i].is_rigid() ? 0.0 : value(loop_.damping, i);
      rows_[i].is_of_bearing = loop_.matrices.has_value();
    }
  }

  const Loop& loop_;
  bool in_plane_;
  Position axis_ = Position::Zero();
  Across across_{Position::Zero(), Position::Zero()};
  std::vector<LoopRow> rows_;
};

}  // namespace
}  // namespace space

std::vector<LoopRow> make_loop_rows(const Loop& loop, bool in_plane) {
  return space::RowMaker(loop, in_plane).make();
}

LoopModel make_loop(const Loop& loop, bool in_plane) {
  LoopModel made;
  made.name = loop.name;
  made.kind = loop.kind;
  made.turns_to_start = !loop.from.orientation.has_value();
  made.measures_at_start = loop.kind == LoopKind::distance && !loop.length;
  made.rows = make_loop_rows(loop, in_plane);
  if (loop.matrices)
    made.bearing = make_bearing(*loop.matrices, made.rows[0].axis, made.rows[1].axis);
  return made;
}

double LoopModel::unit_of(const LoopRow& row, double length) const {
  if (!is_coupling()) return row.is_length() ? length : 1.0;
  double unit = 0.0;
  for (const CoupledCoordinate& at : coupled)
    unit = std::max(unit, std::abs(at.ratio) * (at.slides ? length : 1.0));
  return unit;
}

AnchorModel make_anchor(const Anchor& anchor, const space::Rotation& to_axis) {
  AnchorModel made{anchor.name, anchor.frame, anchor.turns_with_hub, {}, to_axis, anchor.rotor};
  if (const auto* mount = std::get_if<spatial::MountMotion>(&anchor.motion)) {
    made.motion = *mount;
  } else {
    const auto& program = std::get<ProgramAnchorMotion>(anchor.motion);
    SaidAnchorMotion said;
    said.value = space::make_twist(program.translation, program.rotation);
    made.motion = said;
  }
  return made;
}

}  // namespace spoke
