#pragma once
// A number field. It accepts comma, point and the real minus sign; the mouse wheel changes nothing. A value
// out of range is not committed: the field turns red, and a sentence below gives the range.
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
      {};  ///< why the controller or a soft limit refused the number; turns the field red
  float width = fill, height = 32;
  bool changed = false, stale = false;
  bool sentence_below = true;  ///< false: the panel shows state.sentence itself
};

/// The panel keeps one for each field. Typed text stays; otherwise the field follows the shown value.
class NumberField {
 public:
  std::string text;
  std::string sentence;  ///< the error in the text; empty: none
  [[nodiscard]] bool dirty() const { return dirty_; }
  /// The number in the text, in range or not; nullopt when the text is not a number.
  [[nodiscard]] std::optional<double> value() const;
  /// Sets a value as if it had been typed.
  void set(double value, int decimals);
  /// Drops the typed text.
  void reset();

 private:
  friend struct NumberAccess;
  bool dirty_ = false;
  double shown_ = 0;
  bool has_shown_ = false;
};

struct NumberEvent {
  Field field;
  bool committed = false;  ///< Enter, or the focus lost, with a valid and changed number
  bool entered = false;    ///< Enter with a valid number, changed or not
  double value = 0;
};

/// `shown`: the controller's value; nullopt: the controller has no value for this field, as in Go to.
NumberEvent number_field(Ui& ui, std::string_view id, std::string_view label, std::optional<double> shown,
                         NumberField& state, const NumberOptions& options = {});

}  // namespace hw::gui
