// Stands for MPI where it never begins: in builds without it, and in the program that hands over to
// another one where it is launched. This process is alone.

#include "program/ranks/launch.h"

namespace spoke::ranks {

Launch::Launch() = default;
Launch::~Launch() = default;

std::uint64_t Launch::broadcast(std::uint64_t number) const { return number; }
std::vector<std::uint64_t> Launch::gather(std::uint64_t number) const { return {number}; }
std::unique_ptr<Exchange> Launch::make_exchange() const { return nullptr; }

}  // namespace spoke::ranks
