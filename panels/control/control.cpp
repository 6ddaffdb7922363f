#include "panels/control/control.h"

#include <algorithm>

#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/text.h"
#include "panels/control/action_choice.h"
#include "panels/control/analog_bar.h"
#include "panels/control/readouts.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float below_section = 12;

/// Whether an axis can be made to follow an analog input; bars of the analog inputs are then shown.
bool any_follows_analog(const Catalog& c) {
  return std::any_of(c.actions.begin(), c.actions.end(),
                     [](const ActionInfo& a) { return a.follows_analog; });
}

/// Names parameters of the manual that the controller does not answer, because its firmware is older.
Path unanswered(const Frame& f) {
  char names[72];
  std::size_t size = 0;
  int readable = 0, silent = 0;
  for (std::size_t i = 0; i < f.catalog.params.size(); ++i) {
    if (!f.catalog.params[i].readable) continue;
    ++readable;
    if (f.now.params[i].known) continue;
    ++silent;
    const auto end = fmt::format_to_n(names + size, sizeof names - size, "{}{}", size ? ", " : "",
                                      f.catalog.params[i].mnemonic);
    size = std::min(sizeof names, size + end.size);
  }
  if (silent == 0) return Path("nothing: it supports every setting");
  if (silent == readable) return Path("not known: read the set-up first");
  return Path("{}: {}{}", silent, std::string_view(names, size), size == sizeof names ? " ..." : "");
}

std::string_view reported(const auto& text) {
  return text.empty() ? std::string_view("not told") : text.view();
}

}  // namespace

bool has_control(const Catalog& c) { return !c.actions.empty() || !c.readouts.empty(); }

Control::Section& Control::section(const std::string& title) {
  for (Section& s : sections_)
    if (s.title == title) return s;
  sections_.emplace_back();
  sections_.back().title = title;
  sections_.back().heading = tables_->has_title(title) ? "General" : title;
  return sections_.back();
}

void Control::make_sections(const Catalog& c) {
  if (std::exchange(made_, true)) return;
  tables_.emplace(c);
  elsewhere_ = tables_->readouts();
  for (const ActionInfo& a : c.actions)
    if (const int set = c.find_readout(a.sets); set >= 0) elsewhere_.set(static_cast<std::size_t>(set));
  for (std::size_t i = 0; i < c.readout_groups.size(); ++i) {
    const int group = static_cast<int>(i);
    if (readouts_height(c, group, elsewhere_) > 0 && group != c.variables.readout_group)
      section(c.readout_groups[i]).readouts = group;
  }
  if (any_follows_analog(c)) section("Analog inputs").analog = static_cast<int>(c.analog.size());
  for (std::size_t i = 0; i < c.actions.size(); ++i)
    if (!tables_->has_action(c, static_cast<int>(i)))
      section(c.actions[i].group).actions.emplace_back(c, static_cast<int>(i));
  // Actions that draw a path are at the top of the first column.
  std::stable_partition(sections_.begin(), sections_.end(), [&](const Section& s) {
    return std::any_of(s.actions.begin(), s.actions.end(), [&](const ActionForm& a) {
      return c.actions[static_cast<std::size_t>(a.action())].is_arc;
    });
  });
}

/// Reads the settings once per connection, so that a switch in a table shows its state. If the request was
/// refused because other work was under way, it is repeated.
void Control::read_settings(Frame& f) {
  constexpr double again_after_s = 3;
  if (!f.connected()) reading_ = 0;
  if (!f.connected() || !tables_->lacks_settings(f)) return;
  if (reading_ != 0) {
    const IntentOutcome* outcome = f.now.outcome_of(reading_);
    if (!outcome && !f.now.forgotten(reading_)) return;
    if (outcome && (outcome->state == IntentState::pending || outcome->state == IntentState::done)) return;
    const double left = again_after_s - seconds(f.clock - asked_at_);
    if (left > 0) return f.ui.wake_in(left + 0.001);
  }
  reading_ = f.send_and_watch(intent::ReadParams());
  asked_at_ = f.clock;
}

int Control::bars(const Frame& f, const Section& s) { return f.tier == Tier::wide ? 0 : s.analog; }

void Control::draw(Frame& f) {
  make_sections(f.catalog);
  read_settings(f);
  if (any_follows_analog(f.catalog))
    f.tab.watched.look_at_group(f.catalog.analog_readout_group);  // the bars may be anywhere
  Ui& ui = f.ui;
  begin_part(ui, "control", 0, ui.px(f.area.height), Tone::panel, 16);
  const float whole = ImGui::GetContentRegionAvail().x / ui.scale;
  tables_->draw(f, whole);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool two = whole >= 640;
  const float second = two ? second_column(whole) : 0;
  const float width = two ? second - between_columns : whole, second_width = whole - second;
  const std::size_t left = two ? first_column(f, width) : sections_.size();
  const auto stand = [&](float x, float y) { ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), y)); };
  if (!two) tables_->draw_shared(f, width);
  for (std::size_t i = 0; i < left; ++i) {
    stand(0, ImGui::GetCursorScreenPos().y);
    draw_section(f, sections_[i], width, two && i + 1 == left);
  }
  const float left_end = ImGui::GetCursorScreenPos().y;
  if (two) stand(second, at.y);
  if (two) tables_->draw_shared(f, second_width);
  for (std::size_t i = left; i < sections_.size(); ++i) {
    stand(second, ImGui::GetCursorScreenPos().y);
    draw_section(f, sections_[i], second_width, false);
  }
  stand(second, ImGui::GetCursorScreenPos().y);
  draw_about(f, second_width);
  stand(0, std::max(left_end, ImGui::GetCursorScreenPos().y));
  gap(ui, 16);
  end_part();
}

