#pragma once

#include <csignal>
#include <string>
#include <vector>

/// The exit status of mpirun, one of whose processes was killed.
inline constexpr int kKilled = 128 + SIGKILL;

/// The arguments of a study in the folder o, on one thread of each rank, begun or resumed.
extern const std::vector<std::string> kStudyOnRanks;

/// Kills one of 2 to 4 ranks of a study of `runs` short runs at random times, `kills` times in
/// all, and resumes it, until it ends by itself; checks that it then has the results of one
/// process.
void check_rank_kills(int kills, int runs);
