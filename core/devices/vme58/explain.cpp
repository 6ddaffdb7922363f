#include "core/devices/vme58/explain.h"

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t most_explained = 4;

const std::string* help_of(const TextCommand& command) {
  static const std::vector<CommandInfo> all = command_help();
  const bool list = command.given() > 1 && command.fact->shape == Shape::list;
  const std::string* found = nullptr;
  for (const CommandInfo& info : all) {
    if (!info.form.starts_with(command.fact->letters)) continue;
    const bool of_list = info.form.ends_with("..."), recorded = info.help.ends_with("is recorded)");
    if (recorded != (command.fact->when == When::recorded)) continue;
    if (!found || of_list == list) found = &info.help;
    if (of_list == list) break;
  }
  return found;
}

// A line of traffic does not show the mode left by the lines before it. It is read as a single-axis line or,
// if that makes no sense, as a line of AA or of a contour.
std::vector<TextCommand> commands_in_likely_mode(std::string_view bytes) {
  std::vector<TextCommand> best;
  std::ptrdiff_t fewest = 0;
  for (const unsigned mode : {where::single, where::all, where::contour}) {
    Context context;
    context.recording = mode == where::contour;
    context.mode = context.recording ? where::all : mode;
    auto commands = read_commands(bytes, context);
    const auto flaws = std::count_if(commands.begin(), commands.end(),
                                     [](const TextCommand& c) { return !c.fact || !c.flaw.empty(); });
    if (!best.empty() && flaws >= fewest) continue;
    best = std::move(commands);
    fewest = flaws;
  }
  return best;
}

std::string explain_sent(std::string_view bytes) {
  if (bytes == "data area") return "registers read, axis data asked for and read";
  if (bytes.starts_with("mailbox "))
    return "urgent, ahead of everything that waits: " + explain_sent(bytes.substr(8));
  std::string all;
  std::size_t explained = 0;
  const auto commands = commands_in_likely_mode(bytes);
  for (const TextCommand& command : commands) {
    const bool selector = command.fact && command.fact->op <= Op::AS;
    if (selector && commands.size() > 1) continue;
    if (explained++ == most_explained) return all + "; ...";
    const std::string* help = command.fact ? help_of(command) : nullptr;
    if (!all.empty()) all += "; ";
    if (command.fact && command.fact->where & where::single && commands.front().fact &&
        commands.front().fact->op <= Op::AS && explained == 1 && commands.size() > 1)
      all += fmt::format("{}: ", commands.front().text.substr(1) == "A"   ? "all axes"
                                 : commands.front().text.substr(1) == "M" ? "a group"
                                                                          : commands.front().text.substr(1));
    all += help ? *help : "not a command of the data sheet";
  }
  return all;
}

std::string explain_flags(std::string_view reply) {
  const auto flags = decode_flags(reply);
  if (!flags) return {};
  return fmt::format("direction {}, {}, {}, {}", flags->plus ? "+" : "-", flags->done ? "done" : "not done",
                     flags->limit ? "on a limit switch" : "no limit switch",
                     flags->home ? "at home" : "not at home");
}

std::string explain_poll(std::string_view reply) {
  std::string all;
  std::size_t axis = 0;
  while (!reply.empty() && axis < axis_letters.size()) {
    const auto blank = reply.find(' ');
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", axis_letters[axis++], reply.substr(0, blank));
    reply = blank == reply.npos ? std::string_view() : reply.substr(blank + 1);
  }
  return all;
}

}  // namespace

std::string explain(std::string_view bytes, Way way, TrafficKind, std::string_view asked) {
  if (way == Way::sent) return explain_sent(bytes);
  if (asked == "data area") return explain_poll(bytes);
  if (const std::string flags = explain_flags(bytes); !flags.empty()) return flags;
  if (const auto greeting = decode_greeting(bytes))
    return fmt::format("model {}{}{}, firmware {}", greeting->model, greeting->variant.empty() ? "" : "-",
                       greeting->variant, greeting->version);
  if (asked.find("RQ") != asked.npos) return "free entries of the queue";
  return {};
}

}  // namespace hw::vme58
