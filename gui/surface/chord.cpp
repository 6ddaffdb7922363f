#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cctype>

#include <GLFW/glfw3.h>

#include "gui/model/lower_case.h"
#include "gui/surface/automation.h"

namespace hw::gui {
namespace {

struct Name {
  std::string_view name;  // lower case
  int key;
};
constexpr Name key_names[] = {
    {"escape", GLFW_KEY_ESCAPE},
    {"esc", GLFW_KEY_ESCAPE},
    {"enter", GLFW_KEY_ENTER},
    {"return", GLFW_KEY_ENTER},
    {"tab", GLFW_KEY_TAB},
    {"space", GLFW_KEY_SPACE},
    {"backspace", GLFW_KEY_BACKSPACE},
    {"delete", GLFW_KEY_DELETE},
    {"insert", GLFW_KEY_INSERT},
    {"left", GLFW_KEY_LEFT},
    {"right", GLFW_KEY_RIGHT},
    {"up", GLFW_KEY_UP},
    {"down", GLFW_KEY_DOWN},
    {"pageup", GLFW_KEY_PAGE_UP},
    {"pgup", GLFW_KEY_PAGE_UP},
    {"pagedown", GLFW_KEY_PAGE_DOWN},
    {"pgdn", GLFW_KEY_PAGE_DOWN},
    {"home", GLFW_KEY_HOME},
    {"end", GLFW_KEY_END},
};

bool read_key(std::string_view word, Chord& chord) {
  if (word.size() == 1) {
    const auto c = static_cast<unsigned char>(word[0]);
    chord.text = c;
    if (std::isalnum(c))
      chord.key = std::toupper(c);
    else if (c == '?')
      chord.key = GLFW_KEY_SLASH;
    else if (c == ' ')
      chord.key = GLFW_KEY_SPACE;
    else
      chord.key = c < 128 ? c : 0;
    return chord.key != 0;
  }
  const std::string low = lower_case(word);
  for (const Name& n : key_names)
    if (n.name == low) {
      chord.key = n.key;
      chord.text = n.key == GLFW_KEY_SPACE ? ' ' : 0;
      return true;
    }
  if (low.size() >= 2 && low[0] == 'f' && std::all_of(low.begin() + 1, low.end(), ::isdigit)) {
    const int number = std::stoi(low.substr(1, 2));
    if (number < 1 || number > 12) return false;
    chord.key = GLFW_KEY_F1 + number - 1;
    return true;
  }
  return false;
}

}  // namespace

Result<Chord> read_chord(std::string_view text) {
  Chord chord;
  std::string_view rest = text;
  for (std::size_t plus;
       (plus = rest.find('+')) != std::string_view::npos && plus > 0 && plus + 1 < rest.size();) {
    const std::string modifier = lower_case(rest.substr(0, plus));
    if (modifier == "ctrl" || modifier == "control")
      chord.ctrl = true;
    else if (modifier == "shift")
      chord.shift = true;
    else if (modifier == "alt")
      chord.alt = true;
    else
      return fail(FaultKind::text, "There is no modifier named '" + modifier + "'.", {},
                  "Use Ctrl, Shift or Alt.");
    rest.remove_prefix(plus + 1);
  }
  if (!read_key(rest, chord))
    return fail(FaultKind::text, "There is no key named '" + std::string(rest) + "'.", {},
                "Use a letter, F1 to F12, Escape, Enter, Tab, Space, Left, PageUp and the like.");
  if (chord.ctrl || chord.alt) chord.text = 0;
  return chord;
}

}  // namespace hw::gui
