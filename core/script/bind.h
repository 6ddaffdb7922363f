#pragma once
// The parts of a script's world. Each adds its tables to the state.
#include <memory>

#include "core/script/call.h"

namespace hw::script {

void bind_hw(lua_State* L);          ///< `hw`, `print`
void bind_controller(lua_State* L);  ///< methods of what hw.open() gives
void bind_bench(lua_State* L);       ///< methods of its `bench`

void push_controller(lua_State* L, std::shared_ptr<Session> session);
/// The controller that a method was called on.
const std::shared_ptr<Session>& session_of(const Call& call);

/// An axis by its number or the maker's name; throws Misuse when it is neither; -1: there is none such.
int axis_index(lua_State* L, int index, const Catalog& catalog, const char* function);

}  // namespace hw::script
