#pragma once
// What can be done about a refusal because a position is not to be trusted: home the axis, say where it
// stands, or send what was refused once all the same. A panel keeps one for each of its rows that can be
// refused so, and asks by it:
//
//     asked_ = doubt_.send(f, intent::MoveTo(...));                    // in place of f.send_and_watch()
//     if (!doubt_.hear(f, *fate)) refused_ = fate->sentence.view();    // when it was refused or has failed
//     if (doubt_.open())
//       if (const IntentId id = doubt_.draw(f, "goto", "Go, X", row, mode)) asked_ = id;
//
// Ids, of the axis that it is about: `goto/X/refused`, `goto/X/stands_at`, `goto/X/set`, `goto/X/home/-`,
// `goto/X/home/+`, `goto/X/once`.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/device/intent.h"
#include "gui/widgets/number_field.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class DoubtWays {
 public:
  /// Sends it as Frame::send_and_watch() does. What was refused before is forgotten.
  IntentId send(gui::Frame& frame, IntentBody body);
  /// What became of it, other than done. True: it is a matter of doubt, and is told here.
  bool hear(const gui::Frame& frame, const IntentFate& fate);
  [[nodiscard]] bool open() const { return doubtful_ != 0; }
  /// The card, beside `row`. What was sent to deal with it and is to be followed; 0: nothing. `mode`: the way
  /// of homing that is chosen; -1: none is. It closes by itself when nothing is doubtful any more.
  IntentId draw(gui::Frame& frame, std::string_view prefix, std::string_view about, const gui::Rect& row,
                int mode = -1);

 private:
  enum Way : std::uint8_t { set, home_minus, home_plus, once };
  struct Offer {
    Way way;
    std::string id, label, brief;
  };
  void close() { doubtful_ = 0; }
  void tell(const gui::Frame& frame, std::uint32_t doubtful);
  void name_ways(const gui::Frame& frame, std::string_view prefix);
  /// True: Enter.
  bool draw_field(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, Way way) const;
  [[nodiscard]] std::optional<Steps> place(const gui::Frame& frame) const;
  IntentId go(gui::Frame& frame, Way way, int mode);

  std::optional<IntentBody> sent_;
  std::uint32_t doubtful_ = 0;  ///< bit per axis; 0: nothing is open
  AxisId axis_{};               ///< the first of them: one is dealt with after the other
  std::string words_, refused_id_, field_id_;
  std::array<Offer, 4> offers_;
  std::size_t offered_ = 0;  ///< 0: not named yet
  gui::NumberField field_;
  std::string filled_;            ///< what stands in it unless somebody has typed ...
  std::optional<Steps> counted_;  ///< ... and the count that this is
  RefusalCard card_;
};

}  // namespace hw::panels
