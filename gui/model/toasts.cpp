#include "gui/model/toasts.h"

#include <algorithm>

namespace hw::gui {

void Toasts::add(Mood mood, std::string text, const void* about, std::string of) {
  for (Toast& toast : list_)
    if (toast.text == text && toast.of == of) {
      toast.until_s = -1;  // said again: its time starts anew
      return;
    }
  if (list_.size() == at_most) list_.erase(list_.begin());
  std::string said = text;
  list_.push_back({next_number_++, mood, std::move(text), -1, about, std::move(of), std::move(said)});
  list_.back().stays = mood == Mood::fault;
}

void Toasts::add_staying(Mood mood, std::string text) {
  add(mood, std::move(text));
  list_.back().stays = true;
}

void Toasts::look_at(std::optional<std::string_view> front) {
  for (Toast& toast : list_) {
    const bool named = front && !toast.of.empty() && toast.of != *front;
    const std::size_t size = toast.text.size() + (named ? toast.of.size() + 2 : 0);
    if (toast.said.size() != size) toast.said = named ? toast.of + ": " + toast.text : toast.text;
  }
}

void Toasts::withdraw(const void* about) {
  std::erase_if(list_, [about](const Toast& t) { return t.about == about; });
}

void Toasts::dismiss(int number) {
  std::erase_if(list_, [number](const Toast& t) { return t.number == number; });
}

void Toasts::tick(double now_s) {
  for (Toast& toast : list_)
    if (toast.until_s < 0) toast.until_s = toast.stays ? 1e18 : now_s + shown_for_s;
  std::erase_if(list_, [now_s](const Toast& t) { return t.until_s <= now_s; });
}

double Toasts::due_in_s(double now_s) const {
  double due = 1e18;
  for (const Toast& toast : list_) due = std::min(due, std::max(0.0, toast.until_s - now_s));
  return due;
}

}  // namespace hw::gui
