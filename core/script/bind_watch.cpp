// Methods of a controller that run a script's function on a change: c:on, c:wait_until.
#include <deque>
#include <new>
#include <string_view>

#include <fmt/core.h>

#include "core/base/near_name.h"
#include "core/base/number_text.h"
#include "core/script/bind.h"
#include "core/script/task_handle.h"

namespace hw::script {
namespace {

constexpr const char *watch_type = "watch", *react_key = "handwheel.react", *hold_key = "handwheel.hold";

// Both run as fibers of their own, so that the functions they call may wait.
constexpr std::string_view loops = R"lua(
local function react(watch, f)
  while true do f(watch:next()) end
end
local function hold(watch, f)
  while true do
    local found = f()
    if found then return found end
    watch:next()
  end
end
return react, hold
)lua";

enum class About : std::uint8_t { limit, input, stopped, lost, anything };

/// Events outside of the console, which only a status round shows.
bool is_urgent(About about) { return about == About::limit || about == About::input; }

/// The state compared between two looks.
struct Seen {
  std::uint32_t minus = 0, plus = 0, moving = 0, inputs = 0, inputs_known = 0;
  bool lost = false;
};

Seen look_at(const Snapshot& now) {
  Seen seen;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[i];
    if (axis.limits_known && axis.limit_minus) seen.minus |= 1u << i;
    if (axis.limits_known && axis.limit_plus) seen.plus |= 1u << i;
    if (now.axis_moves(i)) seen.moving |= 1u << i;
  }
  seen.inputs = now.inputs, seen.inputs_known = now.inputs_known;
  seen.lost = now.link.state == LinkState::lost;
  return seen;
}

/// The axis as scripts name it: 1, "X".
void push_axis_name(lua_State* L, const std::string& name) {
  if (const auto number = whole_number<lua_Integer>(name))
    lua_pushinteger(L, *number);
  else
    lua_pushlstring(L, name.data(), name.size());
}

/// The device that news concern, in script terms: on a bus its id comes first, in place of its only axis.
struct Source {
  SessionPtr session;
  bool on_bus;

  [[nodiscard]] const std::string& axis(std::size_t i) const { return session->catalog().axes[i].name; }
  /// Returns the number of values pushed.
  int push_axis(lua_State* L, std::size_t i) const {
    if (on_bus) return push_id(L);
    push_axis_name(L, axis(i));
    return 1;
  }
  int push_id(lua_State* L) const {
    const std::string id = session->catalog().id();
    if (on_bus) lua_pushlstring(L, id.data(), id.size());
    return on_bus ? 1 : 0;
  }
};

/// News for a script's function.
class Watch {
 public:
  Watch(const std::vector<SessionPtr>& sessions, bool on_bus, About about) : about_(about) {
    for (const SessionPtr& session : sessions)
      watched_.push_back({Source{session, on_bus}, look_at(session->known())});
  }

  [[nodiscard]] std::size_t size() const { return watched_.size(); }
  [[nodiscard]] const SessionPtr& session(std::size_t which) const { return watched_[which].source.session; }
  [[nodiscard]] About about() const { return about_; }
  /// Compares one session with its last look. True: there is news.
  bool look(std::size_t which);
  std::deque<Answer> news;
  Instant returned_at{};  ///< when its loop last got news, or none

 private:
  void report_limits(const Source& source, std::uint32_t hit, const char* sign);
  void report_inputs(const Source& source, const Seen& before, const Seen& now);
  void report_stopped(const Source& source, std::uint32_t axes);
  void report_lost(const Source& source);

  struct Watched {
    Source source;
    Seen seen;
  };
  const About about_;
  std::vector<Watched> watched_;
};

bool Watch::look(std::size_t which) {
  auto& [source, seen] = watched_[which];
  const Seen now = look_at(source.session->known()), before = std::exchange(seen, now);
  if (about_ == About::limit) report_limits(source, now.minus & ~before.minus, "-");
  if (about_ == About::limit) report_limits(source, now.plus & ~before.plus, "+");
  if (about_ == About::input) report_inputs(source, before, now);
  if (about_ == About::stopped) report_stopped(source, before.moving & ~now.moving);
  if (about_ == About::lost && now.lost && !before.lost) report_lost(source);
  return !news.empty();
}

