// `hw`: opening controllers, time, checks, output.
#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/module.h"
#include "core/session/address.h"

namespace hw::script {
namespace {

Task<Answer> open_and_wait(Runner& runner, std::shared_ptr<SessionGroup> group) {
  runner.add(group);
  const auto connected = co_await group->wait_until_connected();
  if (connected) {
    if (runner.options().stage) runner.options().stage->opened(group);
    co_return [group](lua_State* L) {
      push_controller(L, group);
      return 1;
    };
  }
  Answer why = answer_of_bus(connected, *group);
  co_await group->close();
  runner.remove(group);
  co_return why;
}

int open(Call& call) {
  auto address = Address::parse(call.text(1, "address"));
  if (!address) return call.refuse(address.error());
  Runner& runner = call.runner();
  if (!address->emulated()) runner.go_real();
  std::function<void()> wake = [] {};
  auto group = SessionGroup::open(runner.scheduler(), *address, runner.options().opener, wake);
  if (!group) return call.refuse(group.error());
  return call.wait(open_and_wait(runner, std::move(*group)));
}

Task<Answer> sleep_for(Runner& runner, Duration time) {
  const Instant until = runner.scheduler().now() + time;
  co_await runner.sleep_until(until);
  co_return [](lua_State*) { return 0; };
}

int sleep(Call& call) {
  static_cast<void>(call.number(1, "seconds"));  // nil is an error in the script, not a pause of 0 s
  return call.wait(sleep_for(call.runner(), call.patience(1, 0)));
}

int now(Call& call) {
  lua_pushnumber(call.L, call.runner().seconds_since_start());
  return 1;
}

int check(Call& call) {
  if (lua_toboolean(call.L, call.place(1))) return lua_gettop(call.L);  // returns its arguments
  const std::string why = call.has(2) ? call.text(2, "message") : "the checked condition is false";
  call.runner().end_run(call.L, "hw.check failed: " + why);
  throw Misuse(why);
}

int log(Call& call) {
  call.runner().options().log(
      fmt::format("[{:.6f}] {}", call.runner().seconds_since_start(), call.text(1, "text")));
  return call.nothing();
}

// Like Lua's print, but to the results.
int print(Call& call) {
  std::string line;
  for (int i = 1, n = lua_gettop(call.L); i <= n; ++i) {
    std::size_t length = 0;
    const char* text = lua_tolstring(call.L, i, &length);
    if (i > 1) line += '\t';
    line.append(text, length);
  }
  line += '\n';
  const auto printed = call.runner().options().print(line);
  if (printed) return call.nothing();
  call.runner().end_unread(call.L, printed.error());
  throw Misuse(printed.error().sentence());
}

constexpr Function functions[] = {
    {"open", open}, {"sleep", sleep}, {"now", now}, {"check", check}, {"log", log},
};
constexpr Function globals[] = {{"print", print, true}};

// Without a stage `ui` raises an error that says so.
void bind_absent_screen(lua_State* L) {
  lua_newtable(L);
  lua_newtable(L);
  lua_pushcfunction(
      L, [](lua_State* S) { return luaL_error(S, "there is no screen: run the script with --gui"); });
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_setglobal(L, "ui");
}

}  // namespace

void bind_hw(lua_State* L) {
  push_functions(L, std::begin(functions), std::end(functions), 0);
  const RunOptions& options = Runner::of(L).options();
  lua_createtable(L, static_cast<int>(options.args.size()), 1);
  for (std::size_t i = 0; i < options.args.size(); ++i) {
    lua_pushlstring(L, options.args[i].data(), options.args[i].size());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_pushlstring(L, options.path.data(), options.path.size());
  lua_rawseti(L, -2, 0);
  lua_setfield(L, -2, "args");
  lua_setglobal(L, "hw");
  if (!Runner::of(L).options().stage) bind_absent_screen(L);
  push_functions(L, std::begin(globals), std::end(globals), 0);
  lua_getfield(L, -1, "print");
  lua_setglobal(L, "print");
  lua_pop(L, 1);
}

}  // namespace hw::script
