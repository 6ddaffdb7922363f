// Creates, checks, sends, saves and opens the rows of a list of moves.
#include <cmath>

#include <fmt/core.h>

#include "core/session/text_file.h"
#include "gui/model/tab.h"
#include "gui/widgets/message.h"
#include "panels/moves.h"

namespace hw::panels {

using namespace gui;

void Moves::add_row(const Catalog& c) {
  Row row(c.move_list.columns.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const ActionField& info = c.move_list.columns[i];
    if (!rows_.empty())
      row[i].set(rows_.back()[i].value().value_or(0), info.decimals);
    else
      row[i].set(static_cast<double>(info.fallback) / std::pow(10.0, info.decimals), info.decimals);
  }
  rows_.push_back(std::move(row));
  edited_ = true;
}

void Moves::show_rows(const std::vector<MoveRow>& rows, const MoveListFacts& facts) {
  rows_.assign(rows.size(), Row(facts.columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const int decimals = facts.columns[c].decimals;
      rows_[r][c].set(static_cast<double>(rows[r][c]) / std::pow(10.0, decimals), decimals);
    }
}

std::optional<std::vector<MoveRow>> Moves::values(const MoveListFacts& facts, std::string& why) {
  std::vector<MoveRow> all;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    MoveRow row;
    for (std::size_t c = 0; c < rows_[r].size(); ++c) {
      const ActionField& info = facts.columns[c];
      const double scale = std::pow(10.0, info.decimals);
      NumberField& field = rows_[r][c];
      field.sentence = range_sentence(field.text, {static_cast<double>(info.minimum) / scale,
                                                   static_cast<double>(info.maximum) / scale,
                                                   info.decimals,
                                                   {}});
      if (!field.sentence.empty()) {
        why = fmt::format("Move {}, {}: {}", r + 1, info.label, field.sentence);
        return {};
      }
      row.push_back(std::llround(*field.value() * scale));
    }
    all.push_back(std::move(row));
  }
  return all;
}

std::string_view Moves::unkept() const {
  return edited_ && !rows_.empty() ? "The list of moves has unsaved changes." : "";
}

void Moves::start(Frame& f) {
  std::string why;
  auto rows = values(f.catalog.move_list, why);
  if (!rows) return f.toast(Severity::fault, why + ". Nothing was sent.");
  past_.reset();
  started_ = doubt_.send(f, intent::FeedMoves(std::move(*rows)));
}

void Moves::begin_new(Frame& f) {
  if (asked_to_open_)
    return open_.ask_open("Open moves", open_.folder(), {f.catalog.move_list.file_suffix, ".csv", ".txt"});
  rows_.clear();
  file_.clear();
  edited_ = false;
}

void Moves::save(Frame& f, const std::filesystem::path& path) {
  std::string why;
  const auto rows = values(f.catalog.move_list, why);
  if (!rows) return f.toast(Severity::fault, why + ". Nothing was saved.");
  TextFile file;
  file.text = write_moves(*rows, f.catalog.move_list);
  const auto saved = save_text(path, file);
  f.withdraw(&file_);  // the message why the last file was not saved or opened
  if (!saved) return f.toast(Severity::fault, saved.error().sentence(), &file_);
  file_ = path;
  edited_ = false;
  f.toast(Severity::ok, fmt::format("Saved as {}.", path.string()));
}

void Moves::open(Frame& f, const std::filesystem::path& path) {
  f.withdraw(&file_);
  const auto file = load_text(path);
  if (!file) return f.toast(Severity::fault, file.error().sentence(), &file_);
  const auto rows = read_moves(file->text, f.catalog.move_list);
  if (!rows) return f.toast(Severity::fault, rows.error().sentence(), &file_);
  show_rows(*rows, f.catalog.move_list);
  file_ = path;
  edited_ = false;
}

void Moves::draw_dialogs(Frame& f) {
  if (asking_) {
    const Dialog what{.title = "Replace the list?",
                      .sentences = "It has unsaved changes.",
                      .yes = "Replace",
                      .no = "Keep the list"};
    if (dialog(f.ui, "list/replace", asking_, what) == Answer::yes) begin_new(f);
  }
  if (const auto path = open_.draw(f.ui)) open(f, *path);
  if (const auto path = save_.draw(f.ui)) save(f, *path);
}

}  // namespace hw::panels
