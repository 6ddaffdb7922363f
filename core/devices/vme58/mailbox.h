#pragma once
// The mailbox takes urgent commands past the ring and past full queues (decision M29).
#include <string_view>

#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Mailbox {
 public:
  Mailbox(Wire& wire, Conversation& conversation) : wire_(wire), conversation_(conversation) {}
  /// Mails a command of two letters. Returns once the board has taken it.
  Task<Result<>> mail(std::string_view letters);
  /// Mails `letters` and takes back all text waiting in the ring, whoever put it there: the board would
  /// otherwise carry it out after the mail.
  Task<Result<>> mail_past_ring(std::string_view letters);

 private:
  Task<Result<bool>> is_free();

  Wire& wire_;
  Conversation& conversation_;
};

}  // namespace hw::vme58
