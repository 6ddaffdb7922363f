#pragma once
// What a rehearsal finds out from command to command: switches that were run into, loops that nothing leaves,
// speeds that nobody has set.
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

  /// In the order of time; `box` runs what it is of.
  void hear(const Trace& trace, const Box& box);
  /// It went on to the end of the rehearsal: the loop in which it was then. Empty: none is known.
  [[nodiscard]] std::string loop_words(const Box& box) const;
  /// ... and nothing leaves that loop.
  [[nodiscard]] bool endless(const Box& box) const;
  /// "Program 0, line 3"
  [[nodiscard]] std::string place_words() const;

  [[nodiscard]] const std::vector<RehearsedStop>& stops() const { return stops_; }
  [[nodiscard]] RehearsedStop stop(Instant at, std::string reason) const;
  /// Speed and acceleration of motors that moved by what an earlier program or power-up had left.
  [[nodiscard]] std::vector<RehearsedAssumption> assumptions() const;

 private:
  /// Commands of a program that a loop goes through.
  struct Part {
    int program = 0, first = 0, last = 0;
  };
  void hear_command(const Command& command);
  [[nodiscard]] bool knows_loop(const Box& box) const;
  /// From where the loop's command goes back to, through the programs that it jumps to, to that command
  /// again. Empty: something may lead off that way.
  [[nodiscard]] std::vector<Part> way_round(const Box& box) const;
  [[nodiscard]] std::string part_words(const Part& part) const;
  void uses_speed(const Command& command);
  [[nodiscard]] int line_of(int program, int command) const;

  const Analysis& analysis_;
  int program_ = -1, command_ = -1;                ///< the latest
  int loop_program_ = -1, loop_at_ = -1;           ///< the latest command that went back without counting
  std::map<std::pair<int, int>, int> times_back_;  ///< by program and command
  std::array<bool, max_motors> speed_set_{}, accel_set_{}, speed_assumed_{}, accel_assumed_{};
  std::vector<RehearsedStop> stops_;
};

}  // namespace hw::vxm
