#pragma once
// Buffered moves: a list, with a file of its own, is fed into the controller's buffer as entries become free.
// All other controls work meanwhile. Ids: `list/ROW/COLUMN` (rows from 1), `list/start` ...
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gui/model/move_list.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/file_dialog.h"
#include "gui/widgets/number_field.h"
#include "panels/control/action_form.h"
#include "panels/control/readouts.h"
#include "panels/doubt_remedies.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class Moves final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;
  [[nodiscard]] std::string_view unkept() const override;

 private:
  using Row = std::vector<gui::NumberField>;

  void follow(gui::Frame& frame);
  [[nodiscard]] bool buffer_waits(const gui::Frame& frame) const;
  void draw_toolbar(gui::Frame& frame);
  void draw_progress(gui::Frame& frame, float left, float right, float middle);
  void draw_file_line(gui::Frame& frame);
  void draw_table(gui::Frame& frame, float width, float height);
  void draw_head(gui::Frame& frame, float width);
  bool draw_row(gui::Frame& frame, std::size_t row, float width);
  void draw_side(gui::Frame& frame, float width);
  void draw_param(gui::Frame& frame, std::size_t param, float width);
  void draw_dialogs(gui::Frame& frame);
  void draw_refusal(gui::Frame& frame, const gui::Rect& beside);
  [[nodiscard]] gui::NumberField* cell_past_limit(const Catalog& catalog, int& decimals);

  void add_row(const Catalog& catalog);
  void show_rows(const std::vector<gui::MoveRow>& rows, const MoveListFacts& facts);
  /// The numbers of the list. nullopt: a cell holds no valid number; `why` says which.
  std::optional<std::vector<gui::MoveRow>> values(const MoveListFacts& facts, std::string& why);
  void start(gui::Frame& frame);
  void abort(gui::Frame& frame);
  void save(gui::Frame& frame, const std::filesystem::path& path);
  void open(gui::Frame& frame, const std::filesystem::path& path);
  void begin_new(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not_start(const gui::Frame& frame) const;

  std::vector<Row> rows_;
  std::vector<ActionForm> actions_;
  ReadoutSet beside_switch_;  ///< readouts shown beside a switch
  bool made_ = false, edited_ = false, to_end_ = false;
  std::filesystem::path file_;
  gui::FileDialog open_, save_;
  bool asking_ = false, asked_to_open_ = false;  ///< a question is open before edited rows are discarded
  bool works_ = true;  ///< the list is being sent, or all of it was sent and the buffer is not empty yet
  Instant sent_at_{};  ///< time at which the latest move of the list was sent
  IntentId started_ = 0;
  DoubtRemedies doubt_;
  std::optional<PastTravel> past_;  ///< why the latest Start was refused
  std::string refused_;             ///< the refusal in words
  RefusalCard card_;
};

}  // namespace hw::panels
