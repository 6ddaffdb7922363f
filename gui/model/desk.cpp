#include "gui/model/desk.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "gui/model/list_run.h"
#include "gui/model/step_recorder.h"

namespace hw::gui {

Desk::Desk(const Catalog& catalog, const Language* language, TrafficLog::Explain explain)
    : records(explain),
      programs(catalog, language, work),
      blocks(catalog),
      kept(programs.texts, blocks, work),
      list_run(std::make_unique<ListRun>()),
      step_recorder(std::make_unique<StepRecorder>()),
      setup(catalog),
      help(catalog),
      catalog_(catalog) {}

Desk::~Desk() = default;

std::vector<std::filesystem::path> Desk::take_dropped(std::string_view panel) {
  const auto found = dropped.find(panel);
  return found == dropped.end() ? std::vector<std::filesystem::path>() : std::exchange(found->second, {});
}

void Desk::sent(const IntentBody& body) {
  if (std::holds_alternative<intent::Reset>(body)) programs.texts.doubt();
  if (std::holds_alternative<intent::Stop>(body) || std::holds_alternative<intent::Abort>(body) ||
      std::holds_alternative<intent::HaltProgram>(body))
    stopped();
}

void Desk::stopped() {
  programs.job.give_up();
  list_run->stopped();
  step_recorder->stopped();
  until_stopped_ = std::make_shared<int>(0);
}

void Desk::refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send) {
  work.deliver();
  programs.refresh(now, bench, clock, send);
  records.trace.follow(now);
  setup_write.update(now, catalog_, send);
  setup.settle(now);
  places.follow(now, clock, send, work.worker());
  records.events.follow(now, catalog_);
  kept.follow(clock);
}

void Desk::keep_now(Instant clock) {
  places.keep_now(clock, work.worker());
  kept.keep_now();
}

double Desk::autosave_due_in(Instant clock) const {
  const double texts_in = kept.due_in(clock);
  const double places_in = places.due_in(clock);
  return texts_in < 0 || places_in < 0 ? std::max(texts_in, places_in) : std::min(texts_in, places_in);
}

}  // namespace hw::gui
