#pragma once
// The board keeps no programs: a program is a command string that the console holds and feeds into the ring
// as the board takes it.
#include <string>

#include "core/devices/vme58/all_stop.h"
#include "core/devices/vme58/feed.h"
#include "core/devices/vme58/status_questions.h"

namespace hw::vme58 {

class Programs {
 public:
  Programs(Wire& wire, Readings& readings, Conversation& conversation, const Commands& commands,
           Motions& motions, Speeds& speeds, StatusQuestions& questions, AllStop& all_stop, Feed& feed,
           Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        conversation_(conversation),
        commands_(commands),
        motions_(motions),
        speeds_(speeds),
        questions_(questions),
        all_stop_(all_stop),
        feed_(feed),
        snapshot_(snapshot) {}

  Result<> load(std::string text);
  /// Shows the program as a listing.
  void show();
  Task<Result<>> run();
  [[nodiscard]] bool is_running() const { return snapshot_.program.run == RunState::running; }
  /// Call once a round. A program has ended when all of it has been taken, every queue is empty and no axis
  /// moves.
  Task<Result<>> watch();
  void end(EndedBy ended_by);
  /// Notes a stop in the user's own text: the rest of the program is not sent. ST empties one queue; the
  /// other queues continue.
  void note_stop(const TextCommand& command);
  /// A queued command was rejected; `words` report it and may be extended here.
  void queued_was_rejected(std::string& words);
  /// Why the latest program was rejected; empty: it was not.
  [[nodiscard]] const std::string& rejection() const { return rejection_; }
  void lose();
  void forget();

 private:
  Task<Result<>> feed();
  Task<Result<>> end_rejected(std::string what);

  Wire& wire_;
  Readings& readings_;
  Conversation& conversation_;
  const Commands& commands_;
  Motions& motions_;
  Speeds& speeds_;
  StatusQuestions& questions_;
  AllStop& all_stop_;
  Feed& feed_;
  Snapshot& snapshot_;
  std::string text_;
  EndedBy ends_by_ = EndedBy::target;  ///< reason to report once its queues are empty
  std::string rejection_;
};

}  // namespace hw::vme58
