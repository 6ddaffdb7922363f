#include "panels/places_menu.h"

#include <algorithm>

#include <imgui.h>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float list_width = 320, side = 12, row_height = 32;

/// The position of the next row of the list.
struct Row {
  explicit Row(const Ui& u) : ui(u), at(ImGui::GetCursorScreenPos()) {}
  void place(float x, float height = 28) const {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), at.y + std::floor(ui.px((row_height - height) / 2))));
  }
  ~Row() { ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(row_height))); }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  [[nodiscard]] float middle() const { return at.y + ui.px(row_height / 2); }
  const Ui& ui;
  const ImVec2 at;
};

AxisTarget* target_of(SavedPlace& place, AxisId axis) {
  const auto found =
      std::find_if(place.at.begin(), place.at.end(), [axis](const AxisTarget& t) { return t.axis == axis; });
  return found == place.at.end() ? nullptr : &*found;
}

}  // namespace

std::optional<std::vector<AxisTarget>> PlacesMenu::draw(Frame& f, float width, float height) {
  ButtonOptions o;
  o.width = width;
  o.height = height;
  o.tip = "Saved positions: go there, or save where the axes stand.";
  const Touch opener = button(f.ui, "places", "Places", o);
  if (!begin_popup(f.ui, "places", opener, list_width, rows(f))) {
    edited_ = -1;
    return {};
  }
  std::optional<std::vector<AxisTarget>> chosen;
  if (f.tab.settings.profile.places.empty()) {
    const Row row(f.ui);
    draw_text_line(f.ui, row.at.x + f.ui.px(side), row.at.x + f.ui.px(list_width - side), row.middle(),
                   Face::body, f.ui[Tone::ink2], "No place is saved yet.");
  }
  for (std::size_t i = 0; i < f.tab.settings.profile.places.size();
       ++i) {  // a place may be forgotten during the loop
    if (auto to = draw_place(f, i)) chosen = std::move(to);
    if (static_cast<int>(i) == edited_) draw_axes(f, i);
  }
  popup_line(f.ui);
  draw_save(f);
  if (chosen) ImGui::CloseCurrentPopup();
  end_popup();
  return chosen;
}

float PlacesMenu::rows(const Frame& f) const {
  const auto places = std::max<std::size_t>(f.tab.settings.profile.places.size(), 1);
  const auto axes = edited_ >= 0 ? f.catalog.axes.size() : 0;
  return static_cast<float>(places + axes) + 1.3f;
}

std::optional<std::vector<AxisTarget>> PlacesMenu::draw_place(Frame& f, std::size_t i) {
  Ui& ui = f.ui;
  const SavedPlace& place = f.tab.settings.profile.places[i];
  const Row row(ui);
  draw_text_line(ui, row.at.x + ui.px(side), row.at.x + ui.px(list_width - 176), row.middle(),
                 Face::body_bold, ui[Tone::ink], place.name);
  ButtonOptions go{.disabled = f.tab.why_not_move(), .width = 44, .height = 28, .moving = true};
  row.place(list_width - 172);
  std::optional<std::vector<AxisTarget>> chosen;
  if (button(ui, Path("places/{}/go", place.name), "Go", go).clicked) chosen = place.at;
  row.place(list_width - 122);
  ButtonOptions quiet{.style = ButtonStyle::quiet, .width = 52, .height = 28};
  quiet.on = edited_ == static_cast<int>(i);
  if (button(ui, Path("places/{}/edit", place.name), "Edit", quiet).clicked)
    edit(edited_ == static_cast<int>(i) ? -1 : static_cast<int>(i));
  row.place(list_width - 66);
  quiet.on = false;
  quiet.width = 60;
  if (button(ui, Path("places/{}/forget", place.name), "Forget", quiet).clicked) {
    f.tab.settings.profile.places.erase(f.tab.settings.profile.places.begin() +
                                        static_cast<std::ptrdiff_t>(i));
    f.tab.settings.edited();
    edit(-1);
  }
  return chosen;
}

/// Draws a field for each axis. An axis with an empty field does not move on Go.
void PlacesMenu::draw_axes(Frame& f, std::size_t i) {
  if (i >= f.tab.settings.profile.places.size()) return;
  SavedPlace& place = f.tab.settings.profile.places[i];
  for (std::size_t a = 0; a < f.catalog.axes.size(); ++a) {
    const AxisId axis{static_cast<std::uint8_t>(a)};
    const std::string& name = f.catalog.axes[a].name;
    const DisplayUnit& unit = f.tab.settings.unit(axis);
    const Row row(f.ui);
    draw_text_line(f.ui, row.at.x + f.ui.px(2 * side), row.at.x + f.ui.px(60), row.middle(), Face::body,
                   f.ui[Tone::ink2], name);
    AxisTarget* target = target_of(place, axis);
    NumberOptions o;
    o.range.decimals = unit.real ? unit.decimals : 0;
    o.range.unit = unit.name;
    o.width = 132, o.height = 28;
    o.sentence_below = false;
    row.place(60);
    const auto shown = target ? std::optional(from_steps(target->value, unit)) : std::nullopt;
    const NumberEvent typed =
        number_field(f.ui, Path("places/{}/{}", place.name, name), name, shown, fields_[a], o);
    row.place(200);
    ButtonOptions here{
        .style = ButtonStyle::quiet, .tip = "Present position of this axis.", .width = 52, .height = 28};
    here.disabled = f.now.axes[a].position_known ? "" : "Its position is not known.";
    const bool take = button(f.ui, Path("places/{}/{}/here", place.name, name), "Here", here).clicked;
    if (!typed.committed && !take) continue;
    const Steps value = take ? f.now.axes[a].commanded() : to_steps(typed.value, unit);
    if (target)
      target->value = value;
    else
      place.at.push_back({axis, value});
    std::sort(place.at.begin(), place.at.end(), [](const auto& l, const auto& r) { return l.axis < r.axis; });
    fields_[a].reset();
    f.tab.settings.edited();
  }
}

void PlacesMenu::draw_save(Frame& f) {
  Ui& ui = f.ui;
  const Row row(ui);
  row.place(side);
  FieldOptions o;
  o.width = list_width - 2 * side - 92;
  o.height = 28;
  o.placeholder = "Name of this place";
  const bool entered = text_field(ui, "places/name", "Name of this place", name_, o).entered;
  row.place(list_width - side - 86);
  ButtonOptions b{.width = 86, .height = 28};
  b.disabled = name_.empty() ? "Type its name first." : "";
  b.tip = "Saves the position of all axes; replaces a place of that name.";
  if (button(ui, "places/save", "Save here", b).clicked || (entered && !name_.empty())) save(f);
}

void PlacesMenu::save(Frame& f) {
  auto at = standing_place(f.catalog, f.now);
  if (!at) return f.toast(Severity::fault, at.error().sentence());
  put_place(f.tab.settings.profile.places, {std::move(name_), std::move(*at)});
  name_.clear();
  f.tab.settings.edited();
  edit(-1);
}

void PlacesMenu::edit(int place) {
  edited_ = place;
  for (NumberField& field : fields_) field.reset();
}

}  // namespace hw::panels