void Watch::report_limits(const Source& source, std::uint32_t hit, const char* sign) {
  for (std::size_t i = 0; i < source.session->catalog().axes.size(); ++i)
    if ((hit >> i & 1) != 0)
      news.emplace_back([source, i, sign](lua_State* L) {
        const int words = source.push_axis(L, i);
        lua_pushstring(L, sign);
        return words + 1;
      });
}

void Watch::report_inputs(const Source& source, const Seen& before, const Seen& now) {
  const Catalog& catalog = source.session->catalog();
  const std::uint32_t changed = (now.inputs ^ before.inputs) & now.inputs_known & before.inputs_known;
  for (std::size_t i = 0; i < catalog.inputs.size(); ++i)
    if ((changed >> i & 1) != 0) {
      const bool operated = ((now.inputs >> i & 1) != 0) != catalog.inputs[i].active_low;
      news.emplace_back([source, number = catalog.input_number(i), operated](lua_State* L) {
        const int words = source.push_id(L);
        lua_pushinteger(L, number);
        lua_pushboolean(L, operated);
        return words + 2;
      });
    }
}

void Watch::report_stopped(const Source& source, std::uint32_t stopped) {
  for (std::size_t i = 0; i < source.session->catalog().axes.size(); ++i)
    if ((stopped >> i & 1) != 0)
      news.emplace_back([source, i](lua_State* L) { return source.push_axis(L, i); });
}

void Watch::report_lost(const Source& source) {
  news.emplace_back([source, why = std::string(source.session->known().link.sentence.view())](lua_State* L) {
    const int words = source.push_id(L);
    lua_pushlstring(L, why.data(), why.size());
    return words + 1;
  });
}

using WatchPtr = std::shared_ptr<Watch>;

constexpr Duration look_again = Millis(10);

constexpr Duration from_look_to_look = std::chrono::seconds(1);

/// Queries the inputs alone, as a status round takes long on a slow wire.
void watch_inputs_closely(Session& session) {
  session.pump().watch_inputs(session.now() + from_look_to_look);
}
void watch_limits_closely(Session& session) {
  session.pump().watch_limits(session.now() + from_look_to_look);
}

/// Runs concurrently with the script, so that nothing is missed while its function runs.
Task<> keep_watch(Runner& runner, std::weak_ptr<Watch> watched, std::size_t which, SessionPtr session,
                  About about) {
  const bool urgent = is_urgent(about);
  const Duration pace = urgent ? Millis(5) : Millis(1000);
  for (;;) {
    const Instant deadline = runner.scheduler().now() + pace;
    if (about == About::input) watch_inputs_closely(*session);
    if (about == About::limit) watch_limits_closely(*session);
    const bool news = co_await session->pump().published().wait_until(deadline);
    const WatchPtr watch = watched.lock();
    if (!watch || runner.over() || session->known().link.state == LinkState::closed) co_return;
    if (urgent && !news && session->known().link.connected()) session->pump().want_round();
    if (watch->look(which) || watch->about() == About::anything) runner.happened().notify();
  }
}

Task<Answer> next_news(Runner& runner, WatchPtr watch) {
  while (watch->news.empty() && !runner.over()) co_await runner.happened().wait();
  Answer next = [](lua_State*) { return 0; };
  if (!watch->news.empty()) {
    next = std::move(watch->news.front());
    watch->news.pop_front();
  }
  co_return next;
}

/// News at the instant of the call may come from the script's own reading, so time must pass first. If that
/// reading has taken time already, anything since may be news.
Task<Answer> pause_until_news(Runner& runner, WatchPtr watch) {
  constexpr Duration a_reading = Millis(1);
  const Instant began = runner.scheduler().now(), deadline = began + look_again;
  const bool has_read = began - watch->returned_at >= a_reading;
  for (std::size_t i = 0; i < watch->size(); ++i) watch_inputs_closely(*watch->session(i));
  for (bool news = !has_read; news && runner.scheduler().now() == began && !runner.over();)
    news = watch->size() == 1 ? co_await watch->session(0)->pump().published().wait_until(deadline)
                              : co_await runner.happened().wait_until(deadline);
  watch->returned_at = runner.scheduler().now();
  co_return [](lua_State*) { return 0; };
}

