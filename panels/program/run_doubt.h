#pragma once
// A program moves to counted positions. If a count is doubtful, the run is held back
// before anything is sent, and the remedies stand beside Run. Ids, with the axis concerned:
// `WHERE/doubt/refused`, `WHERE/doubt/stands`, `WHERE/doubt/home/-`, `WHERE/doubt/home/+`,
// `WHERE/doubt/once`.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/device/intent.h"
#include "panels/program/run_bar.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class RunDoubt {
 public:
  /// True: this text relies on doubtful counts, and the question is shown here.
  bool holds_back(const gui::Frame& frame, RunRequest request, const std::string& text);
  struct Once {
    RunRequest request = RunRequest::none;
    gui::AgreedDoubts agreed{};  ///< the doubts that were shown, and no others
  };
  /// Draws beside `row` while the run of `text` is held back. Returns the run to begin once all the same.
  Once draw(gui::Frame& frame, std::string_view where, const gui::Rect& row, const std::string& text);

 private:
  enum Way : std::uint8_t { stands, home_minus, home_plus, once };
  struct Offer {
    Way way;
    std::string id, label, brief;
  };
  /// Finds the places to which the text sends doubtful axes; false: none are known.
  bool find_places(const gui::Frame& frame, const std::string& text);
  /// Travel limits do not bind the user's own texts.
  [[nodiscard]] bool is_beyond_travel(const gui::Frame& frame) const;
  void describe(const gui::Frame& frame, std::uint32_t doubtful);
  void name_ways(const gui::Frame& frame, std::string_view where);
  void go(gui::Frame& frame, Way way) const;
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, Way way) const;

  RunRequest request_ = RunRequest::none;  ///< none: nothing is held back
  std::string text_;                       ///< the text concerned
  intent::RunProgram run_{0};
  bool written_ = false;         ///< from a sequence, not typed
  gui::AgreedDoubts doubted_{};  ///< of all axes, when its places were found
  std::uint32_t doubtful_ = 0;   ///< of these, those that it is about
  AxisId axis_{};                ///< the first of them: axes are dealt with one after the other
  std::string words_, refused_id_;
  Steps counted_;  ///< shown by `stands`
  std::array<Offer, 4> offers_;
  std::size_t offered_ = 0;  ///< 0: not named yet
  RefusalCard card_;
};

}  // namespace hw::panels
