#include "graph/declaration_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>

namespace spoke::graph {
namespace {

// The values of all parts, one part after the other.
using Image = std::vector<double>;

// Copies the memory of parts to and from images.
class PartsMemory {
 public:
  explicit PartsMemory(std::span<const Part> parts) : parts_(parts) {
    begins_.push_back(0);
    for (const Part& part : parts) {
      std::size_t size = 0;
      for (const std::span<double> range : part.memory) size += range.size();
      begins_.push_back(begins_.back() + size);
    }
  }

  std::size_t image_size() const { return begins_.back(); }
  std::size_t begin(std::size_t part) const { return begins_[part]; }
  std::size_t end(std::size_t part) const { return begins_[part + 1]; }

  void save(Image& image) const {
    double* to = image.data();
    for (const Part& part : parts_) {
      for (const std::span<double> range : part.memory) {
        if (!range.empty()) std::memcpy(to, range.data(), range.size_bytes());
        to += range.size();
      }
    }
  }
  void load(std::size_t part, const Image& image) const {
    const double* from = image.data() + begins_[part];
    for (const std::span<double> range : parts_[part].memory) {
      if (!range.empty()) std::memcpy(range.data(), from, range.size_bytes());
      from += range.size();
    }
  }
  // Comparisons are by bits: not-a-numbers must compare too.
  bool equal(std::size_t part, const Image& a, const Image& b) const {
    const std::size_t bytes = (end(part) - begin(part)) * sizeof(double);
    return bytes == 0 || std::memcmp(&a[begin(part)], &b[begin(part)], bytes) == 0;
  }

 private:
  std::span<const Part> parts_;
  std::vector<std::size_t> begins_;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Poison differs from place to place, so that poison copied from elsewhere is told from poison that
// was left where it is.
Image make_nan_poison(std::size_t size) {
  constexpr std::uint64_t quiet_nan = 0x7ff85b0c00000000;
  Image poison(size);
  for (std::size_t i = 0; i < size; ++i) {
    poison[i] = std::bit_cast<double>(quiet_nan | (i & 0xffffffff));
  }
  return poison;
}

// Shows what not-a-numbers hide: a comparison with one is false whatever the value was, and a sum
// with one is that same not-a-number, as if nothing had been added.
Image make_finite_poison(std::size_t size) {
  constexpr double golden = 0.6180339887498949;
  Image poison(size);
  double fraction = 0.0;
  for (double& value : poison) {
    fraction += fraction < 1.0 - golden ? golden : golden - 1.0;
    value = 1.0 + fraction;
  }
  return poison;
}

// How a node declares one part.
struct Declared {
  bool read = false;
  bool written = false;
};

class Checker {
 public:
  explicit Checker(const StepGraph& graph)
      : graph_(graph),
        memory_(graph.parts()),
        poisons_{make_nan_poison(memory_.image_size()), make_finite_poison(memory_.image_size())},
        before_(memory_.image_size()),
        after_(memory_.image_size()),
        results_{Image(memory_.image_size()), Image(memory_.image_size())} {}

  std::vector<DeclarationFault> run() {
    for (const NodeId node : graph_.serial_order()) check(node);
    return std::move(faults_);
  }
  std::vector<DeclarationFault> run_to(NodeId last) {
    for (const NodeId node : graph_.serial_order()) {
      if (node == last) break;
      graph_.run_node(node);
    }
    check(last);
    return std::move(faults_);
  }

 private:
  std::size_t part_count() const { return graph_.parts().size(); }

  void check(NodeId node);
  void find_undeclared_writes();
  void find_unwritten_outputs();
  void find_undeclared_reads();
  void run_poisoned(const std::vector<bool>& poisoned, std::size_t round);
  bool outputs_depend_on(const std::vector<bool>& poisoned);
  bool outputs_differ(const Image& result) const;
  void add_fault(FaultKind kind, int part, const std::string& verb, const std::string& rest);

  const StepGraph& graph_;
  PartsMemory memory_;
  std::array<Image, 2> poisons_;
  Image before_;                  // the node
  Image after_;                   // its ordinary run
  std::array<Image, 2> results_;  // of its last run with each poison

