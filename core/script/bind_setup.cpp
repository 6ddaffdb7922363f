// Methods of a controller for axis names and for parameters by the maker's mnemonics.
#include <cmath>
#include <cstdlib>
#include <vector>

#include <fmt/core.h>

#include "core/base/near_name.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

std::string no_param(const Catalog& catalog, const std::string& name) {
  std::string sentence = fmt::format("{} has no parameter \"{}\".", catalog.short_name, name);
  std::vector<std::string> of_axes;
  for (const AxisInfo& axis : catalog.axes)
    if (catalog.find_param(name + axis.name) >= 0) of_axes.push_back(name + axis.name);
  if (of_axes.size() == 1) sentence += fmt::format(" Say which axis: {}.", of_axes.front());
  if (of_axes.size() > 1)
    sentence += fmt::format(" Say which axis: {} to {}.", of_axes.front(), of_axes.back());
  if (!of_axes.empty()) return sentence;
  std::vector<std::string> names;
  for (const ParamInfo& info : catalog.params) names.push_back(info.mnemonic);
  return sentence + did_you_mean(name, names);
}

// As the maker writes it: 0.8, "4EX07".
std::int64_t unit_of(const ParamInfo& info) {
  std::int64_t unit = 1;
  for (int i = 0; i < info.decimals; ++i) unit *= 10;
  return unit;
}
void push_value(lua_State* L, const ParamInfo& info, std::int64_t value) {
  if (!info.prefix.empty())
    lua_pushstring(L, fmt::format("{}{:0{}}", info.prefix, value, info.digits).c_str());
  else if (info.decimals > 0)
    lua_pushnumber(L, static_cast<double>(value) / static_cast<double>(unit_of(info)));
  else
    lua_pushinteger(L, value);
}
std::int64_t value_of(const Call& call, int argument, const ParamInfo& info) {
  if (!info.prefix.empty() && call.is_text(argument)) {
    const std::string text = call.text(argument, "value");
    char* end = nullptr;
    const bool named = text.starts_with(info.prefix) && text.size() > info.prefix.size();
    const long long number = named ? std::strtoll(text.c_str() + info.prefix.size(), &end, 10) : 0;
    if (!named || *end != 0)
      throw Misuse(fmt::format("{}: the value of {} must read like {}01", call.function(), info.mnemonic,
                               info.prefix));
    return number;
  }
  if (info.decimals > 0)
    return std::llround(call.number(argument, "value") * static_cast<double>(unit_of(info)));
  return call.whole(argument, "value");
}

Task<Answer> get_param(SessionPtr session, int index) {
  const ParamInfo& info = session->catalog().params[index];
  if (info.readable) {
    IntentBody ask = intent::ReadParams(info.mnemonic);
    const auto read = co_await session->perform(std::move(ask));
    if (!read) co_return answer_refused(read.error());
  }
  const ParamState state = session->known().params[index];
  if (!state.known)
    co_return answer_refused(fmt::format("{} cannot be read from this controller.", info.mnemonic));
  co_return [state, &info](lua_State* L) {
    push_value(L, info, state.value);
    return 1;
  };
}
int get(Call& call) {
  const std::string name = call.text(1, "parameter");
  const int index = session_of(call)->catalog().find_param(name);
  if (index < 0) return call.refuse(no_param(session_of(call)->catalog(), name));
  return call.wait(get_param(session_of(call), index));
}

// ---- lists

// Axis names; on a bus the ids of its devices.
int axes(Call& call) {
  std::vector<std::string> names;
  if (const auto bus = bus_of(call))
    for (const auto& member : bus->members()) names.push_back(member->catalog().id());
  else
    for (const AxisInfo& axis : session_of(call)->catalog().axes) names.push_back(axis.name);
  lua_createtable(call.L, static_cast<int>(names.size()), 0);
  for (std::size_t i = 0; i < names.size(); ++i) {
    lua_pushstring(call.L, names[i].c_str());
    lua_rawseti(call.L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

void set_text(lua_State* L, const char* key, const std::string& text) {
  if (text.empty()) return;
  lua_pushlstring(L, text.data(), text.size());
  lua_setfield(L, -2, key);
}

void push_parameter(lua_State* L, const ParamInfo& info, const ParamState& state) {
  lua_createtable(L, 0, 6);
  set_text(L, "label", info.label);
  set_text(L, "unit", info.unit);
  push_value(L, info, info.minimum);
  lua_setfield(L, -2, "min");
  push_value(L, info, info.maximum);
  lua_setfield(L, -2, "max");
  push_value(L, info, info.fallback);
  lua_setfield(L, -2, "default");
  if (!state.known) return;
  push_value(L, info, state.value);
  lua_setfield(L, -2, "value");
}

/// All parameters, read now. Unreadable values are omitted.
Task<Answer> read_parameters(SessionPtr session) {
  IntentBody ask = intent::ReadParams();
  const auto read = co_await session->perform(std::move(ask));
  if (!read) co_return answer_refused(read.error());
  co_return [session](lua_State* L) {
    const auto& params = session->catalog().params;
    lua_createtable(L, 0, static_cast<int>(params.size()));
    for (std::size_t i = 0; i < params.size(); ++i) {
      push_parameter(L, params[i], session->known().params[i]);
      lua_setfield(L, -2, params[i].mnemonic.c_str());
    }
    return 1;
  };
}
int parameters(Call& call) { return call.wait(read_parameters(session_of(call))); }

// ---- one parameter

intent::Closing closing_of(const Call& call, int argument) {
  if (!call.has(argument)) return intent::Closing::ask;
  const std::string word = call.text(argument, "answer");
  if (word == "drive") return intent::Closing::drive;
  if (word == "stay") return intent::Closing::stay;
  throw Misuse("set: argument 3 must be \"drive\" or \"stay\"");
}

Task<Answer> set_param(SessionPtr session, intent::SetParam request) {
  const std::string name = request.mnemonic;
  const IntentId id = session->post(std::move(request));
  auto done = co_await session->outcome(id);
  const IntentOutcome* reported = session->known().outcome_of(id);
  if (!done && reported && reported->asks)
    co_return answer_refused(
        fmt::format("{} A script says which: c:set(\"{}\", value, \"stay\"), or \"drive\".",
                    done.error().sentence(), name));
  co_return answer_of(done);
}

// A script confirms by calling: questions that the manual describes are skipped. The distance of a servo axis
// from its command is not one of them: the script must answer it.
int set(Call& call) {
  const std::string name = call.text(1, "parameter");
  const Catalog& catalog = session_of(call)->catalog();
  const int index = catalog.find_param(name);
  if (index < 0) return call.refuse(no_param(catalog, name));
  const ParamInfo& info = catalog.params[static_cast<std::size_t>(index)];
  intent::SetParam request(name, value_of(call, 2, info), true);
  request.closing = closing_of(call, 3);
  return call.wait(set_param(session_of(call), std::move(request)));
}

constexpr Function setup_table[] = {
    {"axes", axes},
    {"parameters", parameters},
    {"get", get},
    {"set", set},
};

}  // namespace

std::span<const Function> setup_methods() { return setup_table; }

}  // namespace hw::script
