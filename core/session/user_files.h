#pragma once
// The user's folders (XDG), and writing a file so that it is either complete or untouched. May block: for the
// start, for workers, and for files of a few kilobytes.
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

/// Writes a temporary file and renames it over the target, so that a full disk or a crash leaves the old
/// file. The target keeps its permissions; a link is followed; a target that is not a regular file (a device)
/// is written in place.
Result<> write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same, readable by the owner only, whatever the old permissions.
Result<> write_private_file(const std::filesystem::path& path, std::string_view bytes);
/// Creates the folder and its missing parents for the owner only; closes an existing folder to others.
void make_private_folder(const std::filesystem::path& folder);

/// Renames an unreadable file to a name with `ending`, readable by the owner only, and returns that name;
/// empty: it could not be renamed.
std::filesystem::path set_aside(const std::filesystem::path& path, std::string_view ending = ".damaged");

/// A file name for any key: "/dev/ttyUSB0" -> "dev-ttyUSB0-5f3a09c2". Different keys give different names.
std::string file_name_for(std::string_view key);

/// Writes all bytes to an open file, pipe or terminal. Returns 0 or errno.
int write_all(int fd, std::string_view bytes);

/// An errno in words: "the disk is full", "you may not write there".
std::string reason_of(int error_number);

}  // namespace hw
