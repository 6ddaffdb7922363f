#pragma once
// Remedies for a refusal because a position is doubtful: home the axis, set its position, or send the refused
// command once all the same. A panel keeps one for each row that can be refused so, and uses it like this:
//
//     asked_ = doubt_.send(f, intent::MoveTo(...));                    // in place of f.send_and_watch()
//     if (!doubt_.take_refusal(f, *outcome)) refused_ = outcome->sentence.view();  // refused, or failed
//     if (doubt_.open())
//       if (const IntentId id = doubt_.draw(f, "goto", "Go, X", row, mode)) asked_ = id;
//
// Ids, with the axis concerned: `goto/X/refused`, `goto/X/stands_at`, `goto/X/set`, `goto/X/home/-`,
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
  /// Sends like Frame::send_and_watch(), and forgets the previous refusal.
  IntentId send(gui::Frame& frame, IntentBody body);
  /// Call with any outcome other than done. True: a position was doubtful, and the card shows it.
  bool take_refusal(const gui::Frame& frame, const IntentOutcome& outcome);
  /// The same for a command that a job has sent.
  bool take_refusal(const gui::Frame& frame, IntentBody sent, const IntentOutcome& outcome);
  /// Forgets the previous refusal.
  void close() { doubtful_ = 0; }
  [[nodiscard]] bool open() const { return doubtful_ != 0; }
  /// Draws the card beside `row`. Returns the remedy's command, to be followed; 0: none was sent. `mode`: the
  /// chosen way of homing; -1: none. The card closes by itself once no position is doubtful.
  IntentId draw(gui::Frame& frame, std::string_view prefix, std::string_view about, const gui::Rect& row,
                int mode = -1);

 private:
  enum Way : std::uint8_t { set, home_minus, home_plus, once };
  struct Offer {
    Way way;
    std::string id, label, brief;
  };
  void describe(const gui::Frame& frame, std::uint32_t doubtful);
  void name_ways(const gui::Frame& frame, std::string_view prefix);
  /// True: Enter was pressed.
  bool draw_field(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, Way way) const;
  [[nodiscard]] std::optional<Steps> place(const gui::Frame& frame) const;
  IntentId go(gui::Frame& frame, Way way, int mode);

  std::optional<IntentBody> sent_;
  std::uint32_t doubtful_ = 0;  ///< bit per axis; 0: closed
  AxisId axis_{};               ///< the first of them: axes are dealt with one after the other
  std::string words_, refused_id_, field_id_;
  std::array<Offer, 4> offers_;
  std::size_t offered_ = 0;  ///< 0: not named yet
  gui::NumberField field_;
  std::string filled_;            ///< content of the field unless the user has typed ...
  std::optional<Steps> counted_;  ///< ... and its count
  RefusalCard card_;
};

}  // namespace hw::panels
