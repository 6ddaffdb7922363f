#include "panels/memory_map.h"

#include <algorithm>

#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float value_height = 24, bits_height = 20;
constexpr float address_width = 56, hex_width = 96;
constexpr double mark_s = 1.0;
constexpr int shown_characters = 40;

std::uint32_t value_of(const Frame& f, const MemoryCell& c) {
  return f.now.window.value(static_cast<std::size_t>(c.offset), c.bytes);
}

Path address_of(int offset) { return Path("0x{:03X}", offset); }
Path hex_of(const MemoryCell& c, std::uint32_t value) { return Path("{:0{}X}", value, 2 * c.bytes); }

/// "X Encoder Position" under the heading "Axis X" becomes "Encoder Position".
std::string_view short_name(const Frame& f, const MemoryCell& c) {
  std::string_view name = c.name;
  if (c.axis < 0 || static_cast<std::size_t>(c.axis) >= f.catalog.axes.size()) return name;
  const std::string& axis = f.catalog.axes[static_cast<std::size_t>(c.axis)].name;
  if (name.size() > axis.size() && name.starts_with(axis) && name[axis.size()] == ' ')
    name.remove_prefix(axis.size() + 1);
  return name;
}

/// "Axis X" becomes "X" in a cell, "Line 3" becomes "3".
std::string_view in_a_cell(std::string_view label) {
  const auto space = label.rfind(' ');
  const bool numbered = space != label.npos && label.size() - space <= 3 && label.find(' ') == space;
  return numbered ? label.substr(space + 1) : label;
}

void draw_bit(Frame& f, const Rect& r, const ParamBit& bit, bool named, bool set, bool fresh) {
  Ui& ui = f.ui;
  const Tone fill_tone = fresh ? Tone::ink2 : Tone::line;
  if (set) draw_fill(ui, r, ui[fill_tone], 2);
  draw_outline(ui, r, ui[set ? fill_tone : Tone::line], 2);
  const std::string_view label = in_a_cell(bit.label);
  const Path number("{}", bit.bit);
  const Tone tone = !fresh ? Tone::ink3 : set ? Tone::panel : Tone::ink3;
  draw_text_centred(ui, r, Face::small, ui[tone], named ? label : number.view());
}

bool begins_group(const Catalog& c, std::size_t i) {
  return i == 0 || c.memory[i].group != c.memory[i - 1].group;
}

}  // namespace

std::int64_t number_of(const MemoryCell& c, std::uint32_t value) {
  if (!c.is_signed) return value;
  if (c.bytes == 1) return static_cast<std::int8_t>(value);
  if (c.bytes == 2) return static_cast<std::int16_t>(value);
  return static_cast<std::int32_t>(value);
}

std::string_view set_bits(std::span<char> buffer, const MemoryCell& c, std::uint32_t value) {
  std::size_t size = 0;
  for (const ParamBit& bit : c.bits) {
    if ((value >> bit.bit & 1) == 0) continue;
    const auto end =
        fmt::format_to_n(buffer.data() + size, buffer.size() - size, "{}{}", size ? ", " : "", bit.label);
    size = std::min(buffer.size(), size + end.size);
  }
  return size ? std::string_view(buffer.data(), size) : std::string_view("none");
}

void MemoryMap::draw(Frame& f) {
  f.tab.watched.look_at_group(f.catalog.memory_readout_group);
  follow(f);
  Ui& ui = f.ui;
  begin_part(ui, "memory", 0, ui.px(f.area.height), Tone::panel, 16);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float whole = ImGui::GetContentRegionAvail().x / ui.scale;
  const bool two = whole >= 640;
  const float width = two ? std::floor((whole - between_columns) / 2) : whole;
  draw_column(f, false, width);
  draw_rings(f, width);
  const float left_end = ImGui::GetCursorScreenPos().y;
  if (two) ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width + between_columns), at.y));
  draw_column(f, true, width);
  ImGui::SetCursorScreenPos(ImVec2(at.x, std::max(left_end, ImGui::GetCursorScreenPos().y)));
  gap(ui, 16);
  end_part();
}

void MemoryMap::follow(const Frame& f) {
  cells_.resize(f.catalog.memory.size());
  if (!f.now.window.known) return;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Memory& m = cells_[i];
    const std::uint32_t value = value_of(f, f.catalog.memory[i]);
    if (m.known && m.value != value) m.changed_at_s = f.ui.now_s;
    m.value = value;
    m.known = true;
    // The mark expires by time alone, so a console at rest must draw a frame then.
    if (const double left = m.changed_at_s + mark_s - f.ui.now_s; left > 0) f.ui.wake_in(left);
  }
}

bool MemoryMap::marked(const Frame& f, std::size_t cell) const {
  return f.ui.now_s - cells_[cell].changed_at_s < mark_s;
}

