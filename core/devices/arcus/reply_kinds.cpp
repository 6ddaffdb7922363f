#include "core/devices/arcus/reply_kinds.h"

namespace hw::arcus::reply_kinds {

ReplyKind of_question(const Forms& forms, std::string_view question) {
  if (question == "DN") return name;
  if (question == "ID") return product;
  if (question == "VER") return version;
  if (question.starts_with("SA") && !question.starts_with("SASTAT")) return text;
  const bool of_all_axes = question == forms.status || question == forms.positions ||
                           question == forms.encoders || question == forms.speeds;
  return of_all_axes && forms.model->axes() > 1 ? numbers : number;
}

ReplyKind of_text(const Forms& forms, std::string_view command) {
  if (command == "DN" || command == "ID" || command == "VER") return of_question(forms, command);
  const bool does = command.find('=') != command.npos || ends_motion(command) || may_move(forms, command);
  return does ? done : text;
}

bool is_version(std::string_view text) {
  return text.size() >= 2 && text[0] == 'V' && text[1] >= '0' && text[1] <= '9';
}

std::size_t others_at_front(std::string_view bytes, const std::function<bool(std::string_view)>& is_it) {
  if (const std::size_t unsolicited = unsolicited_at_front(bytes); unsolicited != 0) return unsolicited;
  const auto end = bytes.find_first_of(std::string_view("\r\0", 2));
  if (end == bytes.npos) return 0;
  return is_it(decode_reply(bytes.substr(0, end)).text) ? 0 : end + 1;
}

}  // namespace hw::arcus::reply_kinds
