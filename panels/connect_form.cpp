#include "panels/connect_form.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/device/registry.h"
#include "gui/console.h"
#include "gui/device_finder.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float between = 8, rate_width = 92, id_width = 72;

int number_of(const std::string& text, int fallback) {
  int value = fallback;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

void ConnectForm::make() {
  if (std::exchange(made_, true)) return;
  for (const DeviceType& type : device_types())
    if (auto catalog = type.make_catalog({})) catalogs_.push_back(std::move(*catalog));
}

// A controller that is called by an id has one in its catalog.
bool ConnectForm::has_ids() const { return catalog().addressed(); }

std::string ConnectForm::address() const {
  const Catalog& c = catalog();
  if (way_ == Way::usb)
    return c.model + "@usb" + (port_.empty() || port_.starts_with('/') ? "" : ":" + port_);
  std::string text = fmt::format("{}@{}:{}", c.model, way_ == Way::tcp ? "tcp" : "serial", port_);
  if (way_ == Way::serial && baud_ < static_cast<int>(c.can.bauds.size()))
    text += fmt::format(",baud={}", c.can.bauds[static_cast<std::size_t>(baud_)]);
  if (has_ids() && !id_.empty()) text += ",id=" + id_;
  return text;
}

std::string ConnectForm::draw(PageFrame& f, float width) {
  make();
  if (catalogs_.empty()) return {};
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(100), at.y + ui.px(16), Face::body_bold, ui[Tone::ink],
                 "By its parts");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y));
  draw_parts(f, width - 104);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y + ui.px(40)));
  ButtonOptions open;
  open.width = 88;
  const bool opened = button(ui, "connect/form/open", "Open", open).clicked;
  const std::string made = address();
  const float left = at.x + ui.px(104 + 96);
  draw_text_line(ui, left, at.x + ui.px(width), at.y + ui.px(56), Face::code_field, ui[Tone::ink2], made);
  show(ui, {"connect/form/address", Kind::text, "Address", made, {}, false, {}},
       {ImVec2(left, at.y + ui.px(40)), ImVec2(at.x + ui.px(width), at.y + ui.px(72))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(80)));
  draw_guide(f, width);
  std::string chosen = draw_search(f, width);
  return opened ? made : chosen;
}

void ConnectForm::draw_parts(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const float row = ImGui::GetCursorScreenPos().x;
  std::vector<std::string_view> names;
  for (const Catalog& c : catalogs_) names.push_back(c.short_name);
  const int model = dropdown(ui, "connect/form/model", "Model", names, model_);
  if (model >= 0) {
    model_ = model;
    baud_ = 0;
    id_ = catalog().id();
  }
  ImGui::SameLine(0, ui.px(between));
  static constexpr std::array<std::string_view, 3> ways = {"serial", "USB", "tcp"};
  const int picked = dropdown(ui, "connect/form/way", "Way", ways, static_cast<int>(way_));
  if (picked >= 0) {
    way_ = static_cast<Way>(picked);
    port_ = way_ == Way::serial ? "/dev/ttyUSB0" : way_ == Way::tcp ? "127.0.0.1:4001" : "";
  }
  ImGui::SameLine(0, ui.px(between));
  FieldOptions port;
  port.face = Face::code_field;
  port.placeholder = way_ == Way::usb ? "the only one, or its serial number" : "";
  const float used = (ImGui::GetCursorScreenPos().x - row) / ui.scale;
  port.width = std::max(120.0f, width - used - (way_ == Way::serial ? rate_width + between : 0) -
                                    (has_ids() && way_ != Way::usb ? id_width + between : 0));
  text_field(ui, "connect/form/port", "Port", port_, port);
  if (way_ == Way::serial) {
    std::vector<std::string> rates;
    for (const int b : catalog().can.bauds) rates.push_back(fmt::format("{}", b));
    const std::vector<std::string_view> views(rates.begin(), rates.end());
    ImGui::SameLine(0, ui.px(between));
    DropdownOptions o;
    o.width = rate_width;
    o.tip = "Baud rate";
    if (const int b = dropdown(ui, "connect/form/baud", "Baud rate", views, baud_, o); b >= 0) baud_ = b;
  }
  if (!has_ids() || way_ == Way::usb) return;
  ImGui::SameLine(0, ui.px(between));
  FieldOptions id;
  id.face = Face::code_field;
  id.width = id_width;
  id.tip = "The device's id, or the ids of a bus: 01-04";
  text_field(ui, "connect/form/id", "Id", id_, id);
}

/// For a model that leaves the factory on another line: how it comes onto the shared one, in the words of its
/// own setting.
void ConnectForm::draw_guide(PageFrame& f, float width) {
  for (const ParamInfo& p : catalog().params)
    for (const ParamChoice& choice : p.choices) {
      if (choice.value == p.fallback || choice.label.find("RS-485") == std::string::npos) continue;
      const std::string words = fmt::format(
          "From RS-232 to RS-485: open it as it is, choose \"{}\" for {} ({}) in Setup, write it, store it "
          "in the "
          "controller, switch the controller off and on, and open it again with its id.",
          choice.label, p.label, p.mnemonic);
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(104), at.y));
      wrapped(f.ui, Face::small, Tone::ink2, words, width - 104);
      const float end = ImGui::GetCursorScreenPos().y;
      show(f.ui, {"connect/form/guide", Kind::text, "Guide", words, {}, false, {}},
           {at, ImVec2(at.x + f.ui.px(width), end)});
      ImGui::SetCursorScreenPos(ImVec2(at.x, end + f.ui.px(8)));
      return;
    }
}

