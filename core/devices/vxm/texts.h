#pragma once
// Sends raw texts of the user or a script in pieces, and records what they change in the controller.
#include <optional>
#include <string>
#include <vector>

#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/kills.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Texts {
 public:
  Texts(const Console& console, Conversation& conversation, Parameters& setup, Slots& slots, Speeds& speeds,
        Hold& hold, Presence& presence, UnderWay& under_way, Ramp& ramp, const Kills& kills,
        Positions& positions)
      : console_(console),
        conversation_(conversation),
        parameters_(setup),
        slots_(slots),
        speeds_(speeds),
        hold_(hold),
        presence_(presence),
        under_way_(under_way),
        ramp_(ramp),
        kills_(kills),
        positions_(positions) {}

  Task<Result<>> send(std::string text);
  /// Returns the replies; empty if the reply is a prompt that comes later.
  Task<Result<std::string>> converse(std::string text, Duration patience, Priority priority);
  /// A stop by a text of the user. A caller that waits for the reply also gets the end of the move.
  Task<Result<std::string>> stop_by_words(const StopOrder& order);

 private:
  struct RawAnswer {
    std::string text;
    std::optional<Fault> fault;    ///< why it ended; `text` holds the replies before that
    std::string dropped;           ///< a sentence about commands that the controller's state drops
    bool last_is_dropped = false;  ///< no prompt will come
  };
  [[nodiscard]] Result<> may_send(const std::vector<TextCommand>& commands) const;
  Task<RawAnswer> send_pieces(std::string text, Duration patience, Priority priority);
  void warn_of_flaws(const std::vector<TextCommand>& commands) const;
  void note_taken(const Piece& piece);
  void note_taken(const TextCommand& command);
  void note_letter(char letter);
  std::string cut_behind_stop(std::string& text) const;

  const Console& console_;
  Conversation& conversation_;
  Parameters& parameters_;
  Slots& slots_;
  Speeds& speeds_;
  Hold& hold_;
  Presence& presence_;
  UnderWay& under_way_;
  Ramp& ramp_;
  const Kills& kills_;
  Positions& positions_;
};

}  // namespace hw::vxm
