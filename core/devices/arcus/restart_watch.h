#pragma once
// Noticing that the controller was switched off and on: by its counters, its motor power, a program that
// runs, and what it has lost (set_up.h).
#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "core/devices/arcus/code_at_work.h"
#include "core/devices/arcus/conversation.h"
#include "core/devices/arcus/set_up.h"
#include "core/devices/arcus/unexplained.h"

namespace hw::arcus {

class RestartWatch {
 public:
  /// What is known of an axis beside the snapshot.
  struct AxisNow {
    bool runs = false, moving = false;
    bool to_encoder = false;   ///< its stop under StepNLoop ends where the encoder stands, by its count too
    Pps towards_zero;          ///< by itself it comes to zero at most so fast
    Steps room;                ///< StepNLoop corrects it by so much
    bool leaves_zero = false;  ///< it comes to rest elsewhere, unless it is stopped
  };
  struct Ways {
    std::function<AxisNow(int axis)> axis_now;
    /// `moved`: a bit for each axis that was on its way.
    std::function<void(std::string_view how_it_shows, unsigned moved)> restarted;
  };
  /// What had gone out when a round of status began.
  struct Look {
    Unexplained::Mark counters, targets, motors;
  };
  RestartWatch(const Console& console, Conversation& talk, const CodeAtWork& code, SetUp& setup, Ways ways)
      : console_(console), talk_(talk), code_(code), setup_(setup), ways_(std::move(ways)) {}

  /// Whatever goes out, before it does: a change that it explains is no power-cycle.
  void goes_out(std::string_view command);
  void counters_may_be_set() { counters_.may_be_set(); }
  /// It has confirmed these.
  void was_sent_to(int axis, Steps target);
  void jogs(int axis, Sign way);
  void position_was_set(int axis, Steps position);
  void encoder_was_set(int axis, Steps position);
  /// What has gone out explains no zero any more; a position that is put where the encoder stands is another
  /// matter.
  void settle() { counters_.settle(); }

  [[nodiscard]] Look begin_look() const { return {counters_.ask(), targets_.ask(), motors_.ask()}; }
  /// The first of the answers about motion; and whether all that was asked behind it has been answered.
  void first_answer_came() { motion_misses_ = talk_.misses(); }
  [[nodiscard]] bool motion_is_whole() const { return talk_.misses() == motion_misses_; }
  void look_at_counters(const Look& look, bool was_silent = false);
  Task<Result<>> look_at_motors(const Look& look);
  Task<Result<>> look_at_start(int thread, Priority priority);

  /// All counters have come to zero, and nobody saw how: look at the motors.
  [[nodiscard]] bool in_doubt() const { return zero_in_doubt_.has_value(); }
  /// An answer was missing since the last look.
  [[nodiscard]] bool was_silent() const { return stood_ && stood_->misses != talk_.misses(); }
  [[nodiscard]] bool has_looked() const { return stood_.has_value(); }
  [[nodiscard]] bool program_ran() const { return stood_ && stood_->program_ran; }
  void forget();

 private:
  /// What positions are compared with.
  struct Stood {
    struct Axis {
      Steps position, encoder;
      AxisNow then;
      bool sent_away = false;      ///< from zero, and not stopped since
      bool may_have_left = false;  ///< something was sent that may move it, or it was stopped on its way
    };
    std::array<Axis, max_axes> axes{};
    Instant seen_at{};
    std::uint64_t misses = 0;  ///< answers that had not come until then
    bool program_ran = false;
    [[nodiscard]] unsigned moved() const;
  };
  /// Between two looks, of one axis or of any.
  struct Change {
    bool nearer = false;         ///< to zero than it comes by what is known of it
    bool may_be_nearer = false;  ///< it was on its way there, or was stopped on its way from there
    bool jumped = false;         ///< farther than it goes in the time
    void add(const Change& other) {
      nearer = nearer || other.nearer;
      may_be_nearer = may_be_nearer || other.may_be_nearer;
      jumped = jumped || other.jumped;
    }
  };
  static Change change_of(const AxisState& now, const Stood::Axis& before, double elapsed_s,
                          bool targets_stay);
  /// All counters have come to zero, and nobody saw how.
  struct InDoubt {
    Stood before;
    bool at_zero;    ///< all of them, at rest; or a program that power-up starts has moved since
    bool may_be_so;  ///< what was sent may have done it
  };
  [[nodiscard]] Stood where_all_stand() const;
  Task<Result<bool>> a_program_runs();
  Task<Result<bool>> power_up_starts_a_program();
  void be_in_doubt(std::optional<InDoubt> doubt);
  Task<Result<>> decide(InDoubt in_doubt);
  void tell_of_doubt(const Stood& before);

  const Console& console_;
  Conversation& talk_;
  const CodeAtWork& code_;
  SetUp& setup_;
  Ways ways_;
  Unexplained counters_, motors_;    ///< of positions and encoders; of motor power
  Unexplained targets_;              ///< of positions that are put where the encoder stands
  std::uint64_t motion_misses_ = 0;  ///< when the first of the latest answers about motion had come
  std::optional<Stood> stood_;       ///< when last looked at
  std::optional<std::int64_t> motors_on_;
  std::optional<InDoubt> zero_in_doubt_;
};

}  // namespace hw::arcus
