#pragma once
// Updates the knowledge of the board after a command of the user's text or program, except for the axis that
// it selects.
#include <map>

#include "core/devices/vme58/lines.h"
#include "core/devices/vme58/speeds.h"

namespace hw::vme58 {

class Effects {
 public:
  Effects(Selection& selection, Conversation& conversation, Lines& lines, ServoLoops& loops,
          ParameterValues& values, Motions& motions, Speeds& speeds, const Catalog& catalog)
      : selection_(selection),
        conversation_(conversation),
        lines_(lines),
        loops_(loops),
        values_(values),
        motions_(motions),
        speeds_(speeds),
        catalog_(catalog) {}
  void note(const TextCommand& command);
  /// The same for a command of a program, which the board has taken and may carry out later.
  void note_queued(const TextCommand& command);
  /// `whole`: all of the program was carried out.
  void program_ended(bool whole) { lines_.program_ended(whole); }

 private:
  void note_counters(const TextCommand& command);
  void note_contour_ports(const TextCommand& command);

  Selection& selection_;
  Conversation& conversation_;
  Lines& lines_;
  ServoLoops& loops_;
  ParameterValues& values_;
  Motions& motions_;
  Speeds& speeds_;
  const Catalog& catalog_;
  /// Auxiliary outputs that the latest contour switches, as it leaves them: CX plays it.
  std::map<int, bool> contour_ports_;
};

}  // namespace hw::vme58
