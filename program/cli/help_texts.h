#pragma once

// The texts that --help prints around the options.

namespace spoke::cli {

// What --help says below the options: of the program, of each command, and of the exit status; the
// commands that measure write nothing before they are done.
extern const char* const kStatusText;
extern const char* const kMeasuringStatusText;
extern const char* const kRunText;
extern const char* const kCheckText;
extern const char* const kStaticText;
extern const char* const kModesText;
extern const char* const kCampbellText;
extern const char* const kLinearizeText;
extern const char* const kTraceText;
extern const char* const kProgramText;

// The lines of the commands that are programs of their own, which `spoke --help` and theirs have.
extern const char* const kStudySummary;
extern const char* const kCompareSummary;
extern const char* const kPredictSummary;
extern const char* const kReproduceSummary;

}  // namespace spoke::cli
