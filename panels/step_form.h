#pragma once
// The fields of one step of a sequence, drawn from the description by which files hold them
// (core/sequence/fields.h). Ids: `PATH/KEY`, of a move `PATH/to/AXIS`.
#include <map>
#include <string>
#include <string_view>

#include "core/sequence/sequence.h"
#include "gui/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class StepForm {
 public:
  /// At ImGui's cursor. True: a hand has changed `body`.
  bool draw(gui::Frame& frame, std::string_view path, sequence::Step::Body& body,
            const sequence::Sequence& of, float width);
  /// Another step is shown from now on, or the same with other values.
  void forget() { numbers_.clear(); }

 private:
  std::map<std::string, gui::NumberField, std::less<>> numbers_;
};

}  // namespace hw::panels
