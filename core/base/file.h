#pragma once
// Small text files, whole.
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace hw {

Result<std::string> read_text_file(const std::string& path);
/// The file holds either the old text or the new one, whatever happens meanwhile: written beside it, synced,
/// renamed. Blocks until the disk has it. A symlink is followed, permissions are kept.
Result<> write_file_atomically(const std::string& path, std::string_view text);

}  // namespace hw
