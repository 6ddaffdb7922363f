// Travel limits, backlash, and saved places of a script.
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/script/bind.h"
#include "core/script/options.h"

namespace hw::script {
namespace {

// ---- limits

/// Swaps the ends: where units count opposite to steps, the lower end in one is the upper in the other.
void turn_round(Travel& travel) {
  std::swap(travel.minus, travel.plus);
  std::swap(travel.has_minus, travel.has_plus);
}

/// Reads {minus=-1000, plus=90000}; an absent end has no limit.
Travel read_travel(const Call& call, int argument, const Counting& counting, const OneAxis& one) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table))
    throw Misuse(fmt::format("limits: argument 2 must be a table like {{minus=-1000, plus=90000}}, not {}",
                             call.type_of(argument)));
  Travel travel;
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const char* key = lua_type(call.L, -2) == LUA_TSTRING ? lua_tostring(call.L, -2) : "";
    const bool minus = std::strcmp(key, "minus") == 0, plus = std::strcmp(key, "plus") == 0;
    if (!minus && !plus)
      throw Misuse(fmt::format("limits: there is no \"{}\": the ends are minus and plus", key));
    (minus ? travel.minus : travel.plus) = counting.steps(call, lua_absindex(call.L, -1), one, "a limit");
    (minus ? travel.has_minus : travel.has_plus) = true;
    lua_pop(call.L, 1);
  }
  if (counting.steps_per_unit(call, one) < 0) turn_round(travel);
  return travel;
}

/// `per_unit`: 0: in steps.
Answer answer_travel(Travel travel, double per_unit) {
  if (per_unit < 0) turn_round(travel);
  return [travel, per_unit](lua_State* L) {
    const auto set = [&](const char* end, Steps at) {
      push_steps(L, at, per_unit);
      lua_setfield(L, -2, end);
    };
    lua_createtable(L, 0, 2);
    if (travel.has_minus) set("minus", travel.minus);
    if (travel.has_plus) set("plus", travel.plus);
    return 1;
  };
}

Task<Answer> report_travel(SessionPtr session, int axis, double per_unit) {
  co_return answer_travel(session->known().axes[axis].travel, per_unit);
}

int limits(Call& call) {
  const OneAxis one = one_axis(call, 1, "limits");
  if (one.index < 0) return call.refuse(one.refusal);
  const Counting counting = Options(call, 3, "limits", {"unit"}).counting();
  if (!call.has(2)) return call.wait(report_travel(one.session, one.index, counting.per_unit(call, one)));
  Travel travel = read_travel(call, 2, counting, one);
  travel.in_counts = one.session->known().axes[one.index].in_counts;
  return perform(call, one.session, intent::SetTravel(id_of(one.index), travel));
}

// ---- backlash

Task<Answer> read_backlash(SessionPtr session, int axis) {
  const Backlash backlash = session->known().axes[axis].backlash;
  co_return [backlash](lua_State* L) {
    lua_createtable(L, 0, 2);
    lua_pushinteger(L, backlash.by.value);
    lua_setfield(L, -2, "by");
    lua_pushstring(L, backlash.last == Sign::plus ? "+" : "-");
    lua_setfield(L, -2, "ends");
    return 1;
  };
}

/// c:backlash("X", {by=50, ends="+"}); {}: no compensation.
int backlash(Call& call) {
  const OneAxis one = one_axis(call, 1, "backlash");
  if (one.index < 0) return call.refuse(one.refusal);
  if (!call.has(2)) return call.wait(read_backlash(one.session, one.index));
  const Options options(call, 2, "backlash", {"by", "ends"});
  const std::string ends = options.text("ends").value_or("+");
  if (ends != "+" && ends != "-")
    throw Misuse("backlash: ends is \"+\" or \"-\": the way in which every move ends");
  Backlash request;
  request.by = Steps(std::llround(options.above_zero("by", "steps").value_or(0)));
  request.last = ends == "+" ? Sign::plus : Sign::minus;
  return perform(call, one.session, intent::SetBacklash(id_of(one.index), request));
}

// ---- places

/// By axis, in the catalog's order. Returns a refusal, or empty.
std::string read_place(const Call& call, int argument, const Counting& counting,
                       std::vector<AxisTarget>& at) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table))
    throw Misuse(fmt::format("place: argument 2 must be a table like {{X=1000, Y=0}}, not {}",
                             call.type_of(argument)));
  std::array<std::optional<Steps>, max_axes> found{};
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const OneAxis one = one_axis_at(call, lua_absindex(call.L, -2), "place");
    if (one.index < 0) return one.refusal;
    found[static_cast<std::size_t>(one.index)] =
        counting.steps(call, lua_absindex(call.L, -1), one, "a place");
    lua_pop(call.L, 1);
  }
  for (int i = 0; i < max_axes; ++i)
    if (found[static_cast<std::size_t>(i)]) at.push_back({id_of(i), *found[static_cast<std::size_t>(i)]});
  return {};
}

Task<Answer> save_here(SessionPtr session, std::string name) {
  co_await session->pump().refresh();
  auto at = standing_place(session->catalog(), session->known());
  if (!at) co_return answer_refused(at.error());
  put_place(session->places(), {std::move(name), std::move(*at)});
  co_return answer_yes();
}

int save_place(Call& call) {
  const SessionPtr& session = session_of(call);
  std::string name = call.text(1, "name");
  if (name.empty()) throw Misuse("place: argument 1 (name) must not be empty");
  if (!call.has(2)) return call.wait(save_here(session, std::move(name)));
  SavedPlace saved{std::move(name), {}};
  const Counting counting = Options(call, 3, "place", {"unit"}).counting();
  if (const std::string why = read_place(call, 2, counting, saved.at); !why.empty()) return call.refuse(why);
  put_place(session->places(), std::move(saved));
  return call.yes();
}

int go(Call& call) {
  const SessionPtr& session = session_of(call);
  const std::string name = call.text(1, "name");
  const Options options(call, 2, "go", {"speed", "acceleration", "unit"});
  if (const SavedPlace* to = find_place(session->places(), name)) {
    std::vector<OneAxis> axes;
    for (const AxisTarget& target : to->at) axes.push_back(OneAxis{session, target.axis.index, {}});
    const bool paced = options.speed().value > 0;
    intent::MoveTo body(to->at, paced ? options.speed(options.counting().common_to(call, axes)) : Pps());
    body.acceleration = options.acceleration();
    return perform(call, session, std::move(body));
  }
  const std::string names = names_of(session->places());
  return call.refuse(fmt::format("There is no place \"{}\". {}", name,
                                 names.empty() ? "None was saved: c:place(name) saves where the axes stand."
                                               : fmt::format("There is: {}.", names)));
}

constexpr Function places_table[] = {
    {"limits", limits}, {"backlash", backlash}, {"place", save_place}, {"go", go}};

}  // namespace

std::span<const Function> place_methods() { return places_table; }

}  // namespace hw::script
