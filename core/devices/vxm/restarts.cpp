#include "core/devices/vxm/restarts.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/axis_motion.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/greeting.h"

namespace hw::vxm {
namespace {

constexpr int restart_attempts = 8;
constexpr Duration restart_pause = Millis(250);

}  // namespace

// Counts the restart before F removes the only sign of it; the wire may fail in between.
Task<Result<>> Restarts::found(const char* why) {
  if (!presence_.restart_is_counted()) {
    const bool was_moving = console_.snapshot.any_axis_moving() || under_way_.busy();
    under_way_.forget();
    auto reply = co_await conversation_.places(ReplyShape::until_quiet(greeting_quiet_ms), Priority::intent);
    if (!reply && reply.error().kind != FaultKind::no_answer)
      co_return fail(reply.error());  // the next V detects the restart
    count(why, was_moving, reply ? decode_digitized(*reply, max_motors) : std::nullopt);
  }
  presence_.forget_mode();
  auto on_line = co_await presence_.go_on_line();
  if (!on_line) co_return on_line;
  co_return co_await positions_.read(Priority::intent, true);
}

Task<Result<>> Restarts::found_left_local() {
  const bool was_moving = console_.snapshot.any_axis_moving() || under_way_.busy();
  under_way_.forget();
  auto read = co_await positions_.read(Priority::intent, true);
  if (!read) co_return read;
  Digitized places;
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    places.positions.push_back(console_.snapshot.axes[i].position);
  count("It answered from Local mode", was_moving, places);
  co_return Result<>();
}

Task<Result<>> Restarts::may_have_left_local() {
  auto read = co_await positions_.read(Priority::intent, !under_way_.busy());
  if (!read) co_return read;
  bool zero = true;
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    zero = zero && console_.snapshot.axes[i].position == Steps(0);
  if (!zero) co_return Result<>();
  stands_since(Doubt::after_silence);
  knowledge_.may_be_of_before();
  console_.report(Notice::Kind::warning,
                  "Check where the axes are, and home them before the next absolute move: all positions read "
                  "zero. F put the controller on-line, and replies were missing or late, so the console "
                  "cannot tell whether it was switched off and on.");
  co_return Result<>();
}

void Restarts::count(const char* why, bool was_moving, const std::optional<Digitized>& places) {
  presence_.count_restart();
  const bool zero = !places || std::all_of(places->positions.begin(), places->positions.end(),
                                           [](Steps place) { return place.value == 0; });
  ++console_.snapshot.restarts;
  stands_since(zero ? Doubt::restarted : Doubt::none);
  if (!zero)
    return console_.report(
        Notice::Kind::warning,
        fmt::format("{} although it was on-line. It is put on-line again; its positions are kept. "
                    "Nothing else was sent.",
                    why));
  forget_ram();
  console_.report(Notice::Kind::warning,
                  fmt::format("{}: the controller was switched off and on, or reset. Its positions read zero "
                              "where the motors are now, and unstored settings and programs are lost. {}Home "
                              "the axes before the next absolute move.",
                              why, was_moving ? "The motion that was under way was not resumed. " : ""));
}

Task<Result<>> Restarts::found_reset_on_line() {
  ++console_.snapshot.restarts;
  under_way_.forget();
  stands_since(Doubt::reset);
  forget_ram();
  console_.report(Notice::Kind::warning,
                  "The controller was reset by res: its positions read zero where the motors are now, and "
                  "unstored settings and programs are lost. Home the axes before the next absolute move.");
  co_return co_await positions_.read(Priority::intent, true);
}

Task<Result<>> Restarts::reset() {
  auto sent = co_await conversation_.transmit("res", Priority::intent);
  if (!sent) co_return sent;
  under_way_.drop_job();
  under_way_.run_ended(EndedBy::abort);
  forget_ram();
  presence_.note_reset_sent();  // if this is cut short, the next V detects the restart
  Result<> on_line = fail(FaultKind::no_answer, "The controller does not answer after its reset.");
  for (int attempt = 0; attempt < restart_attempts && !on_line && conversation_.station(); ++attempt) {
    auto waited = co_await conversation_.station()->pause(restart_pause);
    if (!waited) co_return waited;
    on_line = co_await presence_.go_on_line();
  }
  if (!on_line) co_return on_line;
  presence_.reset_is_over();
  stands_since(Doubt::reset);
  console_.report(Notice::Kind::info,
                  "The controller was reset: its positions read zero where the motors are now, and unstored "
                  "settings and programs are lost. Home the axes before the next absolute move.");
  co_return co_await positions_.read(Priority::intent, true);
}

/// Shows all axes at rest, and doubts their positions. Doubt::none: the positions were kept.
void Restarts::stands_since(Doubt why) {
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const bool was_busy = axis.activity != Activity::idle && axis.activity != Activity::unknown;
    end_motion(axis, was_busy ? EndedBy::lost : axis.ended_by);
    if (why != Doubt::none) axis.trust.doubt(why, console_.scheduler.now());
  }
}

void Restarts::forget_ram() {
  hold_.ended();
  presence_.note_answers_again();
  scratch_.forget();
  knowledge_.forget();
  speeds_.forget();
  console_.snapshot.program.command = -1;
  console_.snapshot.program.stepping = false;
}

}  // namespace hw::vxm
