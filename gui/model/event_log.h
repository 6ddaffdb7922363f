#pragma once
// Events of one controller, newest last: how its motions and programs ended, where its position was lost,
// when its link was lost and came back, messages of the controller and the console. In bounded memory. GUI
// thread.
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/snapshot.h"
#include "gui/model/traffic_log.h"
#include "gui/model/units_format.h"

namespace hw::gui {

struct LoggedEvent {
  enum class Mark : std::uint8_t { reached, homed, stopped, limit, error, place_lost, link, message };
  Mark mark = Mark::message;
  bool bad = false;  ///< needs attention
  Instant at{};
  std::string subject;       ///< "X", "Program 2"; empty: the controller
  std::string words;         ///< "reached its target, 85.810 mm"
  double took_s = -1;        ///< negative: it has no duration
  std::uint64_t number = 0;  ///< set by EventLog::add()
};

/// Selects the events to show.
enum class EventFilter : std::uint8_t { all, ends, trouble };

class EventLog {
 public:
  using ShowPosition = std::function<std::string(AxisId, Steps)>;

  void add(LoggedEvent event);
  /// How a motion, program, list or drawing ended. What ends together is one event: a program that is cut
  /// short, and the motions that were cut short with it.
  void add(const Ending& ending, const Catalog& catalog, const ShowPosition& position);
  /// Adds changes of link and trust. The first connection of a controller is no event.
  void follow(const Snapshot& now, const Catalog& catalog);
  [[nodiscard]] const std::deque<LoggedEvent>& list() const { return list_; }
  /// Changes whenever the list does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Of this controller; zero: it has not answered yet.
  [[nodiscard]] Instant first_answer_at() const { return first_answer_at_; }
  /// Newest first, one line each: for the clipboard, scripts and screen readers.
  [[nodiscard]] std::string text(EventFilter filter, const DayClock& day) const;

  static constexpr std::size_t capacity = 2000;

 private:
  /// An end that others may still join.
  struct Recent {
    Ending ending;
    std::uint64_t number = 0;  ///< of its event
  };
  void follow_link(const Snapshot& now);
  void follow_trust(const Snapshot& now, const Catalog& catalog);

  [[nodiscard]] LoggedEvent* find(std::uint64_t number);
  void add_motion(const Ending& ending, const Catalog& catalog, const ShowPosition& position);
  void add_run(const Ending& ending, const Catalog& catalog, const ShowPosition& position);
  void join(const Ending& motion, const Recent& run, const Catalog& catalog, const ShowPosition& position);
  void keep_recent(const Ending& ending);

  std::deque<LoggedEvent> list_;
  std::vector<Recent> recent_;
  std::uint64_t version_ = 0, last_number_ = 0;
  bool looked_ = false, was_there_ = false;
  Instant lost_at_{}, first_answer_at_{};
  std::array<PositionTrust, max_axes> trust_{};
};

[[nodiscard]] bool is_shown(const LoggedEvent& event, EventFilter filter);
/// "9.4 s"; empty: it has no duration.
NumberText duration_of(const LoggedEvent& event);

}  // namespace hw::gui
