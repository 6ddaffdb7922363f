#pragma once
// The set-up: every parameter by the maker's mnemonic; which of them are stored, and which a power-up resets,
// by which it is detected.
#include <bitset>
#include <functional>
#include <optional>
#include <string>

#include "core/device/in_turn.h"
#include "core/devices/arcus/borrowed_setting.h"
#include "core/devices/arcus/code_at_work.h"
#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class SetUp {
 public:
  struct Callbacks {
    std::function<void()> loops_unknown;                      ///< StepNLoop may have been switched
    std::function<void(std::string how_it_shows)> restarted;  ///< a value is as power-up makes it
  };
  SetUp(const Console& console, Conversation& conversation, const CodeAtWork& code,
        const BorrowedSetting& borrowed, Callbacks callbacks);

  // ---- the known values
  [[nodiscard]] std::optional<std::int64_t> param(std::string_view mnemonic) const;
  [[nodiscard]] std::optional<std::int64_t> setting(Setting id, int axis = 0) const;
  /// None: not read yet.
  [[nodiscard]] std::optional<bool> has_own_speeds(int axis) const;
  /// Speed at which the axis starts and ends without a ramp; 0: not read yet.
  [[nodiscard]] std::int64_t start_speed(int axis) const;
  void show_own_speeds();

  // ---- reading
  Task<Result<>> read(int index, Priority priority);
  /// Reads a few values in each round at rest.
  Task<Result<>> read_in_turn();
  /// Reads one value that a power-up would reset. something_is_kept(): false: there is none, or programs may
  /// have set it.
  Task<Result<>> read_next_volatile();
  Task<Result<bool>> something_is_kept();

  // ---- setting
  /// True: the controller holds exactly this value.
  Task<Result<bool>> set(intent::SetParam request);
  Task<Result<>> store();
  void is_stored();
  void variable_is_unsaved() { unsaved_variables_ = console_.snapshot.unsaved_setup = true; }
  void changed(int index);
  void forget(std::string_view head);
  void forget_all();
  /// Code runs that may set its parameters.
  void code_may_set();
  /// The setting may have been read while borrowed.
  void was_borrowed(std::string_view name);
  void restarted();

 private:
  [[nodiscard]] int next_that_would_show();
  Task<Result<bool>> code_has_left_something();
  [[nodiscard]] bool in_ram_only(int index) const;
  void compare_with_stored(int index);
  void take(int index, std::int64_t value);
  [[nodiscard]] const SettingFact* fact_of(int index) const;

  const Console& console_;
  Conversation& conversation_;
  const CodeAtWork& code_;
  const BorrowedSetting& borrowed_;
  Callbacks callbacks_;
  std::array<std::int64_t, max_params> after_power_up_{};  ///< of what is stored: the stored value
  std::bitset<max_params> stored_known_;                   ///< of what is stored: after_power_up_ was read
  std::bitset<max_params> settled_;  ///< read twice, and nothing has run since that may have set them
  bool unsaved_variables_ = false;   ///< some variables were set and not stored
  InTurn params_, kept_;
};

}  // namespace hw::arcus
