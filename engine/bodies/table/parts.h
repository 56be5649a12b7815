#pragma once

// The parts of the table (graph/access.h). A part is declared where its memory is placed: the name
// that nodes' declarations show, the memory, and what else is done with it. Its handle is its place
// in the order of declaration, the same in every graph over one table, and stands beside the data
// (part_handles.h).
//
// Padding is in no part: kernels read the zeros of padded vectors, and nothing writes them.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "graph/access.h"
#include "graph/step_graph.h"

namespace spoke {

/// Ranges of memory, in no order.
using Memory = std::vector<std::span<std::byte>>;

/// Returns `count` values from the first one on.
template <class T>
std::span<std::byte> memory_of(T* first, std::size_t count) {
  return {reinterpret_cast<std::byte*>(first), count * sizeof(T)};
}

/// Adds the ranges of a padded vector that hold coordinates.
template <class Layout>
void add_flex(Memory& memory, double* flex, const Layout& layout) {
  layout.for_parts([&](int first, int n) {
    memory.push_back(memory_of(flex + first, static_cast<std::size_t>(n)));
  });
}

/// What is done with a part besides the work of nodes.
enum class Mark : unsigned {
  none = 0,
  state = 1,     ///< steps go on from it: it is set back when they are repeated
  reported = 2,  ///< processes that share the subsystems tell one another at the end of a pass
};

/// All parts of a table. Graphs that were built share them; what is declared afterwards is of later
/// graphs.
class Parts {
 public:
  /// Declares a part; more memory may be added to it. `subsystem`: whose it is; -1: the system's.
  graph::PartId open(graph::Part part, int subsystem, Mark mark);
  /// Adds memory to a part; empty ranges are left out.
  void add(graph::PartId part, std::span<std::byte> range);
  void add(graph::PartId part, const Memory& memory) {
    for (const std::span<std::byte> range : memory) add(part, range);
  }

  /// Hands all parts to a builder that has none: its handles are then those of the table.
  void share_with(graph::StepGraphBuilder& builder) const { builder.share_parts(parts_); }
  /// Returns the memory of the parts with this mark: of one subsystem, or of all things.
  Memory marked(Mark mark) const;
  Memory marked(Mark mark, int subsystem) const;

 private:
  struct Tag {
    int subsystem;
    Mark mark;
  };

  std::vector<graph::Part>& own();
  template <class Selects>
  Memory select(Selects&& selects) const;

  std::shared_ptr<std::vector<graph::Part>> parts_ = std::make_shared<std::vector<graph::Part>>();
  std::vector<Tag> tags_;  ///< by part
};

/// Declares the parts of one owner: "blade 1 / body 2 / terms".
class PartMaker {
 public:
  PartMaker() = default;
  /// `owner`: name before those of the parts, with a separator. `parts` must outlive this.
  PartMaker(Parts& parts, int subsystem = -1, std::string owner = {})
      : parts_(&parts), subsystem_(subsystem), owner_(std::move(owner)) {}
  /// The one of a subsystem; `names` must outlive this.
  PartMaker(Parts& parts, int subsystem, const graph::NodeNames& names)
      : parts_(&parts),
        subsystem_(subsystem),
        owner_(names.of_subsystem(subsystem) + " / "),
        names_(&names) {}
  /// Returns the one of a body of its subsystem.
  PartMaker of_body(int body) const { return of(names_->of_body(subsystem_, body)); }
  /// Returns the one of an item of the owner's.
  PartMaker of(const std::string& item) const {
    return {*parts_, subsystem_, owner_ + item + " / "};
  }

  /// Declares the part of some memory: objects, ranges of them, or lists of ranges of bytes.
  template <class... Data>
  graph::PartId cover(const std::string& name, Mark mark, Data&&... data) const {
    const graph::PartId part = parts_->open({owner_ + name, {}, 0}, subsystem_, mark);
    add(part, std::forward<Data>(data)...);
    return part;
  }
  /// Declares the part of a ring of records; a node touches the one of its step, `values` in a row.
  template <class Ring>
  graph::PartId ring(const std::string& name, Ring& records, std::size_t values = 1) const {
    return parts_->open(
        {owner_ + name, {memory_of(records.data(), records.size())}, values * sizeof(records[0])},
        subsystem_, Mark::none);
  }
  /// Adds memory to a part that was declared elsewhere.
  template <class... Data>
  void add([[maybe_unused]] graph::PartId part, Data&&... data) const {
    (add_one(part, std::forward<Data>(data)), ...);
  }

 private:
  template <class Data>
  void add_one(graph::PartId part, Data&& data) const {
    if constexpr (std::is_convertible_v<Data, const Memory&> ||
                  std::is_convertible_v<Data, std::span<std::byte>>)
      parts_->add(part, data);
    else
      parts_->add(part, graph::bytes_of(std::forward<Data>(data)));
  }

  Parts* parts_ = nullptr;
  int subsystem_ = -1;
  std::string owner_;
  const graph::NodeNames* names_ = nullptr;
};

}  // namespace spoke
