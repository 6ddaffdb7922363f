#pragma once
// The parts of a script's world. Each adds its tables to the state.
#include <memory>
#include <span>

#include "core/script/call.h"
#include "core/session/session_group.h"

namespace hw::script {

void bind_hw(lua_State* L);          ///< `hw`, `print`
void bind_controller(lua_State* L);  ///< methods of hw.open()'s result
std::span<const Function> motion_methods(), text_methods(), status_methods(), setup_methods(),
    program_methods(), trust_methods(), place_methods(), upkeep_methods(), watch_methods(),
    unit_methods();             ///< methods of controllers, by subject
void bind_bench(lua_State* L);  ///< methods of its `bench`
void bind_tasks(lua_State* L);  ///< `hw.spawn` and waiting; call it after bind_hw
std::span<const Function> file_functions(), argument_functions();  ///< of `hw`
void bind_watches(lua_State* L);                                   ///< the basis of c:on and c:wait_until

inline constexpr const char *controller_type = "controller", *bench_type = "bench";
// Metamethods of both.
int index_handle(lua_State* L);  ///< upvalue: the table of methods
int drop_handle(lua_State* L);
/// Completes either metatable and pops it: handles are dropped, and a script cannot read the metatable.
void close_handle_type(lua_State* L);

using SessionPtr = std::shared_ptr<Session>;

/// Pushes the result of hw.open(): a controller, or a bus of several.
void push_controller(lua_State* L, std::shared_ptr<SessionGroup> group);
/// The controller that a method was called on. Misuse for a bus.
const std::shared_ptr<Session>& session_of(const Call& call);
/// The bus that a method was called on; null: a controller.
std::shared_ptr<SessionGroup> bus_of(const Call& call);

/// One axis named by an argument: on a controller by number or name, on a bus (one axis per device) by the
/// device's id.
struct OneAxis {
  std::shared_ptr<Session> session;
  int index = -1;       ///< -1: no such axis
  std::string refusal;  ///< why there is none
};
inline AxisId id_of(int index) { return AxisId{static_cast<std::uint8_t>(index)}; }
OneAxis one_axis(const Call& call, int argument, const char* function);
/// The same for a table key at stack index `place`.
OneAxis one_axis_at(const Call& call, int place, const char* function);

/// Whether a method was called on a bus or one of its devices.
bool is_on_bus(const Call& call);

/// Sets the device of a refusal without one: the controller that the method under way on `L` was called on,
/// or the device of a bus that its first argument names.
void name_device(lua_State* L, Refusal& refusal);

/// Adds axis and device to the fault. On a bus the sentence begins with the device's id.
Refusal refusal_of(const Fault& fault, const Session& session, std::string axis, bool on_bus);
/// The outcome of a request to all devices of a bus.
Answer answer_of_bus(const Result<>& result, const SessionGroup& bus);
/// Sends an intent and waits for its outcome: true, or nil and the reason.
int perform(Call& call, SessionPtr session, IntentBody body);
int perform(Call& call, IntentBody body);

/// An axis by its number or the maker's name; -1: no such axis. Misuse for any other type.
int axis_index(lua_State* L, int index, const Catalog& catalog, const char* function);

}  // namespace hw::script
