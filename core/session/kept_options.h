#pragma once
// How the user draws with one controller: scale, table, tool and speeds. Kept for the next drawing and for
// the next session.
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/user_files.h"

namespace hw {

/// By name. What nobody knows any more is passed over.
struct KeptOptions {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words;
  [[nodiscard]] const double* number(std::string_view name) const;     ///< null: none of that name
  [[nodiscard]] const std::string* word(std::string_view name) const;  ///< null: none of that name
  bool operator==(const KeptOptions&) const = default;
};

class KeptOptionsOfDrawings {
 public:
  explicit KeptOptionsOfDrawings(UserFolders folders) : folders_(std::move(folders)) {}
  /// Unknown key: none. A damaged file: a fault, the file is put aside.
  [[nodiscard]] Result<KeptOptions> load(std::string_view key) const;
  Result<> save(std::string_view key, const KeptOptions& options) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
