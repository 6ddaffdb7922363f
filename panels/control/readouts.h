#pragma once
// What a controller tells beside positions and inputs (Catalog::readouts), by group: values of the whole
// controller as rows, values of each axis as a table. Ids: `readout/ID`.
#include <bitset>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// The words of a value, with its unit: "waiting", "1 284 pulses", "?".
class ReadoutText {
 public:
  ReadoutText(const gui::Frame& frame, std::size_t readout);
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] bool old() const { return old_; }  ///< nobody has told it lately
  [[nodiscard]] bool bad() const { return bad_; }  ///< a fault

 private:
  char bytes_[96];
  std::size_t size_ = 0;
  bool known_ = false, old_ = false, bad_ = false;
};

/// By index in Catalog::readouts.
using ReadoutSet = std::bitset<max_readouts>;

/// The readouts of a group at ImGui's cursor, `width` logical, but for those that are `elsewhere`; has them
/// polled while they are in sight.
void draw_readouts(gui::Frame& frame, int group, float width, const ReadoutSet& elsewhere = {});
/// What draw_readouts() takes, logical.
float readouts_height(const Catalog& catalog, int group, const ReadoutSet& elsewhere = {});
/// One value within `in`: a number ends at its right border, a word begins at the left one. Has it polled.
void draw_readout(gui::Frame& frame, std::size_t readout, const gui::Rect& in);

}  // namespace hw::panels
