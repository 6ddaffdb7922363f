#pragma once
// The driver of both Arcus controllers; their differences are in the Forms. It owns the parts and serves the
// pump. Each part has its own state and a file of its name, and is constructed with the other parts it needs,
// no more (driver_parts.h).
//
//   console, conversation
//                         context; questions, commands, unsolicited messages
//   code_at_work          programs and subroutines that may be running, and what they may do
//   borrowed_setting      a setting written for one motion
//   set_up                parameters, storing, what a power-up resets
//   move_list             a list of moves, fed as places become free
//   readouts              readouts, variables, analog inputs
//   restart_watch         detecting a power cycle
//   motions               the motion of each axis, and what its status means
//   motion_status         reading positions and motion of the axes
//   limit_switches        limit switches, also between the questions of a round
//   threads               the threads that run the stored programs
//   lines                 inputs, outputs, motor power
//   moves, feed, actions  carrying out the console's commands
//   live_status           status during a long procedure
//   stored_lines, programs
//                         the stored code; load, read, run, pause
//   guard_thread          the guard of held jogs that the controller runs
//   after_silence         reading the state after a missed reply
//   stops                 stops (decision AMB-128)
//   texts                 the user's own text
//   finding               identifying the controller, or why it fails
#include <string>
#include <string_view>

#include "core/devices/arcus/driver_parts.h"
#include "core/devices/arcus/finding.h"
#include "core/devices/arcus/stops.h"
#include "core/devices/arcus/texts.h"

namespace hw::arcus {

class ArcusDriver final : public Driver {
 public:
  ArcusDriver(DriverContext context, const Forms& forms, const language::Dialect& dialect);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  void watch_inputs(Instant until) override { known_.lines.watch_inputs(until); }
  void watch_limits(Instant until) override { known_.limits.watch(until); }
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  [[nodiscard]] LastWill last_will(unsigned axes) const override;
  StopProgress stop_progress(const StopOrder& order) override;
  [[nodiscard]] bool clears_up() const override { return known_.borrowed.is_out() || work_.guard.at_work(); }
  [[nodiscard]] std::string leaves_behind() const override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  [[nodiscard]] TextGoals goals_of(std::string_view text) const override;
  void note_broadcast(const std::string& text) override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override { return period_at_rest; }

 private:
  // ---- driver.cpp
  Task<Result<>> jog(intent::JogStart request);
  Task<Result<>> undo_borrowed(const IntentBody& before);
  [[nodiscard]] Result<> guard_allows(const std::string& text) const;
  Task<Result<>> set_param(intent::SetParam request);
  Task<Result<>> set_variable(const intent::SetVariable& request);
  Task<Result<>> read_params(std::string only);
  Task<Result<>> read_again();

  // ---- driver_connect.cpp
  Task<Result<>> find();
  Task<Result<>> read_state();
  void restarted(std::string_view how_it_shows, unsigned moved);

  // ---- driver_poll.cpp
  [[nodiscard]] bool is_at_work() const;
  Task<Result<>> read_at_rest();
  void show_worst();

  const Console console_;
  Conversation conversation_;
  Known known_;
  Work work_;
  AfterSilence silence_;
  Stops stops_;
  Texts texts_;
  Finding finding_;
  int round_ = 0;
};

}  // namespace hw::arcus
