#pragma once
// What a controller can do and tell beside moving: its readouts and actions, by the catalog's headings.
#include <string>
#include <vector>

#include "gui/shell/panel_entry.h"
#include "panels/control/action_form.h"

namespace hw::panels {

class Control final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Section {
    std::string title;
    int readouts = -1;  ///< index into Catalog::readout_groups
    std::vector<ActionForm> actions;
  };
  void make_sections(const Catalog& catalog);
  Section& section(const std::string& title);
  static float height_of(const gui::Frame& frame, const Section& section, float width);
  /// The sections that stand in the first of two columns.
  [[nodiscard]] std::size_t first_column(const gui::Frame& frame, float width) const;
  static void draw_section(gui::Frame& frame, Section& section, float width);
  static void draw_actions(gui::Frame& frame, Section& section, float width);
  static void draw_about(gui::Frame& frame, float width);

  bool made_ = false;
  std::vector<Section> sections_;
};

/// Its analog inputs, actions and readouts are worth a panel of their own.
bool has_control(const Catalog& catalog);

}  // namespace hw::panels
