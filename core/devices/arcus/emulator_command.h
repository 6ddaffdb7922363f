#pragma once
// How a command is found: each form of the manual is a pattern, tried in the order of its table.
//
//   a  an axis letter      n  digits (an index)      s  + or -      v  all that follows, the value
//
// Everything else is literal: "LTaE", "DOn=v", "Hasn". The value may be empty; the handler decides whether
// that is valid.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

struct Arguments {
  int axis = 0;
  std::int64_t index = 0;
  Sign sign = Sign::plus;
  std::string_view value;
};

/// A reply, or the reason of a refusal.
struct Answer {
  Refusal refusal = Refusal::none;
  std::string text = "OK";

  Answer() = default;
  Answer(Refusal r) : refusal(r) {}              // NOLINT: a refusal is an answer
  Answer(std::string t) : text(std::move(t)) {}  // NOLINT
  static Answer number(std::int64_t n) { return std::to_string(n); }
};

struct Command {
  std::string_view form;
  Answer (*run)(Controller&, const Arguments&);
};

/// The arguments, if `text` has that form.
std::optional<Arguments> match(std::string_view form, std::string_view text, std::string_view axis_letters);

/// Without the blanks that may stand around '='.
std::string without_blanks(std::string_view text);

/// The controller's reply, without address and terminator. `own`: commands that only its model has.
std::string answer(Controller& controller, std::span<const Command> own, std::string_view text);

/// Commands that both models have.
std::span<const Command> common_commands();

// For the tables of the models.
/// Whole number in a range.
std::optional<std::int64_t> number_in(std::string_view text, std::int64_t min, std::int64_t max);
std::optional<std::int64_t> position_in(std::string_view text);

}  // namespace hw::arcus
