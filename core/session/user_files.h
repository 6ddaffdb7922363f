#pragma once
// Where the user's own things are kept (XDG folders), and how a file is written so that it is either whole or
// untouched. May block: for the start, for workers, and for files of a few kilobytes.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace hw {

/// Headless runs use none(): they read and write no autosave, recents or profile.
struct UserFolders {
  std::filesystem::path config;  ///< $XDG_CONFIG_HOME/handwheel: profiles
  std::filesystem::path state;   ///< $XDG_STATE_HOME/handwheel: unsaved texts, last connections, sizes
  bool enabled = false;

  static UserFolders none() { return {}; }
  /// From the environment; none() when there is no home.
  static UserFolders standard();
  /// Both below one folder.
  static UserFolders below(const std::filesystem::path& folder);
};

/// The whole file. Faults name the file and say why ("There is no file ...", "... may not be read").
Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t largest);

/// Writes beside the target and renames over it, so that a full disk or a crash leaves the old file. The
/// target keeps its permissions; a link is followed; what is no regular file (a device) is written in place.
Result<> write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same for what is nobody else's: only its owner may read it, whatever stood there before.
Result<> write_private_file(const std::filesystem::path& path, std::string_view bytes);
/// Makes it and what is missing above it, for its owner only; one that is there is closed to others.
void make_private_folder(const std::filesystem::path& folder);

/// Moves a file that cannot be understood out of the way and returns its new name, with `ending` (empty: it
/// would not move).
std::filesystem::path set_aside(const std::filesystem::path& path, std::string_view ending = ".damaged");

/// A file name for any key: "/dev/ttyUSB0" -> "dev-ttyUSB0-5f3a09c2". Different keys give different names.
std::string file_name_for(std::string_view key);

/// All of it into a file, a pipe or a terminal that is open. 0, or errno.
int write_all(int fd, std::string_view bytes);

/// "the disk is full", "you may not write there": errno for a person.
std::string reason_of(int error_number);

}  // namespace hw
