#pragma once
// Detects a power cycle of the controller: by its counters, its motor power, a program that runs, and lost
// settings (set_up.h).
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
  /// Facts about an axis that are not in the snapshot.
  struct AxisNow {
    bool runs = false, moving = false;
    bool to_encoder = false;   ///< its stop under StepNLoop sets its position to the encoder's
    Pps towards_zero;          ///< fastest way to zero by its own motion
    Steps room;                ///< largest correction by StepNLoop
    bool leaves_zero = false;  ///< it comes to rest away from zero, unless stopped
  };
  struct Callbacks {
    std::function<AxisNow(int axis)> axis_now;
    /// `moved`: a bit for each axis that was on its way.
    std::function<void(std::string_view how_it_shows, unsigned moved)> restarted;
  };
  /// The commands that had been sent when a status round began.
  struct Look {
    Unexplained::Mark counters, targets, motors;
  };
  RestartWatch(const Console& console, Conversation& conversation, const CodeAtWork& code, SetUp& setup,
               Callbacks callbacks)
      : console_(console),
        conversation_(conversation),
        code_(code),
        setup_(setup),
        callbacks_(std::move(callbacks)) {}

  /// Call before each command is sent: a change that it explains is no power cycle.
  void goes_out(std::string_view command);
  void counters_may_be_set() { counters_.may_be_set(); }
  /// Call after the controller has confirmed these.
  void was_sent_to(int axis, Steps target);
  void jogs(int axis, Sign way);
  void position_was_set(int axis, Steps position);
  void encoder_was_set(int axis, Steps position);
  /// Commands sent so far no longer explain a zero; they may still explain a position set to the encoder's.
  void settle() { counters_.settle(); }

  [[nodiscard]] Look begin_look() const { return {counters_.ask(), targets_.ask(), motors_.ask()}; }
  /// Call on the first motion reply of a round; motion_is_whole(): all later questions were answered.
  void first_answer_came() { motion_misses_ = conversation_.misses(); }
  [[nodiscard]] bool motion_is_whole() const { return conversation_.misses() == motion_misses_; }
  void look_at_counters(const Look& look, bool was_silent = false);
  Task<Result<>> look_at_motors(const Look& look);
  Task<Result<>> look_at_start(int thread, Priority priority);

  /// All counters have come to zero unseen: check the motors.
  [[nodiscard]] bool in_doubt() const { return zero_in_doubt_.has_value(); }
  /// A reply was missed since the last look.
  [[nodiscard]] bool was_silent() const { return reference_ && reference_->misses != conversation_.misses(); }
  [[nodiscard]] bool has_looked() const { return reference_.has_value(); }
  [[nodiscard]] bool program_ran() const { return reference_ && reference_->program_ran; }
  void forget();

 private:
  /// The earlier state that positions are compared with.
  struct Reference {
    struct Axis {
      Steps position, encoder;
      AxisNow then;
      bool sent_from_zero = false;  ///< the axis was sent away from zero, and not stopped since
      bool may_have_left = false;   ///< something sent may move it, or it was stopped on its way
    };
    std::array<Axis, max_axes> axes{};
    Instant seen_at{};
    std::uint64_t misses = 0;  ///< replies missed until then
    bool program_ran = false;
    [[nodiscard]] unsigned moved() const;
  };
  /// The change between two looks, of one axis or of any axis.
  struct Change {
    bool nearer = false;         ///< nearer to zero than its known motion explains
    bool may_be_nearer = false;  ///< nearer for any reason, or it may have left zero
    bool jumped = false;         ///< farther than it can go in the time
    void add(const Change& other) {
      nearer = nearer || other.nearer;
      may_be_nearer = may_be_nearer || other.may_be_nearer;
      jumped = jumped || other.jumped;
    }
  };
  static Change change_of(const AxisState& now, const Reference::Axis& before, double elapsed_s,
                          bool targets_stay);
  /// All counters have come to zero unseen.
  struct InDoubt {
    Reference before;
    bool at_zero;    ///< all axes are at rest at zero; else a program started by power-up may have moved them
                     ///< since
    bool may_be_so;  ///< a sent command may explain it
  };
  [[nodiscard]] Reference reference_of_now() const;
  Task<Result<bool>> a_program_runs();
  Task<Result<bool>> power_up_starts_a_program();
  void be_in_doubt(std::optional<InDoubt> doubt);
  Task<Result<>> decide(InDoubt in_doubt);
  void warn_of_doubt(const Reference& before);

  const Console& console_;
  Conversation& conversation_;
  const CodeAtWork& code_;
  SetUp& setup_;
  Callbacks callbacks_;
  Unexplained counters_, motors_;       ///< of positions and encoders; of motor power
  Unexplained targets_;                 ///< of positions set to the encoder's
  std::uint64_t motion_misses_ = 0;     ///< when the first of the latest motion replies came
  std::optional<Reference> reference_;  ///< when last looked at
  std::optional<std::int64_t> motors_on_;
  std::optional<InDoubt> zero_in_doubt_;
};

}  // namespace hw::arcus
