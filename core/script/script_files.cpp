#include "core/script/script_files.h"

#include <algorithm>
#include <climits>
#include <cstdlib>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hw::script {
namespace {

bool is_plain_name(std::string_view name) {
  const auto ok = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == '/' || c == ' ';
  };
  return !name.empty() && name.size() < 200 && name.front() != '/' && name.front() != '.' &&
         name.find("..") == name.npos && name.find("/.") == name.npos &&
         std::all_of(name.begin(), name.end(), ok);
}

bool is_a_link(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

}  // namespace

std::string real_path(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (!real) return {};
  std::string copy = real;
  std::free(real);
  return copy;
}

bool is_below(const std::string& folder, const std::string& path) {
  const std::string root = folder == "/" ? folder : folder + "/";
  return !folder.empty() && path.compare(0, root.size(), root) == 0;
}

Result<std::string> file_of_script(const std::string& folder, const std::string& name,
                                   std::string_view ending) {
  const bool ends_so =
      name.size() > ending.size() && std::string_view(name).substr(name.size() - ending.size()) == ending;
  if (!is_plain_name(name) || !ends_so)
    return fail(
        FaultKind::port, fmt::format("A script may not use the file \"{}\".", name),
        "Nothing was read or written.",
        fmt::format("Name a file in the script's folder, by letters, digits, _ and -, as in \"result{}\".",
                    ending));
  const std::string root = real_path(folder), path = folder + "/" + name;
  const std::string inside = real_path(path.substr(0, path.rfind('/')));
  if (inside.empty())
    return fail(FaultKind::port, fmt::format("The folder of \"{}\" does not exist.", name),
                "Nothing was read or written.", "Make it first.");
  if ((inside != root && !is_below(root, inside)) || is_a_link(path))
    return fail(FaultKind::port, fmt::format("\"{}\" is outside of the script's folder.", name),
                "Nothing was read or written.");
  return path;
}

Fault not_written_beside(const std::string& folder, Fault why) {
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
    why.advice = "Copy the script into a folder of your own and run it there.";
  return why;
}

}  // namespace hw::script
