// Takes subsystems that are alike apart into patterns.

#include "engine/small_motions/vibration/coupled_roots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::HubCoupling;
using steady::LinearModel;

constexpr Index kMeetHub = 3;  ///< patterns: 1, cosine, sine

/// Subsystems that are alike, and orthonormal amplitudes for each. The first patterns are those
/// that the hub feels.
struct Family {
  std::vector<std::size_t> subsystems;
  MatrixXd patterns;  ///< one in each column
  Index meeting = 0;  ///< patterns that meet at the hub

  Index held() const { return patterns.cols() - meeting; }
};

/// Returns the columns 1, cos, sin, cos of twice the azimuth, ... made orthonormal, as many as
/// there are subsystems.
MatrixXd make_harmonics(const VectorXd& azimuths) {
  const Index count = azimuths.size();
  MatrixXd patterns(count, count);
  Index found = 0;
  const auto add = [&](VectorXd column) {
    if (found == count) return;
    const double before = column.norm();
    for (int twice = 0; twice < 2; ++twice)
      column -= patterns.leftCols(found) * (patterns.leftCols(found).transpose() * column);
    const double after = column.norm();
    if (after > 1e-6 * before) patterns.col(found++) = column / after;
  };
  add(VectorXd::Ones(count));
  for (Index n = 1; n <= count; ++n) {
    add((static_cast<double>(n) * azimuths).array().cos());
    add((static_cast<double>(n) * azimuths).array().sin());
  }
  for (Index k = 0; k < count; ++k) add(VectorXd::Unit(count, k));  // for subsystems at one azimuth
  return patterns;
}

std::vector<Family> find_families(const LinearModel& model, const std::vector<double>& azimuths) {
  assert(azimuths.size() == model.subsystems.size() &&
         model.alike.size() == model.subsystems.size());
  std::vector<Family> families;
  for (std::size_t first = 0; first < model.subsystems.size(); ++first) {
    if (model.alike[first] != first) continue;
    Family& family = families.emplace_back();
    for (std::size_t i = first; i < model.subsystems.size(); ++i)
      if (model.alike[i] == first) family.subsystems.push_back(i);
    const Index count = std::ssize(family.subsystems);
    family.meeting = std::min(count, kMeetHub);
    family.patterns = MatrixXd::Identity(count, count);
    if (count <= kMeetHub) continue;
    VectorXd own(count);
    for (Index k = 0; k < count; ++k)
      own[k] = azimuths[family.subsystems[static_cast<std::size_t>(k)]];
    family.patterns = make_harmonics(own);
  }
  return families;
}

/// Returns the coupling of a pattern of subsystems with the hub.
HubCoupling combine(const LinearModel& model, const Family& family, Index pattern) {
  HubCoupling sum = model.couplings[family.subsystems[0]];
  for (MatrixXd HubCoupling::*part : {&HubCoupling::M_bh, &HubCoupling::C_bh, &HubCoupling::K_bh,
                                      &HubCoupling::M_hb, &HubCoupling::C_hb, &HubCoupling::K_hb}) {
    (sum.*part).setZero();
    for (std::size_t k = 0; k < family.subsystems.size(); ++k)
      sum.*part += family.patterns(static_cast<Index>(k), pattern) *
                   model.couplings[family.subsystems[k]].*part;
  }
  return sum;
}

/// Returns a model of the hub with a subsystem for each pattern that meets there.
LinearModel reduce(const LinearModel& model, const std::vector<Family>& families) {
  LinearModel reduced{model.M, model.C, model.K, {}, {}, {}, model.round_off, model.rate};
  for (const Family& family : families) {
    const std::size_t first = reduced.subsystems.size();
    for (Index pattern = 0; pattern < family.meeting; ++pattern) {
      reduced.subsystems.emplace_back();
      reduced.couplings.push_back(combine(model, family, pattern));
      reduced.alike.push_back(first);
    }
    reduced.subsystems[first] = model.subsystem(family.subsystems[0]);
  }
  return reduced;
}

