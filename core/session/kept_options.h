#pragma once
// The user's drawing options for one controller (scale, table, tool, speeds), kept for the next drawing and
// session.
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/user_files.h"

namespace hw {

/// By name. Unknown names are ignored.
struct KeptOptions {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words;
  [[nodiscard]] const double* number(std::string_view name) const;     ///< null: absent
  [[nodiscard]] const std::string* word(std::string_view name) const;  ///< null: absent
  bool operator==(const KeptOptions&) const = default;
};

class KeptOptionsOfDrawings {
 public:
  explicit KeptOptionsOfDrawings(UserFolders folders) : folders_(std::move(folders)) {}
  /// Unknown key: no options. A damaged file: a fault; the file is set aside.
  [[nodiscard]] Result<KeptOptions> load(std::string_view key) const;
  Result<> save(std::string_view key, const KeptOptions& options) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
