#include "core/session/text_file.h"

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/session/user_files.h"

namespace hw {
namespace {

bool is_utf8(std::string_view s) {
  for (std::size_t i = 0; i < s.size();) {
    const std::size_t n = utf8_length(s, i);
    if (n == 0) return false;
    i += n;
  }
  return true;
}

std::string from_latin1(std::string_view s) {
  std::string out;
  for (const char c : s) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0 | (byte >> 6));
      out += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return out;
}

/// Index of the first byte that is not text; npos: none. (Tab, line ends and form feed are text.)
std::size_t first_control(std::string_view s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto c = static_cast<unsigned char>(s[i]);
    if ((c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7F) return i;
  }
  return std::string_view::npos;
}

std::string with_line_feeds(std::string_view s, bool& dos_lines) {
  std::string out;
  out.reserve(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] != '\r') {
      out += s[i];
      continue;
    }
    const bool pair = i + 1 < s.size() && s[i + 1] == '\n';
    dos_lines |= pair;
    if (!pair) out += '\n';
  }
  return out;
}

}  // namespace

Result<TextFile> decode_text(std::string bytes, const std::string& name) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);           // byte order mark
  while (!bytes.empty() && bytes.back() == '\x1A') bytes.pop_back();  // end of file of DOS editors
  if (const std::size_t at = first_control(bytes); at != std::string::npos)
    return fail(FaultKind::text,
                fmt::format("{} is not a text: its byte {} is {:02X} hex.", shown_path(name), at + 1,
                            static_cast<unsigned char>(bytes[at])),
                "It was not opened; nothing else was changed.", "Choose a file with program text.");
  TextFile file;
  if (!is_utf8(bytes)) {
    file.was_latin1 = true;
    bytes = from_latin1(bytes);
  }
  file.text = with_line_feeds(bytes, file.dos_lines);
  return file;
}

Result<TextFile> load_text(const std::filesystem::path& path) {
  auto bytes = read_file(path, largest_program_text);
  if (!bytes) {
    Fault fault = std::move(bytes.error());
    if (fault.done.empty()) fault.done = "Nothing was changed.";
    return fail(std::move(fault));
  }
  return decode_text(std::move(*bytes), path.filename().string());
}

Result<> save_text(const std::filesystem::path& path, const TextFile& file) {
  std::string bytes;
  bytes.reserve(file.text.size());
  for (const char c : file.text) {
    if (c == '\n' && file.dos_lines) bytes += '\r';
    bytes += c;
  }
  auto written = write_file(path, bytes);
  if (written) return written;
  Fault fault = std::move(written.error());
  fault.done = "The text is kept here, and the old file is unchanged.";
  return fail(std::move(fault));
}

}  // namespace hw
