#pragma once
// The parts of a script's world. Each adds its tables to the state.
#include <memory>
#include <span>

#include "core/script/call.h"
#include "core/session/session_group.h"

namespace hw::script {

void bind_hw(lua_State* L);          ///< `hw`, `print`
void bind_controller(lua_State* L);  ///< methods of what hw.open() gives
std::span<const Function> motion_methods(), text_methods(), status_methods(), setup_methods(),
    program_methods(), trust_methods(), place_methods(), upkeep_methods(), watch_methods(),
    unit_methods();             ///< of them, by subject
void bind_bench(lua_State* L);  ///< methods of its `bench`
void bind_tasks(lua_State* L);  ///< `hw.spawn` and what waits; needs bind_hw
std::span<const Function> file_functions(), argument_functions();  ///< of `hw`
void bind_watches(lua_State* L);                                   ///< what c:on and c:wait_until run on

inline constexpr const char *controller_type = "controller", *bench_type = "bench";
// Metamethods of both.
int index_handle(lua_State* L);  ///< upvalue: the table of methods
int drop_handle(lua_State* L);
/// What both end with: their handles are dropped, and a script cannot look behind them. Pops the metatable.
void close_handle_type(lua_State* L);

using SessionPtr = std::shared_ptr<Session>;

/// What hw.open() gives: a controller, or a bus of several.
void push_controller(lua_State* L, std::shared_ptr<SessionGroup> group);
/// The controller that a method was called on; a bus is Misuse: it has many.
const std::shared_ptr<Session>& session_of(const Call& call);
/// The bus that a method was called on; null: a single controller.
std::shared_ptr<SessionGroup> bus_of(const Call& call);

/// One axis, named by the argument of a call: of a controller by its number or name, of a bus (whose devices
/// have one each) by the device's id.
struct OneAxis {
  std::shared_ptr<Session> session;
  int index = -1;       ///< -1: there is none such
  std::string refusal;  ///< why
};
inline AxisId id_of(int index) { return AxisId{static_cast<std::uint8_t>(index)}; }
OneAxis one_axis(const Call& call, int argument, const char* function);
/// The same for a key of a table, at `place` of the stack.
OneAxis one_axis_at(const Call& call, int place, const char* function);

/// Whether what a method was called on is a bus, or one of its devices.
bool is_on_bus(const Call& call);

/// Where it names no device yet: by what the method that is under way on `L` was called on, the controller, or
/// the device of a bus that its first argument names.
void name_device(lua_State* L, Refusal& refusal);

/// With what the fault itself does not say. On a bus the sentence begins with the id of the device.
Refusal refusal_of(const Fault& fault, const Session& session, std::string axis, bool on_bus);
/// What became of what all devices of a bus were asked.
Answer answer_of_bus(const Result<>& result, const SessionGroup& bus);
/// Sends an intent, waits for its outcome: true, or nil and the reason.
int perform(Call& call, SessionPtr session, IntentBody body);
int perform(Call& call, IntentBody body);

/// An axis by its number or the maker's name; throws Misuse when it is neither; -1: there is none such.
int axis_index(lua_State* L, int index, const Catalog& catalog, const char* function);

}  // namespace hw::script
