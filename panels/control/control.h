#pragma once
// Shows actions, settings and values of a controller other than motion: tables with a row for each axis, and
// below them the rest under the catalog's headings.
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/panel_entry.h"
#include "panels/control/action_form.h"
#include "panels/control/arc_form.h"
#include "panels/control/axis_tables.h"

namespace hw::panels {

class Control final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Section {
    std::string title;
    std::string heading;  ///< its title, or another title if a table has that already
    int readouts = -1;    ///< index into Catalog::readout_groups
    int analog = 0;       ///< number of bars
    std::vector<ActionForm> actions;
  };
  void make_sections(const Catalog& catalog);
  void read_settings(gui::Frame& frame);
  /// Number of bars; 0 where the right column shows them.
  [[nodiscard]] static int bars(const gui::Frame& frame, const Section& section);
  Section& section(const std::string& title);
  [[nodiscard]] float height_of(const gui::Frame& frame, const Section& section, float width) const;
  [[nodiscard]] float second_column(float whole) const;
  /// Number of sections in the first of two columns.
  [[nodiscard]] std::size_t first_column(const gui::Frame& frame, float width) const;
  /// `last`: the last section of its column, without a line below.
  void draw_section(gui::Frame& frame, Section& section, float width, bool last);
  void draw_actions(gui::Frame& frame, Section& section, float width);
  static void draw_about(gui::Frame& frame, float width);

  bool made_ = false;
  IntentId reading_ = 0;  ///< the latest request for the settings; 0: none on this connection
  Instant asked_at_{};
  std::vector<Section> sections_;
  std::optional<AxisTables> tables_;
  ReadoutSet elsewhere_;  ///< readouts shown in a table or beside their switch
  ArcPath arc_;
};

/// Whether a controller has enough analog inputs, actions and readouts for this panel.
bool has_control(const Catalog& catalog);

}  // namespace hw::panels
