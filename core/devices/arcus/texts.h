#pragma once
// The user's own text: commands, questions, stops, and texts from another session's terminal on the same
// line.
#include <string>
#include <string_view>

#include "core/devices/arcus/after_silence.h"
#include "core/devices/arcus/move_list.h"

namespace hw::arcus {

class Texts {
 public:
  Texts(const Console& console, Conversation& conversation, CodeAtWork& code, BorrowedSetting& borrowed,
        SetUp& setup, MoveList& list, RestartWatch& watch, Motions& motions, Readouts& readouts,
        Threads& threads, Lines& lines, AfterSilence& silence)
      : console_(console),
        conversation_(conversation),
        code_(code),
        borrowed_(borrowed),
        setup_(setup),
        list_(list),
        watch_(watch),
        motions_(motions),
        readouts_(readouts),
        threads_(threads),
        lines_(lines),
        silence_(silence) {}

  Task<Result<std::string>> query(std::string text, Duration patience);
  Task<Result<>> send(const intent::SendText& request);
  Task<Result<std::string>> stop(const StopOrder& order);
  /// Another session of this line has broadcast the text.
  void note_broadcast(const std::string& text);

 private:
  Task<Result<std::string>> transmit(std::string text, Priority priority, Duration patience);
  void note_done(std::string_view command);
  void note_sent(std::string_view as_typed);
  void note_stop(std::string_view text);

  const Console& console_;
  Conversation& conversation_;
  CodeAtWork& code_;
  BorrowedSetting& borrowed_;
  SetUp& setup_;
  MoveList& list_;
  RestartWatch& watch_;
  Motions& motions_;
  Readouts& readouts_;
  Threads& threads_;
  Lines& lines_;
  AfterSilence& silence_;
};

}  // namespace hw::arcus
