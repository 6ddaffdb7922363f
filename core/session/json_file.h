#pragma once
// Small JSON files of our own (profiles, recents, unsaved texts). A damaged one never blocks the start: it is
// put aside with a sentence and the user goes on without it.
//
// Each carries "version": 1 (until October 2026 most had none, and are read alike). Whoever changes what a
// field means raises it, and reads the older ones; new fields do not need it. A file of a newer version is
// put aside whole.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"

namespace hw {

/// The object in the file. An absent file is an empty object. A damaged one is renamed, and the fault says
/// so.
Result<nlohmann::json> read_json(const std::filesystem::path& path, std::string_view what_it_is);
/// Creates the folder, writes atomically; for the eyes of its owner only.
Result<> write_json(const std::filesystem::path& path, const nlohmann::json& object);
/// The fault of a file that parses but does not hold what it should; also renames it.
Fault damaged(const std::filesystem::path& path, std::string_view what_it_is);

}  // namespace hw
