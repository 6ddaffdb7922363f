#pragma once
// Raw text of users and scripts. Sent command by command, so that a rejected command can be named, and
// followed, so that the console knows the selected axis and the settings made.
#include <functional>
#include <string>
#include <vector>

#include "core/devices/vme58/programs.h"
#include "core/devices/vme58/text_goals.h"

namespace hw::vme58 {

class Texts {
 public:
  Texts(Readings& readings, Selection& selection, Conversation& conversation, Commands& commands,
        Motions& motions, Speeds& speeds, Feed& feed, Programs& programs, Effects& effects, NextRound& next,
        const Catalog& catalog, Snapshot& snapshot)
      : readings_(readings),
        selection_(selection),
        conversation_(conversation),
        commands_(commands),
        motions_(motions),
        speeds_(speeds),
        feed_(feed),
        programs_(programs),
        effects_(effects),
        next_(next),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Returns the replies to its queries, one per line.
  Task<Result<std::string>> send(std::string text, Duration patience);
  /// Moves that texts have prepared and that no GO has started yet.
  [[nodiscard]] const PreparedMoves& prepared() const { return prepared_; }
  PreparedMoves& prepared() { return prepared_; }
  void forget_prepared() { prepared_.forget(); }
  /// A stop in the user's words has been sent.
  void note_stop(std::string_view words);
  /// Called for a text that contains RS, which concerns all parts of the driver.
  std::function<Task<Result<>>(std::string text)> reset;

 private:
  Result<> may_send_while_feeding(const std::vector<TextCommand>& commands) const;
  Task<Result<>> prepare(const std::vector<TextCommand>& commands);
  Task<Result<std::string>> transmit(const TextCommand& command, Duration patience);
  Task<Result<>> put(const TextCommand& command, std::string word);
  Result<> cut_short(const TextCommand& command, Fault why);
  Task<Result<>> accepts(const TextCommand& command);
  void note_sent(const TextCommand& command);

  Readings& readings_;
  Selection& selection_;
  Conversation& conversation_;
  Commands& commands_;
  Motions& motions_;
  Speeds& speeds_;
  Feed& feed_;
  Programs& programs_;
  Effects& effects_;
  NextRound& next_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
  PreparedMoves prepared_;
};

}  // namespace hw::vme58
