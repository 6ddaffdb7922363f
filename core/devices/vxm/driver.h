#pragma once
// The VXM from the console's side. Its parts:
//   conversation.h      questions and answers         nameplate.h  what it is
//   signals.h           limits, inputs, outputs       parameters.h values of set and get, storing
//   slots.h             what its five programs hold   greeting.h   what answers at first
//   scratch.h           the one of its own moves      hold.h       whether H is on
//   sight.h             which motors turn             speeds.h     S, and whose it is
// and, with what goes on in the controller as their common state, one subject per file:
//   driver_talk.cpp     what comes unasked
//   driver_text.cpp     raw text of users and scripts
//   driver_connect.cpp  getting it to listen, power-cycles, lost wires
//   driver_poll.cpp     the round of status
//   driver_moves.cpp    moves, jogs, homing, zero, outputs: what they consist of
//   driver_legs.cpp     how each is carried out: runs of a program that nobody uses
//   driver_stop.cpp     stops (decision V102), and what shows of them
//   driver_run.cpp      run, hold, step
//   driver.cpp          what it is made of; perform(): what can be asked of it
#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/device/driver.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/scratch.h"
#include "core/devices/vxm/sight.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/text_pieces.h"

namespace hw::vxm {

/// The answer to K, or to what is asked in a hurry beside it.
inline constexpr Duration kill_patience = Millis(300);

std::unique_ptr<Driver> make_driver(DriverContext context);

class VxmDriver final : public Driver {
 public:
  explicit VxmDriver(DriverContext context);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  StopProgress stop_progress(const StopOrder& order) override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  [[nodiscard]] bool clears_up() const override;
  [[nodiscard]] std::string leaves_behind() const override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override { return Millis(200); }

 private:
  // ---- what the driver knows beside the snapshot

  /// One run of the console's own: at most one index (or a pair on two controllers), so that D always ends
  /// it.
  struct Leg {
    std::string text;  ///< stored commands, each with its end
    int axis = -1, second_axis = -1;
    Activity activity = Activity::idle;  ///< idle: switches or sets something, moves nothing
    Sign sign = Sign::plus;
    std::optional<Steps> target;
    int speed = 0;                ///< 0: as the controller is set
    std::optional<Trust> zeroes;  ///< ends with its axis called zero: for this reason
  };
  /// The legs of one intent; the first is under way.
  struct Job {
    std::deque<Leg> legs;
    bool jog = false;                     ///< starts again at the end of its bounded index
    EndedBy ended_by = EndedBy::nothing;  ///< why it was cut short
    bool leg_over = false;                ///< prompt seen or missed; positions still to be read
    bool limit_reported = false;
    bool cut_whole = false;     ///< the stop has cut off nothing but this leg
    bool end_is_asked = false;  ///< somebody who has stopped it in words of his own waits for its prompt
    [[nodiscard]] bool active() const { return !legs.empty(); }
    [[nodiscard]] bool has_more() const { return jog || legs.size() > 1; }
  };
  /// Unknown until it has been asked on this wire.
  enum class Mode : std::uint8_t { unknown, on_line, local };
  /// What D has told to slow down, as far as it shows.
  struct Ramp {
    Instant began{};
    double from = 0;        ///< steps/s, the most
    bool holds = false;     ///< of a program: nothing is to begin in it, as far as is known
    double slowest = from;  ///< since then
    Instant looked_at{};
    double speed = 0;       ///< when it was looked at; of the fastest motor that can be seen
    bool over = false;      ///< what it was to stop stands
    bool reversed = false;  ///< a motor has turned round since: what is held does not
  };

  // ---- driver_talk.cpp
  void heard(const Message& message);
  void heard_prompt();
  void heard_held(std::string_view command);
  void heard_error(char letter);
  void heard_limit();
  // ---- driver_text.cpp
  struct RawAnswer {
    std::string text;
    std::optional<Fault> fault;    ///< what ended it; `text` is what was answered before
    std::string dropped;           ///< a sentence about commands that the controller's state drops
    bool last_is_dropped = false;  ///< no prompt of it will come
  };
  Task<Result<>> send_text(std::string text);
  Result<> may_send(const std::vector<TextCommand>& commands) const;
  Task<RawAnswer> send_pieces(std::string text, Duration patience, Priority priority);
  Task<Result<std::string>> converse(std::string text, Duration patience, Priority priority);
  Task<Result<std::string>> stop_by_words(const StopOrder& order);
  void warn_of_flaws(const std::vector<TextCommand>& commands);
  void note_taken(const Piece& piece);
  void note_taken(const TextCommand& command);
  void note_letter(char letter);
  std::string cut_behind_stop(std::string& text) const;
  [[nodiscard]] Listening listening() const;

  // ---- driver_connect.cpp
  Task<Result<std::string>> ask_who_listens();
  Task<Result<>> find_out_all();
  Task<Result<>> greet();
  Task<Result<>> end_echo(char state);
  Task<Result<>> hear_without_echo();
  Task<Result<>> go_on_line();
  Task<Result<>> found_local(char state);
  Task<Result<>> found_left_local();
  Task<Result<>> found_restarted(const char* why);
  Task<Result<>> resume_after_loss(char state);
  void count_restart(const char* why, bool was_moving, const std::optional<Digitized>& places);
  Task<Result<>> found_reset_on_line();
  void forget_what_ran();
  void stands_after_restart(Doubt why);
  void forget_ram();

