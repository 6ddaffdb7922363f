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
// and here what is said and done with them, one subject per file:
//   driver_connect.cpp   finding the device, saying why not
//   driver_perform.cpp   what is asked of it
//   driver_restart.cpp   what is left when it was switched off and on; lost wires
//   driver_poll.cpp      the round of status and what it means
//   driver_threads.cpp   threads, and what is read at rest
//   driver_moves.cpp     moves, jogs, homing, positions, power, outputs
//   driver_actions.cpp   the catalog's actions
//   driver_stop.cpp      stops (decision AMB-128)
//   driver_programs.cpp  load, read, run, pause, halt
//   driver_text.cpp      the user's own text
#include <array>
#include <bitset>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/borrowed_setting.h"
#include "core/devices/arcus/code_at_work.h"
#include "core/devices/arcus/console.h"
#include "core/devices/arcus/conversation.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"
#include "core/devices/arcus/move_list.h"
#include "core/devices/arcus/readouts.h"
#include "core/devices/arcus/restart_watch.h"
#include "core/devices/arcus/second_look.h"
#include "core/devices/arcus/set_up.h"
#include "core/devices/arcus/text_meaning.h"

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
  [[nodiscard]] Duration idle_period() const override { return Millis(200); }

 private:
  /// What the console knows of an axis beside the snapshot.
  struct AxisMind {
    Activity wanted = Activity::idle;     ///< what our last command began
    EndedBy ended_by = EndedBy::nothing;  ///< why we ended it, if we did
    std::int64_t status = 0;
    int loop_state = -1;      ///< -1: not read yet
    Instant loop_asked_at{};  ///< the question that told it
    bool ours = false;        ///< a motion of the console is under way
    bool stopping = false;    ///< a stop was sent
    unsigned with = 0;        ///< a bit for each axis of the same motion
    std::int8_t turned = 0;   ///< direction of the latest change of position
    Instant begun_at{};       ///< when our last command was sent
    Pps top_speed{};          ///< of the motion that it began; 0: not known
  };
  void goes_out(std::string_view command);
  void not_done(std::string_view command);

  // ---- driver_text.cpp
  Task<Result<>> send_text(const intent::SendText& wish);
  Task<Result<std::string>> say_text(std::string text, Priority priority, Duration patience);
  Task<Result<std::string>> stop_by_words(const StopOrder& order);
  void note_done(std::string_view text);
  void note_sent(std::string_view as_typed);
  void note_stop(std::string_view text);

  // ---- driver_connect.cpp
  Task<Result<>> find();
  Task<Result<>> identify();
  Task<Result<Reply>> ask_who_it_is(std::string question, std::function<bool(std::string_view)> is_it);
  void note_how_slow();
  Task<Result<>> read_name();
  Task<Result<>> read_state();
  SetUp::Ways ways_of_set_up();
  void loop_is(int axis, std::int64_t state);
  tl::unexpected<Fault> silent() const;
  tl::unexpected<Fault> garbled(std::string_view bytes) const;
  tl::unexpected<Fault> echoed() const;
  tl::unexpected<Fault> line_feeds_come() const;
  [[nodiscard]] int factory_id() const;

  // ---- driver_restart.cpp
  [[nodiscard]] Pps fastest_way_to_zero(int axis) const;
  RestartWatch::Ways ways_of_watch();
  void may_set(std::string_view command);
  Task<Result<>> look_after_silence();
  Task<Result<>> look_back_over_the_loss();
  void restarted(std::string_view how_it_shows, unsigned moved);

  // ---- driver_poll.cpp
  Task<Result<>> see_whether_it_stands();
  Task<Result<>> read_whole_motion(Priority priority);
  Task<Result<>> read_motion(Priority priority);
  Task<Result<>> read_counters(Priority priority);
  Task<Result<>> read_loop(Priority priority);
  Task<Result<>> read_io(Priority priority);
  Task<> stay_live();
  void take_status(const std::vector<std::int64_t>& words);
  void show_axis(int axis, Instant asked_at);
  void show_ended(int axis);
  void show_worst();
  [[nodiscard]] bool moving(int axis) const;  ///< as shown
  [[nodiscard]] bool runs(int axis) const;    ///< as last read
  [[nodiscard]] bool any_moving() const;
  [[nodiscard]] EndedBy how_it_ended(int axis) const;
  [[nodiscard]] bool misses_its_target(int axis) const;
  [[nodiscard]] std::int64_t loop_tolerance(int axis) const;
  [[nodiscard]] bool loop_error(int axis) const;
  [[nodiscard]] AxisError error_of(int axis) const;

  // ---- driver_threads.cpp
  Task<Result<>> read_at_rest();
  Task<Result<>> read_threads(bool all, Priority priority);
  Task<Result<>> read_thread(int thread, Priority priority);
  Task<Result<>> set_variable(const intent::SetVariable& wish);

  // ---- driver_moves.cpp
  Task<Result<>> move(std::vector<AxisTarget> wish, Pps speed, bool relative);
  Task<Result<bool>> ask_incremental();
  Task<Result<std::int64_t>> ask_position(int axis);
  Task<Result<>> jog(intent::JogStart wish);
  Task<Result<>> home(intent::Home wish);
  Task<Result<>> set_position(intent::SetPosition wish);
  Task<Result<>> set_encoder(intent::SetEncoder wish);
  Task<Result<>> set_power(intent::SetPower wish);
  Task<Result<>> set_output(intent::SetOutput wish);
  [[nodiscard]] std::string who_has(int output) const;
  Task<Result<>> start(std::string text, std::vector<int> axes, Activity activity);
  Task<Result<>> borrow_speed(Pps speed, int axis);
  Task<Result<>> start_feed(intent::FeedMoves wish);
  Task<Result<>> feed();
  Task<Fault> after_doubt(Fault why, std::string_view sent);
  void begun(int axis, Activity activity, Instant at);

  // ---- driver_actions.cpp
  Task<Result<>> act(intent::Act wish);
  Task<Result<>> change_speed(int axis, std::int64_t speed, std::int64_t accel_ms);
  Task<Result<>> change_target(int axis, std::int64_t target);
  Task<Result<>> draw(const ActionInfo& info, std::vector<std::int64_t> values);
  Task<Result<>> clear_errors(std::string_view form, int axis);
  Task<Result<>> joystick(int axis, bool on);

  // ---- driver_stop.cpp
  Task<Result<>> send_stop(const StopOrder& order, Duration patience);
  Task<Result<>> stop_line(bool at_once);
  Task<Result<>> stop_axes(int axis, bool at_once, bool motion_only, Duration patience);
  Task<Result<>> stop_all(std::string word, Duration patience);
  Task<Result<>> halt_thread(int thread, Duration patience);
  Task<Result<>> halt_program(int thread, Duration patience);
  Task<Result<>> release_joystick(int axis, std::string stop);
  [[nodiscard]] bool may_run(int thread) const;
  [[nodiscard]] bool program_runs_on() const;
  [[nodiscard]] StopProgress programs_end(const StopOrder& order) const;
  void stopping(int axis, bool at_once);
  void ended_by_us(int axis, EndedBy why);
  void doubt_killed_position(int axis);
  void stands(int axis);

  // ---- driver_programs.cpp
  Task<Result<>> perform_program(IntentBody body);
  Task<Result<>> load(int program, std::string text);
  Task<Result<>> may_be_program(int program, const language::Program& code);
  Task<Result<>> write_lines(std::vector<std::string> lines);
  Task<Result<>> clear_from(int line);
  Task<Result<std::string>> read_line(int line, Priority priority);
  Task<Result<>> write_line(int line, std::string text);
  Task<Result<>> store_line(int line, std::string text, std::string there);
  Task<Result<std::vector<std::string>>> read_lines();
  void note_stored(const std::vector<std::string>& lines);
  tl::unexpected<Fault> broken_off(Fault why);
  Task<Result<>> upload(int program);
  Task<Result<>> run(int program);
  Task<Result<>> control(int thread, int what);
  void forget_thread(std::string_view text);
  Task<Result<>> control_all(int thread, int what);
  Result<> no_thread_runs() const;
  void show_transfer(int done, int total);

  // ---- driver_perform.cpp
  Task<Result<>> set_param(intent::SetParam wish);
  Task<Result<>> read_params(std::string only);
  Task<Result<>> read_again();
  void program_runs(Duration at_most = std::chrono::seconds(1));

  const Console console_;
  const language::Dialect& dialect_;
  Conversation talk_;
  CodeAtWork code_;
  BorrowedSetting borrowed_;
  SetUp setup_;
  MoveList list_;
  Readouts readouts_;
  RestartWatch watch_;

  std::array<AxisMind, max_axes> minds_{};
  bool halting_ = false;  ///< programs were told to end: whether they have is asked while axes stop

  bool name_told_ = false, slow_told_ = false;
  Instant lost_at_{};
  Instant round_began_{};
  Instant motion_asked_at_{};  ///< the oldest question of the newest round that has been applied
  int round_ = 0;
  SecondLook limits_look_, io_look_;
  bool io_due_ = false;  ///< the user's own text may have switched a motor
  int next_thread_ = 0;
};

}  // namespace hw::arcus
