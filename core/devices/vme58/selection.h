#pragma once
// The axis that the next text addresses. The board has one selection for all hosts: each text of the console
// begins by selecting its own axis and ends by restoring the selection of the user's text.
#include <array>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

/// UU by axis; 0: off.
using UserUnits = std::array<double, most_axes>;

class Selection {
 public:
  explicit Selection(const Catalog& catalog) : catalog_(catalog) {}

  /// The selection as the user's text has left it.
  [[nodiscard]] const Context& context() const { return context_; }
  [[nodiscard]] std::string selector() const { return context_.selector(); }
  /// Between CD and CE: text put now becomes part of a contour.
  [[nodiscard]] bool recording() const { return context_.recording; }
  void set(const Context& context) { context_ = context; }
  /// Follows a command of the user's text.
  void observe(const TextCommand& command) { follow(command, context_); }
  void set_recording(bool on) { context_.recording = on; }

  /// The board's selection may differ from that of the user's text: text was taken back, perhaps between two
  /// selectors.
  [[nodiscard]] bool is_lost() const { return lost_; }
  void lose() { lost_ = true; }
  void is_restored() { lost_ = false; }
  /// A recording has ended, also on the board: by a selector, or with the connection. Returns whether one was
  /// under way.
  bool end_recording();
  /// The board has been reset.
  void forget();

  /// `selector`, then `text`, then the user's selector. The console's numbers are counts, so user units are
  /// off during its text (they act when a command is read).
  [[nodiscard]] std::string addressed(std::string_view selector, std::string_view text) const;
  [[nodiscard]] std::string addressed(int axis, std::string_view text) const;
  /// UU of one axis; 0: off.
  [[nodiscard]] double user_unit(int axis) const { return user_unit_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const UserUnits& user_units() const { return user_unit_; }
  void note_units(const TextCommand& command);

 private:
  [[nodiscard]] const std::string& name(int axis) const {
    return catalog_.axes[static_cast<std::size_t>(axis)].name;
  }

  const Catalog& catalog_;
  Context context_;
  bool lost_ = false;
  UserUnits user_unit_{};
};

}  // namespace hw::vme58
