// A script's value for a controller, a bus, or one device of a bus.
#include <new>

#include <fmt/format.h>

#include "core/base/near_name.h"
#include "core/base/shown_text.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

struct Handle {
  std::shared_ptr<SessionGroup> group;
  int device;  ///< -1: the whole bus
};

const Handle& handle_of(const Call& call) {
  for (const char* type : {controller_type, bench_type})
    if (void* found = luaL_testudata(call.L, 1, type)) return *static_cast<Handle*>(found);
  throw Misuse("call this with a colon on a controller returned by hw.open(): c:position(1)");
}

void push_handle(lua_State* L, Handle handle, const char* type) {
  new (lua_newuserdatauv(L, sizeof(Handle), 0)) Handle(std::move(handle));
  luaL_setmetatable(L, type);
}

// {["01"]=..., ["02"]=...}
void push_devices(lua_State* L, const Handle& bus) {
  lua_createtable(L, 0, static_cast<int>(bus.group->members().size()));
  for (std::size_t i = 0; i < bus.group->members().size(); ++i) {
    const std::string id = bus.group->members()[i]->catalog().id();
    lua_pushlstring(L, id.data(), id.size());
    push_handle(L, Handle{bus.group, static_cast<int>(i)}, controller_type);
    lua_rawset(L, -3);
  }
}

std::string ids_of(const SessionGroup& bus) {
  std::string all;
  for (const auto& member : bus.members()) all += (all.empty() ? "" : ", ") + member->catalog().id();
  return all;
}

std::string no_axis(const Catalog& catalog, const char* wanted) {
  std::vector<std::string> names;
  for (const AxisInfo& axis : catalog.axes) names.push_back(axis.name);
  return fmt::format("There is no such axis. {} has: {}.{}", catalog.short_name, fmt::join(names, ", "),
                     wanted ? did_you_mean(wanted, names) : "");
}

}  // namespace

std::shared_ptr<SessionGroup> bus_of(const Call& call) {
  const Handle& handle = handle_of(call);
  return handle.device < 0 ? handle.group : nullptr;
}

bool is_on_bus(const Call& call) { return handle_of(call).group->is_bus(); }

const std::shared_ptr<Session>& session_of(const Call& call) {
  const Handle& handle = handle_of(call);
  if (handle.device >= 0) return handle.group->members()[static_cast<std::size_t>(handle.device)];
  throw Misuse(fmt::format("this is a bus of several controllers: name the device, c.devices[\"{}\"]",
                           handle.group->members().front()->catalog().id()));
}

OneAxis one_axis_at(const Call& call, int place, const char* function) {
  OneAxis one;
  const auto bus = bus_of(call);
  if (!bus) {
    one.session = session_of(call);
    one.index = axis_index(call.L, place, one.session->catalog(), function);
    const char* name = lua_type(call.L, place) == LUA_TSTRING ? lua_tostring(call.L, place) : nullptr;
    if (one.index < 0) one.refusal = no_axis(one.session->catalog(), name);
    return one;
  }
  if (lua_type(call.L, place) != LUA_TSTRING)
    throw Misuse(fmt::format("{}: on a bus the axis is the id of a device, as \"{}\", not {}", function,
                             bus->members().front()->catalog().id(),
                             lua_isnoneornil(call.L, place) ? "nil" : luaL_typename(call.L, place)));
  const int device = bus->find(lua_tostring(call.L, place));
  if (device < 0) {
    one.refusal = fmt::format("There is no device \"{}\". On this wire are: {}.",
                              shown_text(lua_tostring(call.L, place), 40), ids_of(*bus));
    return one;
  }
  one.session = bus->members()[static_cast<std::size_t>(device)];
  one.index = 0;
  return one;
}

OneAxis one_axis(const Call& call, int argument, const char* function) {
  return one_axis_at(call, call.place(argument), function);
}

int axis_index(lua_State* L, int index, const Catalog& catalog, const char* function) {
  if (lua_type(L, index) == LUA_TSTRING) return catalog.find_axis(lua_tostring(L, index));
  int whole = 0;
  const lua_Integer n = lua_tointegerx(L, index, &whole);
  if (!whole)
    throw Misuse(fmt::format("{}: the axis must be its number or its name, as 1 or \"{}\", not {}", function,
                             catalog.axes.front().name,
                             lua_isnoneornil(L, index) ? "nil" : luaL_typename(L, index)));
  return n >= 1 && n <= static_cast<lua_Integer>(catalog.axes.size()) ? static_cast<int>(n - 1) : -1;
}

