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
extern const char* const kStudyText;
extern const char* const kStudyStatusText;
extern const char* const kCompareText;
extern const char* const kPredictText;
extern const char* const kTraceText;
extern const char* const kReproduceText;
extern const char* const kProgramText;

}  // namespace spoke::cli
