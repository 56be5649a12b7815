// Runs each node on poisoned data and compares memory bit by bit.

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
using Image = std::vector<std::byte>;

// Copies the memory of parts to and from images.
class PartsMemory {
 public:
  explicit PartsMemory(std::span<const Part> parts) : parts_(parts) {
    begins_.push_back(0);
    for (const Part& part : parts) {
      std::size_t size = 0;
      for (const std::span<std::byte> range : part.memory) size += range.size();
      begins_.push_back(begins_.back() + size);
    }
  }

  std::size_t image_size() const { return begins_.back(); }
  std::size_t begin(std::size_t part) const { return begins_[part]; }
  std::size_t end(std::size_t part) const { return begins_[part + 1]; }

  void save(Image& image) const {
    std::byte* to = image.data();
    for (const Part& part : parts_) {
      for (const std::span<std::byte> range : part.memory) {
        if (!range.empty()) std::memcpy(to, range.data(), range.size_bytes());
        to += range.size();
      }
    }
  }
  void load(std::size_t part, const Image& image) const {
    const std::byte* from = image.data() + begins_[part];
    for (const std::span<std::byte> range : parts_[part].memory) {
      if (!range.empty()) std::memcpy(range.data(), from, range.size_bytes());
      from += range.size();
    }
  }
  // Comparisons are by bits: not-a-numbers must compare too.
  bool equal(std::size_t part, const Image& a, const Image& b) const {
    const std::size_t bytes = end(part) - begin(part);
    return bytes == 0 || std::memcmp(&a[begin(part)], &b[begin(part)], bytes) == 0;
  }

 private:
  std::span<const Part> parts_;
  std::vector<std::size_t> begins_;
};

// Poison differs from place to place, so that poison copied from elsewhere is told from poison that
// was left where it is. As doubles, one pattern is not-a-numbers, the other finite numbers of 1 to
// 1.5, which show accesses that not-a-numbers hide: a comparison with one is false whatever the
// value was, and a sum with one is that same not-a-number, as if nothing had been added. As whole
// numbers, one is negative and the other positive. The two differ in every byte, so that no byte
// that an honest node has written looks like both; and no byte is zero, so that a flag is set.
using Word = std::array<std::byte, sizeof(std::uint64_t)>;
struct PoisonWords {
  Word not_a_number, finite;
};
PoisonWords make_poison_words(std::uint64_t place) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15, spread = 0x0007ffffffffffff;
  // Bits 0 to 50 vary: of both words none of these bytes may become zero.
  std::uint64_t bits = ((place + 1) * golden) & spread;
  for (int shift = 0; shift < 48; shift += 8) {
    const std::uint64_t byte = bits >> shift & 0xff;
    if (byte == 0x00 || byte == 0xff) bits ^= std::uint64_t{0x55} << shift;
  }
  return {std::bit_cast<Word>(0xfff8000000000000 | (~bits & spread)),
          std::bit_cast<Word>(0x3ff0000000000000 | bits)};
}

struct Poison {
  std::array<Image, 2> patterns;
  std::vector<bool>
      // Whether a word begins at the byte; a range may begin and end within a word, as a flag does.
      begins_word;
};
Poison make_poison(std::span<const Part> parts) {
  Poison poison;
  std::uint64_t place = 0;
  for (const Part& part : parts) {
    for (const std::span<const std::byte> range : part.memory) {
      auto at = reinterpret_cast<std::uintptr_t>(range.data()) % sizeof(Word);
      PoisonWords words = make_poison_words(place);
      for (std::size_t i = 0; i < range.size(); ++i) {
        poison.patterns[0].push_back(words.not_a_number[at]);
        poison.patterns[1].push_back(words.finite[at]);
        poison.begins_word.push_back(at == 0 || i == 0);
        if (++at < words.finite.size()) continue;
        at = 0;
        words = make_poison_words(++place);
      }
      ++place;
    }
  }
  return poison;
}

// The declaration of one part by the node.
struct Declared {
  bool read = false;
  bool written = false;
};

class Checker {
 public:
  explicit Checker(const StepGraph& graph)
      : graph_(graph),
        memory_(graph.parts()),
        poison_(make_poison(graph.parts())),
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
  bool looks_unwritten(std::size_t byte) const;
  std::size_t mark_unwritten(std::size_t part);
  void find_unwritten_outputs();
  void find_undeclared_reads();
  void run_poisoned(const std::vector<bool>& poisoned, std::size_t round);
  bool outputs_depend_on(const std::vector<bool>& poisoned);
  bool outputs_differ(const Image& result) const;
  void add_fault(FaultKind kind, int part, const std::string& verb, const std::string& rest);

