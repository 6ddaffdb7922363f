#pragma once
// The VME58 from the console's side. One subject per file:
//   driver_talk.cpp        the rings: commands in, replies out
//   driver_rejections.cpp  what the board rejects, at once or late
//   driver_mailbox.cpp     urgent commands past everything that waits (decision M29)
//   driver_stops.cpp       stops: what is sent, and what shows that it takes effect
//   driver_connect.cpp     finding the board, saying why not, resets
//   driver_poll.cpp        registers and data area, and what they mean
//   driver_servo.cpp       servo axes: places, loops, and what may close one
//   driver_samples.cpp     recordings of one axis
//   driver_ask.cpp         what a round asks by command: flags, slips, queues
//   driver_moves.cpp       moves, jogs, homing, positions, power, outputs
//   driver_speeds.cpp      the speed of an axis, and that of one move; how long a slow one may show nothing
//   driver_params.cpp      set-up
//   driver_text.cpp        raw text of users and scripts
//   driver_program.cpp     command strings that the console holds and feeds
//
// The board has one command ring and one addressed axis for everybody. What the console sends begins with the
// axis that it means and ends with the one that the user's own text has selected.
#include <array>
#include <bitset>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/driver.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/commands.h"
#include "core/devices/vme58/mailbox.h"
#include "core/devices/vme58/parameters.h"
#include "core/devices/vme58/servo_place.h"
#include "core/motion/servo_watch.h"

namespace hw::vme58 {

std::unique_ptr<Driver> make_driver(DriverContext context);

class Vme58Driver final : public Driver, private Readings::Listener {
 public:
  explicit Vme58Driver(DriverContext context);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  StopProgress stop_progress(const StopOrder& order) override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override;

 private:
  /// A setting that is written for one motion, and put back behind it.
  struct Borrowed {
    std::int64_t before, for_now;
    bool left_alone = false;    ///< a lost window or an emptied queue came between: what is there is right,
                                ///< unless it is `for_now`
    bool waits_behind = false;  ///< `before` was put into the queue behind the motion already
  };
  /// A VL that text or set-up has put into a queue, where it may still wait.
  struct PutVelocity {
    std::int64_t value;
    bool carried_out = false;  ///< the queues were seen empty since: what is read next is right
  };
  /// Of a servo axis.
  struct ServoMind {
    ServoPlace place;
    std::optional<bool> closed;  ///< its loop, as EA, HN or HF have told; none: not known
    bool goes_to_place = true;   ///< its motion is to end somewhere: no jog, and not cut short by a stop
    bool settling = false;       ///< such a motion was seen, and nobody has said yet how it ended
  };
  /// What the speed of an axis shows since it was told to stop.
  struct SlowDown {
    Instant since{};      ///< first seen turning then
    Instant slower_at{};  ///< it has lost speed, or was told again
    std::int64_t first = 0, least = 0;
  };
  /// What a motion to the home switch does there.
  enum class AtHome : std::uint8_t { nothing, sets_counter, stops_dead };
  /// What the console knows of an axis beside the snapshot.
  struct AxisMind {
    Activity wanted = Activity::idle;     ///< what our last command began
    EndedBy ended_by = EndedBy::nothing;  ///< why we ended it, if we did
    bool ours = false;                    ///< a motion of the console is under way
    unsigned group = 0;                   ///< the axes of its move, when there are several
    bool stopping = false;
    std::optional<SlowDown> slow_down;
    bool done = false;                 ///< its done flag was seen since the motion began
    bool limit_hit = false;            ///< its limit flag, likewise
    bool from_limit = false;           ///< it stood on a switch then, and has not come off it
    bool turned = false;               ///< it has moved since then
    bool counted = false;              ///< the console has set its counter since the last round
    std::int8_t way = 0;               ///< direction of the latest change of position
    std::int8_t limit_end = 0;         ///< of the switch it stands on, once that is known
    std::int8_t letter = 0;            ///< the board's direction letter when that was last judged
    AtHome at_home = AtHome::nothing;  ///< of its motion
    bool by_text = false;              ///< a motion of the user's text or program may be under way
    bool in_group = false;             ///< in the queue of AA or AM something may wait that moves it
    bool listed = false;      ///< a list of AA or AM may have prepared a motion that their next GO begins
    bool asks_queue = false;  ///< it rests without a reason: its queue tells whether it has ended
    Duration jog_gap{};       ///< of a jog: it turns, though so long no count and no velocity may show it
    Instant creeps_until{};   ///< and so it is taken to turn until then
    Instant still_since{};
    ServoMind servo;
    std::optional<Borrowed> velocity;  ///< VL, while a move with a speed of its own has another there
    std::optional<PutVelocity> put_velocity;
  };
  void registers_read(const Registers& registers) override;
  void axes_read(int whole, Instant at) override;
  void queued_was_rejected(std::string& words);
  [[nodiscard]] std::string rejected_late() const;
  Task<Result<>> end_rejected(std::string what);
  void forget_rejection();

