#pragma once

// Writes the files of a study: tables of runs and of histories, and everything else in JSON.

#include <cstdint>
#include <functional>
#include <string>

#include "program/study/analysis.h"
#include "program/study/study.h"

namespace spoke::study {

/// Takes a file's text, piece by piece.
using Sink = std::function<void(std::string_view piece)>;

/// Writes runs.csv: a row per run, its status, parameters, responses that are numbers, and
/// diagnosis.
void write_runs_csv(const Study& study, const Sampling& sampling, const ForEachRun& for_each,
                    const Sink& sink);

/// Writes histories.csv: a row per run and time, a column per history. Rows of one run whose
/// histories have times of their own leave cells empty.
void write_histories_csv(const Study& study, const ForEachRun& for_each, const Sink& sink);

/// Returns study.json: the study, and its analysis.
std::string make_json(const Study& study, const Sampling& sampling, const Analysis& analysis);

/// Returns the command that makes a run alone, to be pasted into a shell.
std::string replay_command(const Study& study, const Sampling& sampling, std::int64_t run);

}  // namespace spoke::study
