#pragma once
// The lines of the stored code: one text for all programs, written line by line, read back and compared.
#include <string>
#include <vector>

#include "core/devices/arcus/live_status.h"

namespace hw::arcus {

class StoredLines {
 public:
  StoredLines(const Console& console, Conversation& talk, CodeAtWork& code, LiveStatus& live)
      : console_(console), talk_(talk), code_(code), live_(live) {}

  Task<Result<std::vector<std::string>>> read();
  /// These, and nothing behind them.
  Task<Result<>> write(std::vector<std::string> lines);
  Task<Result<>> clear_from(int line);
  /// By a stop, a lost link or a line that is not taken: what is stored then may run, and is no program.
  tl::unexpected<Fault> broken_off(Fault why);
  /// The next console to open it does not know.
  [[nodiscard]] std::string leaves_behind() const;

 private:
  Task<Result<std::string>> read_line(int line, Priority priority);
  Task<Result<>> write_line(int line, std::string text);
  Task<Result<>> store_line(int line, std::string text, std::string there);
  void show_transfer(int done, int total);

  const Console& console_;
  Conversation& talk_;
  CodeAtWork& code_;
  LiveStatus& live_;
};

}  // namespace hw::arcus
