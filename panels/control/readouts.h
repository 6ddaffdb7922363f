#pragma once
// Draws the values that a controller reports in addition to positions and inputs (Catalog::readouts), by
// group: values of the whole controller as rows, values of each axis as a table. Ids: `readout/ID`.
#include <bitset>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// A value in words, with its unit: "waiting", "1 284 pulses", "?".
class ReadoutText {
 public:
  ReadoutText(const gui::Frame& frame, std::size_t readout);
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] bool old() const { return old_; }  ///< not reported lately
  [[nodiscard]] bool bad() const { return bad_; }  ///< a fault

 private:
  char bytes_[96];
  std::size_t size_ = 0;
  bool known_ = false, old_ = false, bad_ = false;
};

/// A set of indices of Catalog::readouts.
using ReadoutSet = std::bitset<max_readouts>;

/// Draws the readouts of a group at ImGui's cursor, except those `elsewhere`, and polls them while they are
/// visible. `width` logical.
void draw_readouts(gui::Frame& frame, int group, float width, const ReadoutSet& elsewhere = {});
/// Height of draw_readouts(), logical.
float readouts_height(const Catalog& catalog, int group, const ReadoutSet& elsewhere = {});
/// The readout of free places in the buffer of moves; -1: none.
int find_free_places(const Catalog& catalog);
/// Draws a value within `in` and polls it. Numbers are right-aligned, words left-aligned.
void draw_readout(gui::Frame& frame, std::size_t readout, const gui::Rect& in);

}  // namespace hw::panels
