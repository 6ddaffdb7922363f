// Binds `ui`, a script's input to the screen. An action that a user could not do is an error in the script's
// line.
#include <lua.hpp>

#include <fmt/core.h>

#include "core/script/call.h"
#include "gui/app/script_stage.h"

namespace hw::app {
namespace {

using script::Answer;
using script::Call;
using script::Misuse;

ScriptStage& stage(const Call& call) { return *static_cast<ScriptStage*>(call.runner().options().stage); }
gui::Automation& automation(const Call& call) { return stage(call).automation(); }

Answer done_or_error(const Result<>& result) {
  if (!result) return script::answer_error(result.error().sentence());
  return script::answer_yes();
}

template <Result<> (gui::Automation::*verb)(std::string_view)>
int on_one(Call& call) {
  return call.wait_for_act(
      [&ui = automation(call), id = call.text(1, "id")] { return done_or_error((ui.*verb)(id)); });
}

int type(Call& call) {
  return call.wait_for_act([&ui = automation(call), id = call.text(1, "id"), text = call.text(2, "text")] {
    return done_or_error(ui.type(id, text));
  });
}

int value(Call& call) {
  return call.wait_for_act([&ui = automation(call), id = call.text(1, "id")] {
    auto shown = ui.value(id);
    return shown ? script::answer_text(std::move(*shown)) : script::answer_refused(shown.error().sentence());
  });
}

int drag(Call& call) {
  const double share = call.has(3) ? call.number(3, "share") : 0.5;
  if (share < 0 || share > 1) throw Misuse("ui.drag: a share of the height from 0 to 1");
  return call.wait_for_act([&ui = automation(call), id = call.text(1, "id"), onto = call.text(2, "id"),
                            share] { return done_or_error(ui.drag(id, onto, static_cast<float>(share))); });
}

int exists(Call& call) {
  return call.wait_for_act([&ui = automation(call), id = call.text(1, "id")]() -> Answer {
    return [there = ui.exists(id)](lua_State* L) {
      lua_pushboolean(L, there);
      return 1;
    };
  });
}

void set_text(lua_State* L, const char* name, std::string_view text) {
  lua_pushlstring(L, text.data(), text.size());
  lua_setfield(L, -2, name);
}
void set_number(lua_State* L, const char* name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

int push_list(lua_State* L, const std::vector<gui::Automation::Listed>& all) {
  lua_createtable(L, static_cast<int>(all.size()), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const gui::Automation::Listed& w = all[i];
    lua_createtable(L, 0, 7);
    set_text(L, "id", w.id);
    set_text(L, "kind", w.kind);
    set_text(L, "label", w.label);
    set_text(L, "value", w.value);
    lua_createtable(L, 0, 4);
    set_number(L, "x", w.x);
    set_number(L, "y", w.y);
    set_number(L, "width", w.width);
    set_number(L, "height", w.height);
    lua_setfield(L, -2, "rectangle");
    lua_pushboolean(L, w.enabled);
    lua_setfield(L, -2, "enabled");
    lua_pushboolean(L, w.moving);
    lua_setfield(L, -2, "moving");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

int list(Call& call) {
  return call.wait_for_act([&ui = automation(call)]() -> Answer {
    return [all = ui.list()](lua_State* L) { return push_list(L, all); };
  });
}

int frame(Call& call) {
  const std::int64_t n = call.has(1) ? call.whole(1, "frames") : 1;
  if (n < 0 || n > 1'000'000) throw Misuse("ui.frame: from 0 to 1000000 frames");
  return call.wait_for_act([&ui = automation(call), n] {
    ui.frame(static_cast<int>(n));
    return script::answer_yes();
  });
}

int screenshot(Call& call) {
  std::string path = call.text(1, "path");
  if (!path.ends_with(".png")) throw Misuse("ui.screenshot: the name of a picture ends in .png");
  return call.wait_for_act([&ui = automation(call), &notes = call.runner().notes(), path] {
    const Result<> taken = ui.screenshot(path);
    if (taken) notes.written.note(path, {});
    return done_or_error(taken);
  });
}

int window(Call& call) {
  const std::int64_t w = call.whole(1, "width"), h = call.whole(2, "height");
  const double scale = call.has(3) ? call.number(3, "scale") : 1;
  if (w < 1 || w > 16384 || h < 1 || h > 16384) throw Misuse("ui.window: 1 to 16384 pixels");
  return call.wait_for_act([&ui = automation(call), w, h, scale] {
    return done_or_error(ui.window(static_cast<int>(w), static_cast<int>(h), static_cast<float>(scale)));
  });
}

int theme(Call& call) {
  return call.wait_for_act(
      [&on = stage(call), name = call.text(1, "theme")] { return done_or_error(on.set_theme(name)); });
}

int lose_focus(Call& call) {
  return call.wait_for_act([&ui = automation(call)] {
    ui.lose_focus();
    return script::answer_yes();
  });
}

constexpr script::Function functions[] = {
    {"click", on_one<&gui::Automation::click>},
    {"press", on_one<&gui::Automation::press>},
    {"release", on_one<&gui::Automation::release>},
    {"drag", drag},
    {"key", on_one<&gui::Automation::key>},
    {"key_down", on_one<&gui::Automation::key_down>},
    {"key_up", on_one<&gui::Automation::key_up>},
    {"theme", theme},
    {"type", type},
    {"value", value},
    {"exists", exists},
    {"list", list},
    {"frame", frame},
    {"screenshot", screenshot},
    {"window", window},
    {"lose_focus", lose_focus},
};

}  // namespace

void ScriptStage::bind(lua_State* L) {
  runner_ = &script::Runner::of(L);
  script::push_functions(L, std::begin(functions), std::end(functions), 0);
  lua_setglobal(L, "ui");
}

}  // namespace hw::app
