#pragma once
// A number that a person types. Comma and point both read, the real minus too; the wheel changes nothing. A
// value out of range is not reported: the field turns red and the range stands below it in words.
#include <optional>
#include <string>
#include <string_view>

#include "gui/model/typed_number.h"
#include "gui/widgets/text_field.h"

namespace hw::gui {

struct NumberOptions {
  NumberRange range{};
  std::string_view disabled = {};
  std::string_view tip = {};
  std::string_view refused =
      {};  ///< from elsewhere: the controller or a soft limit says no; turns the field red
  float width = fill, height = 32;
  bool changed = false, stale = false;
  bool sentence_below = true;  ///< false: the panel shows state.sentence itself
};

/// Kept by the panel, one per field. While somebody has typed, the text is his; else it follows the shown
/// value.
class NumberField {
 public:
  std::string text;
  std::string sentence;  ///< what is wrong with the text; empty: nothing
  [[nodiscard]] bool dirty() const { return dirty_; }
  /// What the text says now, valid or not for the range; nothing when it is no number.
  [[nodiscard]] std::optional<double> value() const;
  /// Puts a value as if it had been typed.
  void set(double value, int decimals);
  /// Forgets what was typed.
  void reset();

 private:
  friend struct NumberAccess;
  bool dirty_ = false;
  double shown_ = 0;
  bool has_shown_ = false;
};

struct NumberEvent {
  Field field;
  bool committed = false;  ///< Enter, or the caret left, with a valid and changed number
  bool entered = false;    ///< Enter with a valid number, changed or not
  double value = 0;
};

/// `shown`: the value that the controller has (nullopt: the text is the panel's alone, as in Go to).
NumberEvent number_field(Ui& ui, std::string_view id, std::string_view label, std::optional<double> shown,
                         NumberField& state, const NumberOptions& options = {});

}  // namespace hw::gui
