#pragma once
// What happened to one controller, newest last: how its motions and programs ended, where it lost its place,
// when its link went and came back, what it and the console had to say. In bounded memory. GUI thread.
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

#include "core/device/snapshot.h"
#include "gui/model/traffic_log.h"
#include "gui/model/units_format.h"

namespace hw::gui {

struct Happening {
  enum class Mark : std::uint8_t { reached, homed, stopped, limit, error, place_lost, link, message };
  Mark mark = Mark::message;
  bool bad = false;  ///< somebody has to do something about it
  Instant at{};
  std::string who;     ///< "X", "Program 2"; empty: the controller
  std::string words;   ///< "reached its target, 85.810 mm"
  double took_s = -1;  ///< negative: it has no duration
};

/// Which of them are shown.
enum class EventFilter : std::uint8_t { all, ends, trouble };

class EventLog {
 public:
  void add(Happening event);
  /// Of a controller that is looked at for the first time nothing has happened.
  void follow(const Snapshot& now, const Catalog& catalog);
  [[nodiscard]] const std::deque<Happening>& list() const { return list_; }
  /// Changes whenever the list does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Newest first, a line each: for the clipboard, for scripts and screen readers.
  [[nodiscard]] std::string text(EventFilter filter, const DayClock& day) const;

  static constexpr std::size_t capacity = 2000;

 private:
  void follow_link(const Snapshot& now);
  void follow_trust(const Snapshot& now, const Catalog& catalog);

  std::deque<Happening> list_;
  std::uint64_t version_ = 0;
  bool looked_ = false, was_there_ = false;
  Instant lost_at_{};
  std::array<PositionTrust, max_axes> trust_{};
};

[[nodiscard]] bool is_shown(const Happening& event, EventFilter filter);
/// "9.4 s"; empty: it has no duration.
NumberText duration_of(const Happening& event);

}  // namespace hw::gui