void push_controller(lua_State* L, std::shared_ptr<SessionGroup> group) {
  const int device = group->is_bus() ? -1 : 0;
  push_handle(L, Handle{std::move(group), device}, controller_type);
}

int drop_handle(lua_State* L) {
  const WayOut::Closed closed(Runner::of(L).way_out());
  static_cast<Handle*>(lua_touserdata(L, 1))->~Handle();
  return 0;
}

void close_handle_type(lua_State* L) {
  lua_pushcfunction(L, drop_handle);
  lua_setfield(L, -2, "__gc");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

static std::shared_ptr<Session> device_meant(lua_State* L, const Handle& handle) {
  const auto& members = handle.group->members();
  int device = handle.device;
  if (device < 0 && lua_type(L, 2) == LUA_TSTRING) device = handle.group->find(lua_tostring(L, 2));
  return device < 0 ? nullptr : members[static_cast<std::size_t>(device)];
}

// The arguments are still on the stack after a wait.
void name_device(lua_State* L, Refusal& refusal) {
  const void* self = luaL_testudata(L, 1, controller_type);
  if (!self || !refusal.device.empty()) return;
  const Handle& handle = *static_cast<const Handle*>(self);
  const auto device = device_meant(L, handle);
  if (!device) return;
  refusal.device = device->address().text();
  if (handle.group->is_bus()) refusal.reason = fmt::format("{}: {}", device->catalog().id(), refusal.reason);
}

/// The axis of an intent; empty: none, or several.
static std::string axis_of_request(const IntentBody& body, const Catalog& catalog) {
  const int axis = std::visit(
      [](const auto& request) -> int {
        if constexpr (requires { request.axis.index; })
          return request.axis.index;
        else if constexpr (requires { request.targets.front().axis; })
          return request.targets.size() == 1 ? request.targets.front().axis.index : -1;
        else
          return -1;
      },
      body);
  return axis < 0 ? std::string() : catalog.axes[static_cast<std::size_t>(axis)].name;
}

// On a bus the sentence names the device too, to distinguish it from the others.
Refusal refusal_of(const Fault& fault, const Session& session, std::string axis, bool on_bus) {
  Refusal refusal = refusal_of(fault);
  if (on_bus) refusal.reason = fmt::format("{}: {}", session.catalog().id(), refusal.reason);
  refusal.axis = std::move(axis);
  refusal.device = session.address().text();
  return refusal;
}

// The sentence names the device already.
Answer answer_of_bus(const Result<>& result, const SessionGroup& bus) {
  if (result) return answer_yes();
  const auto origin = bus.origin_of(result.error());
  if (!origin) return answer_of(result);
  return answer_refused(refusal_of(result.error(), *origin, {}, false));
}

static Task<Answer> perform_body(SessionPtr session, IntentBody body, bool on_bus) {
  std::string axis = axis_of_request(body, session->catalog());
  const auto result = co_await session->perform(std::move(body));
  if (result) co_return answer_yes();
  co_return answer_refused(refusal_of(result.error(), *session, std::move(axis), on_bus));
}
int perform(Call& call, SessionPtr session, IntentBody body) {
  asked_by(body, StoppedBy::script);
  return call.wait(perform_body(std::move(session), std::move(body), is_on_bus(call)));
}
int perform(Call& call, IntentBody body) { return perform(call, session_of(call), std::move(body)); }

// c.bench, c.devices, else a method. nil if absent; a bus has no bench of its own.
int index_handle(lua_State* L) {
  const auto& handle = *static_cast<Handle*>(luaL_checkudata(L, 1, controller_type));
  const WayOut::Closed closed(Runner::of(L).way_out());
  const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  if (key == "bench" && handle.device >= 0) {
    push_handle(L, handle, bench_type);
    return 1;
  }
  if (key == "devices" && handle.group->is_bus() && handle.device < 0) {
    push_devices(L, handle);
    return 1;
  }
  lua_pushvalue(L, 2);
  lua_rawget(L, lua_upvalueindex(1));
  return 1;
}

}  // namespace hw::script
