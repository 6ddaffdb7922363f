// How far a script lets axes go, and the places that it saves and goes back to.
#include <array>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "core/script/bind.h"

namespace hw::script {
namespace {

// ---- limits

/// {minus=-1000, plus=90000}; what is left out bounds nothing.
Travel read_travel(const Call& call, int argument) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table)) throw Misuse("the limits must be a table like {minus=-1000, plus=90000}");
  Travel travel;
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const char* key = lua_type(call.L, -2) == LUA_TSTRING ? lua_tostring(call.L, -2) : "";
    const bool minus = std::strcmp(key, "minus") == 0, plus = std::strcmp(key, "plus") == 0;
    int whole = 0;
    const lua_Integer place = lua_tointegerx(call.L, -1, &whole);
    if (!minus && !plus) throw Misuse("limits are called minus and plus");
    if (!whole) throw Misuse("a limit must be a whole number of steps");
    (minus ? travel.minus : travel.plus) = Steps(place);
    (minus ? travel.has_minus : travel.has_plus) = true;
    lua_pop(call.L, 1);
  }
  return travel;
}

Answer answer_travel(const Travel& travel) {
  return [travel](lua_State* L) {
    lua_createtable(L, 0, 2);
    if (travel.has_minus) lua_pushinteger(L, travel.minus.value), lua_setfield(L, -2, "minus");
    if (travel.has_plus) lua_pushinteger(L, travel.plus.value), lua_setfield(L, -2, "plus");
    return 1;
  };
}

Task<Answer> tell_travel(SessionPtr session, int axis) {
  co_return answer_travel(session->known().axes[axis].travel);
}

int limits(Call& call) {
  const OneAxis one = one_axis(call, 1, "limits");
  if (one.index < 0) return call.refuse(one.refusal);
  if (!call.has(2)) return call.wait(tell_travel(one.session, one.index));
  Travel travel = read_travel(call, 2);
  travel.in_counts = one.session->known().axes[one.index].in_counts;
  return perform(call, one.session, intent::SetTravel(id_of(one.index), travel));
}

// ---- places

/// By axis, in the catalog's order. Not empty: there is none such.
std::string read_place(const Call& call, int argument, std::vector<AxisTarget>& at) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table)) throw Misuse("a place must be a table like {X=1000, Y=0}");
  std::array<std::optional<Steps>, max_axes> found{};
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const OneAxis one = one_axis_at(call, lua_absindex(call.L, -2), "place");
    int whole = 0;
    const lua_Integer steps = lua_tointegerx(call.L, -1, &whole);
    if (!whole) throw Misuse("a place must be a whole number of steps");
    lua_pop(call.L, 1);
    if (one.index < 0) return one.refusal;
    found[static_cast<std::size_t>(one.index)] = Steps(steps);
  }
  for (int i = 0; i < max_axes; ++i)
    if (found[static_cast<std::size_t>(i)]) at.push_back({id_of(i), *found[static_cast<std::size_t>(i)]});
  return {};
}

Task<Answer> save_here(SessionPtr session, std::string name) {
  co_await session->pump().refresh();
  auto at = standing_place(session->catalog(), session->known());
  if (!at) co_return answer_refused(at.error().sentence());
  put_place(session->places(), {std::move(name), std::move(*at)});
  co_return answer_yes();
}

int save_place(Call& call) {
  const SessionPtr& session = session_of(call);
  std::string name = call.text(1, "name");
  if (name.empty()) throw Misuse("a place needs a name");
  if (!call.has(2)) return call.wait(save_here(session, std::move(name)));
  SavedPlace saved{std::move(name), {}};
  if (const std::string why = read_place(call, 2, saved.at); !why.empty()) return call.refuse(why);
  put_place(session->places(), std::move(saved));
  return call.yes();
}

int go(Call& call) {
  const SessionPtr& session = session_of(call);
  const std::string name = call.text(1, "name");
  const SavedPlace* to = find_place(session->places(), name);
  if (to) return perform(call, session, intent::MoveTo(to->at));
  const std::string names = names_of(session->places());
  return call.refuse(fmt::format("There is no place \"{}\". {}", name,
                                 names.empty() ? "None was saved: c:place(name) saves where the axes stand."
                                               : fmt::format("There is: {}.", names)));
}

constexpr Function places_table[] = {{"limits", limits}, {"place", save_place}, {"go", go}};

}  // namespace

std::span<const Function> place_methods() { return places_table; }

}  // namespace hw::script
