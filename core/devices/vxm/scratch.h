#pragma once
// The program that holds a move of the console: a program that M has shown to be empty. Afterwards it is
// emptied and the user's selection restored, so that the Run button never repeats a move of the console.
//
// A lost or doubled byte makes another command, which the controller carries out silently. So nothing is
// written before PM has confirmed the selected program, nothing runs before lst has confirmed the text, and
// nothing counts as cleared before M and PM have confirmed it.
#include <string>

#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {

class Scratch {
 public:
  Scratch(Conversation& conversation, Slots& slots) : conversation_(conversation), slots_(slots) {}

  /// -1: the controller holds nothing of the console's.
  [[nodiscard]] int slot() const { return slot_; }
  [[nodiscard]] bool in_use() const { return slot_ >= 0; }
  /// The controller has restarted.
  void forget() { slot_ = -1; }

  /// Finds a program for the next move.
  Task<Result<>> take();
  /// Fills the program with exactly these stored commands, ready for R.
  Task<Result<>> fill(std::string commands);
  /// Empties the program.
  Task<Result<>> clear(Priority priority);

 private:
  Task<Result<bool>> holds(const std::string& commands);

  Conversation& conversation_;
  Slots& slots_;
  int slot_ = -1;
};

}  // namespace hw::vxm