  // ---- driver_poll.cpp
  Task<Result<>> ask_whether_it_hears_again();
  Task<Result<>> poll_on_line(Round round);
  Task<Result<>> poll_echoing();
  Task<Result<>> see_whether_it_stands();
  Task<Result<>> poll_local();
  Task<Result<>> read_positions(Priority priority, bool at_rest, bool and_a_signal = false);
  Task<Result<>> take_state(char state);
  Task<Result<>> see_to_dirt();
  Task<Result<>> catch_up();
  void show_position(int axis, Steps position);
  void show_worst();
  [[nodiscard]] bool busy() const { return job_.active() || stored_running_; }

  // ---- driver_moves.cpp
  Task<Result<>> move(const std::vector<AxisTarget>& targets, Pps speed, bool relative);
  Task<Result<>> jog(const intent::JogStart& jog);
  Task<Result<>> home(const intent::Home& home);
  Task<Result<>> set_position(const intent::SetPosition& wish);
  Task<Result<>> set_output(const intent::SetOutput& wish);
  Result<> may_move(int axis) const;
  Result<> may_run() const;
  Result<int> checked_speed(Pps speed) const;
  Result<> may_move_all(const std::vector<AxisTarget>& targets, bool relative) const;
  Result<std::vector<AxisTarget>> checked_goals(const std::vector<AxisTarget>& targets, bool relative);
  void add_leg(Job& job, const AxisTarget& goal, int speed, bool relative) const;
  Leg jog_leg(int axis, Sign sign, int speed) const;
  void warn_of_motor_type(int axis);

  // ---- driver_legs.cpp
  Task<Result<>> settle();
  Task<Result<>> begin(Job job);
  void forget_how_it_ended();
  Task<Result<>> start_leg();
  Result<> never_begun(const Result<>& why);
  Task<Result<>> run_quickly(Leg leg);
  Task<Result<>> end_leg(Priority priority);
  Result<> cut_short() const;
  Task<Result<>> restore_speeds();
  std::string leg_program(const Leg& leg);
  EndedBy how_it_ended(const Leg& leg) const;
  void show_leg(const Leg& leg);
  void show_leg_ended(const Leg& leg, EndedBy ended_by);
  std::optional<Leg> next_jog_leg(const Leg& last, EndedBy ended_by) const;

  // ---- driver_stop.cpp
  Task<Result<>> send_stop(const StopOrder& order);
  Task<Result<>> stop_blind(const StopOrder& order);
  Task<Result<>> stop_local();
  Task<Result<>> stop_leg(const StopOrder& order);
  void expect_ramp();
  Task<Result<>> ramp_down();
  Task<Result<>> stop_program(const StopOrder& order);
  Task<Result<>> stop_unknown();
  [[nodiscard]] bool moves_for(const StopOrder& order) const;
  void show_stopping();
  void drop_later_legs(int axis);
  void note_stop();
  StopProgress watch_the_ramp();
  StopProgress watch_the_program();
  [[nodiscard]] bool stands_since_ramp() const;
  [[nodiscard]] bool seems_to_stand() const;
  [[nodiscard]] bool some_are_hidden() const;
  bool goes_on(const StopProgress& progress);
  bool has_begun_anew();
  Task<Result<>> kill(bool standing, Priority priority = Priority::stop);
  Task<Result<>> settle_hold();
  void kill_not_confirmed(EndedBy ended_by);
  void killed(EndedBy ended_by = EndedBy::abort);
  void doubt_positions();
  void all_are_zero();
  void run_ended(EndedBy ended_by);
  void look_what_ended_the_run();
  [[nodiscard]] bool looks_for_switches(int slot, int motor) const;

  // ---- driver_run.cpp
  Result<> may_change() const;
  Task<Result<>> run(int slot);
  void program_has_begun_a_way(bool reversed);
  Result<> may_switch_hold() const;
  Task<Result<>> pause();
  Task<Result<>> switch_hold(std::string text, bool on, Priority priority);
  Task<Result<>> resume();
  Task<Result<>> single_step();
  void show_running(int slot);
  [[nodiscard]] bool may_turn(int slot, int motor) const;

  // ---- driver.cpp
  Task<Result<>> perform_program(const IntentBody& body);
  static int slot_of(const IntentBody& body);
  Task<Result<>> read_again();
  Task<Result<>> reset();

  // ---- its parts
  const Console console_;
  Scheduler& scheduler_;
  Snapshot& draft_;
  Event news_;
  Conversation talk_;
  Nameplate nameplate_;
  Signals signals_;
  Parameters parameters_;
  Slots slots_;
  Scratch scratch_;
  Sight sight_;
  Speeds speeds_;
  Hold hold_;

  // ---- what goes on in the controller
  Mode mode_ = Mode::unknown;
  bool connected_before_ = false, stay_local_ = false;
  bool lost_while_busy_ = false;

  Job job_;
  bool stored_running_ = false;
  bool reset_said_ = false;       ///< res by a text of the user's; its restart has not been seen
  bool restart_counted_ = false;  ///< it has not been seen on-line since
  bool left_local_ = false;       ///< a stop has put it on-line; nobody has counted that yet
  char halted_ = 0;               ///< letter of the error that waits for K
  Instant ask_again_at_{};
  std::optional<Ramp> ramp_;
  std::array<bool, max_motors> type_warned_{};

  int round_ = 0;
  Instant round_began_{};
  std::optional<int> ended_run_;  ///< its slot: its end was seen, the switches have not been read since

  bool echo_told_ = false;
  Instant killed_at_{};
};

}  // namespace hw::vxm
