#pragma once
// The script's environment: Lua without files, processes and foreign modules.
#include <string>

struct lua_State;

namespace hw::script {

/// Opens the harmless part of Lua's library in a new state. `folder`: where `require` finds modules. `print`
/// and all functions of the console are added elsewhere.
void open_sandbox(lua_State* L, const std::string& folder);

/// The folder of a file; "." when it has none.
std::string folder_of(const std::string& path);

}  // namespace hw::script
