#pragma once
// What is known of the set-up. The board shows speeds and gains in its data area; what it shows nowhere is
// known while the console has set it itself since the board's start, and unknown otherwise.
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/parameters.h"
#include "core/devices/vme58/readings.h"
#include "core/motion/servo_watch.h"

namespace hw::vme58 {

class ParameterValues {
 public:
  ParameterValues(const Catalog& catalog, const Variant& variant, const Readings& readings, Snapshot& draft)
      : catalog_(catalog), readings_(readings), draft_(draft), all_(parameters_of(variant)) {}

  /// By its place in the catalog.
  [[nodiscard]] const Parameter& at(std::size_t place) const { return all_[place]; }
  [[nodiscard]] std::optional<std::int64_t> known(int axis, std::string_view letters) const;
  /// Some gain answers a standing error, as far as is known.
  [[nodiscard]] bool drives(int axis) const;
  /// None: not all of them are known. Where nothing is integrated, its interval does not matter.
  [[nodiscard]] std::optional<motion::ServoGains> gains(int axis) const;

  void know(std::size_t place, std::int64_t value);
  /// The data area shows integer parts only: from here on it does not tell all of a gain.
  void note_fraction(const ParameterFact& fact, std::int64_t value);
  /// From the data area: a fraction that the console has set stays beside it, and one that another session
  /// has set, or may have, nobody can tell.
  void take(int axis);
  /// What the user's own text has set.
  void note(const TextCommand& command);
  void as_from_factory();

  /// No gain with a fraction was set since the board's start. A mark on the board keeps that for others.
  [[nodiscard]] bool gains_are_whole() const { return gains_are_whole_; }
  void gains_are_whole(bool whole) { gains_are_whole_ = whole; }
  [[nodiscard]] bool mark_is_due() const { return mark_due_; }
  void mark_was_left() { mark_due_ = false; }

 private:
  const Catalog& catalog_;
  const Readings& readings_;
  Snapshot& draft_;
  const std::vector<Parameter> all_;  ///< in the order of the catalog's
  bool gains_are_whole_ = false, mark_due_ = false;
};

}  // namespace hw::vme58
