#pragma once
// Whether the controller holds before each command of a program (H), as far as known. H toggles the hold, and
// only the behaviour of a program shows its state.
namespace hw::vxm {

class Hold {
 public:
  [[nodiscard]] bool is_on() const { return on_; }
  /// False: another H might switch it either way.
  [[nodiscard]] bool is_known() const { return !doubtful_ && !found_running_; }
  /// The wire was lost with an H on it, or a K was not confirmed.
  [[nodiscard]] bool is_doubtful() const { return doubtful_; }
  [[nodiscard]] bool is_surely_on() const { return on_ && is_known(); }

  // ---- sent commands
  void was_switched(bool on) {
    if (on != on_) shown_ = false;
    on_ = on;
  }
  void was_toggled() { was_switched(!on_); }
  void doubt() { doubtful_ = true; }
  /// The wire was lost: the last H may not have arrived.
  void wire_lost() { doubtful_ = doubtful_ || (on_ && !shown_); }
  /// K or a restart: nothing is held.
  void ended() { *this = Hold(); }

  // ---- reports and behaviour of the controller
  /// The controller has listed the command before which it holds.
  void showed() {
    on_ = shown_ = true;
    doubtful_ = found_running_ = false;
  }
  /// A program started by another host runs, which may have sent H: no motion has begun since.
  void found_running() { found_running_ = true; }
  void nothing_runs_from_before() { found_running_ = false; }
  /// A motion has begun, so nothing is held.
  void is_seen_off() { on_ = shown_ = doubtful_ = found_running_ = false; }

  // ---- release: the hold must not stop the present or next run
  void release_soon() { release_ = true; }
  [[nodiscard]] bool is_to_be_released() const { return release_ && on_; }
  void was_released() { release_ = false; }

  // ---- motions begun in a program since the hold was last thought to be on
  [[nodiscard]] bool something_has_begun() const { return begun_; }
  void something_begins() { begun_ = true; }
  void expect_nothing_to_begin() { begun_ = false; }

 private:
  bool on_ = false, shown_ = false, doubtful_ = false, found_running_ = false, release_ = false,
       begun_ = false;
};

}  // namespace hw::vxm
