#pragma once
// Findings of a rehearsal while programs run: why each stopped, which switches were hit, which loop never
// ends.
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/emulator_controller.h"
#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

class ProgramWatch {
 public:
  ProgramWatch(const Controller& controller, const language::Compilation& made,
               const language::Dialect& dialect)
      : controller_(controller), made_(made), dialect_(dialect) {}

  /// Call in order of time. False: an input was read and was the same as at the last read there.
  bool observe(const Controller::Trace& trace);
  /// Call after each event: notes programs that have stopped in error since.
  void look_at_programs();
  [[nodiscard]] const std::vector<RehearsedStop>& stops() const { return stops_; }
  /// The errors of all programs stopped by one; empty: none.
  [[nodiscard]] std::string errors() const;

  struct Unfinished {
    std::string sentence;
    bool endless = false;
  };
  /// Programs and motions still running at the end of the time. `nothing_comes`: nothing more would have
  /// happened.
  [[nodiscard]] Unfinished unfinished(bool nothing_comes);

 private:
  struct Loop {
    int head = -1, end = -1;  ///< low-level lines
  };
  [[nodiscard]] bool is_in(int program, language::ThreadState state) const;
  [[nodiscard]] std::string place_of(int program) const;
  [[nodiscard]] std::string reason_of(int program) const;
  [[nodiscard]] int source_line(int line) const;
  [[nodiscard]] Loop loop_around(int line) const;
  [[nodiscard]] Unfinished still_running(int program, bool nothing_comes) const;
  [[nodiscard]] Unfinished still_moving(bool nothing_comes);
  [[nodiscard]] bool has_mixed_loops(const language::Instruction& i) const;
  [[nodiscard]] Refusal error_among(const language::Instruction& i) const;
  void stopped(int line, std::string reason, std::string axis = {}, int direction = 0);

  const Controller& controller_;
  const language::Compilation& made_;
  const language::Dialect& dialect_;
  std::array<int, most_axes> sent_by_{-1, -1, -1, -1};  ///< line of the latest motion of each axis
  std::map<int, std::string> last_read_;                ///< by line
  std::array<bool, language::max_programs> failed_{};
  std::vector<RehearsedStop> stops_;
};

}  // namespace hw::arcus
