#pragma once
// What hw.spawn() and c:on() give, and the waiting for it.
#include <memory>
#include <vector>

#include "core/script/call.h"

namespace hw::script {

/// In place of the coroutine on top of the stack, which Runner::spawn() has left there.
void push_task(lua_State* L, std::shared_ptr<Spawned> spawned);

/// One of those that are waited for.
struct Racer {
  std::shared_ptr<Spawned> spawned;
  bool ours;  ///< begun for this wait alone: it ends with it
};

/// Until the first of them is over: its results, behind its place in the list when that is wanted. What they
/// run on must stay on the waiting stack, or elsewhere.
Task<Answer> wait_for_first(Runner& runner, std::vector<Racer> racers, bool with_place, Duration patience,
                            std::string too_late);

}  // namespace hw::script
