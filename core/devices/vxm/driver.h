#pragma once
// The VXM from the console's side. Its parts:
//   conversation.h      questions and answers         nameplate.h  what it is
//   signals.h           limits, inputs, outputs       parameters.h values of set and get, storing
//   slots.h             what its five programs hold   greeting.h   what answers at first
//   scratch.h           the one of its own moves      hold.h       whether H is on
//   sight.h             which motors turn             speeds.h     S, and whose it is
//   presence.h          whether and how it listens    restarts.h   what a restart leaves
//   job.h, under_way.h  what goes on in it            ramp.h       what D has told to slow down
//   positions.h         where the motors are          status.h     what V tells
//   kills.h             K                             hold_switch.h  H
//   knowledge.h         what is read once             echo.h       one that echoes
//   admission.h         what it may do now            headline.h   what needs attention most
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
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/driver.h"
#include "core/devices/vxm/admission.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/echo.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/hold_switch.h"
#include "core/devices/vxm/job.h"
#include "core/devices/vxm/kills.h"
#include "core/devices/vxm/knowledge.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/restarts.h"
#include "core/devices/vxm/scratch.h"
#include "core/devices/vxm/sight.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/status.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

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
  Task<Result<>> found_local(char state);
  Task<Result<>> resume_after_loss(char state);

  // ---- driver_poll.cpp
  Task<Result<>> poll_on_line(Round round);
  Task<Result<>> poll_echoing();
  Task<Result<>> see_whether_it_stands();
  Task<Result<>> poll_local();

  // ---- driver_moves.cpp
  Task<Result<>> move(const std::vector<AxisTarget>& targets, Pps speed, bool relative);
  Task<Result<>> jog(const intent::JogStart& jog);
  Task<Result<>> home(const intent::Home& home);
  Task<Result<>> set_position(const intent::SetPosition& wish);
  Task<Result<>> set_output(const intent::SetOutput& wish);
  Result<int> checked_speed(Pps speed) const;
  Result<> may_move_all(const std::vector<AxisTarget>& targets, bool relative) const;
  Result<std::vector<AxisTarget>> checked_goals(const std::vector<AxisTarget>& targets, bool relative);
  void add_leg(Job& job, const AxisTarget& goal, int speed, bool relative) const;
  Leg jog_leg(int axis, Sign sign, int speed) const;

  // ---- driver_legs.cpp
  Task<Result<>> settle();
  Task<Result<>> begin(Job job);
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
  Task<Result<>> ramp_down();
  Task<Result<>> stop_program(const StopOrder& order);
  Task<Result<>> stop_unknown();
  void show_stopping();
  void look_what_ended_the_run();
  [[nodiscard]] bool looks_for_switches(int slot, int motor) const;

  // ---- driver_run.cpp
  Task<Result<>> run(int slot);
  Task<Result<>> pause();
  Task<Result<>> resume();
  Task<Result<>> single_step();
  [[nodiscard]] bool may_turn(int slot, int motor) const;

  // ---- driver.cpp
  Task<Result<>> perform_program(const IntentBody& body);
  static int slot_of(const IntentBody& body);
  Task<Result<>> read_again();

  // ---- its parts
  const Console console_;
  Conversation talk_;
  Nameplate nameplate_;
  Signals signals_;
  Parameters parameters_;
  Slots slots_;
  Scratch scratch_;
  Sight sight_;
  Speeds speeds_;
  Hold hold_;
  Knowledge knowledge_;
  Presence presence_;
  Ramp ramp_;
  UnderWay under_way_;
  Positions positions_;
  Headline headline_;
  Kills kills_;
  HoldSwitch hold_switch_;
  Admission admission_;
  Restarts restarts_;
  Status status_;
  Echo echo_;

  int round_ = 0;
  Instant round_began_{};
};

}  // namespace hw::vxm
