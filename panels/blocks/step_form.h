#pragma once
// The fields of one step of a sequence, drawn from the description by which files hold them
// (core/sequence/fields.h), and beside one of them why the controller cannot do it. Ids: `PATH/KEY`, of a
// move `PATH/to/AXIS`, `PATH/axes/1`, `PATH/axes/2` and `PATH/way` of an arc, `PATH/stairs/N/until`,
// `PATH/nearest`, `PATH/refusal`.
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"
#include "core/sequence/words.h"
#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// What the form is of.
struct StepAtHand {
  std::string_view path;
  const sequence::Step::Body& body;
  const sequence::Sequence& of;
  const sequence::Look& look;
  const RefusedStep* refused = nullptr;  ///< null: it is written
};

class StepForm {
 public:
  /// At ImGui's cursor. What a hand has made of its body; none: nothing. At rest it takes nothing from the
  /// heap.
  std::optional<sequence::Step::Body> draw(gui::Frame& frame, const StepAtHand& step, float width);
  /// Another step is shown from now on, or the same with other values.
  void forget() { numbers_.clear(), at_hand_.reset(), problem_.clear(); }
  /// What is typed and cannot be taken, so that the step is still as it was: "Output: from 0 to 64."; empty:
  /// nothing.
  [[nodiscard]] std::string_view problem() const { return problem_; }

 private:
  std::map<std::string, gui::NumberField, std::less<>> numbers_;
  std::optional<sequence::Step::Body> at_hand_;  ///< without the steps that stand in it
  std::string problem_;
};

}  // namespace hw::panels
