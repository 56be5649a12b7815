#pragma once

// The kinds of files that commands write, each known by how such a file begins.

#include <string_view>

namespace spoke::cli {

struct FileKind {
  const char* name;            ///< as messages have it: "a page (HTML)"
  std::string_view beginning;  ///< first bytes, letters of either case
  std::string_view mark = {};  ///< stands in the first bytes, too; empty: nothing does

  /// Whether a file that begins with these kHead bytes, or is these, is of the kind.
  bool has(std::string_view head) const;
};

/// Bytes that tell the kind of a file.
constexpr int kHead = 512;

// Files that users name. Where others than Spoke write such files as well, only Spoke's own are of
// the kind.
extern const FileKind kPage;              ///< of all commands
extern const FileKind kWindFile;          ///< of spoke wind
extern const FileKind kExportedFile;      ///< of spoke export
extern const FileKind kImportedScenario;  ///< of spoke import
extern const FileKind kImportedPolar;     ///< of spoke import
extern const FileKind kImportedWind;      ///< of spoke import
extern const FileKind kFmuFile;           ///< of spoke fmu

/// Returns the kind of a file in a folder of results, by its name: "sensors.csv". The name must be
/// one that a command writes.
const FileKind& kind_of_result(std::string_view name);

}  // namespace spoke::cli