bool MemoryMap::fresh(const Frame& f, const MemoryCell& c) const {
  const auto axis = static_cast<std::size_t>(std::max(c.axis, 0));
  const Instant seen = c.axis >= 0 ? f.now.axes[axis].seen_at : f.now.io_seen_at;
  return f.connected() && f.now.window.known && !is_stale(seen, f.clock, f.now.poll_period);
}

void MemoryMap::draw_column(Frame& f, bool of_axes, float width) {
  Ui& ui = f.ui;
  const float left = ImGui::GetCursorScreenPos().x;
  for (std::size_t i = 0; i < f.catalog.memory.size(); ++i) {
    const MemoryCell& c = f.catalog.memory[i];
    if ((c.axis >= 0) != of_axes) continue;
    if (begins_group(f.catalog, i)) {
      const float y = ImGui::GetCursorScreenPos().y;
      draw_text_line(ui, left, left + ui.px(width), y + ui.px(title_height / 2), Face::body_bold,
                     ui[Tone::ink], c.group);
      ImGui::SetCursorScreenPos(ImVec2(left, y + ui.px(title_height)));
    }
    if (c.bits.empty())
      draw_value(f, i, width);
    else
      draw_register(f, i, width);
    ImGui::SetCursorScreenPos(ImVec2(left, ImGui::GetCursorScreenPos().y));
  }
}

/// Draws address, name, and the mark of a recent change.
void MemoryMap::draw_head(Frame& f, std::size_t i, ImVec2 at, float width, float middle) {
  Ui& ui = f.ui;
  const MemoryCell& c = f.catalog.memory[i];
  const Path address = address_of(c.offset);
  if (marked(f, i)) {
    const Rect bar{ImVec2(at.x - ui.px(8), middle - ui.px(8)), ImVec2(at.x - ui.px(5), middle + ui.px(8))};
    ImGui::GetWindowDrawList()->AddRectFilled(bar.min, bar.max, ui[Tone::ink]);
    show(ui, {Path("register/{}/changed", address.view()), Kind::lamp, "has just changed"}, bar);
  }
  draw_text_line(ui, at.x, at.x + ui.px(address_width), middle, Face::code_time, ui[Tone::ink3], address);
  draw_text_line(ui, at.x + ui.px(address_width), at.x + ui.px(width), middle, Face::body, ui[Tone::ink2],
                 short_name(f, c));
}

