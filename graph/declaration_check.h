#pragma once

// Checks that the nodes of a graph read and write the parts that they declare, and nothing else.

#include <string>
#include <vector>

#include "graph/step_graph.h"
#include "spoke/export.h"

namespace spoke::graph {

/// A way in which a node departs from its declaration.
enum class FaultKind {
  undeclared_read,    ///< the node's result depends on a part it does not declare as read
  undeclared_write,   ///< the node changes a part it does not declare as written
  unwritten_output,   ///< a part declared as only written is not written in full
  hidden_state,       ///< the node's result depends on memory that belongs to no part
  overlapping_parts,  ///< two parts share memory, so that edges may be missing
};

/// One place where a node does not keep to its declaration.
struct DeclarationFault {
  FaultKind kind;         ///< kind of the departure
  NodeId node;            ///< the node at fault; index -1: the fault is not one of a node
  PartId part;            ///< the part concerned; index -1: no single part can be named
  std::string node_name;  ///< name by StepGraph::name_of()
  std::string part_name;  ///< name with which it was added
  std::string message;    ///< one sentence for people, with the names
};

/// Runs every node on its declared data alone and reports what it reads or writes beyond its
/// declaration; no fault means that none showed with the data at hand. It finds accesses by their
/// effect on memory, however the body comes by its data: run again with everything undeclared
/// replaced by poison (bits that are not-a-numbers as doubles, then finite numbers), a node must
/// give the same bits and leave the poison alone. Parts must hold data of which any bits are a
/// value. Serial, in any build type; afterwards the parts hold the results of one ordinary serial
/// run. If parts overlap, that is reported and no node is run. Each body runs three times (more
/// often if at fault), which must not matter to memory outside the parts.
SPOKE_EXPORT std::vector<DeclarationFault> check_declarations(const StepGraph& graph);

/// Checks one node alone; those before it in the serial order run once, ordinarily, those behind it
/// do not run.
SPOKE_EXPORT std::vector<DeclarationFault> check_declaration(const StepGraph& graph, NodeId node);

}  // namespace spoke::graph
