#include "core/script/lua_places.h"

#include <lua.hpp>

#include <fmt/core.h>

namespace hw::script {

std::string running_line(lua_State* L) {
  lua_Debug at;
  for (int level = 0; lua_getstack(L, level, &at); ++level) {
    lua_getinfo(L, "Sl", &at);
    if (at.currentline > 0) return fmt::format("{}:{}: ", at.short_src, at.currentline);
  }
  return {};
}

std::string calling_lines(lua_State* L) {
  std::string all;
  lua_Debug at;
  for (int level = 0, found = 0; found < 9 && lua_getstack(L, level, &at); ++level) {
    lua_getinfo(L, "Sl", &at);
    if (at.currentline <= 0 || *at.source == '=') continue;  // '=': not of the script
    if (found++ > 0) all += fmt::format("\n  called from {}:{}", at.short_src, at.currentline);
  }
  return all;
}

}  // namespace hw::script
