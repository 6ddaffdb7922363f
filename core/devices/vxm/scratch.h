#pragma once
// The program that a move of the console is put into: one that M has shown empty. It is emptied and the
// user's selection put back afterwards, so that the Run button never repeats a move of the console.
//
// A byte that is lost or doubled on the way makes another command, which the controller carries out without a
// word. So nothing is written before PM has told which program is selected, nothing runs before lst has shown
// what was written, and nothing counts as cleared before M and PM have told it.
#include <string>

#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {

class Scratch {
 public:
  Scratch(Conversation& talk, Slots& slots) : talk_(talk), slots_(slots) {}

  /// -1: nothing of the console's stands in the controller.
  [[nodiscard]] int slot() const { return slot_; }
  [[nodiscard]] bool in_use() const { return slot_ >= 0; }
  /// The controller has restarted.
  void forget() { slot_ = -1; }

  /// Finds one for what comes.
  Task<Result<>> take();
  /// Puts these stored commands into it, and nothing else: R would run them.
  Task<Result<>> fill(std::string commands);
  /// Empties it.
  Task<Result<>> clear(Priority priority);

 private:
  Task<Result<bool>> holds(const std::string& commands);

  Conversation& talk_;
  Slots& slots_;
  int slot_ = -1;
};

}  // namespace hw::vxm
