#include "panels/help/manual_reader.h"

#include <algorithm>
#include <cmath>

#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

const ManualPage* page_named(std::string_view name) {
  const auto pages = manual_pages();
  const auto found =
      std::find_if(pages.begin(), pages.end(), [&](const ManualPage& page) { return page.name == name; });
  return found == pages.end() ? nullptr : &*found;
}

/// "scripts.md#read" split into page and anchor.
struct ManualTarget {
  std::string_view page, anchor;
};
ManualTarget target_of(std::string_view s) {
  const auto hash = s.find('#');
  std::string_view page = s.substr(0, hash);
  if (page.ends_with(".md")) page.remove_suffix(3);
  return {page, hash == s.npos ? std::string_view() : s.substr(hash + 1)};
}

/// Whether the target is in the manual; other targets are shown as text.
bool leads_somewhere(std::string_view target) {
  const ManualTarget to = target_of(target);
  return to.page.empty() ? !to.anchor.empty() : page_named(to.page) != nullptr;
}

void draw_underline(const Ui& ui, ImVec2 at, float width, float line, ImU32 colour) {
  const float y = std::floor(at.y + line) - ui.px(2);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + width, y + ui.hair()), colour);
}

}  // namespace

std::string_view ManualReader::title() const {
  return now_.page ? std::string_view(text_.title) : std::string_view("Manual");
}

void ManualReader::show(Place place) {
  now_ = place;
  text_ = place.page ? read_manual(place.page->markdown) : ManualText();
  layout_ = {};
  scroll_requested_ = true;
}

void ManualReader::open(std::string_view target) {
  const ManualTarget to = target_of(target);
  const ManualPage* page = to.page.empty() && !to.anchor.empty() ? now_.page : page_named(to.page);
  const std::string anchor(to.anchor);  // the target may belong to the page that is replaced
  constexpr std::size_t remembered = 64;
  if (before_.size() == remembered) before_.erase(before_.begin());
  before_.push_back(now_);
  if (page != now_.page || !page)
    show({page, 0});
  else
    scroll_requested_ = true;
  requested_anchor_ = anchor;
}

void ManualReader::go_back() {
  if (before_.empty()) return;
  const Place place = before_.back();
  before_.pop_back();
  requested_anchor_.clear();
  if (place.page != now_.page) return show(place);
  now_ = place;
  scroll_requested_ = true;
}

void ManualReader::draw(PageFrame& f, std::string_view own) {
  if (now_.page)
    draw_page(f);
  else
    draw_contents(f, own);
  follow_request(f.ui.scale);
  if (!scroll_requested_) now_.scroll = ImGui::GetScrollY() / f.ui.scale;
}

/// Scrolls one frame later, because the scroll range is that of the last frame.
void ManualReader::follow_request(float scale) {
  if (!scroll_requested_ || (now_.page && layout_.width == 0)) return;
  scroll_requested_ = false;
  float to = now_.scroll * scale;
  for (const ManualMark& mark : layout_.marks)
    if (!requested_anchor_.empty() && mark.anchor == requested_anchor_) to = mark.y;
  requested_anchor_.clear();
  ImGui::SetScrollY(to);
}

// ---- contents

void ManualReader::draw_contents(PageFrame& f, std::string_view own) {
  const auto pages = manual_pages();
  if (titles_.empty())
    for (const ManualPage& page : pages) titles_.push_back(read_manual(page.markdown).title);
  const ManualPage* chosen = nullptr;
  const ManualPage* first = page_named(own);
  if (first) {
    section_title(f.ui, "This controller");
    if (draw_row(f, *first)) chosen = first;
    section_title(f.ui, "All pages", {}, 48);
  }
  for (const ManualPage& page : pages)
    if (&page != first && draw_row(f, page)) chosen = &page;
  gap(f.ui, 16);
  if (chosen) open(chosen->name);
}

bool ManualReader::draw_row(PageFrame& f, const ManualPage& page) {
  Ui& ui = f.ui;
  const std::string& title = titles_[static_cast<std::size_t>(&page - manual_pages().data())];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const Touch t = touch(ui, {Path("help/page/{}", page.name), Kind::button, title}, ImVec2(width, ui.px(32)));
  if (t.hovered || t.held) draw_across(ui, t.rect.min.y, t.rect.max.y, ui[Tone::hover]);
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + width, at.y + ui.hair()), ui[Tone::line]);
  draw_text_line(ui, at.x, t.rect.max.x - ui.px(20), t.rect.centre().y, Face::body, ui[Tone::ink], title);
  draw_icon(ImGui::GetWindowDrawList(), Icon::chevron_right,
            ImVec2(t.rect.max.x - ui.px(8), std::floor(t.rect.centre().y)), ui.px(12), ui[Tone::ink3]);
  draw_ring(ui, t);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
  return t.clicked;
}

// ---- a page

void ManualReader::draw_page(PageFrame& f) {
  Ui& ui = f.ui;
  const float width = std::floor(ImGui::GetContentRegionAvail().x);
  if (layout_.width != width || layout_.scale != ui.scale) {
    layout_ = lay_out_manual(ui, text_, width);
    scroll_requested_ = true;  // scrolls to the previous position, in the new scale
  }
  gap(ui, 12);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const Rect& well : layout_.wells)
    draw_fill(ui,
              {ImVec2(at.x + well.min.x, at.y + well.min.y), ImVec2(at.x + well.max.x, at.y + well.max.y)},
              ui[Tone::well], 2);
  for (const float y : layout_.hairlines)
    list->AddRectFilled(ImVec2(at.x, std::floor(at.y + y)),
                        ImVec2(at.x + width, std::floor(at.y + y) + ui.hair()), ui[Tone::line]);
  for (const ManualMark& mark : layout_.marks)
    gui::show(ui, {Path("help/heading/{}", mark.anchor), Kind::text, mark.words, mark.words},
              {ImVec2(at.x, at.y + mark.y), ImVec2(at.x + width, at.y + mark.y + ui.px(20))});
  const std::string_view target = draw_runs(f, at);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + layout_.height));
  gap(ui, 24);
  if (!target.empty()) open(target);
}

/// Draws the visible runs. Returns the target of a pressed link.
std::string_view ManualReader::draw_runs(PageFrame& f, ImVec2 at) {
  Ui& ui = f.ui;
  const Rect sight{ImGui::GetWindowPos(), ImVec2(ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                                                 ImGui::GetWindowPos().y + ImGui::GetWindowHeight())};
  std::string_view target;
  for (const ManualRun& run : layout_.runs) {
    const ImVec2 place(at.x + run.x, at.y + run.y);
    const float line = ui.line(run.face);
    const bool in_sight = place.y + line >= sight.min.y && place.y <= sight.max.y;
    // A link continued on the next line can be pressed there too, with the id of its beginning.
    const bool leads = run.link >= 0 && leads_somewhere(layout_.links[static_cast<std::size_t>(run.link)]);
    if (leads && (in_sight || run.begins)) {
      ImGui::SetCursorScreenPos(place);
      const std::string_view leads_to = layout_.links[static_cast<std::size_t>(run.link)];
      const Path id("help/link/{}{}", run.link, run.begins ? "" : "/on");
      const Touch t = touch(ui, {id, Kind::button, run.text, leads_to}, ImVec2(run.width, line));
      draw_underline(ui, place, run.width, line, ui[t.hovered ? Tone::ink : Tone::edge]);
      draw_ring(ui, t);
      if (t.clicked) target = leads_to;
    }
    if (in_sight) draw_text(ui, place, run.face, ui[run.tone], run.text);
  }
  return target;
}

}  // namespace hw::panels
