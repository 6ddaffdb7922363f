// Methods of a controller for upkeep: clearing errors, storing the set-up, backup to a file and restore.
#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/sandbox.h"
#include "core/script/script_files.h"
#include "core/session/backup.h"

namespace hw::script {
namespace {

/// The action that clears stored errors; -1: the controller stores none.
int clearing_action(const Catalog& catalog) {
  const int clear = catalog.find_action("clear");
  return clear >= 0 ? clear : catalog.find_action("clear_flags");
}

Task<Answer> clear_all(SessionPtr session) {
  const Catalog& catalog = session->catalog();
  if (const int action = clearing_action(catalog); action >= 0) {
    std::vector<std::int64_t> values;
    for (const ActionField& field : catalog.actions[static_cast<std::size_t>(action)].fields)
      values.push_back(field.fallback);  // a field for an axis: all axes
    IntentBody clear = intent::Act(action, std::move(values));
    const auto cleared = co_await session->perform(std::move(clear));
    if (!cleared) co_return answer_of(cleared);
  }
  co_await session->pump().refresh();
  const Snapshot& now = session->known();
  for (int i = 0; i < now.axis_count; ++i)
    if (now.axes[i].activity == Activity::error)
      co_return answer_refused(fmt::format("The error of axis {} remains: its cause is still there.",
                                           catalog.axes[static_cast<std::size_t>(i)].name));
  if (!now.link.connected())
    co_return answer_refused(fmt::format("There is no connection. {}", now.link.sentence.view()));
  co_return answer_yes();
}

int clear_errors(Call& call) { return call.wait(clear_all(session_of(call))); }

int store(Call& call) {
  const SessionPtr& session = session_of(call);
  if (!session->catalog().can.store)
    return call.refuse(fmt::format("{} has no command to store its set-up.", session->catalog().short_name));
  return perform(call, intent::Store());
}

Result<std::string> backup_file(const Call& call) {
  return file_of_script(folder_of(call.runner().options().path), call.text(1, "file"), ".toml");
}

Task<Answer> back_up(Runner& runner, SessionPtr session, std::string path) {
  const auto taken = co_await take_backup(session);
  if (!taken) co_return answer_refused(taken.error());
  const auto saved = save_backup(path, *taken, session->catalog());
  if (!saved) co_return answer_refused(not_written_beside(folder_of(runner.options().path), saved.error()));
  runner.notes().written.note(path, fmt::format("{} parameters", taken->parameters.size()));
  co_return answer_yes();
}

int backup(Call& call) {
  auto path = backup_file(call);
  if (!path) return call.refuse(path.error());
  return call.wait(back_up(call.runner(), session_of(call), std::move(*path)));
}

/// Also writes parameters that carry a warning, as c:set does: a script confirms by calling.
Task<Answer> bring_back(SessionPtr session, Backup kept, std::string path) {
  const auto report = co_await restore_backup(session, std::move(kept), std::move(path), Warned::write);
  if (!report) co_return answer_refused(report.error());
  if (!report->left_out.empty()) co_return answer_refused(report->left_out.front());
  co_return answer_yes();
}

int restore(Call& call) {
  auto path = backup_file(call);
  if (!path) return call.refuse(path.error());
  auto kept = load_backup(*path);
  if (!kept) return call.refuse(kept.error());
  return call.wait(bring_back(session_of(call), std::move(*kept), std::move(*path)));
}

constexpr Function upkeep_table[] = {
    {"clear_errors", clear_errors},
    {"store", store},
    {"backup", backup},
    {"restore", restore},
};

}  // namespace

std::span<const Function> upkeep_methods() { return upkeep_table; }

}  // namespace hw::script
