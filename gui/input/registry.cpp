#include "gui/input/registry.h"

#include <algorithm>
#include <cstdint>

namespace hw::gui {
namespace {

constexpr std::string_view kind_names[] = {"button", "hold", "toggle", "lamp", "text", "field", "editor",
                                           "choice", "list", "slider", "tab",  "row",  "meter", "link"};

/// The bytes of a page may move while it grows, so a view's pointer holds an offset until the frame ends.
const char* as_offset(std::size_t offset) { return reinterpret_cast<const char*>(offset); }

struct Decoded {
  unsigned code;
  std::size_t bytes;
};
Decoded decode(std::string_view text) {
  unsigned code = 0;
  const int n = [&] {
    const auto lead = static_cast<unsigned char>(text[0]);
    const int length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
    for (int i = 1; i < length && i < static_cast<int>(text.size()); ++i)
      code = (code << 6) | (static_cast<unsigned char>(text[static_cast<std::size_t>(i)]) & 0x3Fu);
    return length;
  }();
  return {code, std::min(static_cast<std::size_t>(n), text.size())};
}

void append_ascii(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const Decoded d = decode(text);
    text.remove_prefix(d.bytes);
    if (d.code < 0x80)
      out += static_cast<char>(d.code);
    else if (d.code == 0x2212 || d.code == 0x2013)
      out += '-';
    else if (d.code == 0xB0)
      out += "deg";
    else if (d.code == 0xB5)
      out += 'u';
    else if (d.code == 0xB7)
      out += '-';
    else if (d.code == 0xD7)
      out += 'x';
    else if (d.code == 0x2026)
      out += "...";
    else if (d.code == 0x2264)
      out += "<=";
    else if (d.code == 0x2265)
      out += ">=";
    else if (d.code == 0x2039)
      out += '<';
    else if (d.code == 0x203A)
      out += '>';
    else if (d.code != 0x2009 && d.code != 0xA0)
      out += '?';
  }
}

}  // namespace

std::string_view name_of(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

void Registry::begin_frame() {
  drawn_.texts.clear();
  drawn_.widgets.clear();
  drawn_.clear.clear();
  drawn_.top_layer = 0;
}

std::string_view Registry::keep(std::string_view text, bool ascii_only) {
  const std::size_t offset = drawn_.texts.size();
  if (ascii_only)
    append_ascii(drawn_.texts, text);
  else
    drawn_.texts.append(text);
  return {as_offset(offset), drawn_.texts.size() - offset};
}

void Registry::add(const Widget& widget) {
  Widget kept = widget;
  kept.id = keep(widget.id, false);
  kept.label = keep(widget.label, false);
  kept.value = keep(widget.value, true);
  kept.reason = keep(widget.reason, false);
  if (widget.usable()) drawn_.top_layer = std::max(drawn_.top_layer, widget.layer);
  drawn_.widgets.push_back(kept);
}

void Registry::end_frame() {
  std::swap(drawn_, shown_);
  for (Widget& w : shown_.widgets)
    for (std::string_view* view : {&w.id, &w.label, &w.value, &w.reason})
      *view = {shown_.texts.data() + reinterpret_cast<std::uintptr_t>(view->data()), view->size()};
}

const Widget* Registry::find(std::string_view id) const {
  // Searches from the top layer down: a dialog may repeat the id of a widget on the page below.
  for (auto w = shown_.widgets.rbegin(); w != shown_.widgets.rend(); ++w)
    if (w->id == id) return &*w;
  return nullptr;
}

bool Registry::wants_scroll(std::string_view id) {
  if (scroll_to_.empty() || scroll_to_ != id) return false;
  scroll_to_.clear();
  return true;
}

}  // namespace hw::gui