/// Places of the coordinates of all subsystems in a vector that begins with those of the hub.
class Layout {
 public:
  explicit Layout(const LinearModel& model) : size_(model.M.rows()) {
    for (std::size_t i = 0; i < model.subsystems.size(); ++i) {
      starts_.push_back(size_);
      size_ += model.subsystem(i).M.rows();
    }
  }
  Eigen::VectorXcd zero() const { return Eigen::VectorXcd::Zero(size_); }
  /// Adds a motion of all subsystems of a family.
  template <class Motion>
  void add(const Family& family, Index pattern, const Motion& motion, Eigen::VectorXcd& x) const {
    for (std::size_t k = 0; k < family.subsystems.size(); ++k)
      x.segment(starts_[family.subsystems[k]], motion.size()) +=
          family.patterns(static_cast<Index>(k), pattern) * motion;
  }

 private:
  std::vector<Index> starts_;
  Index size_;
};

/// Adds the roots of patterns that move the hub, or feel it.
void add_meeting(const LinearModel& model, const std::vector<Family>& families,
                 const Layout& layout, Index count, std::vector<Root>& roots) {
  const LinearModel reduced = reduce(model, families);
  const Pencil pencil(reduced);
  for (const Root& root : find_roots(pencil, std::min(count, pencil.size()))) {
    Root& whole = roots.emplace_back(Root{root.s, layout.zero()});
    whole.x.head(model.M.rows()) = root.x.head(model.M.rows());
    std::size_t subsystem = 0;
    for (const Family& family : families)
      for (Index pattern = 0; pattern < family.meeting; ++pattern, ++subsystem)
        layout.add(family, pattern,
                   root.x.segment(pencil.start(subsystem), reduced.subsystem(subsystem).M.rows()),
                   whole.x);
  }
}

/// Returns the model of one subsystem of a family while the hub is held.
LinearModel hold_hub(const LinearModel& model, const Family& family) {
  return {{}, {}, {}, {model.subsystem(family.subsystems[0])}, {}, {0}, {}, model.rate};
}

/// Adds the roots of patterns that leave the hub at rest.
void add_held(const LinearModel& model, const Family& family, const Layout& layout, Index count,
              std::vector<Root>& roots) {
  if (family.held() == 0) return;
  const LinearModel one = hold_hub(model, family);
  const Pencil pencil(one);
  if (pencil.size() == 0) return;
  const Index needed = std::min(pencil.size(), (count - 1) / family.held() + 1);
  for (const Root& root : find_roots(pencil, needed))
    for (Index pattern = family.meeting; pattern < family.patterns.cols(); ++pattern) {
      Root& whole = roots.emplace_back(Root{root.s, layout.zero()});
      layout.add(family, pattern, root.x, whole.x);
    }
}

}  // namespace

std::vector<Root> find_coupled_roots(const LinearModel& model, const std::vector<double>& azimuths,
                                     Index count) {
  const std::vector<Family> families = find_families(model, azimuths);
  const Layout layout(model);
  std::vector<Root> roots;
  add_meeting(model, families, layout, count, roots);
  for (const Family& family : families) add_held(model, family, layout, count, roots);
  std::stable_sort(roots.begin(), roots.end(),
                   [](const Root& a, const Root& b) { return std::abs(a.s) < std::abs(b.s); });
  if (std::ssize(roots) > count) roots.resize(static_cast<std::size_t>(count));
  return roots;
}

std::vector<LinearModel> take_apart(const LinearModel& model, const std::vector<double>& azimuths) {
  const std::vector<Family> families = find_families(model, azimuths);
  std::vector<LinearModel> parts;
  if (model.is_coupled()) parts.push_back(reduce(model, families));
  for (const Family& family : families)
    if (!model.is_coupled() || family.held() > 0) parts.push_back(hold_hub(model, family));
  return parts;
}

}  // namespace spoke::vibration
