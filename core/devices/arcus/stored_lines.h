#pragma once
// The lines of the stored code: one text for all programs, written line by line, then read back and compared.
#include <optional>
#include <string>
#include <vector>

#include "core/device/transfer_progress.h"
#include "core/devices/arcus/live_status.h"

namespace hw::arcus {

class StoredLines {
 public:
  StoredLines(const Console& console, Conversation& conversation, CodeAtWork& code, LiveStatus& live)
      : console_(console),
        conversation_(conversation),
        code_(code),
        live_(live),
        progress_(console.snapshot.transfer, console.catalog) {}

  Task<Result<std::vector<std::string>>> read();
  /// Stores these lines, and no others after them. Each line is read before it is reported as stored, because
  /// another host may have written it without being noticed. Returns how many lines had to be written,
  /// because they were not known to be stored.
  Task<Result<int>> write(std::vector<std::string> lines);
  /// The fault after a stop, a lost link or a refused line: the stored lines may run, but are no program.
  tl::unexpected<Fault> broken_off(Fault why);
  /// The warning for the user if the console exits now; the next console does not know it.
  [[nodiscard]] std::string leaves_behind() const;

 private:
  Task<Result<std::string>> read_line(int line);
  Task<Result<>> write_line(int line);
  Task<Result<std::vector<std::string>>> read_all();
  Task<Result<int>> write_all();
  Task<Result<>> write_changed_lines();
  struct OtherLine {
    int line;
    std::string text;
  };
  Task<Result<std::optional<OtherLine>>> compare_unread_lines();
  [[nodiscard]] const std::string& wanted(int line) const;
  [[nodiscard]] bool is_there(int line) const;
  [[nodiscard]] int not_read(int lines) const;
  [[nodiscard]] int work_from(int line, bool reads_first) const;
  void forget_stored();
  void doubt_stored();
  [[nodiscard]] std::string torn_code_words() const;
  struct Faults {
    std::uint64_t misses = 0;
    int unexpected = 0;
    bool operator==(const Faults&) const = default;
  };
  [[nodiscard]] Faults faults_now() const { return {conversation_.misses(), conversation_.unexpected()}; }

  const Console& console_;
  Conversation& conversation_;
  CodeAtWork& code_;
  LiveStatus& live_;
  TransferProgress progress_;
  std::vector<std::string> wanted_;  ///< the lines to store
  std::vector<bool> read_;           ///< by line: read in this call, and not written since
  int seen_ = 0, written_ = 0;       ///< lines, in one pass
  bool differs_ = false;             ///< found by the latest comparison
  Faults known_at_;                  ///< when its lines were last known
};

}  // namespace hw::arcus
