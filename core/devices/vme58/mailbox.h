#pragma once
// Urgent commands go through the mailbox (decision M29): past the ring, past full queues.
#include <string_view>

#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Mailbox {
 public:
  Mailbox(Wire& wire, Conversation& conversation) : wire_(wire), conversation_(conversation) {}
  /// Two letters. It has been taken out by the board when this returns.
  Task<Result<>> mail(std::string_view letters);
  /// What stands in the ring behind the word is taken back, whoever has put it there: taken from there a
  /// moment later it would act behind it.
  Task<Result<>> mail_past_ring(std::string_view letters);

 private:
  Task<Result<bool>> is_free();

  Wire& wire_;
  Conversation& conversation_;
};

}  // namespace hw::vme58
