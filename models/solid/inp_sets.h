#pragma once

// Sets of an .inp file, of nodes or of elements: numbers, ranges of numbers, and earlier sets.

#include <map>
#include <string>
#include <vector>

#include "models/solid/mesh_parts.h"

namespace spoke::solid {

/// All sets of one kind. What they hold is known only when the whole file is read.
class InpSets {
 public:
  struct Set {
    std::string name;
    std::vector<int> members;  ///< numbers, ascending, each once; from resolve() on
  };

  /// Begins a set of this name, or goes on with it.
  void open(const std::string& name);
  /// Returns the index of a set, whose name is in capitals or not; -1: there is none.
  int find(const std::string& name) const;

  // Put into the set that was opened last.
  void add_number(int number, int line);
  void add_range(int first, int last, int step, int line);
  void add_set(int set, int line);

  /// Finds the members of all sets. Numbers of ranges that are not in `known` are left out, others
  /// refused, unless `may_miss`. `members`: "node" or "element".
  void resolve(const LabelIndex& known, const std::vector<int>& labels, bool may_miss,
               const char* members, const std::string& file);
  const std::vector<Set>& sets() const { return sets_; }

 private:
  struct Entry {
    int set;  // that it belongs to
    int first, last, step;
    int other;  // a set whose members are taken; -1: the numbers are
    int line;
  };
  std::vector<Set> sets_;
  std::map<std::string, int> index_;
  std::vector<Entry> entries_;
  int open_ = -1;
};

}  // namespace spoke::solid
