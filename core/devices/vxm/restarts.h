#pragma once
// Effects of a restart, by power off and on or by res: positions are zero wherever the motors stand, RAM
// holds the contents stored last, and nothing runs.
#include <optional>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/knowledge.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/scratch.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Restarts {
 public:
  Restarts(const Console& console, Conversation& conversation, Presence& presence, Knowledge& knowledge,
           Scratch& scratch, Speeds& speeds, Hold& hold, UnderWay& under_way, Positions& positions)
      : console_(console),
        conversation_(conversation),
        presence_(presence),
        knowledge_(knowledge),
        scratch_(scratch),
        speeds_(speeds),
        hold_(hold),
        under_way_(under_way),
        positions_(positions) {}

  /// The controller is in Local mode although it was on-line.
  Task<Result<>> found(const char* why);
  /// A stop ended Local mode before the positions could be asked for.
  Task<Result<>> found_left_local();
  /// Local mode may have been left; the mode is unknown.
  Task<Result<>> may_have_left_local();
  /// res and F were sent in one text: only the sent res shows the restart.
  Task<Result<>> found_reset_on_line();
  /// Requested by the user.
  Task<Result<>> reset();

 private:
  void count(const char* why, bool was_moving, const std::optional<Digitized>& places);
  void stands_since(Doubt why);
  void forget_ram();

  const Console& console_;
  Conversation& conversation_;
  Presence& presence_;
  Knowledge& knowledge_;
  Scratch& scratch_;
  Speeds& speeds_;
  Hold& hold_;
  UnderWay& under_way_;
  Positions& positions_;
};

}  // namespace hw::vxm
