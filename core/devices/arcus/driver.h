#pragma once
// Both Arcus controllers from the console's side: what differs is in the Forms. One subject per file:
//   conversation.h       questions, commands, what comes unasked
//   driver_text.cpp      the user's own text
//   driver_connect.cpp   finding the device, saying why not
//   driver_restart.cpp   noticing that it was switched off and on; lost wires
//   driver_poll.cpp      the round of status and what it means
//   driver_readouts.cpp  readouts, variables, analog inputs, threads: read in turn, watched ones each round
//   driver_moves.cpp     moves, jogs, homing, positions, power, outputs
//   driver_actions.cpp   the catalog's actions
//   driver_buffer.cpp    feeding a list of moves
//   driver_stop.cpp      stops (decision AMB-128)
//   driver_subroutine.cpp  subroutines called by the host, which no stop ends
//   driver_programs.cpp  load, read, run, pause, halt
//   driver_params.cpp    set-up
#include <array>
#include <bitset>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/driver.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/conversation.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"
#include "core/devices/arcus/second_look.h"
#include "core/devices/arcus/stored_code.h"
#include "core/devices/arcus/text_meaning.h"
#include "core/devices/arcus/unexplained.h"

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
  [[nodiscard]] bool clears_up() const override { return borrowed_.has_value(); }
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
  /// What positions are compared with, to notice that the controller has been switched off and on.
  struct Stood {
    struct Axis {
      Steps position, encoder;
      Pps towards_zero;  ///< by itself it comes to zero at most so fast
      Steps room;        ///< StepNLoop corrects it by so much
      bool moved = false;
    };
    std::array<Axis, max_axes> axes{};
    Instant seen_at{};
    std::uint64_t misses = 0;  ///< answers that had not come until then
    bool program_ran = false;
  };
  /// What had gone out when a round of status began.
  struct Look {
    Unexplained::Mark counters, targets, motors;
  };
  /// A setting that is written for one motion, and put back behind it.
  struct Borrowed {
    std::string name;
    std::int64_t before, for_now;
    bool left_alone = false;  ///< through a lost wire: whoever has set it since is right
  };
  /// A subroutine that the host has called, and that moves something or may.
  struct Called {
    int number;
    std::optional<Duration> rests;  ///< it is over when nothing has moved for so long
    bool told = false;
  };

  void tell(Notice::Kind kind, std::string text);
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
  tl::unexpected<Fault> silent() const;
  tl::unexpected<Fault> garbled(std::string_view bytes) const;
  tl::unexpected<Fault> echoed() const;
  tl::unexpected<Fault> line_feeds_come() const;
  [[nodiscard]] int factory_id() const;

  // ---- driver_restart.cpp
  [[nodiscard]] Pps fastest_way_to_zero(int axis) const;
  [[nodiscard]] Stood where_all_stand() const;
  void may_set(std::string_view command);
  [[nodiscard]] Look begin_look() const;
  void look_at_counters(const Look& look, bool was_silent = false);
  Task<Result<>> look_after_silence();
  Task<Result<>> read_whole_motion(Priority priority);
  Task<Result<>> look_at_motors(Unexplained::Mark asked);
  Task<Result<bool>> power_up_leads_here();
  Task<Result<bool>> something_is_kept();
  Task<Result<>> look_at_start(int thread, Priority priority);
  [[nodiscard]] bool programs_switch_motors() const;
  Task<Result<>> look_back_over_the_loss();
  void restarted(std::string_view how_it_shows, const std::optional<Stood>& before);

  // ---- driver_poll.cpp
  Task<Result<>> see_whether_it_stands();
  Task<Result<>> read_motion(Priority priority);
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

  // ---- driver_readouts.cpp
  Task<Result<>> read_watched();
  Task<Result<>> read_in_turn();
  Task<Result<>> read_readout(int index, Priority priority);
  Task<Result<>> read_variable(int number, Priority priority);
  Task<Result<>> read_analog(int number, Priority priority);
  Task<Result<>> read_threads(bool all, Priority priority);
  Task<Result<>> read_thread(int thread, Priority priority);
  Task<Result<>> set_variable(const intent::SetVariable& wish);
  void put_readout(std::string_view id, std::int64_t value);
  void find_readouts_told_by_status();

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
  Task<Result<>> borrow(std::string name, std::int64_t value);
  Task<Result<>> borrow_speed(Pps speed, int axis);
  Task<Result<>> give_back();
  Task<Result<>> give_back_first();
  Task<Fault> after_doubt(Fault why, std::string_view sent);
  Result<> may_move_axis(int axis) const;
  void begun(int axis, Activity activity, Instant at);

  // ---- driver_actions.cpp
  Task<Result<>> act(intent::Act wish);
  Task<Result<>> change_speed(int axis, std::int64_t speed, std::int64_t accel_ms);
  Task<Result<>> change_target(int axis, std::int64_t target);
  Task<Result<>> draw(const ActionInfo& info, std::vector<std::int64_t> values);
  Task<Result<>> clear_errors(std::string_view form, int axis);
  Task<Result<>> joystick(int axis, bool on);

  // ---- driver_buffer.cpp
  Task<Result<>> start_feed(intent::FeedMoves wish);
  Task<Result<>> feed();
  void end_feed();

  // ---- driver_stop.cpp
  Task<Result<>> send_stop(const StopOrder& order);
  Task<Result<>> stop_line(bool at_once);
  Task<Result<>> stop_axes(int axis, bool at_once, bool motion_only);
  Task<Result<>> stop_all(std::string word);
  Task<Result<>> halt_thread(int thread, Duration patience);
  Task<Result<>> halt_program(int thread);
  Task<Result<>> release_joystick(int axis, std::string stop);
  [[nodiscard]] bool may_run(int thread) const;
  [[nodiscard]] bool program_runs_on() const;
  [[nodiscard]] StopProgress programs_end(const StopOrder& order) const;
  void stopping(int axis, bool at_once);
  void ended_by_us(int axis, EndedBy why);
  void doubt_killed_position(int axis);
  void stands(int axis);

  // ---- driver_subroutine.cpp
  void note_call(std::string_view text);
  [[nodiscard]] Duration longest_run(std::string_view call) const;
  [[nodiscard]] bool subroutine_may_run();
  StopProgress outlast_subroutine(const StopOrder& order, bool turns);

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

  // ---- driver_params.cpp
  Task<Result<>> set_param(intent::SetParam wish);
  Task<Result<>> read_param(int index, Priority priority);
  Task<Result<>> read_params(std::string only);
  Task<Result<>> read_again();
  Task<Result<>> read_what_power_keeps();
  int next_that_would_show();
  [[nodiscard]] bool in_ram_only(int index) const;
  void compare_with_stored(int index);
  void program_runs(Duration at_most = std::chrono::seconds(1));
  Task<Result<>> store();
  void is_stored();
  void forget_params(std::string_view head);
  void changed_param(int index);
  [[nodiscard]] std::optional<std::int64_t> param(std::string_view mnemonic) const;
  [[nodiscard]] std::optional<std::int64_t> setting(Setting id, int axis = 0) const;
  [[nodiscard]] std::optional<bool> has_own_speeds(int axis) const;
  [[nodiscard]] std::int64_t start_speed(int axis) const;
  void show_own_speeds();
  [[nodiscard]] const SettingFact* fact_of(int param) const;

  [[nodiscard]] const Model& model() const { return *forms_.model; }
  [[nodiscard]] int axis_count() const { return model().axes(); }
  [[nodiscard]] std::string axis_name(int axis) const;

  Scheduler& scheduler_;
  const Catalog& catalog_;
  Snapshot& draft_;
  ScriptTexts& texts_;
  std::function<void(Notice)> notify_;
  std::function<void()> changed_;
  const Forms& forms_;
  const language::Dialect& dialect_;
  Conversation talk_;

  std::array<AxisMind, max_axes> minds_{};
  Unexplained counters_, motors_;  ///< of positions and encoders; of motor power
  Unexplained targets_;            ///< of positions that are put where the encoder stands
  std::uint64_t motion_misses_ = 0;  ///< when the first of the latest answers about motion had come
  std::optional<Stood> stood_;     ///< when last looked at
  std::optional<std::int64_t> motors_on_;
  std::optional<Stood> zero_in_doubt_;  ///< since then all counters have come to zero, nobody saw how
  bool incremental_ = false;
  std::optional<Borrowed> borrowed_;
  std::deque<std::vector<std::int64_t>> to_feed_;
  int buffer_free_ = 0;
  bool buffer_on_ = false;
  bool halting_ = false;  ///< programs were told to end: whether they have is asked while axes stop

  bool name_told_ = false, slow_told_ = false;
  Instant lost_at_{};
  Instant round_began_{};
  Instant motion_asked_at_{};  ///< the oldest question of the newest round that has been applied
  int round_ = 0;
  SecondLook limits_look_, io_look_;
  bool io_due_ = false;  ///< the user's own text may have switched a motor
  std::uint32_t watched_ = 0;
  std::optional<StoredCode> stored_code_;  ///< not known: not looked, or foreign code
  std::optional<Called> called_;
  std::optional<Called> called_before_;    ///< the last text that went out, should it be refused
  std::uint64_t outlasted_stop_ = 0;  ///< the stop that watches it
  Instant stood_at_{};                ///< since that stop
  Instant moved_at_{};                ///< when an axis was last seen to move, or may have
  int next_readout_ = 0, next_variable_ = 0, next_analog_ = 0, next_param_ = 0, next_thread_ = 0,
      next_kept_ = 0;
  std::array<std::int64_t, max_params> after_power_up_{};  ///< of what is stored: as it was then
  std::bitset<max_params> stored_known_;                   ///< of what is stored: after_power_up_ was read
  bool unsaved_variables_ = false;                         ///< some were set and not stored
  std::bitset<max_params> nobody_sets_;  ///< read, and nothing has run since that may have set them
  Instant programs_run_until_{};         ///< of those that were seen or started
  std::vector<bool> by_status_;          ///< readouts that the status tells
};

}  // namespace hw::arcus