  const StepGraph& graph_;
  PartsMemory memory_;
  Poison poison_;
  Image before_;                  // the node
  Image after_;                   // memory after its ordinary run
  std::array<Image, 2> results_;  // results of its last run with each poison

  NodeId node_;                     // the node being checked
  std::vector<Declared> declared_;  // per part
  std::vector<bool> left_alone_;    // bytes only to be written that were not written
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
  for (std::size_t round = 0; round < poison_.patterns.size(); ++round) run_poisoned(unread, round);

  find_undeclared_writes();
  find_unwritten_outputs();
  if (outputs_differ(results_[0]) || outputs_differ(results_[1])) find_undeclared_reads();
  // The next node finds the results of this one's ordinary run.
  for (std::size_t part = 0; part < part_count(); ++part) memory_.load(part, after_);
}

// Runs the node on the data it found, the parts marked in `poisoned` replaced by poison.
void Checker::run_poisoned(const std::vector<bool>& poisoned, std::size_t round) {
  for (std::size_t part = 0; part < part_count(); ++part) {
    memory_.load(part, poisoned[part] ? poison_.patterns[round] : before_);
  }
  graph_.run_node(node_);
  memory_.save(results_[round]);
}

void Checker::find_undeclared_writes() {
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (declared_[part].written) continue;
    bool changed = !memory_.equal(part, before_, after_);
    for (std::size_t round = 0; round < poison_.patterns.size(); ++round) {
      const Image& found = declared_[part].read ? before_ : poison_.patterns[round];
      changed = changed || !memory_.equal(part, found, results_[round]);
    }
    if (!changed) continue;
    add_fault(FaultKind::undeclared_write, static_cast<int>(part), "writes",
              declared_[part].read ? ", which it declares as only read" : " without declaring it");
  }
}

// Whether a byte looks unwritten: one that shows either poison unchanged was not written. One
// poison would not do: sums with a not-a-number look unchanged.
bool Checker::looks_unwritten(std::size_t byte) const {
  return results_[0][byte] == poison_.patterns[0][byte] &&
         results_[1][byte] == poison_.patterns[1][byte];
}

// Marks the bytes of a part that were left alone, and counts them. Values computed from poison may
// show some of its bytes by chance: where a word has bytes that differ from run to run, it counts
// as a whole.
std::size_t Checker::mark_unwritten(std::size_t part) {
  std::size_t count = 0;
  for (std::size_t begin = memory_.begin(part), end = begin; begin < memory_.end(part);
       begin = end) {
    bool is_left = true, is_equal = true;
    do {
      const bool is_unwritten = looks_unwritten(end);
      is_left = is_left && is_unwritten;
      is_equal = is_equal && (is_unwritten || results_[0][end] == results_[1][end]);
      ++end;
    } while (end < memory_.end(part) && !poison_.begins_word[end]);
    for (std::size_t byte = begin; byte < end; ++byte) {
      left_alone_[byte] = (is_left || is_equal) && looks_unwritten(byte);
      count += left_alone_[byte] ? 1 : 0;
    }
  }
  return count;
}

void Checker::find_unwritten_outputs() {
  left_alone_.assign(memory_.image_size(), false);
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (!declared_[part].written || declared_[part].read) continue;
    const std::size_t count = mark_unwritten(part);
    if (count == 0) continue;
    const std::size_t size = memory_.end(part) - memory_.begin(part);
    add_fault(FaultKind::unwritten_output, static_cast<int>(part), "leaves unwritten",
              ", which it declares as written and not as read: " + std::to_string(count) +
                  " of its " + std::to_string(size) + " bytes keep what was there before");
  }
}

bool Checker::outputs_differ(const Image& result) const {
  for (std::size_t part = 0; part < part_count(); ++part) {
    if (!declared_[part].written || memory_.equal(part, after_, result)) continue;
    for (std::size_t i = memory_.begin(part); i < memory_.end(part); ++i) {
      if (!left_alone_[i] && after_[i] != result[i]) return true;
    }
  }
  return false;
}

bool Checker::outputs_depend_on(const std::vector<bool>& poisoned) {
  for (std::size_t round = 0; round < poison_.patterns.size(); ++round) {
    run_poisoned(poisoned, round);
    if (outputs_differ(results_[round])) return true;
  }
  return false;
}

// Poisons part after part to name the one that is read. Precondition: the outputs differ with
// everything undeclared poisoned.
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
  std::span<std::byte> memory;
  int part;
};

std::vector<DeclarationFault> find_overlaps(std::span<const Part> parts) {
  std::vector<PartRange> ranges;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const std::span<std::byte> memory : parts[part].memory) {
      if (!memory.empty()) ranges.push_back({memory, static_cast<int>(part)});
    }
  }
  const std::less<const std::byte*> before;
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
