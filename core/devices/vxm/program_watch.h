#pragma once
// Findings of a rehearsal, command by command: limit switches hit, endless loops, speeds never set.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/device/language.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {

class ProgramWatch {
 public:
  explicit ProgramWatch(const Analysis& analysis) : analysis_(analysis) {}

  /// Call in order of time. `box`: the controller of the trace.
  void observe(const Trace& trace, const Box& box);
  /// For a program still running at the end of the rehearsal: its loop then. Empty: none is known.
  [[nodiscard]] std::string loop_words(const Box& box) const;
  /// Whether no command leaves that loop.
  [[nodiscard]] bool endless(const Box& box) const;
  /// "Program 0, line 3"
  [[nodiscard]] std::string place_words() const;

  [[nodiscard]] const std::vector<RehearsedStop>& stops() const { return stops_; }
  [[nodiscard]] RehearsedStop stop(Instant at, std::string reason) const;
  /// Speeds and accelerations that motions took over from an earlier program or power-up.
  [[nodiscard]] std::vector<RehearsedAssumption> assumptions() const;

 private:
  /// Consecutive commands of a program, as a part of a loop.
  struct Part {
    int program = 0, first = 0, last = 0;
  };
  void note_command(const Command& command);
  [[nodiscard]] bool knows_loop(const Box& box) const;
  /// From the target of the loop's command, through the programs that it jumps to, back to that command.
  /// Empty: some command may leave the loop.
  [[nodiscard]] std::vector<Part> way_round(const Box& box) const;
  [[nodiscard]] std::string part_words(const Part& part) const;
  void uses_speed(const Command& command);
  [[nodiscard]] int line_of(int program, int command) const;

  const Analysis& analysis_;
  int program_ = -1, command_ = -1;                ///< the latest command
  int loop_program_ = -1, loop_at_ = -1;           ///< the latest jump or L0
  std::map<std::pair<int, int>, int> times_back_;  ///< by program and command
  std::array<bool, max_motors> speed_set_{}, accel_set_{}, speed_assumed_{}, accel_assumed_{};
  std::vector<RehearsedStop> stops_;
};

}  // namespace hw::vxm
