#pragma once
// Asks before a program moves to doubtful positions. The run is held back before any command is sent, and the
// remedies are beside Run. Ids, with the axis concerned: `WHERE/doubt/refused`, `WHERE/doubt/stands`,
// `WHERE/doubt/home/-`, `WHERE/doubt/home/+`, `WHERE/doubt/once`.
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
  /// Returns true when the text relies on doubtful counts; the question is then shown.
  bool holds_back(const gui::Frame& frame, RunRequest request, const std::string& text);
  struct AcceptedRun {
    RunRequest request = RunRequest::none;
    gui::AgreedDoubts agreed{};  ///< only the doubts that were shown
  };
  /// Draws beside `row` while the run of `text` is held back. Returns the run that the user wants once all
  /// the same.
  AcceptedRun draw(gui::Frame& frame, std::string_view where, const gui::Rect& row, const std::string& text);

 private:
  enum Remedy : std::uint8_t { stands, home_minus, home_plus, once };
  struct Offer {
    Remedy way;
    std::string id, label, brief;
  };
  /// Finds the targets of doubtful axes in the text. Returns false when none is known.
  bool find_places(const gui::Frame& frame, const std::string& text);
  /// Whether a target is beyond a travel limit. These limits do not apply to texts that the user has typed.
  [[nodiscard]] bool is_beyond_travel(const gui::Frame& frame) const;
  void describe(const gui::Frame& frame, std::uint32_t doubtful);
  void name_remedies(const gui::Frame& frame, std::string_view where);
  void go(gui::Frame& frame, Remedy way) const;
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, Remedy way) const;

  RunRequest request_ = RunRequest::none;  ///< none: no run is held back
  std::string text_;                       ///< the text concerned
  intent::RunProgram run_{0};
  bool written_ = false;         ///< the text was written from a sequence, not typed
  gui::AgreedDoubts doubted_{};  ///< doubts of all axes when the targets were found
  std::uint32_t doubtful_ = 0;   ///< the doubtful axes that the question is about
  AxisId axis_{};                ///< the first of them: the card handles them one after the other
  std::string words_, refused_id_;
  Steps counted_;  ///< count shown by `stands`
  std::array<Offer, 4> offers_;
  std::size_t offered_ = 0;  ///< number of `offers_`; 0: not made yet
  RefusalCard card_;
};

}  // namespace hw::panels
