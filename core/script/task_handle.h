#pragma once
// The task that hw.spawn() and c:on() return, and waiting for it.
#include <memory>
#include <vector>

#include "core/script/call.h"

namespace hw::script {

/// Replaces the coroutine that Runner::spawn() has left on top of the stack by a task.
void push_task(lua_State* L, std::shared_ptr<Spawned> spawned);

/// One of the functions waited for.
struct Awaited {
  std::shared_ptr<Spawned> spawned;
  bool ours;  ///< begun for this wait only: it is cancelled with it
};

/// Waits for the first to end and returns its results, after its index in the list if `with_place`. Keep the
/// coroutines referenced meanwhile, on the waiting stack or elsewhere.
Task<Answer> wait_for_first(Runner& runner, std::vector<Awaited> awaited, bool with_place, Duration patience,
                            std::string too_late);

}  // namespace hw::script
