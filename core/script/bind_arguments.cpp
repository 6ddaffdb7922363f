// hw.arguments: a script declares its arguments and gets them as a table.
#include <algorithm>

#include <fmt/format.h>

#include "core/script/arguments.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

/// Pushes t[key] of the table at `table`, without the script's __index.
int raw_get(lua_State* L, int table, const char* key) {
  lua_pushstring(L, key);
  return lua_rawget(L, table);
}

std::string own_text(lua_State* L, int table, const char* key) {
  const int kind = raw_get(L, table, key);
  const bool shown = kind == LUA_TSTRING || kind == LUA_TNUMBER;
  const std::string text = shown ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  if (kind != LUA_TNIL && !shown) throw Misuse(fmt::format("hw.arguments: {} must be a text", key));
  return text;
}

void check_keys(lua_State* L, int table) {
  static constexpr std::string_view known[] = {"name", "kind", "default", "help", "choices"};
  lua_pushnil(L);
  while (lua_next(L, table)) {
    lua_pop(L, 1);
    const std::string key = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "(no name)";
    if (std::find(std::begin(known), std::end(known), key) == std::end(known))
      throw Misuse(
          fmt::format("hw.arguments: an argument has no \"{}\"; it takes {}", key, fmt::join(known, ", ")));
  }
}

void check_list(lua_State* L, int declared) {
  const char* const how =
      "it takes a list of arguments, each a table: hw.arguments{{name=\"count\", default=10}}";
  if (!lua_istable(L, declared)) throw Misuse(fmt::format("hw.arguments: {}", how));
  lua_pushnil(L);
  while (lua_next(L, declared)) {
    lua_pop(L, 1);
    const std::string key = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    if (!key.empty() && key != "about")
      throw Misuse(fmt::format("hw.arguments: there is no \"{}\": {}", key, how));
  }
}

/// The table on top. Pops it.
Argument argument_of(lua_State* L) {
  if (!lua_istable(L, -1))
    throw Misuse("hw.arguments: each argument is a table like {name=\"count\", default=10}");
  const int table = lua_gettop(L);
  check_keys(L, table);
  Argument one;
  one.name = own_text(L, table, "name");
  if (one.name.empty() || one.name == "help" || one.name.find_first_of("= -") == 0 ||
      one.name.find('=') != one.name.npos)
    throw Misuse("hw.arguments: each argument needs a name, and \"help\" is taken");
  one.help = own_text(L, table, "help");
  const std::string kind_word = own_text(L, table, "kind");
  const int fallback = raw_get(L, table, "default");
  lua_pop(L, 1);
  if (fallback == LUA_TSTRING || fallback == LUA_TNUMBER) one.fallback = own_text(L, table, "default");
  const auto kind = argument_kind(!kind_word.empty()        ? kind_word
                                  : fallback == LUA_TNUMBER ? "number"
                                                            : "text");
  if (!kind) throw Misuse("hw.arguments: " + kind.error().what);
  one.kind = *kind;
  one.required = fallback == LUA_TNIL && one.kind != Argument::Kind::flag;
  if (raw_get(L, table, "choices") == LUA_TTABLE)
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
      if (lua_type(L, -1) != LUA_TSTRING) throw Misuse("hw.arguments: choices is a list of texts");
      one.choices.emplace_back(lua_tostring(L, -1));
    }
  lua_settop(L, table - 1);
  return one;
}

void push_value(lua_State* L, const Argument& one, const std::string& value) {
  switch (one.kind) {
    case Argument::Kind::flag: lua_pushboolean(L, 1); break;
    case Argument::Kind::whole:
      lua_pushinteger(L, static_cast<lua_Integer>(std::strtod(value.c_str(), nullptr)));
      break;
    case Argument::Kind::number:
      if (lua_stringtonumber(L, value.c_str()) == 0) lua_pushnumber(L, std::strtod(value.c_str(), nullptr));
      break;
    case Argument::Kind::text: lua_pushlstring(L, value.data(), value.size()); break;
  }
}

/// Pushes the given values, else the defaults from the script's table; for a flag whether it was given.
int push_given(lua_State* L, int declared, const std::vector<Argument>& known, const GivenArguments& given) {
  lua_createtable(L, 0, static_cast<int>(known.size()));
  const int result = lua_gettop(L);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto found = given.values.find(known[i].name);
    if (found != given.values.end()) {
      push_value(L, known[i], found->second);
    } else if (known[i].kind == Argument::Kind::flag) {
      lua_pushboolean(L, 0);
    } else {
      lua_rawgeti(L, declared, static_cast<lua_Integer>(i + 1));
      raw_get(L, lua_gettop(L), "default");
      lua_remove(L, -2);
    }
    lua_setfield(L, result, known[i].name.c_str());
  }
  return 1;
}

int arguments(Call& call) {
  lua_State* const L = call.L;
  const int declared = call.place(1);
  check_list(L, declared);

  std::vector<Argument> known;
  for (lua_Integer i = 1; lua_rawgeti(L, declared, i) != LUA_TNIL; ++i) known.push_back(argument_of(L));
  lua_pop(L, 1);
  const RunOptions& options = call.runner().options();
  const auto given = read_arguments(known, options.args);
  if (!given) {
    call.runner().end_for_words(L, given.error().sentence());
    throw Misuse(given.error().sentence());
  }
  if (!given->wants_help) return push_given(L, declared, known, *given);
  const auto reported = options.print(arguments_help(known, options.path, own_text(L, declared, "about")));
  if (!reported)
    call.runner().end_unread(L, reported.error());
  else
    call.runner().end_for_words(L, {});
  throw Misuse("help was asked for");
}

constexpr Function argument_table[] = {{"arguments", arguments}};

}  // namespace

std::span<const Function> argument_functions() { return argument_table; }

}  // namespace hw::script
