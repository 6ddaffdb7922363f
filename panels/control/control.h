#pragma once
// Actions, settings and values of a controller apart from motion: tables with a row per axis, and under them
// the rest, by the catalog's headings.
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
    std::string heading;  ///< its title, or another one if a table already has it
    int readouts = -1;    ///< index into Catalog::readout_groups
    int analog = 0;       ///< number of bars
    std::vector<ActionForm> actions;
  };
  void make_sections(const Catalog& catalog);
  void read_settings(gui::Frame& frame);
  /// Number of bars: where the right column is drawn, they stand there.
  [[nodiscard]] static int bars(const gui::Frame& frame, const Section& section);
  Section& section(const std::string& title);
  [[nodiscard]] float height_of(const gui::Frame& frame, const Section& section, float width) const;
  [[nodiscard]] float second_column(float whole) const;
  /// Number of sections in the first of two columns.
  [[nodiscard]] std::size_t first_column(const gui::Frame& frame, float width) const;
  /// `last`: of its column, so no line is drawn below.
  void draw_section(gui::Frame& frame, Section& section, float width, bool last);
  void draw_actions(gui::Frame& frame, Section& section, float width);
  static void draw_about(gui::Frame& frame, float width);

  bool made_ = false;
  IntentId reading_ = 0;  ///< the latest request for the settings; 0: none since the link came
  Instant asked_at_{};
  std::vector<Section> sections_;
  std::optional<AxisTables> tables_;
  ReadoutSet elsewhere_;  ///< readouts shown in a table or beside their switch
  ArcPath arc_;
};

/// Its analog inputs, actions and readouts are worth a panel of their own.
bool has_control(const Catalog& catalog);

}  // namespace hw::panels
