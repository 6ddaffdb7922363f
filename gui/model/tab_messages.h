#pragma once
// The messages of one tab for its user, each shown once: notices of the controller, refused and failed
// intents, questions. GUI thread.
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "core/device/travel_check.h"
#include "gui/model/event_log.h"
#include "gui/model/followed_intents.h"
#include "gui/model/jog_hold.h"
#include "gui/model/user_settings.h"

namespace hw::gui {

class TabMessages {
 public:
  /// All must outlive this object.
  TabMessages(const Catalog& catalog, const UserSettings& settings, JogHold& jog, EventLog& events);

  FollowedIntents followed;

  void add(Notice notice);
  /// Once a frame: looks at the followed intents. A refused jog ends its hold.
  void follow(const Snapshot& now, Instant clock);

  /// The notices since the last call.
  [[nodiscard]] std::vector<Notice> take_notices();
  [[nodiscard]] std::vector<std::string>& complaints() { return complaints_; }
  /// Why the intent was refused or has failed, in the displayed units.
  [[nodiscard]] std::string words_of(const IntentOutcome& outcome) const;

  /// A tap of the jog pad that was refused because it would have gone past a limit.
  struct TapPastLimit {
    PastTravel past;
    std::string words;
  };
  std::optional<TapPastLimit> tap_past_limit;  ///< until the pad's card is closed
  /// The jog pad is drawn in this frame, and with it the card of a refused tap.
  void look_at_pad() { pad_looked_at_ = true; }

 private:
  void complain(const IntentOutcome& outcome, Instant clock);

  const Catalog& catalog_;
  const UserSettings& settings_;
  JogHold& jog_;
  EventLog& events_;
  std::vector<Notice> notices_;
  std::vector<std::string> complaints_;
  bool pad_looked_at_ = false;  ///< in this frame
};

}  // namespace hw::gui
