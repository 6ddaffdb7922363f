// The result of hw.open(): one controller or one bus. Its methods are in the other bind_*.cpp, by subject.
#include "core/script/bind.h"

namespace hw::script {

void bind_controller(lua_State* L) {
  luaL_newmetatable(L, controller_type);
  lua_newtable(L);
  for (const auto methods :
       {motion_methods(), text_methods(), status_methods(), setup_methods(), program_methods(),
        trust_methods(), place_methods(), upkeep_methods(), watch_methods(), unit_methods()})
    add_functions(L, methods, 1);
  lua_pushcclosure(L, index_handle, 1);
  lua_setfield(L, -2, "__index");
  close_handle_type(L);
}

}  // namespace hw::script
