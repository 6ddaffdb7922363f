#pragma once
// The status line: the worst true fact about a controller in one or two sentences, and what to do about it.
#include <functional>
#include <optional>
#include <string>

#include "core/base/fixed_text.h"
#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "gui/model/jog_hold.h"
#include "gui/model/severity.h"

namespace hw::gui {

struct StatusSentence {
  Severity severity = Severity::plain;
  FixedText<800> text;
  std::size_t goes_on = 0;  ///< bytes at the end of `text` that describe motion beside a fault
  /// The same sentence: `goes_on` only divides it.
  bool operator==(const StatusSentence& other) const {
    return severity == other.severity && text == other.text;
  }
};

/// The place of a running program, as the editor shows it.
struct RunPlace {
  std::string subject;       ///< "Programs 0 and 2 are"; empty: the program that the snapshot names
  int line = -1;             ///< of the text, from 0; -1: not known
  int stored_line = -1;      ///< of the stored code, where only that is known
  int pass = 0, passes = 0;  ///< 0: not known
  std::optional<double> left_s;
};

struct StatusFacts {
  const Catalog& catalog;
  const Snapshot& now;
  Instant clock;
  std::optional<JogHold::Control> held;                     ///< held by the user
  bool jogging = false;                                     ///< held long enough for a continuous jog
  std::function<std::string(AxisId, Steps)> show_position;  ///< "12.000 mm"
  std::function<std::string(AxisId, Pps)> show_speed;       ///< "5.000 mm/s"
  std::function<std::string(Instant)> time_of_day;          ///< "14:20:08"
  RunPlace run{};
  std::string failed{};  ///< programs stopped in error, as a sentence: shown beside what still runs
  bool unset_read =
      false;  ///< the choices to make before the first move have been read, or a banner shows them
};

StatusSentence status_sentence(const StatusFacts& facts);

/// Adds a sentence on what else goes on.
void add_running_words(StatusSentence& sentence, std::string_view words);

/// The index of a parameter that must be chosen before an axis may move and is not; -1: none.
int unset_before_moving(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw::gui