  NodeId node_;                     // being checked
  std::vector<Declared> declared_;  // per part
  std::vector<bool> left_alone_;    // per place: only to be written, and not written
  std::vector<DeclarationFault> faults_;
};

void Checker::check(NodeId node) {
  node_ = node;
  memory_.save(before_);
  declared_.assign(part_count(), {});
  for (const PartId p : graph_.node(node).reads) {
    declared_[static_cast<std::size_t>(p.index)].read = true;
  }
  for (const PartId p : graph_.node(node).writes) {
    declared_[static_cast<std::size_t>(p.index)].written = true;
  }

  graph_.run_node(node);
  memory_.save(after_);
  std::vector<bool> unread(part_count());
  for (std::size_t part = 0; part < part_count(); ++part) unread[part] = !declared_[part].read;
  for (std::size_t round = 0; round < poisons_.size(); ++round) run_poisoned(unread, round);

  find_undeclared_writes();
  find_unwritten_outputs();
  if (outputs_differ(results_[0]) || outputs_differ(results_[1])) find_undeclared_reads();
  // The next node finds what this one left in its ordinary run.
  for (std::size_t part = 0; part < part_count(); ++part) memory_.load(part, after_);
}

// Runs the node on the data it found, the parts marked in `poisoned` replaced by poison.
void Checker::run_poisoned(const std::vector<bool>& poisoned, std::size_t round) {
  for (std::size_t part = 0; part < part_count(); ++part) {
    memory_.load(part, poisoned[part] ? poisons_[round] : before_);
  }
  graph_.run_node(node_);
  memory_.save(results_[round]);
}

void Checker::find_undeclared_writes() {
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (declared_[part].written) continue;
    bool changed = !memory_.equal(part, before_, after_);
    for (std::size_t round = 0; round < poisons_.size(); ++round) {
      const Image& found = declared_[part].read ? before_ : poisons_[round];
      changed = changed || !memory_.equal(part, found, results_[round]);
    }
    if (!changed) continue;
    add_fault(FaultKind::undeclared_write, static_cast<int>(part), "writes",
              declared_[part].read ? ", which it declares as only read" : " without declaring it");
  }
}

// A place that shows either poison unchanged was not written. One poison would not do: sums with a
// not-a-number look unchanged.
void Checker::find_unwritten_outputs() {
  left_alone_.assign(memory_.image_size(), false);
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (!declared_[part].written || declared_[part].read) continue;
    std::size_t count = 0;
    for (std::size_t i = memory_.begin(part); i < memory_.end(part); ++i) {
      left_alone_[i] =
          same_bits(results_[0][i], poisons_[0][i]) && same_bits(results_[1][i], poisons_[1][i]);
      count += left_alone_[i] ? 1 : 0;
    }
    if (count == 0) continue;
    const std::size_t size = memory_.end(part) - memory_.begin(part);
    add_fault(FaultKind::unwritten_output, static_cast<int>(part), "leaves unwritten",
              ", which it declares as written and not as read: " + std::to_string(count) +
                  " of its " + std::to_string(size) + " values keep what was there before");
  }
}

bool Checker::outputs_differ(const Image& result) const {
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (!declared_[part].written || memory_.equal(part, after_, result)) continue;
    for (std::size_t i = memory_.begin(part); i < memory_.end(part); ++i) {
      if (!left_alone_[i] && !same_bits(after_[i], result[i])) return true;
    }
  }
  return false;
}

bool Checker::outputs_depend_on(const std::vector<bool>& poisoned) {
  for (std::size_t round = 0; round < poisons_.size(); ++round) {
    run_poisoned(poisoned, round);
    if (outputs_differ(results_[round])) return true;
  }
  return false;
}

// The outputs are known to differ with everything undeclared poisoned: poisons part after part to
// name the one that is read.
void Checker::find_undeclared_reads() {
  std::vector<bool> poisoned(part_count(), false);
  if (outputs_depend_on(poisoned)) {
    add_fault(FaultKind::hidden_state, -1, "gives another result when run again on the same data",
              ": it depends on memory that belongs to no part");
    return;
  }
  bool named = false;
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (declared_[part].read) continue;
    poisoned[part] = true;
    if (outputs_depend_on(poisoned)) {
      named = true;
      add_fault(FaultKind::undeclared_read, static_cast<int>(part), "reads",
                declared_[part].written ? ", which it declares as only written"
                                        : " without declaring it");
    }
    poisoned[part] = false;
  }
  if (!named) {
    add_fault(FaultKind::undeclared_read, -1, "reads parts that it does not declare as read",
              ": it shows only when several of them change at once");
  }
}

void Checker::add_fault(FaultKind kind, int part, const std::string& verb,
                        const std::string& rest) {
  DeclarationFault fault{kind, node_, {part}, graph_.name_of(node_), {}, {}};
  fault.message = "node \"" + fault.node_name + "\" " + verb;
  if (part >= 0) {
    fault.part_name = graph_.part({part}).name;
    fault.message += " part \"" + fault.part_name + "\"";
  }
  fault.message += rest + ".";
  faults_.push_back(std::move(fault));
}

struct PartRange {
  std::span<double> memory;
  int part;
};

std::vector<DeclarationFault> find_overlaps(std::span<const Part> parts) {
  std::vector<PartRange> ranges;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const std::span<double> memory : parts[part].memory) {
      if (!memory.empty()) ranges.push_back({memory, static_cast<int>(part)});
    }
  }
  const std::less<const double*> before;
  std::stable_sort(ranges.begin(), ranges.end(), [&](const PartRange& a, const PartRange& b) {
    return before(a.memory.data(), b.memory.data());
  });
  std::vector<DeclarationFault> faults;
  const PartRange* reaching_furthest = nullptr;
  for (const PartRange& range : ranges) {
    const auto end_of = [](const PartRange& r) { return r.memory.data() + r.memory.size(); };
    if (reaching_furthest && before(range.memory.data(), end_of(*reaching_furthest))) {
      const std::string& first = parts[static_cast<std::size_t>(reaching_furthest->part)].name;
      const std::string& second = parts[static_cast<std::size_t>(range.part)].name;
      faults.push_back({FaultKind::overlapping_parts,
                        {},
                        {range.part},
                        {},
                        second,
                        "part \"" + second + "\" shares memory with part \"" + first + "\"."});
    }
    if (!reaching_furthest || before(end_of(*reaching_furthest), end_of(range))) {
      reaching_furthest = &range;
    }
  }
  return faults;
}

}  // namespace

std::vector<DeclarationFault> check_declarations(const StepGraph& graph) {
  std::vector<DeclarationFault> overlaps = find_overlaps(graph.parts());
  if (!overlaps.empty()) return overlaps;
  return Checker(graph).run();
}

std::vector<DeclarationFault> check_declaration(const StepGraph& graph, NodeId node) {
  std::vector<DeclarationFault> overlaps = find_overlaps(graph.parts());
  if (!overlaps.empty()) return overlaps;
  return Checker(graph).run_to(node);
}

}  // namespace spoke::graph
