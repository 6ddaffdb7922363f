#include "gui/shell/frame.h"

#include "gui/shell/console.h"

namespace hw::gui {

void PageFrame::toast(Severity severity, std::string sentence, const void* about) const {
  console.toast(severity, std::move(sentence), about);
}

void PageFrame::withdraw(const void* about) const { console.toasts().withdraw(about); }

void Frame::toast(Severity severity, std::string sentence, const void* about) const {
  console.toast(tab, severity, std::move(sentence), about);
}
IntentId Frame::send(IntentBody body) const { return tab.send_followed(std::move(body)); }
IntentId Frame::send_and_watch(IntentBody body) const { return tab.send(std::move(body)); }
void Frame::operate_bench(BenchCommand command) const { tab.operate_bench(std::move(command)); }
void Frame::show_panel(std::string_view id, std::string_view widget) const { console.show_panel(id, widget); }

}  // namespace hw::gui
