#include "core/devices/vme58/feed.h"

#include <fmt/core.h>

namespace hw::vme58 {
namespace {

constexpr int commands_a_round = 64;

}  // namespace

int line_holding(std::string_view text, std::size_t at) {
  int line = 0;
  for (const char c : text.substr(0, at)) line += c == '\n';
  return line;
}

bool Feed::load(const std::string& plain) {
  Context context = selection_.context();
  fed_ = Fed{};
  context_ = fed_.before = context;
  apart_ = false;
  to_feed_.clear();
  for (const TextCommand& command : read_commands(plain, context))
    to_feed_.emplace_back(line_holding(plain, command.begin), std::string(command.text));
  return !to_feed_.empty();
}

void Feed::begin() {
  snapshot_.feed.running = true;
  snapshot_.feed.sent = 0;
  snapshot_.feed.total = static_cast<std::int32_t>(to_feed_.size());
}

/// If the user's text has selected an axis meanwhile, adds the program's selector before the command and the
/// user's after it. Not within a contour, which a selector would end.
std::string Feed::text_for(std::string_view command, const Context& after) const {
  const std::string users = selection_.selector(), own = context_.selector();
  std::string text;
  if (!context_.recording && (selection_.is_lost() || (apart_ && own != users))) text = own + " ";
  text += std::string(command) + ";";
  if (apart_ && !after.recording && after.selector() != users) text += " " + users;
  return text + "\n";
}

std::string Feed::rejected_late() const {
  return fmt::format("The board rejected a command of lines 1 to {} when a queue reached it.", fed_.line + 1);
}

Task<Result<std::optional<std::string>>> Feed::go_on() {
  for (int n = 0; n < commands_a_round; ++n) {
    if (!fed_.text.empty()) {
      const auto taken = co_await conversation_.is_taken(Priority::transfer);
      if (!taken) co_return fail(taken.error());
      if (!*taken) {
        fed_.waits = true;
        co_return std::nullopt;
      }
      auto finished = co_await finish();
      if (!finished || *finished) co_return finished;
    }
    if (to_feed_.empty()) {
      snapshot_.feed.running = false;
      co_return std::nullopt;
    }
    const auto late = co_await readings_.was_rejected(Priority::transfer);
    if (!late) co_return fail(late.error());
    if (*late) co_return rejected_late();
    const auto put = co_await put_next();
    if (!put) co_return fail(put.error());
    if (!*put) co_return std::nullopt;
  }
  co_return std::nullopt;
}

/// Handles a command that the board has taken: it was rejected, or takes effect from here on.
Task<Result<std::optional<std::string>>> Feed::finish() {
  const auto bad = co_await readings_.was_rejected(Priority::transfer);
  if (!bad) co_return fail(bad.error());
  const std::string sent = std::exchange(fed_.text, {});
  ++snapshot_.feed.sent;
  // Commands taken by the board wait in its queues, and the command under way is not reported; only pieces
  // need this count.
  snapshot_.program.command =
      snapshot_.pieces.running ? static_cast<std::int16_t>(snapshot_.feed.sent) : std::int16_t{-1};
  if (*bad) {
    std::string what = fed_.waits ? rejected_late()  // other commands may have run meanwhile
                                  : fmt::format("Line {}: the board rejected \"{}\".", fed_.line + 1, sent);
    what += commands_.open_loop_words(sent, fed_.before);
    selection_.lose();  // the rejected command may have been a selector
    if (!apart_) selection_.set(fed_.before);
    co_return what;
  }
  Context read = fed_.before;
  for (const TextCommand& command : read_commands(sent, read)) effects_.note_queued(command);
  co_return std::nullopt;
}

Task<Result<bool>> Feed::put_next() {
  auto [line, command] = to_feed_.front();
  Context after = context_;
  for (const TextCommand& read : read_commands(command, after)) motions_.note_group(read);
  std::string text = text_for(command, after);
  const auto put = co_await conversation_.put(std::move(text), Priority::transfer);
  if (!put) co_return fail(put.error());
  if (!*put) co_return false;
  to_feed_.pop_front();
  fed_.before = std::exchange(context_, after);
  if (!apart_) selection_.set(after);
  selection_.set_recording(after.recording);
  if (!after.recording) selection_.is_restored();
  fed_.line = line;
  fed_.waits = false;
  fed_.text = std::move(command);
  co_return true;
}

void Feed::end() {
  forget();
  if (selection_.end_recording()) selection_.lose();  // a selector also ends it on the board
}

void Feed::forget() {
  to_feed_.clear();
  fed_.text.clear();
  snapshot_.feed.running = false;
}

}  // namespace hw::vme58
