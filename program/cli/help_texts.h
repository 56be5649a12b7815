#pragma once

// The texts that --help prints around the options.

namespace spoke::cli {

// Texts of --help below the options: about the exit status, about each command, and about the
// program. Commands that measure have their own text about the exit status, for they write nothing
// before they are done.
extern const char* const kStatusText;
extern const char* const kMeasuringStatusText;
extern const char* const kRunText;
extern const char* const kCheckText;
extern const char* const kReduceText;
extern const char* const kStaticText;
extern const char* const kModesText;
extern const char* const kCampbellText;
extern const char* const kCriticalText;
extern const char* const kPerformanceText;
extern const char* const kLinearizeText;
extern const char* const kWindText;
extern const char* const kSchemaText;
extern const char* const kNewText;
extern const char* const kHelpText;
extern const char* const kDoctorText;
extern const char* const kTraceText;
extern const char* const kProgramText;

// Summaries of the commands that are programs of their own, for `spoke --help` and for theirs.
extern const char* const kStudySummary;
extern const char* const kImportSummary;
extern const char* const kExportSummary;
extern const char* const kFmuSummary;
extern const char* const kVerifySummary;
extern const char* const kCompareSummary;
extern const char* const kReproduceSummary;

}  // namespace spoke::cli
