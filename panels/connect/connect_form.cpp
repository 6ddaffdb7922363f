#include "panels/connect/connect_form.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "gui/shell/console.h"
#include "gui/shell/device_finder.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/measures.h"
#include "panels/names.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float option_width = 184, rate_width = 92, id_width = 72, least_port = 120;
/// Least width at which the search fields and the button are in one line.
constexpr float search_in_one_line = 500;

int number_in(const std::string& text, int fallback) {
  int value = fallback;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

void ConnectForm::make() {
  if (std::exchange(made_, true)) return;
  std::set<int> rates;
  for (const Catalog& c : catalogs_.all())
    if (c.addressed()) rates.insert(c.can.bauds.begin(), c.can.bauds.end());
  rates_.assign(rates.begin(), rates.end());
  for (const int rate : rates_) rate_words_.push_back(fmt::format("{}", rate));
  for (const Catalog& c : catalogs_.all()) {
    transports_.push_back(ways_to(c));
    std::vector<std::string>& words = baud_words_.emplace_back();
    for (const int baud : c.can.bauds) words.push_back(fmt::format("{}", baud));
  }
}

// A controller addressed by an id has ids in its catalog.
bool ConnectForm::has_ids() const { return catalog().addressed(); }

const ConnectForm::Transports& ConnectForm::transports() const {
  return transports_[static_cast<std::size_t>(model_)];
}
const TransportInfo& ConnectForm::transport() const {
  return *transports()[static_cast<std::size_t>(transport_)];
}

const std::string& ConnectForm::address() {
  const Catalog& c = catalog();
  made_address_.clear();
  const auto put = [&]<class... Args>(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(made_address_), format, std::forward<Args>(args)...);
  };
  if (transport().is_usb) {
    put("{}@usb", c.model);
    if (!port_.empty() && !port_.starts_with('/')) put(":{}", port_);
    return made_address_;
  }
  put("{}@{}:{}", c.model, transport().name, port_);
  if (transport().has_base) put(",base={}", base_);
  if (transport().has_rate && baud_ < static_cast<int>(c.can.bauds.size()))
    put(",baud={}", c.can.bauds[static_cast<std::size_t>(baud_)]);
  if (has_ids() && !id_.empty()) put(",id={}", id_);
  if (!has_options()) return made_address_;
  for (const OptionInfo& option : c.options)
    if (const auto chosen = chosen_.find(option.key); chosen != chosen_.end() && chosen->second > 0)
      put(",{}={}", option.key, option.choices[static_cast<std::size_t>(chosen->second)].first);
  return made_address_;
}

std::string ConnectForm::draw(PageFrame& f, float width) {
  make();
  if (catalogs_.all().empty()) return {};
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(100), at.y + ui.px(16), Face::body_bold, ui[Tone::ink],
                 "By its parts");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y));
  const bool opened = draw_parts(f, width - 104);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(has_options() ? 120 : 80)));
  draw_guide(f, width);
  std::string chosen = draw_search(f, width);
  return opened ? address() : chosen;
}

void ConnectForm::choose(int picked) {
  transport_ = picked;
  port_ = transport().example;
}

