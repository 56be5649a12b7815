#pragma once

// Writes the files of a study: tables of runs and of histories, and everything else in JSON.

#include <cstdint>
#include <functional>
#include <string>

#include "program/study/analysis.h"
#include "program/study/load_analysis.h"
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

/// Writes the values of the parameters with a key as a table that a design of the kind "table"
/// reads, with the columns of a table that say something about runs.
void write_table(const Study& study, const Sampling& sampling, const Sink& sink);

// Write the files of a study that has statistics.
/// statistics.csv: a row per run and sensor.
void write_statistics_csv(const Study& study, const ForEachRun& for_each, const Sink& sink);
/// extremes.csv: the least and the greatest value of each sensor, and all others at that time.
void write_extremes_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink);
/// lifetime.csv: damage-equivalent ranges of each sensor over the hours of a lifetime.
void write_lifetime_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink);
/// by_speed.csv: statistics of each sensor by load case and speed of the wind.
void write_by_speed_csv(const Study& study, const LoadAnalysis& loads, const Sink& sink);

/// Returns study.json: the study, and its analysis.
std::string make_json(const Study& study, const Sampling& sampling, const Analysis& analysis);

/// Returns the command that makes a run alone, to be pasted into a shell.
std::string replay_command(const Study& study, const Sampling& sampling, std::int64_t run);

}  // namespace spoke::study
