#pragma once
// When a command is refused because a position is doubtful, this card offers remedies: home the axis, set its
// position, or send the refused command once all the same. A panel keeps one object for each row that can be
// refused so, and uses it like this:
//
//     asked_ = doubt_.send(f, intent::MoveTo(...));                    // in place of f.send_and_watch()
//     if (!doubt_.take_refusal(f, *outcome)) refused_ = outcome->sentence.view();  // refused, or failed
//     if (doubt_.open())
//       if (const IntentId id = doubt_.draw(f, "goto", "Go, X", row, mode)) asked_ = id;
//
// Ids, here for axis X of `goto`: `goto/X/refused`, `goto/X/stands_at`, `goto/X/set`, `goto/X/home/-`,
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

class DoubtRemedies {
 public:
  /// Sends as Frame::send_and_watch() does, and forgets the previous refusal.
  IntentId send(gui::Frame& frame, IntentBody body);
  /// Call with any outcome other than done. Returns true when a position was doubtful; the card then shows
  /// it.
  bool take_refusal(const gui::Frame& frame, const IntentOutcome& outcome);
  /// As above, for a command that a job has sent.
  bool take_refusal(const gui::Frame& frame, IntentBody sent, const IntentOutcome& outcome);
  /// Forgets the previous refusal.
  void close() { doubtful_ = 0; }
  [[nodiscard]] bool open() const { return doubtful_ != 0; }
  /// Draws the card beside `row`. Returns the id of the command that a remedy has sent; 0: none was sent.
  /// `mode` is the chosen way of homing; -1: none. The card closes when no position is doubtful any more.
  IntentId draw(gui::Frame& frame, std::string_view prefix, std::string_view about, const gui::Rect& row,
                int mode = -1);

 private:
  enum Remedy : std::uint8_t { set, home_minus, home_plus, once };
  struct Offer {
    Remedy way;
    std::string id, label, brief;
  };
  void describe(const gui::Frame& frame, std::uint32_t doubtful);
  void name_remedies(const gui::Frame& frame, std::string_view prefix);
  /// Returns true when Enter was pressed.
  bool draw_field(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, Remedy way) const;
  [[nodiscard]] std::optional<Steps> place(const gui::Frame& frame) const;
  IntentId go(gui::Frame& frame, Remedy way, int mode);

  std::optional<IntentBody> sent_;
  std::uint32_t doubtful_ = 0;  ///< bit per axis; 0: closed
  AxisId axis_{};               ///< the first doubtful axis: the card handles them one after the other
  std::string words_, refused_id_, field_id_;
  std::array<Offer, 4> offers_;
  std::size_t offered_ = 0;  ///< number of `offers_`; 0: not made yet
  gui::NumberField field_;
  std::string filled_;            ///< content of the field, unless the user has typed
  std::optional<Steps> counted_;  ///< the count that `filled_` shows
  RefusalCard card_;
};

}  // namespace hw::panels
