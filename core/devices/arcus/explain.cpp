#include "core/devices/arcus/explain.h"

#include <fmt/format.h>

#include "core/device/command_form.h"
#include "core/devices/arcus/codec.h"

namespace hw::arcus {
namespace {

std::vector<AxisInfo> axes_of(const Model& model) {
  std::vector<AxisInfo> axes;
  for (const char letter : model.axis_letters) axes.push_back({std::string(1, letter), {}, true, true});
  return axes;
}

std::string help_for(const Model& model, std::span<const CommandInfo> known, std::string_view text) {
  const std::vector<AxisInfo> axes = axes_of(model);
  for (const CommandInfo& c : known)
    if (CommandForm(c, axes).match(text) == CommandForm::Match::whole) return c.help;
  return {};
}

std::string explain_sent(const Model& model, std::span<const CommandInfo> known, std::string_view bytes) {
  const std::string_view text = text_of(bytes);
  const int address = address_of(bytes);
  std::string to;
  if (address >= 0 && address == model.broadcast)
    to = "to all devices, no reply: ";
  else if (address >= 0)
    to = fmt::format("to {:02}: ", address);
  const std::string help = help_for(model, known, text);
  return help.empty() ? to + "not a command of the manual" : to + help;
}

std::string explain_status(const Model& model, std::string_view text) {
  const auto words = decode_numbers(text, static_cast<std::size_t>(model.axes()));
  if (!words) return {};
  std::string all;
  for (int i = 0; i < model.axes(); ++i)
    all += fmt::format("{}{} {}", i ? "; " : "", model.axis_letters[static_cast<std::size_t>(i)],
                       status_words(model, (*words)[static_cast<std::size_t>(i)]));
  return all;
}

}  // namespace

std::string status_words(const Model& model, std::int64_t word) {
  const StatusBits& b = model.status;
  struct Row {
    int bit;
    const char* words;
  };
  const Row rows[] = {{b.accelerating, "accelerating"},
                      {b.constant, "at speed"},
                      {b.decelerating, "decelerating"},
                      {b.minus_limit, "- limit switch on"},
                      {b.plus_limit, "+ limit switch on"},
                      {b.home, "home switch on"},
                      {b.alarm, "alarm on"},
                      {b.minus_error, "- limit error"},
                      {b.plus_error, "+ limit error"},
                      {b.alarm_error, "alarm error"},
                      {b.latch, "latch input on"},
                      {b.index, "on the index mark"},
                      {b.timed_out, "communication timed out"}};
  std::string all = reports_motion(word) ? "" : "at rest";
  for (const Row& row : rows)
    if (has_bit(word, row.bit)) all += fmt::format("{}{}", all.empty() ? "" : ", ", row.words);
  return all;
}

bool names_product(std::string_view reply, const Model& model) {
  return decode_reply(reply).text == model.product;
}

std::string explain(const Model& model, std::span<const CommandInfo> known, std::string_view bytes, Way way,
                    TrafficKind kind, std::string_view asked) {
  if (way == Way::sent) return explain_sent(model, known, bytes);
  if (const auto id = in_position(bytes)) return fmt::format("device {:02} is in position", *id);
  if (kind == TrafficKind::unparsed) return "not a reply to a query";
  const Reply reply = decode_reply(bytes);
  if (reply.refused()) return "refused: " + explain_refusal(model, reply.text);
  if (reply.text == "OK") return "done";
  const std::string_view question = text_of(asked);
  if (question == "MST" || (question.starts_with("MST") && question.size() == 4 && model.axes() > 1))
    return question == "MST" ? explain_status(model, reply.text)
                             : status_words(model, decode_number(reply.text).value_or(0));
  return {};
}

}  // namespace hw::arcus
