// Sets refer to earlier ones only, so entries are taken in the order of the file.

#include "models/solid/inp_sets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "models/solid/inp_lines.h"

namespace spoke::solid {
namespace {

constexpr std::size_t kMostMembers = std::size_t{1} << 26;

void sort_members(std::vector<int>& members) {
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

}  // namespace

void InpSets::open(const std::string& name) {
  const auto [found, is_new] =
      index_.try_emplace(in_capitals(name), static_cast<int>(sets_.size()));
  if (is_new) sets_.push_back({name, {}});
  open_ = found->second;
}

int InpSets::find(const std::string& name) const {
  const auto found = index_.find(in_capitals(name));
  return found == index_.end() ? -1 : found->second;
}

void InpSets::add_number(int number, int line) {
  if (!entries_.empty()) {  // numbers in a row make one entry
    Entry& last = entries_.back();
    if (last.set == open_ && last.other < 0 && last.line == line && last.step == 0 &&
        last.last == number - 1) {
      last.last = number;
      return;
    }
  }
  entries_.push_back({open_, number, number, 0, -1, line});
}

void InpSets::add_range(int first, int last, int step, int line) {
  entries_.push_back({open_, first, last, step, -1, line});
}

void InpSets::add_set(int set, int line) { entries_.push_back({open_, 0, 0, 0, set, line}); }

void InpSets::resolve(const LabelIndex& known, const std::vector<int>& labels, bool may_miss,
                      const char* members, const std::string& file) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Entry& entry = entries_[e];
    std::vector<int>& set = sets_[static_cast<std::size_t>(entry.set)].members;
    const std::size_t before = set.size();
    if (entry.other >= 0) {
      const std::vector<int>& other = sets_[static_cast<std::size_t>(entry.other)].members;
      if (entry.other != entry.set) set.insert(set.end(), other.begin(), other.end());
    } else if (entry.step == 0) {
      for (std::int64_t k = entry.first; k <= entry.last; ++k) {
        const auto number = static_cast<int>(k);
        if (known.find(number) >= 0)
          set.push_back(number);
        else if (!may_miss)
          refuse_mesh(file, entry.line,
                      "names " + std::string(members) + ' ' + std::to_string(number) +
                          ", which the file does not have, expected the number of one");
      }
    } else {
      const std::vector<int>& order = known.ascending();
      for (std::size_t k = known.lower_bound(entry.first); k < order.size(); ++k) {
        const int number = labels[static_cast<std::size_t>(order[k])];
        if (number > entry.last) break;
        if ((number - entry.first) % entry.step == 0) set.push_back(number);
      }
    }
    count += set.size() - before;
    if (count > kMostMembers)
      refuse_mesh(
          file, entry.line,
          "sets have more than " + std::to_string(kMostMembers) + " members, expected fewer");
    if (e + 1 == entries_.size() || entries_[e + 1].set != entry.set) sort_members(set);
  }
}

}  // namespace spoke::solid