/// Draws two lines: model, transport and port, then Open and its address. Rate and id are in the first line
/// if they fit, else in the second.
bool ConnectForm::draw_parts(PageFrame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Names models;
  for (const Catalog& c : catalogs_.all()) models.add(c.short_name);
  const int model = dropdown(ui, "connect/form/model", "Model", models, model_);
  if (model >= 0) {
    const TransportInfo* before = &transport();
    model_ = model;
    baud_ = 0;
    id_ = catalog().id();
    const Transports& has = transports();
    const auto same = std::find(has.begin(), has.end(), before);
    same == has.end() ? choose(0) : void(transport_ = static_cast<int>(same - has.begin()));
  }
  ImGui::SameLine(0, ui.px(between));
  Names titles;
  for (const TransportInfo* w : transports()) titles.add(w->title);
  const int picked = dropdown(ui, "connect/form/way", "Way", titles, transport_);
  if (picked >= 0) choose(picked);
  ImGui::SameLine(0, ui.px(between));
  const bool by_usb = transport().is_usb, has_id = has_ids() && !by_usb,
             has_rate_or_base = transport().has_rate || transport().has_base;
  const float numbers = (has_rate_or_base ? rate_width + between : 0) + (has_id ? id_width + between : 0);
  const float used = (ImGui::GetCursorScreenPos().x - at.x) / ui.scale;
  const bool one_line = width - used - numbers >= least_port;
  FieldOptions port;
  port.face = Face::code_field;
  port.placeholder = by_usb ? "serial number, if there are several" : "";
  port.width = width - used - (one_line ? numbers : 0);
  text_field(ui, "connect/form/port", "Port", port_, port);
  const auto draw_numbers = [&](bool before) {
    const auto apart = [&] { ImGui::SameLine(0, ui.px(between)); };
    if (has_rate_or_base) before ? (draw_rate_or_base(ui), apart()) : (apart(), draw_rate_or_base(ui));
    if (has_id) before ? (draw_id(ui), apart()) : (apart(), draw_id(ui));
  };
  if (one_line) draw_numbers(false);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
  if (!one_line) draw_numbers(true);
  const std::string& made = address();
  ButtonOptions open;
  open.width = 88;
  open.tip = made;
  const bool opened = button(ui, "connect/form/open", "Open", open).clicked;
  ImGui::SameLine(0, ui.px(between));
  const ImVec2 words = ImGui::GetCursorScreenPos();
  if (words.x + text_width(ui, Face::code_field, made) <=
      at.x + ui.px(width))  // else only the tooltip shows it
    draw_text_line(ui, words.x, at.x + ui.px(width), at.y + ui.px(56), Face::code_field, ui[Tone::ink2],
                   made);
  show(ui, {"connect/form/address", Kind::text, "Address", made, {}, false, {}},
       {words, ImVec2(at.x + ui.px(width), at.y + ui.px(72))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(80)));
  if (has_options()) draw_options(ui);
  return opened;
}

/// Draws the options that a board does not report before it is opened.
void ConnectForm::draw_options(Ui& ui) {
  for (const OptionInfo& option : catalog().options) {
    Names names;
    for (const auto& [value, label] : option.choices) names.add(label);
    DropdownOptions o;
    o.width = option_width;
    o.tip = option.key;
    int& chosen = chosen_[option.key];
    if (const int picked = dropdown(ui, Path("connect/form/{}", option.key), option.key, names, chosen, o);
        picked >= 0)
      chosen = picked;
    ImGui::SameLine(0, ui.px(between));
  }
  ImGui::NewLine();
}

/// The rate of a serial line, or the window address of a board.
void ConnectForm::draw_rate_or_base(Ui& ui) {
  if (transport().has_base) {
    FieldOptions base;
    base.face = Face::code_field;
    base.width = rate_width;
    base.tip = "Address of the board's window in the short address space, set by its jumpers";
    text_field(ui, "connect/form/base", "Base", base_, base);
    return;
  }
  Names rates;
  for (const std::string& baud : baud_words_[static_cast<std::size_t>(model_)]) rates.add(baud);
  DropdownOptions o;
  o.width = rate_width;
  o.tip = "Baud rate";
  if (const int b = dropdown(ui, "connect/form/baud", "Baud rate", rates, baud_, o); b >= 0) baud_ = b;
}

void ConnectForm::draw_id(Ui& ui) {
  FieldOptions id;
  id.face = Face::code_field;
  id.width = id_width;
  id.tip = "The device's id, or the ids of a bus: 01-04";
  text_field(ui, "connect/form/id", "Id", id_, id);
}

/// Says how to bring a model that leaves the factory with another line setting onto the shared line, in the
/// words of that setting. Empty: not needed.
const std::string& ConnectForm::guide() {
  if (std::exchange(guide_of_, model_) == model_) return guide_;
  guide_.clear();
  for (const ParamInfo& p : catalog().params)
    for (const ParamChoice& choice : p.choices)
      if (guide_.empty() && choice.value != p.fallback && choice.label.find("RS-485") != std::string::npos)
        guide_ = fmt::format(
            "From RS-232 to RS-485: open it as it is, choose \"{}\" for {} ({}) in Setup, write it, store it "
            "in the controller, switch the controller off and on, and open it again with its id.",
            choice.label, p.label, p.mnemonic);
  return guide_;
}

void ConnectForm::draw_guide(PageFrame& f, float width) {
  const std::string& words = guide();
  if (words.empty()) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(104), at.y));
  wrapped(f.ui, Face::small, Tone::ink2, words, width - 104);
  const float end = at.y + wrapped_height(f.ui, Face::small, words, f.ui.px(width - 104));
  show(f.ui, {"connect/form/guide", Kind::text, "Guide", words, {}, false, {}},
       {at, ImVec2(at.x + f.ui.px(width), end)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, end + f.ui.px(8)));
}