/// The left of the second column: that of the second of two tables, if they share the width more or less
/// evenly; else half of the width.
float Control::second_column(float whole) const {
  const float of_tables = tables_->second_column();
  if (of_tables >= whole * 0.42f && of_tables <= whole * 0.58f) return of_tables;
  return std::floor((whole - between_columns) / 2) + between_columns;
}

std::size_t Control::first_column(const Frame& f, float width) const {
  float all = 0;
  for (const Section& s : sections_) all += height_of(f, s, width);
  float left = 0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const float height = height_of(f, sections_[i], width);
    if (left + height / 2 > all / 2 && i > 0) return i;
    left += height;
  }
  return sections_.size();
}

float Control::height_of(const Frame& f, const Section& s, float width) const {
  if (s.readouts < 0 && s.actions.empty() && bars(f, s) == 0) return 0;
  float height = title_height + below_section;
  if (s.readouts >= 0) height += readouts_height(f.catalog, s.readouts, elsewhere_);
  height += analog_bar_height * static_cast<float>(bars(f, s));
  for (const ActionForm& a : s.actions)
    height += f.catalog.actions[static_cast<std::size_t>(a.action())].is_arc ? arc_height
              : is_setter(f.catalog, a)                                      ? setter_height
                                                                             : a.height(width);
  return height;
}

void Control::draw_section(Frame& f, Section& s, float width, bool last) {
  if (height_of(f, s, width) == 0) return;
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(title_height / 2), Face::body_bold,
                 ui[Tone::ink], s.heading);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(title_height)));
  if (s.readouts >= 0) draw_readouts(f, s.readouts, width, elsewhere_);
  for (int n = 1; n <= bars(f, s); ++n) draw_analog_bar(f, Path("control/analog/{}", n), n, width);
  if (s.readouts >= 0 && !s.actions.empty()) gap(ui, 8);
  draw_actions(f, s, width);
  gap(ui, below_section - 4);
  if (last) return;
  const ImVec2 end = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, end.y),
                                            ImVec2(at.x + ui.px(width), end.y + ui.hair()), ui[Tone::line]);
  gap(ui, 4);
}

void Control::draw_actions(Frame& f, Section& s, float width) {
  Ui& ui = f.ui;
  const float left = ImGui::GetCursorScreenPos().x, right = left + ui.px(width);
  float x = left;
  bool on_line = false;
  const auto end_line = [&] {
    if (on_line) gap(ui, 8);
    on_line = false;
    x = left;
    ImGui::SetCursorScreenPos(ImVec2(left, ImGui::GetCursorScreenPos().y));
  };
  for (std::size_t i = 0; i < s.actions.size(); ++i) {
    ActionForm& a = s.actions[i];
    if (is_of_choice(f.catalog, a)) {
      end_line();
      draw_action_choice(f, s.actions, i, width);
      i = end_of_choice(f.catalog, s.actions, i) - 1;
      continue;
    }
    if (!a.only_a_button()) {
      end_line();
      if (f.catalog.actions[static_cast<std::size_t>(a.action())].is_arc)
        arc_.draw(f, a, width);
      else if (is_setter(f.catalog, a))
        draw_setter(f, a, width);
      else
        a.draw(f, width);
      continue;
    }
    const float wide = ui.px(a.button_width(ui));
    if (on_line && x + wide > right) end_line();
    const float y = ImGui::GetCursorScreenPos().y;
    if (on_line) ImGui::SetCursorScreenPos(ImVec2(x, y - ui.px(32)));
    a.draw_button(f, 0);
    ImGui::SetCursorScreenPos(ImVec2(left, std::max(y, ImGui::GetItemRectMax().y)));
    x += wide + ui.px(8);
    on_line = true;
  }
  end_line();
  for (ActionForm& a : s.actions)
    if (a.only_a_button() && !is_of_choice(f.catalog, a)) a.draw_refusal(f, width);
}

void Control::draw_about(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(title_height / 2), Face::body_bold,
                 ui[Tone::ink], "Controller");
  float y = at.y + ui.px(title_height);
  const auto fact = [&](std::string_view id, std::string_view name, std::string_view value) {
    const Rect row{ImVec2(at.x, y), ImVec2(at.x + ui.px(width), y + ui.px(24))};
    const float middle = std::floor(row.centre().y);
    draw_text_line(ui, row.min.x, row.max.x, middle, Face::body, ui[Tone::ink2], name);
    const float w = std::ceil(text_width(ui, Face::body, value));
    const float name_end = row.min.x + std::ceil(text_width(ui, Face::body, name)) + ui.px(12);
    draw_text_line(ui, std::max(name_end, row.max.x - w), row.max.x + 1, middle, Face::body, ui[Tone::ink],
                   value);
    show(ui, {id, Kind::text, name, value, {}, false, {}}, row);
    y = row.max.y;
  };
  const Identity& identity = f.now.identity;
  fact("about/model", "Reports", reported(identity.model));
  fact("about/firmware", "Firmware", reported(identity.firmware));
  if (!identity.serial.empty()) fact("about/serial", "Device name", identity.serial.view());
  fact("about/console", "This program", "Handwheel " HW_VERSION);
  fact("about/older", "Missing in this firmware", unanswered(f));
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
}

}  // namespace hw::panels