int watch_next(Call& call) {
  const auto& watch = *static_cast<WatchPtr*>(luaL_checkudata(call.L, 1, watch_type));
  if (watch->about() == About::anything) return call.wait(pause_until_news(call.runner(), watch));
  return call.wait(next_news(call.runner(), watch));
}

int drop_watch(lua_State* L) {
  const WayOut::Closed closed(Runner::of(L).way_out());
  static_cast<WatchPtr*>(lua_touserdata(L, 1))->~WatchPtr();
  return 0;
}

/// Starts loop(watch, the function at `place`) as a fiber; leaves the coroutine on the stack.
std::shared_ptr<Spawned> begin_loop(Call& call, const char* loop, const WatchPtr& watch, int place) {
  lua_getfield(call.L, LUA_REGISTRYINDEX, loop);
  new (lua_newuserdatauv(call.L, sizeof(WatchPtr), 0)) WatchPtr(watch);
  luaL_setmetatable(call.L, watch_type);
  lua_pushvalue(call.L, place);
  return call.runner().spawn(call.L, 2);
}

void want_function(const Call& call, int argument, const char* function) {
  if (!lua_isfunction(call.L, call.place(argument)))
    throw Misuse(fmt::format("{}: argument {} must be a function, as function() ... end, not {}", function,
                             argument, call.type_of(argument)));
}

About about_of(const std::string& word) {
  static const std::vector<std::string> words{"limit", "input", "stopped", "lost"};
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i]) return static_cast<About>(i);
  throw Misuse(fmt::format("on: there is no \"{}\". There is limit, input, stopped, lost.{}", word,
                           did_you_mean(word, words)));
}

/// The object of a method call, or all devices of the bus.
WatchPtr watch_on(const Call& call, About about) {
  if (const auto bus = bus_of(call)) return std::make_shared<Watch>(bus->members(), true, about);
  return std::make_shared<Watch>(std::vector<SessionPtr>{session_of(call)}, false, about);
}

void begin_to_watch(const Call& call, const WatchPtr& watch) {
  for (std::size_t i = 0; i < watch->size(); ++i)
    asio::co_spawn(call.runner().scheduler().executor(),
                   keep_watch(call.runner(), watch, i, watch->session(i), watch->about()), asio::detached);
}

int on(Call& call) {
  const About about = about_of(call.text(1, "what"));
  want_function(call, 2, "on");
  const WatchPtr watch = watch_on(call, about);
  begin_to_watch(call, watch);
  push_task(call.L, begin_loop(call, react_key, watch, call.place(2)));
  return 1;
}

int wait_until(Call& call) {
  want_function(call, 1, "wait_until");
  const Duration patience = call.patience(2, 3600);
  const WatchPtr watch = watch_on(call, About::anything);
  watch->returned_at = call.runner().scheduler().now();
  for (std::size_t i = 0; i < watch->size(); ++i) watch_inputs_closely(*watch->session(i));
  if (watch->size() > 1) begin_to_watch(call, watch);  // for the news of all in one queue
  std::vector<Awaited> awaited{{begin_loop(call, hold_key, watch, call.place(1)), true}};
  return call.wait(
      wait_for_first(call.runner(), std::move(awaited), false, patience,
                     fmt::format("Timeout: the condition was not met within {:g} s.", seconds(patience))));
}

constexpr Function watch_table[] = {{"on", on}, {"wait_until", wait_until}};
constexpr Function news_table[] = {{"next", watch_next}};

}  // namespace

std::span<const Function> watch_methods() { return watch_table; }

void bind_watches(lua_State* L) {
  luaL_newmetatable(L, watch_type);
  push_functions(L, std::begin(news_table), std::end(news_table), 1);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, drop_watch);
  lua_setfield(L, -2, "__gc");
  lua_pop(L, 1);
  if (luaL_loadbufferx(L, loops.data(), loops.size(), "=handwheel", "t") != LUA_OK) lua_error(L);
  lua_call(L, 0, 2);
  lua_setfield(L, LUA_REGISTRYINDEX, hold_key);
  lua_setfield(L, LUA_REGISTRYINDEX, react_key);
}

}  // namespace hw::script
