#include "core/script/sandbox.h"

#include <algorithm>
#include <lua.hpp>
#include <string_view>

#include "core/script/runner.h"
#include "core/script/script_files.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"

namespace hw::script {
namespace {

// Removes or restricts functions of base Lua that would harm the computer or the replay. `pairs` visits texts
// and numbers in sorted order: Lua's own order, and so the commands sent, would change from run to run.
constexpr std::string_view prelude = R"lua(
local load_any, type, next, getmetatable, rawget = load, type, next, getmetatable, rawget
local sort, select, error = table.sort, select, error
function load(chunk, name, mode, ...)
  if select("#", ...) > 0 then return load_any(chunk, name, "t", ...) end
  return load_any(chunk, name, "t")
end
local function before(a, b)
  local x, y = type(a), type(b)
  if x ~= y then return x == "number" end
  return a < b
end
local function in_order(t)
  local keys, n, rest = {}, 0, {}
  for k in next, t do
    local kind = type(k)
    if kind == "number" or kind == "string" then n = n + 1; keys[n] = k else rest[#rest + 1] = k end
  end
  sort(keys, before)
  for i = 1, #rest do keys[n + i] = rest[i] end
  return keys
end
local plain_pairs = pairs
function pairs(t)
  if type(t) ~= "table" then return plain_pairs(t) end
  local own = getmetatable(t)
  if type(own) == "table" and rawget(own, "__pairs") then return plain_pairs(t) end
  local keys, i = in_order(t), 0
  return function(over)
    while true do
      i = i + 1
      local k = keys[i]
      if k == nil then return nil end
      local v = rawget(over, k)
      if v ~= nil then return k, v end
    end
  end, t, nil
end
local set = setmetatable
function setmetatable(t, meta)  -- a finalizer could not be interrupted
  if type(meta) == "table" and rawget(meta, "__gc") ~= nil then
    error("setmetatable: __gc is not possible here", 2)
  end
  return set(t, meta)
end
local collect = collectgarbage
function collectgarbage(what)
  if what == nil or what == "collect" then return collect() end
  if what == "count" then return collect("count") end
  error("collectgarbage: only \"collect\" and \"count\" are possible here", 2)
end
local seed = math.randomseed
seed(1)
function math.randomseed(...)
  if select("#", ...) > 0 then return seed(...) end
end
)lua";

constexpr std::string_view withheld[] = {"dofile", "loadfile", "io", "os", "package", "debug"};

bool harmless_name(std::string_view name) {
  const auto ok = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  return !name.empty() && name.size() < 200 && name.front() != '.' && name.find("..") == name.npos &&
         std::all_of(name.begin(), name.end(), ok);
}

// Pushes the module's chunk and returns true, or a message and false.
bool load_module(lua_State* L, const std::string& folder, std::string_view name) {
  const auto refuse = [&](const std::string& sentence) {
    lua_pushlstring(L, sentence.data(), sentence.size());
    return false;
  };
  const std::string quoted = "require \"" + std::string(name) + "\": ";
  if (!harmless_name(name))
    return refuse(quoted + "a module is a file beside the script, named by letters, digits, _ and dots");
  std::string file(name);
  std::replace(file.begin(), file.end(), '.', '/');
  file += ".lua";
  const std::string path = real_path(folder + "/" + file);
  if (path.empty()) return refuse(quoted + "there is no " + file + " in the script's folder");
  if (!is_below(real_path(folder), path))
    return refuse(quoted + "that file is outside of the script's folder");
  const auto text = read_file(path, largest_program_text);
  if (!text) return refuse(quoted + text.error().sentence());
  return luaL_loadbufferx(L, text->data(), text->size(), ("@" + file).c_str(), "t") == LUA_OK;
}

bool load_module_of_upvalue(lua_State* L) {
  const WayOut::Closed closed(Runner::of(L).way_out());
  std::size_t length = 0;
  const char* name = lua_tolstring(L, 1, &length);
  return load_module(L, lua_tostring(L, lua_upvalueindex(1)),
                     name ? std::string_view(name, length) : std::string_view());
}

// Stores the module's result, or true, under its name (stack: name, result).
int keep_module(lua_State* L, int, lua_KContext) {
  if (lua_isnil(L, 2)) {
    lua_pushboolean(L, 1);
    lua_replace(L, 2);
  }
  lua_pushvalue(L, 1);
  lua_pushvalue(L, 2);
  lua_settable(L, lua_upvalueindex(2));
  return 1;
}

// upvalues: folder, table of loaded modules.
int require(lua_State* L) {
  luaL_checkstring(L, 1);
  lua_settop(L, 1);
  lua_pushvalue(L, 1);
  if (lua_gettable(L, lua_upvalueindex(2)) != LUA_TNIL) return 1;
  lua_pop(L, 1);
  if (!load_module_of_upvalue(L)) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
    return lua_error(L);
  }
  lua_pushvalue(L, 1);
  lua_callk(L, 1, 1, 0, keep_module);
  return keep_module(L, LUA_OK, 0);
}

}  // namespace

void open_sandbox(lua_State* L, const std::string& folder) {
  constexpr luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},       {LUA_COLIBNAME, luaopen_coroutine},
                                    {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
                                    {LUA_MATHLIBNAME, luaopen_math}, {LUA_UTF8LIBNAME, luaopen_utf8}};
  for (const luaL_Reg& library : libraries) {
    luaL_requiref(L, library.name, library.func, 1);
    lua_pop(L, 1);
  }
  if (luaL_loadbufferx(L, prelude.data(), prelude.size(), "=sandbox", "t") == LUA_OK) lua_call(L, 0, 0);
  for (const std::string_view name : withheld) {
    lua_pushnil(L);
    lua_setglobal(L, name.data());
  }
  lua_getglobal(L, LUA_STRLIBNAME);
  lua_pushnil(L);
  lua_setfield(L, -2, "dump");
  lua_pop(L, 1);
  lua_pushlstring(L, folder.data(), folder.size());
  lua_newtable(L);
  lua_pushcclosure(L, require, 2);
  lua_setglobal(L, "require");
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == path.npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace hw::script