void MemoryMap::draw_value(Frame& f, std::size_t i, float width) {
  Ui& ui = f.ui;
  const MemoryCell& c = f.catalog.memory[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect row{at, ImVec2(at.x + ui.px(width), at.y + ui.px(value_height))};
  const bool known = cells_[i].known, is_fresh = fresh(f, c);
  const NumberText decimal = format_number(static_cast<double>(number_of(c, cells_[i].value)), 0);
  const Path value("{}{}", known ? decimal.view() : "?", known && !is_fresh ? "?" : "");
  const float hex_room = width >= 360 ? hex_width : 0;  // in a narrow column the names need the width
  if (ImGui::IsRectVisible(row.min, row.max)) {
    const float middle = std::floor(row.centre().y);
    const Face face = marked(f, i) ? Face::body_bold : Face::body;
    const float end = row.max.x - ui.px(hex_room);
    const float begin = std::max(at.x, end - std::ceil(text_width(ui, face, value)));
    draw_head(f, i, at, (begin - at.x) / ui.scale - 8, middle);
    draw_text_line(ui, begin, end + 1, middle, face, ui[is_fresh ? Tone::ink : Tone::ink3], value);
    if (known && hex_room > 0) {
      const Path hex = hex_of(c, cells_[i].value);
      draw_text_line(ui, row.max.x - std::ceil(text_width(ui, Face::code_time, hex)), row.max.x + 1, middle,
                     Face::code_time, ui[Tone::ink3], hex);
    }
  }
  const Path address = address_of(c.offset);
  show(ui, {Path("register/{}", address.view()), Kind::text, c.name, value, {}, false, c.help}, row);
  ImGui::SetCursorScreenPos(ImVec2(at.x, row.max.y));
}

void MemoryMap::draw_register(Frame& f, std::size_t i, float width) {
  Ui& ui = f.ui;
  const MemoryCell& c = f.catalog.memory[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect row{at, ImVec2(at.x + ui.px(width), at.y + ui.px(value_height))};
  const bool known = cells_[i].known, is_fresh = fresh(f, c);
  const float middle = std::floor(row.centre().y);
  draw_head(f, i, at, width - hex_width, middle);
  const Path hex = hex_of(c, cells_[i].value);
  const Path value("{}{}", known ? hex.view() : "?", known && !is_fresh ? "?" : "");
  draw_text_line(ui, row.max.x - std::ceil(text_width(ui, Face::code_field, value)), row.max.x + 1, middle,
                 Face::code_field, ui[is_fresh ? Tone::ink : Tone::ink3], value);
  const Path address = address_of(c.offset);
  show(ui, {Path("register/{}", address.view()), Kind::text, c.name, value, {}, false, c.help}, row);

  const int cells = std::max(8, c.bits.back().bit + 1);
  const float cell = ui.px(width) / static_cast<float>(cells), y = row.max.y;
  // Names are shown only if all of them fit, because a mixture of names and numbers is hard to read.
  const bool named = std::all_of(c.bits.begin(), c.bits.end(), [&](const ParamBit& bit) {
    return text_width(ui, Face::small, in_a_cell(bit.label)) + ui.px(6) <= cell;
  });
  for (const ParamBit& bit : c.bits) {
    const float x = std::floor(at.x + cell * static_cast<float>(bit.bit));
    const bool set = known && (cells_[i].value >> bit.bit & 1) != 0;
    const Rect r{ImVec2(x, y), ImVec2(std::floor(x + cell - ui.px(2)), y + ui.px(bits_height))};
    draw_bit(f, r, bit, named, set, is_fresh);
    show(ui,
         {Path("register/{}/bit/{}", address.view(), bit.bit),
          Kind::lamp,
          bit.label,
          !known ? "?"
          : set  ? "set"
                 : "clear",
          {},
          false,
          bit.label},
         r);
  }
  char words[160];
  const std::string_view names =
      known ? set_bits(words, c, cells_[i].value) : std::string_view("not read yet");
  const Rect line{ImVec2(at.x, y + ui.px(bits_height)), ImVec2(row.max.x, y + ui.px(bits_height + 20))};
  draw_text_line(ui, line.min.x, line.max.x, std::floor(line.centre().y), Face::small,
                 ui[is_fresh ? Tone::ink2 : Tone::ink3], names);
  const bool cut = text_width(ui, Face::small, names) > line.width();
  show(ui,
       {Path("register/{}/bits", address.view()),
        Kind::text,
        "set",
        names,
        {},
        false,
        cut ? names : std::string_view()},
       line);
  ImGui::SetCursorScreenPos(ImVec2(at.x, line.max.y + ui.px(4)));
}

void MemoryMap::draw_rings(Frame& f, float width) {
  Ui& ui = f.ui;
  const WindowImage& w = f.now.window;
  for (const MemoryRing& ring : f.catalog.memory_rings) {
    if (ring.cells <= 0) continue;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect row{at, ImVec2(at.x + ui.px(width), at.y + ui.px(28))};
    const auto put = static_cast<int>(w.value(static_cast<std::size_t>(ring.put_index), 2)) % ring.cells;
    const auto get = static_cast<int>(w.value(static_cast<std::size_t>(ring.get_index), 2)) % ring.cells;
    const int waiting = (put - get + ring.cells) % ring.cells;
    const Path words("put {}, get {}, {} waiting", put, get, waiting);
    const std::string_view shown = w.known ? words.view() : "?";
    const float middle = std::floor(row.centre().y);
    draw_text_line(ui, at.x, row.max.x, middle, Face::body, ui[Tone::ink2], ring.name);
    draw_text_line(ui, row.max.x - std::ceil(text_width(ui, Face::body, shown)), row.max.x + 1, middle,
                   Face::body, ui[f.connected() ? Tone::ink : Tone::ink3], shown);
    show(ui, {Path("ring/{}", ring.name), Kind::text, ring.name, shown}, row);
    ImGui::SetCursorScreenPos(ImVec2(at.x, row.max.y));
    MeterOptions o;
    o.words = shown;
    o.old = !f.connected();
    o.width = width;
    meter(ui, Path("ring/{}/meter", ring.name), ring.name,
          static_cast<float>(waiting) / static_cast<float>(ring.cells - 1), o);
    // The newest characters of the ring, whether the receiver has taken them or not.
    char text[static_cast<std::size_t>(shown_characters)];
    for (int n = 0; n < shown_characters; ++n) {
      const int cell = (put - shown_characters + n + 2 * ring.cells) % ring.cells;
      const std::uint32_t c = w.value(static_cast<std::size_t>(ring.offset + 2 * cell), 2) & 0xFF;
      text[n] = c >= 0x20 && c < 0x7F ? static_cast<char>(c) : ' ';
    }
    const std::string_view newest =
        w.rings_known ? std::string_view(text, sizeof text) : std::string_view("not read yet");
    const Rect line{ImVec2(at.x, row.max.y + ui.px(12)), ImVec2(row.max.x, row.max.y + ui.px(32))};
    draw_text_line(ui, line.min.x, line.max.x, std::floor(line.centre().y), Face::code_time, ui[Tone::ink2],
                   newest);
    show(ui, {Path("ring/{}/text", ring.name), Kind::text, ring.name, newest}, line);
    ImGui::SetCursorScreenPos(ImVec2(at.x, line.max.y + ui.px(4)));
  }
}

}  // namespace hw::panels
