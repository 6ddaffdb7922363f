// `hw.spawn`, `hw.wait_any`: concurrent functions of a script. Each is a fiber of its own, so all may wait.
#include <algorithm>
#include <new>

#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/task_handle.h"

namespace hw::script {
namespace {

constexpr const char* task_type = "task";
constexpr std::size_t most_at_once = 100;

using SpawnedPtr = std::shared_ptr<Spawned>;

/// Null: not a task.
SpawnedPtr task_at(lua_State* L, int place) {
  void* found = luaL_testudata(L, place, task_type);
  return found ? *static_cast<SpawnedPtr*>(found) : nullptr;
}

SpawnedPtr task_of(const Call& call) {
  auto spawned = task_at(call.L, 1);
  if (!spawned) throw Misuse("call this with a colon on a task returned by hw.spawn(): task:wait()");
  return spawned;
}

int spawn(Call& call) {
  if (!lua_isfunction(call.L, call.place(1)))
    throw Misuse(fmt::format("hw.spawn: argument 1 must be a function, not {}: hw.spawn(f, ...) calls f(...)",
                             call.type_of(1)));
  push_task(call.L, call.runner().spawn(call.L, lua_gettop(call.L) - 1));
  return 1;
}

int push_results(lua_State* L, const Spawned& from) {
  const int base = lua_gettop(from.L) - from.results;
  if (!lua_checkstack(L, from.results + 1) || !lua_checkstack(from.L, 1)) return 0;
  for (int i = 1; i <= from.results; ++i) {
    lua_pushvalue(from.L, base + i);
    lua_xmove(from.L, L, 1);
  }
  return from.results;
}

/// {task, function, ...}: starts the functions now, in order.
int wait_any(Call& call) {
  lua_State* const L = call.L;
  const int table = call.place(1);
  const std::size_t count = lua_istable(L, table) ? lua_rawlen(L, table) : 0;
  if (count == 0 || count > most_at_once)
    throw Misuse(
        fmt::format("hw.wait_any: argument 1 must be a list of 1 to {} tasks and functions", most_at_once));
  const Duration patience = call.patience(2, 1e6);
  if (!lua_checkstack(L, static_cast<int>(count) + 8))
    throw Misuse("hw.wait_any: too many tasks and functions");
  const int first = lua_gettop(L) + 1;
  for (std::size_t i = 1; i <= count; ++i) {
    lua_rawgeti(L, table, static_cast<lua_Integer>(i));
    if (!lua_isfunction(L, -1) && !task_at(L, -1))
      throw Misuse(
          fmt::format("hw.wait_any: number {} is neither a function nor a task of hw.spawn, but {}: write "
                      "function() return ... end",
                      i, lua_isnoneornil(L, -1) ? "nil" : luaL_typename(L, -1)));
  }
  std::vector<Awaited> awaited;
  for (int place = first; place < first + static_cast<int>(count); ++place) {
    const bool ours = lua_isfunction(L, place);
    if (ours) {
      lua_pushvalue(L, place);
      auto spawned = call.runner().spawn(L, 0);
      lua_replace(L, place);  // keeps the coroutine referenced during the wait
      awaited.push_back({std::move(spawned), true});
    } else {
      awaited.push_back({task_at(L, place), false});
    }
  }
  return call.wait(wait_for_first(call.runner(), std::move(awaited), true, patience,
                                  "Timeout: none of the tasks has ended."));
}

int task_wait(Call& call) {
  std::vector<Awaited> one{{task_of(call), false}};
  return call.wait(wait_for_first(call.runner(), std::move(one), false, call.patience(1, 1e6),
                                  "Timeout: the task has not ended."));
}

int task_over(Call& call) {
  lua_pushboolean(call.L, task_of(call)->over);
  return 1;
}

int task_cancel(Call& call) {
  if (!call.runner().cancel(*task_of(call)))
    throw Misuse("a task cannot cancel itself: let its function return");
  return call.yes();
}

int drop_task(lua_State* L) {
  const WayOut::Closed closed(Runner::of(L).way_out());
  static_cast<SpawnedPtr*>(lua_touserdata(L, 1))->~SpawnedPtr();
  return 0;
}

constexpr Function task_functions[] = {{"spawn", spawn}, {"wait_any", wait_any}};
constexpr Function task_methods[] = {{"wait", task_wait}, {"over", task_over}, {"cancel", task_cancel}};

}  // namespace

void push_task(lua_State* L, std::shared_ptr<Spawned> spawned) {
  new (lua_newuserdatauv(L, sizeof(SpawnedPtr), 1)) SpawnedPtr(std::move(spawned));
  luaL_setmetatable(L, task_type);
  lua_insert(L, -2);
  lua_setiuservalue(L, -2, 1);  // keeps the coroutine and its results
}

Task<Answer> wait_for_first(Runner& runner, std::vector<Awaited> awaited, bool with_place, Duration patience,
                            std::string too_late) {
  const Instant deadline = runner.scheduler().now() + patience;
  const auto over = [](const Awaited& one) { return one.spawned->over; };
  auto first = std::find_if(awaited.begin(), awaited.end(), over);
  for (bool in_time = true; first == awaited.end() && in_time && !runner.over();) {
    in_time = co_await runner.happened().wait_until(deadline);
    first = std::find_if(awaited.begin(), awaited.end(), over);
  }
  const auto won = first == awaited.end() ? nullptr : first->spawned;
  for (const Awaited& one : awaited)
    if (one.ours && !runner.over()) runner.cancel(*one.spawned);
  if (!won) co_return answer_refused(script::too_late(Refusal{std::move(too_late)}));
  const auto place = static_cast<lua_Integer>(first - awaited.begin()) + 1;
  co_return [won, place, with_place](lua_State* L) {
    if (with_place) lua_pushinteger(L, place);
    return push_results(L, *won) + (with_place ? 1 : 0);
  };
}

void bind_tasks(lua_State* L) {
  luaL_newmetatable(L, task_type);
  push_functions(L, std::begin(task_methods), std::end(task_methods), 1);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, drop_task);
  lua_setfield(L, -2, "__gc");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
  lua_getglobal(L, "hw");
  add_functions(L, task_functions, 0);
  add_functions(L, file_functions(), 0);
  add_functions(L, argument_functions(), 0);
  lua_pop(L, 1);
  bind_watches(L);
}

}  // namespace hw::script
