// Methods of a controller that move, stop and wait for its axes.
#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/base/near_name.h"
#include "core/base/shown_text.h"
#include "core/script/bind.h"
#include "core/script/options.h"

namespace hw::script {
namespace {

Sign sign_of(const Call& call, int argument) {
  const std::string sign = call.is_text(argument) ? call.text(argument, "direction") : call.type_of(argument);
  if (sign == "+") return Sign::plus;
  if (sign == "-") return Sign::minus;
  throw Misuse(fmt::format("{}: argument {} (direction) must be \"+\" or \"-\", not {}", call.function(),
                           argument, shown_text(sign, 40)));
}

struct ById {  // the same order in every run
  bool operator()(const SessionPtr& a, const SessionPtr& b) const {
    return a->catalog().id() < b->catalog().id();
  }
};
using Targets = std::map<SessionPtr, std::vector<AxisTarget>, ById>;

/// The key as scripts write it in a table of targets: X, [1]; on a bus ["01"].
std::string key_of_first_axis(const Call& call) {
  const auto bus = bus_of(call);
  if (bus) return fmt::format("[\"{}\"]", bus->members().front()->catalog().id());
  const std::string& name = session_of(call)->catalog().axes.front().name;
  return name.front() >= '0' && name.front() <= '9' ? fmt::format("[{}]", name) : name;
}

// Reads {[1]=400} or {X=1000, Y=0} in the catalog's order; on a bus {["01"]=400}. Returns a refusal, or
// empty.
std::string read_targets(const Call& call, int argument, const Counting& counting, Targets& targets) {
  const int table = call.place(argument);
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const OneAxis one = one_axis_at(call, lua_absindex(call.L, -2), call.function());
    if (one.index < 0) return one.refusal;
    const Steps steps = counting.steps(call, lua_absindex(call.L, -1), one, "a target");
    lua_pop(call.L, 1);
    targets[one.session].push_back(AxisTarget{id_of(one.index), steps});
  }
  if (targets.empty())
    throw Misuse(fmt::format("{}: the table of targets is empty: an axis whose value is nil is not in it",
                             call.function()));
  for (auto& [session, own] : targets)
    std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.axis < b.axis; });
  return {};
}

// ---- the pace of a motion

/// Steps per unit of the speed.
double common_unit(const Call& call, const Counting& counting, const Targets& targets) {
  std::vector<OneAxis> axes;
  for (const auto& [session, own] : targets)
    for (const AxisTarget& target : own) axes.push_back(OneAxis{session, target.axis.index, {}});
  return counting.common_to(call, axes);
}

const std::vector<std::string> pace_options{"speed", "acceleration", "unit"};

// ---- moves

std::string name_of_axis(const Session& session, AxisId axis) {
  return session.catalog().axes[axis.index].name;
}

// Starts all before waiting for the first.
template <class Move>
Task<Answer> move_all(Targets targets, intent::Pace pace, bool on_bus) {
  struct UnderWay {
    SessionPtr session;
    IntentId id;
    std::string axis;  // empty: several
  };
  std::vector<UnderWay> under_way;
  for (auto& [session, own] : targets)
    under_way.push_back({session, 0, own.size() == 1 ? name_of_axis(*session, own.front().axis) : ""});
  for (UnderWay& one : under_way) {
    Move body(std::move(targets[one.session]), pace.speed);
    body.acceleration = pace.acceleration;
    one.id = one.session->post(std::move(body));
  }
  std::optional<Refusal> first;
  for (const UnderWay& one : under_way) {
    const auto moved = co_await one.session->outcome(one.id);
    if (!first && !moved) first = refusal_of(moved.error(), *one.session, one.axis, on_bus);
  }
  co_return first ? answer_refused(std::move(*first)) : answer_yes();
}

template <class Move>
int move(Call& call) {
  if (!lua_istable(call.L, call.place(1)))
    throw Misuse(fmt::format("{}: the targets must be a table like {{{}=400}}, not {}", call.function(),
                             key_of_first_axis(call), call.type_of(1)));
  const Options options(call, 2, call.function(), pace_options);
  const Counting counting = options.counting();
  Targets targets;
  if (const std::string why = read_targets(call, 1, counting, targets); !why.empty()) return call.refuse(why);
  intent::Pace pace{options.speed(), options.acceleration()};
  if (pace.speed.value > 0) pace.speed = options.speed(common_unit(call, counting, targets));
  return call.wait(move_all<Move>(std::move(targets), pace, is_on_bus(call)));
}

intent::Pace pace_of_axis(const Call& call, const Options& options, const OneAxis& one) {
  return {options.speed(options.counting().steps_per_unit(call, one)), options.acceleration()};
}

