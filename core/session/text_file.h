#pragma once
// Program texts in files. A file that is not text is not opened; a text that cannot be saved stays in the
// editor.
#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace hw {

struct TextFile {
  std::string text;         ///< UTF-8, lines end with LF
  bool dos_lines = false;   ///< the file has CR LF and gets it again
  bool was_latin1 = false;  ///< not UTF-8: read as Latin-1, will be saved as UTF-8
};

inline constexpr std::size_t largest_program_text = 1'000'000;  // bytes

Result<TextFile> load_text(const std::filesystem::path& path);
/// Decodes bytes already read. `name`: for the message.
Result<TextFile> decode_text(std::string bytes, const std::string& name);
/// Atomic. On a fault the old file remains, and the message says that the text is kept.
Result<> save_text(const std::filesystem::path& path, const TextFile& file);

}  // namespace hw
