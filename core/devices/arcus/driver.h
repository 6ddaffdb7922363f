#pragma once
// Both Arcus controllers from the console's side: what differs is in the Forms. Parts with a state of their
// own:
//   conversation.h       questions, commands, what comes unasked
//   set_up.h             parameters, storing, what a power-up takes back
//   code_at_work.h       programs and subroutines that may be under way, and what they may do
//   borrowed_setting.h   a setting that is written for one motion
//   readouts.h           readouts, variables, analog inputs
//   restart_watch.h      noticing that it was switched off and on
//   move_list.h          a list of moves, fed as places become free
//   motions.h            what is under way on each axis
//   motion_status.h      asking where the axes are and what they do
//   threads.h            the threads that run the stored programs
//   lines.h              inputs, outputs, motor power
//   moves.h              moves, jogs, homing, positions
//   feed.h               a list of moves that runs
//   actions.h            the catalog\'s actions
//   live_status.h        status in the middle of a long procedure
//   stored_lines.h       the lines of the stored code
//   programs.h           load, read, run, pause
//   after_silence.h      what is looked at where an answer was missing
//   stops.h              stops (decision AMB-128)
//   texts.h              the user's own text
// and here what is said and done with them, one subject per file:
//   driver_connect.cpp   finding the device, saying why not
//   driver_perform.cpp   what is asked of it
//   driver_restart.cpp   what is left when it was switched off and on; lost wires
//   driver_poll.cpp      the round of status
//   driver_threads.cpp   what is read at rest; variables
#include <array>
#include <bitset>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/actions.h"
#include "core/devices/arcus/feed.h"
#include "core/devices/arcus/lines.h"
#include "core/devices/arcus/programs.h"
#include "core/devices/arcus/stops.h"
#include "core/devices/arcus/texts.h"

namespace hw::arcus {

class ArcusDriver final : public Driver {
 public:
  ArcusDriver(DriverContext context, const Forms& forms, const language::Dialect& dialect);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  StopProgress stop_progress(const StopOrder& order) override;
  [[nodiscard]] bool clears_up() const override { return borrowed_.is_out(); }
  [[nodiscard]] std::string leaves_behind() const override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  void overhear(const std::string& text) override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override { return period_at_rest; }

 private:
  void goes_out(std::string_view command);
  void not_done(std::string_view command);

  // ---- driver_connect.cpp
  Task<Result<>> find();
  Task<Result<>> identify();
  Task<Result<Reply>> ask_who_it_is(std::string question, std::function<bool(std::string_view)> is_it);
  void note_how_slow();
  Task<Result<>> read_name();
  Task<Result<>> read_state();
  SetUp::Ways ways_of_set_up();
  tl::unexpected<Fault> silent() const;
  tl::unexpected<Fault> garbled(std::string_view bytes) const;
  tl::unexpected<Fault> echoed() const;
  tl::unexpected<Fault> line_feeds_come() const;
  [[nodiscard]] int factory_id() const;

  // ---- driver_restart.cpp
  RestartWatch::Ways ways_of_watch();
  void restarted(std::string_view how_it_shows, unsigned moved);

  // ---- driver_poll.cpp
  void show_worst();

  // ---- driver_threads.cpp
  Task<Result<>> read_at_rest();
  Task<Result<>> set_variable(const intent::SetVariable& wish);

  // ---- driver_perform.cpp
  Task<Result<>> set_param(intent::SetParam wish);
  Task<Result<>> read_params(std::string only);
  Task<Result<>> read_again();

  const Console console_;
  Conversation talk_;
  CodeAtWork code_;
  BorrowedSetting borrowed_;
  SetUp setup_;
  MoveList list_;
  Readouts readouts_;
  RestartWatch watch_;
  Motions motions_;
  MotionStatus status_;
  Threads threads_;
  Lines lines_;
  Moves moves_;
  Feed feed_;
  Actions actions_;
  LiveStatus live_;
  StoredLines stored_;
  Programs programs_;
  AfterSilence silence_;
  Stops stops_;
  Texts texts_;

  bool name_told_ = false, slow_told_ = false;
  Instant lost_at_{};
  int round_ = 0;
};

}  // namespace hw::arcus
