#pragma once
// A transaction of a link: included by its own files only.
#include <utility>

#include "core/link/link.h"
#include "core/link/station.h"

namespace hw {

// One transaction, waiting or in flight. Lives in the frame of the coroutine that waits for it.
struct Link::Pending {
  Station& station;
  Transaction transaction;
  Result<std::string> result{std::string()};
  Suspended suspended;
  bool finished = false;
  bool its_turn = false;  ///< a burst on a window, run by its own coroutine
  Pending(Station& s, Transaction t) : station(s), transaction(std::move(t)) {}
  [[nodiscard]] bool is_question() const { return transaction.reply.kind != ReplyShape::Kind::none; }
};

}  // namespace hw