  // ---- driver_stops.cpp
  Task<Result<>> stop_motion(int axis, bool at_once, bool jog);
  Task<Result<>> stop_by_text(std::string text);
  Task<Result<bool>> stop_axis(std::string selector);
  Task<Result<>> stop_all(std::string_view word);
  [[nodiscard]] bool stops_alone(int axis) const;
  void stopping(int axis, bool at_once);
  void stands(int axis);
  Task<Result<>> look_at_queues_after_stop();
  void is_anothers(int axis);
  SlowDown& slow_down(int axis);
  [[nodiscard]] Duration effect_patience(int axis, const SlowDown& slow_down) const;
  [[nodiscard]] Duration longest_ramp(int axis, const SlowDown& slow_down) const;
  void stopped_in_vain(int axis);
  void doubt_killed_positions();
  void doubt_killed_position(int axis, double speed);

  // ---- driver_connect.cpp
  Task<Result<>> find_board();
  Task<Result<>> identify();
  Task<Result<>> read_state();
  Task<Result<>> forget_others_units();
  void tell_other_jumpers();
  Task<Result<>> leave_mark();
  Task<Result<>> found_reset(Doubt why);
  Task<Result<>> reset_by_text(std::string text);
  Task<Result<>> reset();
  Task<Result<>> starts_again(std::string_view how);
  void lose_motions();
  void forget();

  // ---- driver_poll.cpp
  Task<Result<>> read_more(Registers registers);
  void take_parameters(int axis);
  void show_axis(int axis, Instant at);
  void show_still(int axis, Instant at);
  void show_limits(int axis);
  void end_motion(int axis, EndedBy ended_by);
  void trusted(int axis, Trust how) { draft_.axes[axis].trust.settle(how, now()); }
  void comes_home(int axis);
  void show_worst();
  void record_round();
  [[nodiscard]] std::int64_t value(int axis, AxisValue v) const { return readings_.value(axis, v); }
  [[nodiscard]] bool moving(int axis) const { return readings_.moving(axis); }
  [[nodiscard]] static bool met_limit(const AxisMind& mind);

  // ---- driver_servo.cpp
  void show_place(int axis, Instant at, bool turns);
  [[nodiscard]] bool settles(int axis) const;
  EndedBy judged(int axis, EndedBy ended_by);
  void begins_to_settle(int axis);
  void know_loop(int axis, std::optional<bool> closed);
  [[nodiscard]] std::int64_t deadband(int axis) const;
  [[nodiscard]] std::optional<std::int64_t> known_param(int axis, std::string_view letters) const;
  [[nodiscard]] bool driven(int axis) const;
  Task<Result<>> may_close(int axis, intent::Closing answer, std::string state, std::string consequence);
  Task<Result<>> may_drive(const Parameter& parameter, std::int64_t value, intent::Closing answer);
  Task<Result<>> take_place(int axis);
  Task<Result<>> load_positions(int axis, Steps value);
  bool warn_of_closing(const TextCommand& command);

  // ---- driver_samples.cpp
  [[nodiscard]] bool sampling() const;
  void sample(Instant at);
  [[nodiscard]] std::optional<motion::ServoGains> known_gains(int axis) const;

  // ---- driver_ask.cpp
  Task<Result<>> read_flags(Priority priority);
  Task<Result<>> read_slips();
  Task<Result<>> read_loops(Priority priority);
  Task<Result<>> read_done();
  Task<Result<>> read_queues(Priority priority);
  Task<Result<bool>> is_worked_off();
  Task<Result<>> ask_in_turn();
  void show_full_queue();
  void take_done(unsigned axes);
  void take_queues(bool were_empty);
  [[nodiscard]] bool wants_done() const;

  // ---- driver_moves.cpp
  Task<Result<>> move(std::vector<AxisTarget> wish, Pps speed, bool relative);
  Task<Result<>> jog(intent::JogStart wish);
  Task<Result<>> begin_jog(std::string text, int axis);
  Task<Result<>> home(intent::Home wish);
  Task<Result<>> set_position(intent::SetPosition wish);
  Task<Result<>> set_power(intent::SetPower wish);
  Task<Result<>> switch_loop(int axis, bool on, intent::Closing answer);
  Task<Result<>> set_output(intent::SetOutput wish);
  Task<Result<>> act(intent::Act wish);
  Task<Result<>> begin(std::string text, unsigned axes, Activity activity,
                       std::array<Steps, max_axes> targets);
  Result<> may_move(int axis) const;
  Result<std::int64_t> checked_speed(Pps speed) const;

