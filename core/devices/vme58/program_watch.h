#pragma once
// Findings of a rehearsal while the board works: limit switches met, and commands that nothing ends.
#include <array>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

class ProgramWatch {
 public:
  /// `line_of`: line of the text, indexed by Note::source.
  ProgramWatch(const Board& board, std::vector<int> line_of) : board_(board), line_of_(std::move(line_of)) {}

  void observe(const Note& note);
  /// Whether a command read the same level of a line as it did the last time.
  [[nodiscard]] bool is_repeated(const Note& look);
  void stopped(Instant at, int source, std::string reason, int axis = -1, int direction = 0);
  [[nodiscard]] const std::vector<RehearsedStop>& stops() const { return stops_; }

  /// Note::source of the earliest command at work in a queue; -1: none, or its motion continues.
  [[nodiscard]] int at_work() const;

  struct Unfinished {
    int source = -1;  ///< as Note::source; -1: the text was not fully taken
    std::string why;  ///< part of a sentence; empty: no more is known
    bool endless = false;
  };
  /// The command or motion still going on when the time is over.
  [[nodiscard]] Unfinished unfinished() const;

 private:
  [[nodiscard]] Unfinished of_queue(const CommandQueue& queue) const;
  [[nodiscard]] std::string line_words(int source) const;
  [[nodiscard]] int line_of(int source) const {
    return source >= 0 && ix(source) < line_of_.size() ? line_of_[ix(source)] : -1;
  }

  const Board& board_;
  const std::vector<int> line_of_;
  std::array<int, most_axes> sent_by_{-1, -1, -1, -1, -1, -1, -1, -1};  ///< source of its latest motion
  std::vector<signed char> last_look_;                                  ///< by source; -1: none yet
  std::vector<RehearsedStop> stops_;
};

}  // namespace hw::vme58
