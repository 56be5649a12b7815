#pragma once

// The user's loads as an actor: their evaluation, and their failures.

#include <exception>
#include <string>
#include <vector>

#include "engine/bodies/act/user_load/load_markers.h"

namespace spoke {

/// A load on the table.
template <class World>
struct LoadData {
  int number = 0;  ///< in the list that it was given in
  std::shared_ptr<const Load> load;
  std::vector<Marker> given;
  std::vector<int> subsystems;  ///< those of the markers, each once, ascending
  std::vector<PlacedMarker<World>> markers;
  ArenaVector<SectionWrench<World>> wrenches;  ///< by marker
  graph::PartId part;                          ///< of the wrenches
  // Arguments and results of the load: rewritten at every evaluation, no part of the table.
  std::vector<MarkerMotion> motions;
  std::vector<Wrench> forces;
  std::exception_ptr thrown;  ///< exception of the load, since it was last cleared
};

/// A load that has thrown.
struct FailedLoad {
  std::string sentence;  ///< "the load NAME of blade 2 failed AT: REASON"
  std::exception_ptr thrown;
};

template <class World>
class UserLoads final : public Actor<World> {
 public:
  /// Puts loads on a table, coupled if a load ties subsystems. System and table must outlive it.
  /// Throws InputError, naming the load, if a marker is on no body of the system.
  UserLoads(const std::vector<AskedLoad>& asked, const System<World>& system,
            StepData<World>& data);

  /// Returns load number `index` of those placed. Throws InputError if there is none.
  LoadData<World>& find(int index);
  /// Returns the first load that has thrown since, in the order of the subsystems; `at` says when,
  /// `names` what subsystems are called. Precondition: has_failed().
  FailedLoad find_failed(const std::vector<std::string>& names, const std::string& at) const;

  Stage stage() const override { return {"load", StageRole::terms}; }
  /// Adds the nodes of the loads whose first subsystem is `i`. A load between subsystems is a node
  /// of no subsystem.
  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override;
  void list_parts_on(int i, int j, PartList& parts) const override;
  bool calls_user() const override { return !loads_.empty(); }
  bool has_failed() const override;
  void clear_failures() override;

 private:
  /// Evaluates a load at time `t` [s] and the state in the table. If it fails, its wrenches are no
  /// numbers, which ends the step, and `load.thrown` says why.
  void evaluate(double t, LoadData<World>& load) const noexcept;

  const System<World>& system_;
  StepData<World>& data_;
  /// By first subsystem; those of one as they were given.
  std::vector<std::unique_ptr<LoadData<World>>> loads_;
};

/// Puts loads on a table as its last actor, and lets tension feel them.
template <class World>
UserLoads<World>& place_loads(const std::vector<AskedLoad>& loads, const System<World>& system,
                              StepData<World>& data);

}  // namespace spoke