  // ---- driver_speeds.cpp
  Task<Result<>> read_velocity(int axis, Priority priority);
  Task<Result<>> borrow_velocity(int axis, std::int64_t speed);
  Task<Result<>> give_speed_back(int axis, Priority priority);
  Task<Result<>> give_speeds_back(Priority priority);
  Task<Result<>> give_speeds_behind_motions(Priority priority);
  void note_velocity(const TextCommand& command);
  void forget_put_velocities(int axis);
  [[nodiscard]] std::int64_t velocity_of(int axis) const;
  /// VL as the user has it, also while a move with a speed of its own has put another there, or while it
  /// waits in a queue.
  [[nodiscard]] std::int64_t own_velocity_of(int axis) const;
  void begins_to_creep(int axis, Duration gap);
  [[nodiscard]] Duration rest_patience(int axis) const;
  [[nodiscard]] Duration jog_gap(int axis, double speed) const;

  // ---- driver_params.cpp
  Task<Result<>> set_param(intent::SetParam wish);
  Task<Result<>> read_params();
  void factory_params();
  void note_param(const TextCommand& command);
  void know_param(std::size_t place, std::int64_t value);
  void note_fraction(const ParameterFact& fact, std::int64_t value);

  // ---- driver_text.cpp
  Task<Result<>> send_text(std::string text);
  Task<Result<std::string>> send_commands(std::string text, Duration patience);
  Task<Result<>> put_command(const TextCommand& command, std::string word);
  Result<> cut_short(const TextCommand& command, Fault why);
  Task<Result<>> accepts(const TextCommand& command);
  void note_stop_of_program(const TextCommand& command);
  void note_sent(const TextCommand& command);
  void note_effects(const TextCommand& command);
  Result<> may_say_while_feeding(const std::vector<TextCommand>& commands) const;
  void note_motion(const TextCommand& command);
  void note_group(const TextCommand& command);

  // ---- driver_program.cpp
  Task<Result<>> perform_program(const IntentBody& body);
  Task<Result<>> load(std::string text);
  Task<Result<>> run_program();
  Task<Result<>> feed();
  [[nodiscard]] std::string fed_text(std::string_view command, const Context& after) const;
  void end_program(EndedBy ended_by);
  Task<Result<>> watch_program();

  [[nodiscard]] int axis_count() const { return static_cast<int>(catalog_.axes.size()); }
  [[nodiscard]] const std::string& axis_name(int axis) const {
    return catalog_.axes[static_cast<std::size_t>(axis)].name;
  }

  [[nodiscard]] Instant now() const { return wire_.now(); }
  void tell(Notice::Kind kind, std::string text) { wire_.tell(kind, std::move(text)); }
  [[nodiscard]] std::string addressed(int axis, std::string_view text) const {
    return selection_.addressed(axis, text);
  }

  const Catalog& catalog_;
  Snapshot& draft_;
  ScriptTexts& texts_;
  std::function<void()> changed_;
  std::function<void(const AxisSample&)> sample_;
  const Variant& variant_;
  const std::vector<Parameter> parameters_;  ///< in the order of the catalog's

  Wire wire_;
  Selection selection_;
  Readings readings_;
  Conversation conversation_;
  Mailbox mailbox_;
  Commands commands_;

  std::array<AxisMind, max_axes> minds_{};

  // mailbox and stops
  bool widened_ = false;       ///< a stop of one axis has become one of all, and they do not stand yet
  bool mailbox_deaf_ = false;  ///< it was acknowledged and nothing was done
  /// What waits in the queues behind a stop of all axes.
  enum class QueuesAfterStop : std::uint8_t { empty, not_known, wait };
  QueuesAfterStop queues_after_stop_ = QueuesAfterStop::empty;
  Instant rests_since_{};  ///< no axis was seen turning since then, or since that stop

  bool connected_before_ = false;
  bool gains_are_whole_ = false;  ///< no gain with a fraction was set since the board's start, as its mark says
  bool mark_due_ = false;         ///< it has to say something else from here on
  int outputs_direction_ = factory_outputs;
  std::uint8_t limits_ = 0, homes_ = 0, slips_ = 0;
  bool flags_wanted_ = false;
  bool loops_wanted_ = false;  ///< an axis did not come to its place: its loop may have opened
  bool queues_due_ = false;    ///< they are asked for as soon as nothing turns
  bool queues_empty_ = false;  ///< all of them, those of AA and AM too, when last asked
  std::uint32_t watched_ = 0;
  int round_ = 0;
  std::string round_text_;  ///< keeps its memory

  int sampled_axis_ = -1;
  Instant sample_until_{};
  motion::ServoWatch servo_watch_;  ///< of the sampled axis

  std::string program_text_;
  std::deque<std::pair<int, std::string>> to_feed_;  ///< line and command
  std::string feeding_;                              ///< sent, not taken yet
  int feeding_line_ = 0;
  Context fed_context_;          ///< of the program, as far as it was put
  Context before_feeding_;       ///< in which `feeding_` is read
  bool fed_apart_ = false;       ///< the user's text has selected an axis meanwhile: each keeps its own
  bool feeding_waits_ = false;   ///< the board did not take it at once
  bool program_flawed_ = false;  ///< a command of it was rejected when its turn came
  std::string rejection_;        ///< why the latest program has ended, if it was that
};

}  // namespace hw::vme58
