#pragma once

// The largest deflection of each tip, which a run prints.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/run_report/html_file.h"
#include "engine/simulation.h"

namespace spoke::run_report {

/// Finds the largest deflection of each tip over all steps: of a rotor in the plane across the
/// undeformed blade, in space the distance from the tip's undeformed place. The sensors have a
/// tip's displacement in the hub frame.
class TipDeflections {
 public:
  /// Throws std::out_of_range if a blade or subsystem has no tip sensors.
  explicit TipDeflections(const Simulation& simulation);
  /// Goes on with what extremes() was. Precondition: one for each blade and subsystem.
  TipDeflections(const Simulation& simulation, const std::vector<TipExtreme>& extremes);

  /// sensors: all sensor values at time t [s].
  void add(double t, std::span<const double> sensors);
  std::vector<TipExtreme> extremes() const;  ///< by blade, then by subsystem
  /// A text such as "-0.534149 m at 6.765 s (blades 1-3)" for each group of blades with the same
  /// deflection, the largest first.
  std::vector<std::string> describe() const;
  /// The first of these.
  TipSummary summarise() const;

 private:
  struct Tip {
    std::string name;                         ///< of a subsystem; of a blade empty
    std::array<std::size_t, 3> components{};  ///< indices of its sensors; in the plane two
    /// In the plane: across the blade, which is turned by the azimuth; positive ahead of the hub's
    /// rotation, counterclockwise.
    std::optional<double> azimuth{};
    TipExtreme extreme{};

    double deflection(std::span<const double> sensors) const;
  };
  void add_spatial_tip(const Simulation& simulation, const std::string& tree,
                       const std::string& name);

  std::vector<Tip> tips_;
};

/// How many tips a scenario has, one for each blade and subsystem.
std::size_t count_tips(const Scenario& scenario);

}  // namespace spoke::run_report
