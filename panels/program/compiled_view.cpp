#include "panels/program/compiled_view.h"

#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/text.h"
#include "panels/program/threads.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float code_row_height = 24, number_right = 48, code_left = 72, source_width = 0.45f;

const std::vector<std::string>* listing_of(const ProgramReport& report, int slot) {
  const auto found = report.listing.find(slot);
  return found == report.listing.end() || found->second.empty() ? nullptr : &found->second;
}

}  // namespace

void CompiledView::follow(ProgramTexts& texts, int slot) {
  const ProgramReport& report = texts.report(slot);
  if (version_ == texts.version(slot) && slot_ == slot) return;
  version_ = texts.version(slot);
  slot_ = slot;
  whole_.clear();
  source_lines_.clear();
  const auto* listing = listing_of(report, slot);
  if (!listing) return;
  source_lines_.assign(listing->size(), -1);
  for (const std::string& line : *listing) whole_ += line + "\n";
  for (std::size_t i = 0; i < report.lines.size(); ++i)
    for (int n = 0; n < report.lines[i].command_count; ++n)
      if (const int at = report.lines[i].first_command + n;
          at >= 0 && at < static_cast<int>(source_lines_.size()))
        source_lines_[static_cast<std::size_t>(at)] = static_cast<int>(i);
}

void CompiledView::draw(Frame& f, int slot, float width, float height) {
  Ui& ui = f.ui;
  ProgramTexts& texts = f.tab.desk().programs.texts;
  follow(texts, slot);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  show(ui, {"program/listing", Kind::text, "Compiled program", whole_, {}, false, {}},
       {at, ImVec2(at.x + ui.px(width), at.y + ui.px(height))});
  begin_part(ui, "program/compiled", ui.px(width), ui.px(height), Tone::well, 0);
  const auto* listing = listing_of(texts.report(slot), slot);
  if (!listing) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(16), at.y + ui.px(16)));
    wrapped(ui, Face::body, Tone::ink2,
            texts.text(slot).empty() ? "The program is empty."
                                     : "There is nothing to show until its errors are corrected.");
    return end_part();
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(listing->size()), ui.px(code_row_height));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const ImVec2 here = ImGui::GetCursorScreenPos();
      const float right = here.x + ui.px(width), source = here.x + ui.px(width * source_width);
      const Path number("{}", i);
      draw_text_right(ui, ImVec2(here.x + ui.px(number_right), here.y + ui.px(2)), Face::code_field,
                      ui[Tone::ink3], number);
      const float middle = here.y + ui.px(code_row_height / 2);
      draw_text_line(ui, here.x + ui.px(code_left), source - ui.px(16), middle, Face::code, ui[Tone::ink],
                     (*listing)[static_cast<std::size_t>(i)]);
      const int line = source_lines_[static_cast<std::size_t>(i)];
      if (line >= 0) {
        draw_text_line(ui, source, source + ui.px(40), middle, Face::code_field, ui[Tone::ink3],
                       Path("{}", line + 1));
        draw_text_line(ui, source + ui.px(44), right - ui.px(16), middle, Face::code_field, ui[Tone::ink2],
                       line_of(texts.text(slot), line));
      }
      ImGui::SetCursorScreenPos(ImVec2(here.x, here.y + ui.px(code_row_height)));
    }
  clipper.End();
  end_part();
}

}  // namespace hw::panels
