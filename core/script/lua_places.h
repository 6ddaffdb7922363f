#pragma once
// Lines of a script, for messages.
#include <string>

struct lua_State;

namespace hw::script {

/// The line that runs now: "script.lua:12: ".
std::string running_line(lua_State* L);
/// The calling lines, without that of the error itself, which the message names.
std::string calling_lines(lua_State* L);

}  // namespace hw::script
