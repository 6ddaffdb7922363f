#include "gui/model/toasts.h"

#include <algorithm>
#include <utility>

#include "gui/model/gui_log.h"

namespace hw::gui {
namespace {

/// Parts from a file or a wire may be long, or not printable.
std::string fit_to_read(std::string text) {
  std::size_t end = std::min(text.size(), Toasts::longest);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  if (end < text.size()) {
    text.resize(end);
    text += "\u2026";
  }
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text;
}

}  // namespace

void Toasts::add(Severity severity, std::string text, const void* about, std::string of) {
  text = fit_to_read(std::move(text));
  gui_log().debug("{}{}{}", of, of.empty() ? "" : ": ", text);
  changed_ = true;
  const auto same =
      std::find_if(list_.begin(), list_.end(), [&](const Toast& t) { return t.text == text && t.of == of; });
  if (same != list_.end()) {
    ++same->times;
    same->about = about;
    same->until_s = -1;  // restarts its time and makes it the newest again
    same->first.reset();
    std::rotate(same, same + 1, list_.end());
    return;
  }
  if (list_.size() == at_most) make_room();
  std::string shown_text = text;
  list_.push_back(
      {next_number_++, severity, std::move(text), -1, about, std::move(of), std::move(shown_text)});
  list_.back().stays = severity == Severity::fault;
}

/// Drops a toast that would expire by itself first.
void Toasts::make_room() {
  const auto passing = std::find_if(list_.begin(), list_.end(), [](const Toast& t) { return !t.stays; });
  list_.erase(passing == list_.end() ? list_.begin() : passing);
}

void Toasts::add_staying(Severity severity, std::string text) {
  add(severity, std::move(text));
  list_.back().stays = true;
}

void Toasts::look_at(std::optional<std::string_view> front) {
  for (Toast& toast : list_) {
    const bool named = front && !toast.of.empty() && toast.of != *front;
    const std::size_t size = toast.text.size() + (named ? toast.of.size() + 2 : 0);
    if (toast.shown_text.size() != size) toast.shown_text = named ? toast.of + ": " + toast.text : toast.text;
  }
}

void Toasts::withdraw(const void* about) {
  changed_ |= std::erase_if(list_, [about](const Toast& t) { return t.about == about; }) > 0;
}

void Toasts::look_at_controller(const void* about, Standing stands) {
  for (Toast& toast : list_)
    if (toast.about == about && !toast.first) toast.first = stands;
  const auto done = [&](const Toast& t) {
    return t.about == about && ((stands.linked && !t.first->linked) || (stands.moving && !t.first->moving));
  };
  changed_ |= std::erase_if(list_, done) > 0;
}

void Toasts::dismiss(int number) {
  changed_ |= std::erase_if(list_, [number](const Toast& t) { return t.number == number; }) > 0;
}

void Toasts::dismiss_all() {
  changed_ |= !list_.empty();
  list_.clear();
}

bool Toasts::tick(double now_s) {
  for (Toast& toast : list_) {
    if (toast.until_s >= 0) continue;
    toast.since_s = now_s;
    toast.until_s = toast.stays ? 1e18 : now_s + shown_for_s;
  }
  changed_ |= std::erase_if(list_, [now_s](const Toast& t) { return t.until_s <= now_s; }) > 0;
  return std::exchange(changed_, false);
}

double Toasts::due_in_s(double now_s) const {
  double due = 1e18;
  for (const Toast& toast : list_) due = std::min(due, std::max(0.0, toast.until_s - now_s));
  return due;
}

}  // namespace hw::gui
