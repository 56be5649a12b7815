#pragma once

// The largest deflection of each tip, which a run prints.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/simulation.h"
#include "program/run_report/html_file.h"

namespace spoke::run_report {

/// Finds the largest deflection of each tip over all steps: in the plane, across the undeformed
/// blade; in space, the distance from the tip's undeformed place. The sensors have a tip's
/// displacement in the hub frame.
class TipDeflections {
 public:
  /// Starts without values. Throws std::out_of_range if a blade or subsystem has no tip sensors.
  explicit TipDeflections(const Simulation& simulation);
  /// Continues from earlier extremes(). Precondition: there is one for each blade and subsystem.
  TipDeflections(const Simulation& simulation, const std::vector<TipExtreme>& extremes);

  /// Adds all sensor values at time t [s].
  void add(double t, std::span<const double> sensors);
  std::vector<TipExtreme> extremes() const;  ///< extremes by blade, then by subsystem
  /// Returns a text such as "-0.534149 m at 6.765 s (blades 1-3)" for each group of blades with the
  /// same deflection, the largest first.
  std::vector<std::string> describe() const;
  /// Returns the first of these groups.
  TipSummary summarise() const;

 private:
  struct Tip {
    std::string name;                         ///< name of the subsystem; empty for a blade
    std::array<std::size_t, 3> components{};  ///< indices of its sensors; two in the plane
    /// The blade's azimuth in the plane [rad]. The deflection is across the blade, positive ahead
    /// of the hub's rotation, counterclockwise.
    std::optional<double> azimuth{};
    TipExtreme extreme{};

    double deflection(std::span<const double> sensors) const;
  };
  void add_spatial_tip(const Simulation& simulation, const std::string& tree,
                       const std::string& name);

  std::vector<Tip> tips_;
};

/// Counts the tips of a scenario, one for each blade and subsystem.
std::size_t count_tips(const Scenario& scenario);

}  // namespace spoke::run_report
