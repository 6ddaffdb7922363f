#pragma once
// Settings written for one motion and restored after it: at once, or as soon as a stop or a lost wire allows.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class BorrowedSetting {
 public:
  /// `given_back` is called with the name: the value last read may be the borrowed one.
  BorrowedSetting(Conversation& conversation, std::function<void(std::string_view name)> given_back)
      : conversation_(conversation), given_back_(std::move(given_back)) {}

  /// `shown`: the value last known. The value read now is the one restored later.
  Task<Result<>> borrow(std::string name, std::int64_t value, std::optional<std::int64_t> shown);
  Task<Result<>> give_back();
  /// Call before anything that a borrowed setting would affect, or that would store it.
  Task<Result<>> give_back_first();
  [[nodiscard]] bool is_out() const { return !borrowed_.empty(); }
  /// After a lost wire: a value set by another host since then stays.
  void leave_alone() {
    for (Borrowed& one : borrowed_) one.left_alone = true;
  }
  /// The controller has restarted and lost the setting.
  void forget() { borrowed_.clear(); }
  /// The user's task if the console exits now, as a sentence; empty: none.
  [[nodiscard]] std::string leaves_behind() const;

 private:
  struct Borrowed {
    std::string name;
    std::int64_t before, for_now;
    bool left_alone = false;
  };
  /// If a stop comes first, the setting stays borrowed.
  Task<Result<>> give_back_last();
  Task<Result<>> put_back(Borrowed setting);
  Conversation& conversation_;
  std::function<void(std::string_view)> given_back_;
  std::vector<Borrowed> borrowed_;
};

}  // namespace hw::arcus