float ConnectForm::height(PageFrame& f, float width) {
  make();
  if (catalogs_.all().empty()) return 0;
  const DeviceSearchState& state = f.console.devices().state();
  const std::string& words = guide();
  const float guide_height =
      words.empty() ? 0 : wrapped_height(f.ui, Face::small, words, f.ui.px(width - 104)) / f.ui.scale + 8;
  const float search = (width - 104 >= search_in_one_line ? 40 : 80) + (words_of(state).empty() ? 0 : 24);
  return (has_options() ? 120 : 80) + guide_height + search + 32 * static_cast<float>(state.found.size()) +
         24;
}

// ---- search

std::string ConnectForm::words_of(const DeviceSearchState& state) const {
  if (state.running)
    return state.of == 0 ? "" : fmt::format("{} of {}: {}", state.asked, state.of, state.now);
  if (!searched_) return {};
  if (state.of == 0)
    return state.found.empty() ? "There is no serial port to search." : "No port could be searched.";
  const auto devices = std::count_if(state.found.begin(), state.found.end(),
                                     [](const FoundDevice& d) { return !d.address.empty(); });
  return fmt::format("{} after {} of {} queries, {} found.", state.cancelled ? "Ended" : "Done", state.asked,
                     state.of, devices);
}

/// Draws fields for the unknown parts: port, rate, id.
void ConnectForm::draw_search_fields(Ui& ui, bool in_one_line) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Names places;
  places.add("every port");
  if (transport().is_port && !port_.empty()) places.add(port_);
  one_port_ = one_port_ && places.size() > 1;
  DropdownOptions o;
  o.width = 132;
  o.tip = "Ports to search";
  if (const int i = dropdown(ui, "connect/search/port", "Ports", places, one_port_, o); i >= 0)
    one_port_ = i == 1;
  ImGui::SameLine(0, ui.px(between));
  Names rates;
  rates.add("every rate");
  for (const std::string& rate : rate_words_) rates.add(rate);
  o.width = 116;
  o.tip = "Rates to search";
  if (const int i = dropdown(ui, "connect/search/baud", "Rates", rates, rate_, o); i >= 0) rate_ = i;
  if (in_one_line)
    ImGui::SameLine(0, ui.px(between));
  else
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
  FieldOptions id;
  id.width = 40;
  id.face = Face::code_field;
  id.tip = "First id to search";
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
  id.tip = "Last id to search";
  text_field(ui, "connect/search/last", "Last id", last_, id);
  ImGui::SameLine(0, ui.px(between));
}

std::string ConnectForm::draw_search(PageFrame& f, float width) {
  Ui& ui = f.ui;
  DeviceFinder& finder = f.console.devices();
  const DeviceSearchState& state = finder.state();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(100), at.y + ui.px(16), Face::body_bold, ui[Tone::ink], "Search");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(104), at.y));
  const bool in_one_line = width - 104 >= search_in_one_line;
  draw_search_fields(ui, in_one_line);
  const float fields = in_one_line ? 0 : 40;
  ButtonOptions o;
  o.tip = "Queries each id at each of these rates and ports. The search moves nothing, and takes a while.";
  if (state.running) {
    if (button(ui, "connect/search/cancel", "End the search", o).clicked) finder.cancel();
  } else if (button(ui, "connect/search", "Search", o).clicked) {
    searched_ = true;
    finder.start(one_port_ ? port_ : std::string(),
                 rate_ > 0 ? rates_[static_cast<std::size_t>(rate_ - 1)] : 0, number_in(first_, 0),
                 number_in(last_, 99));
  }
  const std::string words = words_of(state);
  if (!words.empty()) {
    const float left = at.x + ui.px(104), top = at.y + ui.px(fields + 36);
    draw_text_line(ui, left, at.x + ui.px(width), top + ui.px(12), Face::small, ui[Tone::ink2], words);
    show(ui, {"connect/search/progress", Kind::text, "Search", words, {}, false, words},
         {ImVec2(left, top), ImVec2(at.x + ui.px(width), top + ui.px(24))});
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(fields + (words.empty() ? 40 : 64))));
  std::string chosen;
  for (std::size_t i = 0; i < state.found.size(); ++i) {
    const FoundDevice& device = state.found[i];
    const ImVec2 row = ImGui::GetCursorScreenPos();
    const std::string shown = fmt::format("{}, {}", device.title, device.sentence);
    const float left = row.x + ui.px(104), right = row.x + ui.px(width - 80);
    draw_text_line(ui, left, right, row.y + ui.px(16), Face::body, ui[Tone::ink], shown);
    show(ui, {Path("connect/search/found/{}/text", i), Kind::text, "Found", shown, {}, false, shown},
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
