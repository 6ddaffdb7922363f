#pragma once
// A choice of one name: a segment if the names fit on a line, else a drop-down.
#include <span>
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

/// The place of an open list, in pixels: below its button, else above it, else as far down as it fits. It
/// never covers the top bar, because STOP ALL is there.
Rect place_list(const Ui& ui, const Rect& opener, float width, float height);

struct SegmentOptions {
  std::string_view disabled = {};
  float cell_width = 32;  ///< least width of a cell
  float height = 32;
};
/// Cells in a well; their ids are `id/<name>`. Returns the index chosen in this frame, or -1.
int segment(Ui& ui, std::string_view id, std::span<const std::string_view> names, int chosen,
            const SegmentOptions& options = {});

struct DropdownOptions {
  std::string_view disabled = {};
  std::string_view tip = {};
  float width = 0;  ///< 0: as wide as the longest name
  float height = 32;
  bool error = false;
  std::string_view none = {};  ///< shown while none is chosen
};
/// A button with the chosen name and a chevron. It opens rows 32 high; their ids are `id/<name>`. Up, Down
/// and Enter choose in the open list. Returns the index chosen in this frame, or -1.
int dropdown(Ui& ui, std::string_view id, std::string_view label, std::span<const std::string_view> names,
             int chosen, const DropdownOptions& options = {});

/// A button that opens a list of actions. Returns the index chosen in this frame, or -1. `titled`: the label
/// is a title, so an arrow shows that the button opens a list.
int menu(Ui& ui, std::string_view id, std::string_view label, std::span<const std::string_view> names,
         std::string_view disabled = {}, float height = 32, bool titled = false);

}  // namespace hw::gui
