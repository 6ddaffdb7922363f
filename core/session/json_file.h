#pragma once
// The console's small JSON files (profiles, recents, unsaved texts). A damaged file never blocks the start:
// it is set aside with a message, and the console continues without it.
//
// Each has "version": 1 (until October 2026 most had none; these are read the same way). When you change the
// meaning of a field, raise the version and still read older ones; a new field needs no new version. A file
// of a newer version is set aside whole.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"

namespace hw {

/// The object in the file; empty for an absent file. A damaged file is renamed, and the fault says so.
Result<nlohmann::json> read_json(const std::filesystem::path& path, std::string_view what_it_is);
/// Creates the folder and writes atomically; readable by the owner only.
Result<> write_json(const std::filesystem::path& path, const nlohmann::json& object);
/// Renames a file that parses but has the wrong content, and returns the fault.
Fault damaged(const std::filesystem::path& path, std::string_view what_it_is);

}  // namespace hw
