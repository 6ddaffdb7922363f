#pragma once
// Files that a script may read and write: those of its own folder, of a kind that cannot be run.
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace hw::script {

/// Where the links really lead; empty when there is no such file.
std::string real_path(const std::string& path);
/// Both as real_path() gives them.
bool is_below(const std::string& folder, const std::string& path);

/// The path of `name`, which ends in `ending` (".csv") and need not exist yet, in `folder` or below it.
Result<std::string> file_of_script(const std::string& folder, const std::string& name,
                                   std::string_view ending);

}  // namespace hw::script