/// A bare speed, or a table of options.
int jog(Call& call) {
  const OneAxis one = one_axis(call, 1, "jog");
  const Sign sign = sign_of(call, 2);
  const bool bare = call.has(3) && !lua_istable(call.L, call.place(3));
  intent::Pace pace;
  if (bare)
    pace.speed = Pps(call.number(3, "speed"));
  else if (const Options options(call, 3, "jog", pace_options); one.index >= 0)
    pace = pace_of_axis(call, options, one);
  if (one.index < 0) return call.refuse(one.refusal);
  intent::JogStart body(id_of(one.index), sign, pace.speed, false);
  body.acceleration = pace.acceleration;
  return perform(call, one.session, std::move(body));
}

/// A mode by id, by the maker's word, or by number (its index). -1: none.
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
  return fmt::format("There is no homing mode \"{}\". The modes are {}.{}", wanted, fmt::join(ids, ", "),
                     did_you_mean(wanted, ids));
}

/// The mode by its bare word, or a table of options.
int home(Call& call) {
  const OneAxis one = one_axis(call, 1, "home");
  const bool bare = call.has(3) && !lua_istable(call.L, call.place(3));
  std::optional<std::string> wanted;
  intent::Pace pace;
  if (bare) {
    wanted = call.text(3, "mode");
  } else {
    const Options options(call, 3, "home", {"mode", "speed", "acceleration", "unit"});
    wanted = options.text("mode");
    if (one.index >= 0) pace = pace_of_axis(call, options, one);
  }
  if (one.index < 0) return call.refuse(one.refusal);
  intent::Home body(id_of(one.index), sign_of(call, 2));
  body.pace = pace;
  if (wanted) {
    const auto& modes = one.session->catalog().homing_modes;
    body.mode = homing_mode(modes, *wanted);
    if (body.mode < 0) return call.refuse(no_such_homing(modes, *wanted));
  }
  return perform(call, one.session, std::move(body));
}

Task<Answer> stop_bus(std::shared_ptr<SessionGroup> bus, bool at_once) {
  const auto stopped = co_await bus->perform_stop(at_once);
  co_return answer_of_bus(stopped, *bus);
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

/// In a wait, a fault of this kind is always a timeout: a controller that does not answer is reported as
/// lost.
Refusal of_wait(Refusal refusal) {
  return refusal.kind == FaultKind::no_answer ? too_late(std::move(refusal)) : refusal;
}

/// Advice after a motion that ended before its target; `axis` -1: several axes.
std::string_view advice_on_end(const Session& session, FaultKind kind, int axis) {
  if (kind == FaultKind::lost) return "Repair the cable or the power: the console reconnects by itself.";
  if (axis < 0) return {};
  switch (session.known().axes[ix(axis)].ended_by) {
    case EndedBy::limit: return "Move the axis the other way, off the switch.";
    case EndedBy::error: return "Call clear_errors(), then give the command again.";
    case EndedBy::elsewhere:
      return "Find out which program or button stops the axis, then give the command again.";
    case EndedBy::lost: return "Check where the axis is and home it, then give the command again.";
    case EndedBy::not_in_place: return "Find out why the axis does not move, then give the command again.";
    default: return {};
  }
}

Task<Answer> wait_idle(SessionPtr session, Duration patience, bool on_bus) {
  const auto idle = co_await session->wait_until_idle(patience);
  if (idle) co_return answer_yes();
  const bool ended = idle.error().kind == FaultKind::controller;
  const int index = ended ? axis_not_finished(session->known(), session->catalog()) : -1;
  std::string axis = index >= 0 ? name_of_axis(*session, id_of(index)) : std::string();
  Refusal refusal = refusal_of(idle.error(), *session, std::move(axis), on_bus);
  if (refusal.what_to_do.empty()) refusal.what_to_do = advice_on_end(*session, idle.error().kind, index);
  co_return answer_refused(of_wait(std::move(refusal)));
}
Task<Answer> wait_bus_idle(std::shared_ptr<SessionGroup> bus, Duration patience) {
  const auto idle = co_await bus->wait_until_idle(patience);
  if (idle) co_return answer_yes();
  const auto origin = bus->origin_of(idle.error());
  if (!origin) co_return answer_refused(of_wait(refusal_of(idle.error())));
  co_return answer_refused(of_wait(refusal_of(idle.error(), *origin, {}, false)));
}
int wait(Call& call) {
  const Duration patience = call.patience(1, 3600);
  if (auto bus = bus_of(call)) return call.wait(wait_bus_idle(std::move(bus), patience));
  return call.wait(wait_idle(session_of(call), patience, is_on_bus(call)));
}

constexpr Function motion_table[] = {
    {"move_to", move<intent::MoveTo>}, {"move_by", move<intent::MoveBy>}, {"jog", jog},   {"home", home},
    {"stop", stop<intent::Stop>},      {"abort", stop<intent::Abort>},    {"wait", wait},
};

}  // namespace

std::span<const Function> motion_methods() { return motion_table; }

}  // namespace hw::script
