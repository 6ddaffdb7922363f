// Methods of a controller that move its axes, stop them, and wait for them.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/base/near_name.h"
#include "core/script/bind.h"
#include "core/script/options.h"

namespace hw::script {
namespace {

Sign sign_of(const Call& call, int argument) {
  const std::string sign = call.text(argument, "direction");
  if (sign == "+") return Sign::plus;
  if (sign == "-") return Sign::minus;
  throw Misuse("the direction must be \"+\" or \"-\"");
}

struct ById {  // the same order in every run
  bool operator()(const SessionPtr& a, const SessionPtr& b) const {
    return a->catalog().id() < b->catalog().id();
  }
};
using Targets = std::map<SessionPtr, std::vector<AxisTarget>, ById>;

// {[1]=400} or {X=1000, Y=0}, put into the catalog's order; on a bus {["01"]=400}. Not empty: why not.
std::string read_targets(const Call& call, int argument, Targets& targets) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table)) throw Misuse("the targets must be a table like {[1]=400}");
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const OneAxis one = one_axis_at(call, lua_absindex(call.L, -2), "targets");
    int whole = 0;
    const lua_Integer steps = lua_tointegerx(call.L, -1, &whole);
    if (!whole) throw Misuse("a target must be a whole number of steps");
    lua_pop(call.L, 1);
    if (one.index < 0) return one.refusal;
    targets[one.session].push_back(AxisTarget{id_of(one.index), Steps(steps)});
  }
  if (targets.empty()) throw Misuse("the table of targets is empty");
  for (auto& [session, own] : targets)
    std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.axis < b.axis; });
  return {};
}

// ---- moves

std::string name_of_axis(const Session& session, AxisId axis) {
  return session.catalog().axes[axis.index].name;
}

// All begin before the first is waited for.
template <class Move>
Task<Answer> move_all(Targets targets, Pps speed) {
  struct UnderWay {
    SessionPtr session;
    IntentId id;
    std::string axis;  // empty: several
  };
  std::vector<UnderWay> under_way;
  for (auto& [session, own] : targets)
    under_way.push_back({session, 0, own.size() == 1 ? name_of_axis(*session, own.front().axis) : ""});
  for (UnderWay& one : under_way) one.id = one.session->post(Move(std::move(targets[one.session]), speed));
  std::optional<Refusal> first;
  for (const UnderWay& one : under_way) {
    const auto moved = co_await one.session->outcome(one.id);
    if (!first && !moved) first = refusal_of(moved.error(), *one.session, one.axis);
  }
  co_return first ? answer_refused(std::move(*first)) : answer_yes();
}

template <class Move>
int move(Call& call) {
  const Pps speed = Options(call, 2, "move", {"speed"}).speed();
  Targets targets;
  if (const std::string why = read_targets(call, 1, targets); !why.empty()) return call.refuse(why);
  return call.wait(move_all<Move>(std::move(targets), speed));
}

/// A bare number, or {speed=}.
Pps jog_speed(const Call& call, int argument) {
  const bool bare = call.has(argument) && !lua_istable(call.L, call.place(argument));
  return bare ? Pps(call.number(argument, "speed")) : Options(call, argument, "jog", {"speed"}).speed();
}

int jog(Call& call) {
  const OneAxis one = one_axis(call, 1, "jog");
  const Pps speed = jog_speed(call, 3);
  if (one.index < 0) return call.refuse(one.refusal);
  return perform(call, one.session, intent::JogStart(id_of(one.index), sign_of(call, 2), speed, false));
}

/// By id, by the maker's word, or by its number, which is its place. -1: none.
int homing_mode(const std::vector<HomingMode>& modes, const std::string& wanted) {
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (wanted == modes[i].id || (!wanted.empty() && wanted == modes[i].maker) ||
        wanted == fmt::format("{}", i))
      return static_cast<int>(i);
  return -1;
}

std::string no_such_homing(const std::vector<HomingMode>& modes, const std::string& wanted) {
  std::vector<std::string> ids;
  for (const HomingMode& m : modes) ids.push_back(m.id);
  return fmt::format("There is no way of homing \"{}\". There is {}.{}", wanted, fmt::join(ids, ", "),
                     did_you_mean(wanted, ids));
}

/// The bare word, or {mode=}.
std::optional<std::string> wanted_homing(const Call& call, int argument) {
  if (lua_istable(call.L, call.place(argument)))
    return Options(call, argument, "home", {"mode"}).text("mode");
  if (!call.has(argument)) return {};
  return call.text(argument, "mode");
}

int home(Call& call) {
  const OneAxis one = one_axis(call, 1, "home");
  const auto wanted = wanted_homing(call, 3);
  if (one.index < 0) return call.refuse(one.refusal);
  int mode = 0;
  if (wanted) {
    const auto& modes = one.session->catalog().homing_modes;
    mode = homing_mode(modes, *wanted);
    if (mode < 0) return call.refuse(no_such_homing(modes, *wanted));
  }
  return perform(call, one.session, intent::Home(id_of(one.index), sign_of(call, 2), mode));
}

Task<Answer> stop_bus(std::shared_ptr<SessionGroup> bus, bool at_once) {
  const auto stopped = co_await bus->perform_stop(at_once);
  co_return answer_of(stopped);
}

template <class How>
int stop(Call& call) {
  if (call.has(1)) {
    const OneAxis one = one_axis(call, 1, "stop");
    if (one.index < 0) return call.refuse(one.refusal);
    return perform(call, one.session, How(bus_of(call) ? -1 : one.index));
  }
  if (auto bus = bus_of(call)) return call.wait(stop_bus(std::move(bus), std::is_same_v<How, intent::Abort>));
  return perform(call, How(-1));
}

Task<Answer> wait_idle(SessionPtr session, Duration patience) {
  const auto idle = co_await session->wait_until_idle(patience);
  if (idle) co_return answer_yes();
  co_return answer_refused(refusal_of(idle.error(), *session, {}));
}
Task<Answer> wait_bus_idle(std::shared_ptr<SessionGroup> bus, Duration patience) {
  const auto idle = co_await bus->wait_until_idle(patience);
  co_return answer_of(idle);
}
int wait(Call& call) {
  const Duration patience = call.patience(1, 3600);
  if (auto bus = bus_of(call)) return call.wait(wait_bus_idle(std::move(bus), patience));
  return call.wait(wait_idle(session_of(call), patience));
}

constexpr Function motion_table[] = {
    {"move_to", move<intent::MoveTo>}, {"move_by", move<intent::MoveBy>}, {"jog", jog},   {"home", home},
    {"stop", stop<intent::Stop>},      {"abort", stop<intent::Abort>},    {"wait", wait},
};

}  // namespace

std::span<const Function> motion_methods() { return motion_table; }

}  // namespace hw::script
