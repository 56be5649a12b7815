#pragma once

#include <utility>
#include <vector>

#include "bench/reproduce/reproduction.h"

/// Configurations and their times per step [s].
using Times = std::vector<std::pair<spoke::compare::Configuration, double>>;

/// A reproduction on an idle machine of 2 processors that has nothing but these times, each the
/// same in three rounds.
spoke::reproduce::Reproduction reproduction_of(spoke::reproduce::Work work, const Times& times);

/// A reproduction on the same machine with times that differ from round to round.
spoke::reproduce::Reproduction reproduction_of_rounds(
    spoke::reproduce::Work work,
    const std::vector<std::pair<spoke::compare::Configuration, std::vector<double>>>& times);

/// Puts the times of another kind of work beside them.
void add_times(spoke::reproduce::Work work, const Times& times,
               spoke::reproduce::Reproduction& all);
