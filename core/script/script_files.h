#pragma once
// Files that a script may read and write: in its own folder, of a type that cannot be executed.
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace hw::script {

/// The path with links resolved; empty: no such file.
std::string real_path(const std::string& path);
/// Both paths from real_path().
bool is_below(const std::string& folder, const std::string& path);

/// The path of `name` in `folder` or below. It must end in `ending` (".csv") and need not exist yet.
Result<std::string> file_of_script(const std::string& folder, const std::string& name,
                                   std::string_view ending);
/// A file beside the script that could not be written: installed examples lie where only root writes.
Fault not_written_beside(const std::string& folder, Fault why);

}  // namespace hw::script
