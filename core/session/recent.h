#pragma once
// The last connections, newest first.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct RecentConnection {
  std::string address;  ///< canonical
  std::string name;     ///< the user's name for the controller
  bool operator==(const RecentConnection&) const = default;
};

/// Local time, "2026-11-28" and "09:48"; empty: not known.
struct ClosingTime {
  std::string date, time;
  bool operator==(const ClosingTime&) const = default;
};

class RecentConnections {
 public:
  explicit RecentConnections(UserFolders folders) : folders_(std::move(folders)) {}
  /// A damaged file: a fault; the file is set aside and the list is empty.
  Result<> load();
  /// Puts the address first in place of its older entry. An empty name keeps the older entry's.
  Result<> opened(std::string address, std::string name);
  /// Closed by the user while the console runs on: removes the address from last_time().
  Result<> closed(std::string_view address);
  /// The console ends with the connections of this run; without any, the earlier closing time stays.
  Result<> ended(ClosingTime now);
  Result<> renamed(std::string_view address, std::string name);
  Result<> remove(std::string_view address);
  [[nodiscard]] const std::vector<RecentConnection>& list() const { return list_; }
  /// The addresses opened by the last run of the console that opened any, newest first, to be reopened
  /// together. Without those removed or closed since.
  [[nodiscard]] const std::vector<std::string>& last_time() const { return last_time_; }
  [[nodiscard]] bool is_of_last_time(std::string_view address) const;

  /// When that run ended. Not known if it was broken off.
  [[nodiscard]] const ClosingTime& last_end() const { return last_end_; }

  static constexpr std::size_t capacity = 12;

 private:
  [[nodiscard]] Result<> save() const;
  UserFolders folders_;
  std::vector<RecentConnection> list_;
  std::vector<std::string> last_time_, this_time_;  ///< addresses
  ClosingTime last_end_, this_end_;
};

}  // namespace hw
