// The list of parts, and what is marked of it.

#include "engine/bodies/table/parts.h"

namespace spoke {

/// Returns the parts to be changed, apart from those that graphs have.
std::vector<graph::Part>& Parts::own() {
  if (parts_.use_count() > 1) parts_ = std::make_shared<std::vector<graph::Part>>(*parts_);
  return *parts_;
}

graph::PartId Parts::open(graph::Part part, int subsystem, Mark mark) {
  own().push_back(std::move(part));
  tags_.push_back({subsystem, mark});
  return {static_cast<int>(tags_.size()) - 1};
}

void Parts::add(graph::PartId part, std::span<std::byte> range) {
  if (!range.empty()) own()[static_cast<std::size_t>(part.index)].memory.push_back(range);
}

template <class Selects>
Memory Parts::select(Selects&& selects) const {
  Memory memory;
  for (std::size_t k = 0; k < tags_.size(); ++k)
    if (selects(tags_[k]))
      memory.insert(memory.end(), (*parts_)[k].memory.begin(), (*parts_)[k].memory.end());
  return memory;
}

Memory Parts::marked(Mark mark) const {
  return select([mark](const Tag& tag) { return tag.mark == mark; });
}

Memory Parts::marked(Mark mark, int subsystem) const {
  return select(
      [mark, subsystem](const Tag& tag) { return tag.mark == mark && tag.subsystem == subsystem; });
}

}  // namespace spoke
