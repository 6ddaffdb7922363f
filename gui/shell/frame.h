#pragma once
// The data that a panel gets in each frame: one controller at one instant, and the calls to act on it. The
// console makes it for each panel and frame, and a panel keeps none of it. A panel holds view state only, and
// never knows a device by name.
#include <cstdint>
#include <string>
#include <string_view>

#include "core/device/bench.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/severity.h"
#include "gui/surface/layout.h"

namespace hw::gui {

class Console;
class Tab;
class Ui;

/// The data of a page without a controller (connect, keyboard map).
struct PageFrame {
  Ui& ui;
  Console& console;
  Box area;  ///< logical pixels; the panel is an ImGui child there, with its cursor at the top left
  Tier tier;
  bool rail;      ///< a column 56 wide with lamps only
  Instant clock;  ///< present time; an age is `clock` minus `seen_at`

  /// Shows a sentence at the bottom of the centre. Faults stay until they are read, other toasts disappear
  /// after 6 s. `about` is the subject: see Toasts::withdraw().
  void toast(Severity severity, std::string sentence, const void* about = nullptr) const;
  /// Removes the messages about a subject that has changed.
  void withdraw(const void* about) const;
};

struct Frame : PageFrame {
  Tab& tab;  ///< names, units, texts and traffic of this controller
  const Catalog& catalog;
  const Snapshot& now;
  const BenchView& bench;

  /// As PageFrame::toast(); names this controller while another controller is in front.
  void toast(Severity severity, std::string sentence, const void* about = nullptr) const;
  /// Sends the intent. If it is refused or fails, a toast shows the sentence.
  IntentId send(IntentBody body) const;
  /// Sends the intent. The panel shows its outcome itself, from now.outcome_of(id).
  IntentId send_and_watch(IntentBody body) const;
  void operate_bench(BenchCommand command) const;
  /// Brings the panel `tab/ID` to the front; if `widget` is given, scrolls to it and focuses it.
  void show_panel(std::string_view id, std::string_view widget = {}) const;

  [[nodiscard]] bool connected() const {
    return now.link.state == LinkState::good || now.link.state == LinkState::late;
  }
  /// Why a button that needs the controller is disabled.
  [[nodiscard]] std::string_view no_link() const { return connected() ? "" : "There is no link."; }
};

}  // namespace hw::gui
