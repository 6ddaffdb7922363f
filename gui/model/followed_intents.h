#pragma once
// The intents of one tab whose outcome concerns the user: failures, questions, and the latest stop.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/device/snapshot.h"

namespace hw::gui {

class FollowedIntents {
 public:
  /// An intent that may be sent again with an answer (intent::Closing), and the question; see Dialogs.
  struct Question {
    IntentBody body;
    std::string sentence;
  };

  /// Reports it if it is refused or fails.
  void add(IntentId id) { followed_.push_back(id); }
  /// Its refusal may be a question.
  void may_ask(Intent intent) { may_ask_.push_back(std::move(intent)); }
  void stop_was_sent(IntentId id) { stop_ = id; }
  /// The latest stop may still have to go out.
  [[nodiscard]] bool stop_waits() const { return stop_ != 0; }
  [[nodiscard]] std::optional<Question>& question() { return question_; }

  /// Once a frame. Calls `failed` once for each intent that was refused or has failed.
  void refresh(const Snapshot& now, const std::function<void(const IntentOutcome&)>& failed);

 private:
  void look_for_questions(const Snapshot& now);
  void look_at_stop(const Snapshot& now);

  std::vector<IntentId> followed_;
  std::vector<Intent> may_ask_;
  std::optional<Question> question_;
  IntentId stop_ = 0;  ///< until it has done its work
};

}  // namespace hw::gui
