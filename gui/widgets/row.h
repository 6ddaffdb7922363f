#pragma once
// Rows of lists and tables: no frame, no stripes, a hairline above each, titles small, numbers right aligned.
#include <span>
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

struct Column {
  std::string_view title;
  float width = 0;     ///< logical; 0: an equal share of the remaining width
  bool right = false;  ///< numbers
};

/// Places the columns within a line.
class Columns {
 public:
  Columns(const Ui& ui, std::span<const Column> columns, float left_px, float right_px);
  [[nodiscard]] Rect cell(std::size_t column, const Rect& row) const;
  void text(const Ui& ui, std::size_t column, const Rect& row, Face face, ImU32 colour,
            std::string_view s) const;
  [[nodiscard]] std::span<const Column> columns() const { return columns_; }

 private:
  std::span<const Column> columns_;
  float left_ = 0, right_ = 0, share_ = 0, scale_ = 1;
};

/// Draws the titles in a row 32 high.
void table_head(Ui& ui, const Columns& columns);

struct RowOptions {
  float height = 32;
  bool chosen = false;  ///< sel, 3 px bar
  bool bad = false;     ///< fault_t, red bar
  bool hairline = true;
  bool pressable = true;
  std::string_view value = {};
  std::string_view disabled = {};
};
/// The background of a row over the full width of the window; the panel draws into touch.rect. If the row
/// contains controls, set `pressable` to false, or draw them after SetItemAllowOverlap.
Touch row(Ui& ui, std::string_view id, std::string_view label, const RowOptions& options = {});

}  // namespace hw::gui