// ---- search

namespace {

std::string progress_of(const DeviceSearchState& state, bool begun) {
  if (state.running) return fmt::format("{} of {}: {}", state.asked, state.of, state.now);
  if (state.of > 0)
    return fmt::format("{} after {} of {} questions, {} found.", state.cancelled ? "Ended" : "Done",
                       state.asked, state.of, state.found.size());
  return begun ? "There is no serial port to ask." : "";
}

}  // namespace

std::string ConnectForm::draw_search(PageFrame& f, float width) {
  Ui& ui = f.ui;
  DeviceFinder& finder = f.console.devices();
  const DeviceSearchState& state = finder.state();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(100), at.y + ui.px(16), Face::body_bold, ui[Tone::ink], "Search");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y));
  draw_search_fields(f, finder);
  const float left = ImGui::GetItemRectMax().x + ui.px(12);
  const std::string words = progress_of(state, searched_);
  const float right = at.x + ui.px(width);
  const bool below = right - left < ui.px(160);
  const ImVec2 said = below ? ImVec2(at.x + ui.px(104), at.y + ui.px(32)) : ImVec2(left, at.y);
  draw_text_line(ui, said.x, right, said.y + ui.px(16), Face::small, ui[Tone::ink2], words);
  show(ui, {"connect/search/progress", Kind::text, "Search", words, {}, false, words},
       {said, ImVec2(right, said.y + ui.px(32))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(below && !words.empty() ? 68 : 40)));
  return draw_found(f, state, width);
}

void ConnectForm::draw_search_fields(PageFrame& f, DeviceFinder& finder) {
  Ui& ui = f.ui;
  const bool named = way_ == Way::serial && !port_.empty();
  if (named) {
    const std::array<std::string_view, 2> where = {"all ports", "this port"};
    DropdownOptions o;
    o.tip = "Every serial port of this computer, or only the one that stands above.";
    if (const int picked = dropdown(ui, "connect/search/where", "Where", where, this_port_ ? 1 : 0, o);
        picked >= 0)
      this_port_ = picked == 1;
    ImGui::SameLine(0, ui.px(between));
  }
  FieldOptions id;
  id.width = 40;
  id.face = Face::code_field;
  id.tip = "First id that is asked";
  const auto word = [&](std::string_view s) {
    const ImVec2 here = ImGui::GetCursorScreenPos();
    draw_text_line(ui, here.x, here.x + ui.px(60), here.y + ui.px(16), Face::body, ui[Tone::ink2], s);
    ImGui::SetCursorScreenPos(
        ImVec2(here.x + std::ceil(text_width(ui, Face::body, s)) + ui.px(between), here.y));
  };
  word("ids");
  text_field(ui, "connect/search/first", "First id", first_, id);
  ImGui::SameLine(0, ui.px(between));
  word("to");
  id.tip = "Last id that is asked";
  text_field(ui, "connect/search/last", "Last id", last_, id);
  ImGui::SameLine(0, ui.px(between));
  ButtonOptions o;
  o.tip = "Asks each id at each rate. It moves nothing, and takes a while.";
  if (finder.state().running) {
    if (button(ui, "connect/search/cancel", "End the search", o).clicked) finder.cancel();
  } else if (button(ui, "connect/search", "Search rates and ids", o).clicked) {
    searched_ = true;
    finder.start(named && this_port_ ? port_ : "", 0, number_of(first_, 0), number_of(last_, 99));
  }
}

/// What was found, each with a way in: its address when that was pressed.
std::string ConnectForm::draw_found(PageFrame& f, const DeviceSearchState& state, float width) {
  Ui& ui = f.ui;
  std::string chosen;
  for (std::size_t i = 0; i < state.found.size(); ++i) {
    const FoundDevice& device = state.found[i];
    const ImVec2 row = ImGui::GetCursorScreenPos();
    const std::string said = fmt::format("{}, {}", device.title, device.sentence);
    const float left = row.x + ui.px(104), right = row.x + ui.px(width - 80);
    draw_text_line(ui, left, right, row.y + ui.px(16), Face::body, ui[Tone::ink], said);
    show(ui, {Path("connect/search/found/{}/text", i), Kind::text, "Found", said, {}, false, said},
         {ImVec2(left, row.y), ImVec2(right, row.y + ui.px(32))});
    if (!device.address.empty()) {
      ImGui::SetCursorScreenPos(ImVec2(row.x + ui.px(width - 72), row.y));
      ButtonOptions b;
      b.width = 72;
      b.height = 28;
      if (button(ui, Path("connect/search/found/{}", i), "Open", b).clicked) chosen = device.address;
    }
    ImGui::SetCursorScreenPos(ImVec2(row.x, row.y + ui.px(32)));
  }
  return chosen;
}

}  // namespace hw::panels
