#pragma once
// Known values of the set-up. The board shows speeds and gains in its data area; any other parameter is known
// only if the console has set it since the board's start.
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
  ParameterValues(const Catalog& catalog, const Variant& variant, const Readings& readings,
                  Snapshot& snapshot)
      : catalog_(catalog), readings_(readings), snapshot_(snapshot), all_(parameters_of(variant)) {}

  /// The parameter at this place in the catalog.
  [[nodiscard]] const Parameter& at(std::size_t place) const { return all_[place]; }
  [[nodiscard]] std::optional<std::int64_t> known(int axis, std::string_view letters) const;
  /// Whether a gain may act on a standing error: one of these gains is unknown or not 0.
  [[nodiscard]] bool drives(int axis) const;
  /// None: not all gains are known. KN may be unknown if KI is 0.
  [[nodiscard]] std::optional<motion::ServoGains> gains(int axis) const;

  void know(std::size_t place, std::int64_t value);
  /// A value with a fraction was set: the data area, which shows integer parts only, no longer shows gains in
  /// full.
  void note_fraction(const ParameterFact& fact, std::int64_t value);
  /// Takes the values of the data area. A fraction set by the console is kept; a gain is unknown if another
  /// session may have set a fraction.
  void take(int axis);
  /// Notes a parameter set by the user's own text.
  void note(const TextCommand& command);
  void as_from_factory();

  /// No gain with a fraction was set since the board's start. A mark on the board informs other sessions.
  [[nodiscard]] bool gains_are_whole() const { return gains_are_whole_; }
  void gains_are_whole(bool whole) { gains_are_whole_ = whole; }
  [[nodiscard]] bool mark_is_due() const { return mark_due_; }
  void mark_was_left() { mark_due_ = false; }

 private:
  const Catalog& catalog_;
  const Readings& readings_;
  Snapshot& snapshot_;
  const std::vector<Parameter> all_;  ///< in catalog order
  bool gains_are_whole_ = false, mark_due_ = false;
};

}  // namespace hw::vme58
