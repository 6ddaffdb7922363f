#include "tests/simulation/draw.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/device/registry.h"
#include "core/session/address.h"
#include "tests/simulation/models.h"
#include "tests/simulation/random.h"

namespace hw::simulation {
namespace {

class Artist {
 public:
  Artist(const ModelFacts& facts, std::uint64_t seed, const Drawing& drawing)
      : random_(seed * 1000003u + 17),
        beside_(seed * 2000003u + 31),
        tool_(seed * 3000017u + 43),
        facts_(facts),
        drawing_(drawing) {
    plan_.model = facts.model;
    const bool bus = drawing.bus && !facts.bus.empty();
    plan_.options = random_.one_of(bus ? facts.bus : facts.options);
    plan_.length = drawing.length;
    const auto address = Address::parse(plan_.address());
    if (!address) throw std::runtime_error(address.error().sentence());
    devices_ = static_cast<int>(address->devices().size());
    const auto catalog = find_device_type(address->model)->make_catalog(address->devices().front().options);
    if (!catalog) throw std::runtime_error(catalog.error().sentence());
    catalog_ = *catalog;
  }

  Plan draw() {
    draw_quirk(drawing_.faults ? facts_.quirks : facts_.strict);
    if (facts_.model == "vxm" && plan_.options.find("quirk=") == std::string::npos && beside_.percent(5))
      plan_.options += plan_.options.empty() ? "quirk=old-firmware" : ",quirk=old-firmware";
    if (drawing_.faults) draw_habits();
    if (facts_.needs_power)
      for (int device = 0; device < devices_; ++device) put(Millis(900), "motor_power", device, {-1, 1});
    for (Millis at(1000 + random_.between(0, 1000)); at < drawing_.length; at += gap()) {
      if (drawing_.faults && random_.percent(20))
        draw_fault(at);
      else
        draw_action(at);
      if (beside_.percent(4)) draw_scripts(at);
    }
    std::stable_sort(plan_.steps.begin(), plan_.steps.end(),
                     [](const Step& a, const Step& b) { return a.at < b.at; });
    return std::move(plan_);
  }

 private:
  using Numbers = std::vector<std::int64_t>;
  void put(Millis at, std::string verb, int device, Numbers numbers = {}, std::string text = {}) {
    plan_.steps.push_back({at, std::move(verb), device, std::move(numbers), std::move(text)});
  }
  // Races live in the gaps of a few milliseconds, motions in those of seconds.
  Millis gap() {
    if (random_.percent(35)) return Millis(random_.between(0, 60));
    return Millis(random_.between(60, 400) + random_.mostly_small(0, 4000));
  }
  std::int64_t axis() { return random_.between(0, static_cast<std::int64_t>(catalog_.axes.size()) - 1); }
  std::int64_t axis_or_all() { return random_.percent(50) ? -1 : axis(); }
  int device() { return static_cast<int>(random_.between(0, devices_ - 1)); }
  std::int64_t distance() {
    const std::int64_t sign = random_.sign();
    return one_more_way(sign, random_.between(40, 600) * 10 * scale());
  }
  /// No two moves of a plan go the same way.
  std::int64_t one_more_way(std::int64_t sign, std::int64_t about) {
    std::int64_t way = sign * (about + ++moves_);
    while (!ways_.insert(way).second) way += sign;
    return way;
  }
  std::int64_t scale() const { return facts_.model == "vme58" ? 20 : 1; }
  std::string stop_of_all() {
    std::vector<std::string> texts;
    for (const StopText& text : facts_.stops)
      if (text.axis < 0) texts.push_back(text.text);
    return beside_.one_of(texts);
  }
  std::int64_t slot() { return random_.between(0, std::max(1, catalog_.program.slots) - 1); }

  void draw_quirk(const std::vector<std::string>& quirks) {
    const bool has_one = plan_.options.find("quirk=") != std::string::npos;
    if (!quirks.empty() && !has_one && random_.percent(25))
      plan_.options += (plan_.options.empty() ? "" : ",") + random_.one_of(quirks);
  }
  // What is so all the time, with this unit or on this wire.
  void draw_habits() {
    const auto whole = static_cast<std::int64_t>(drawing_.length.count()) + 60'000;
    if (catalog_.can.window) {
      if (random_.percent(8)) put(Millis(0), "slow_cycles", 0, {random_.mostly_small(1, 20), whole});
      return;
    }
    if (random_.percent(8)) put(Millis(0), "delay", 0, {1, random_.mostly_small(20, 2500), whole});
    if (random_.percent(8)) put(Millis(0), "gaps", 0, {1, random_.between(1, 40), whole});
    if (!facts_.newer.empty() && beside_.percent(5))
      put(Millis(0), "unknown", 0, {}, beside_.one_of(facts_.newer));
    if (facts_.prompt != 0 && random_.percent(10))
      put(Millis(0), "habit", 0, {1, facts_.prompt, random_.between(1, 6), random_.percent(50)});
  }

  void draw_action(Millis at) {
    const int on = device();
    const auto draw = random_.between(1, 100);
    if (draw <= 24) return draw_stop(at, on);
    if (draw <= 44) return draw_move(at, on);
    if (draw <= 58) return draw_jog(at, on);
    if (draw <= 62 && !catalog_.homing_modes.empty()) {
      const auto modes = static_cast<std::int64_t>(catalog_.homing_modes.size());
      return put(at, "home", on, {axis(), random_.sign(), random_.between(0, modes - 1)});
    }
    if (draw <= 74) return draw_program(at, on);
    if (draw <= 84) return draw_text(at, on);
    if (draw <= 93) return draw_setting(at, on);
    if (draw <= 95) return put(at, "wait_idle", on, {random_.between(100, 5000)});
    if (draw <= 97) {
      put(at, "close", on);
      if (beside_.percent(50)) put(at, "type_stop_closing", on, {}, stop_of_all());
      return put(at + Millis(random_.mostly_small(20, 4000)), "open", on);
    }
    draw_bench(at, on);
  }

  void draw_stop(Millis at, int on) {
    const auto draw = random_.between(1, 100);
    if (draw <= 50) return put(at, "stop", on, {axis_or_all()});
    if (draw <= 60) return put(at, "abort", on, {axis_or_all()});
    if (draw <= 70) return put(at, "stop_wire", on, {random_.percent(20)});
    const StopText& text = random_.one_of(facts_.stops);
    if (text.axis >= static_cast<int>(catalog_.axes.size())) return put(at, "stop", on, {-1});
    if (draw <= 85) return put(at, "type_stop", on, {}, text.text);
    if (draw <= 92) return put(at, "query_stop", on, {random_.between(100, 2000)}, text.text);
    put(at, "halt", on, {-1});
  }
  void draw_move(Millis at, int on) {
    const auto draw = random_.between(1, 100);
    const std::int64_t speed = random_.percent(60) ? 0 : random_.between(200, 3000) * scale();
    if (draw <= 60) return put(at, "move_by", on, {axis(), distance(), speed});
    if (draw <= 85 || catalog_.axes.size() < 2) return put(at, "move_to", on, {axis(), distance(), speed});
    put(at, "line", on, {distance(), distance()});
  }
  void draw_jog(Millis at, int on) {
    const std::int64_t held = random_.percent(30) ? random_.between(20, 250) : random_.between(250, 3000);
    const auto draw = random_.between(1, 100);
    if (draw > 95) return put(at, "script_jog", on, {axis(), random_.sign()});
    put(at, draw <= 82 ? "jog" : "jog_frozen", on, {axis(), random_.sign(), held});
  }
  void draw_program(Millis at, int on) {
    const auto draw = random_.between(1, 100);
    if (draw <= 40) {
      const std::int64_t where = slot();
      std::string text = random_.one_of(facts_.programs);
      if (tool_.percent(30)) text = tool_.one_of(facts_.tool_programs);
      if (tool_.percent(20)) draw_pieces(at + Millis(tool_.mostly_small(10, 4000)), on);
      put(at, "load", on, {where}, std::move(text));
      return put(at + Millis(random_.mostly_small(10, 4000)), "run", on, {where});
    }
    if (draw <= 60) return put(at, "run", on, {slot()});
    if (draw <= 70) return put(at, "pause", on);
    if (draw <= 80) return put(at, "resume", on);
    if (draw <= 85) return put(at, "step", on);
    if (draw <= 92) return put(at, "upload", on, {slot()});
    put(at, "clear", on, {slot()});
  }
  /// What does not fit into the memory of a PMX goes through its buffer. A long program fills the queue of a
  /// board, which then reads its ring no more.
  void draw_pieces(Millis at, int on) {
    if (plan_.options.find("deaf") != std::string::npos) return;
    const char* verb = devices_ > 1 && tool_.percent(60) ? "together" : "pieces";
    put(at, verb, on,
        {tool_.between(1, 12), tool_.percent(50) ? tool_.between(60, 120) : tool_.between(2, 20)});
    if (tool_.percent(40)) put(at + Millis(tool_.between(500, 5000)), "pause", on);
    if (tool_.percent(40)) put(at + Millis(tool_.between(3000, 8000)), "resume", on);
    if (tool_.percent(30))
      put(at + Millis(tool_.between(500, 6000)), "override_speed", on, {tool_.between(5, 210)});
  }
  /// Nothing reaches a board that neither obeys its mailbox nor reads its ring.
  std::string harmless(Random& random) {
    std::string text = random.one_of(facts_.harmless);
    const bool holds_ring = text == "WQ" && plan_.options.find("deaf") != std::string::npos;
    return holds_ring ? facts_.harmless.front() : text;
  }
  /// What is sent meanwhile waits in the ring, for a quarter of a second at most; and then a stop.
  void draw_into_held_ring(Millis at, int on) {
    const Millis moved = at + Millis(beside_.between(20, 400));
    put(moved, "move_by", on, {axis(), distance(), 0});
    put(moved + Millis(beside_.between(20, 400)), "stop", on, {-1});
  }
  void draw_text(Millis at, int on) {
    const auto draw = random_.between(1, 100);
    if (draw <= 50) {
      const std::string text = harmless(random_);
      put(at, "type", on, {}, text);
      return text == "WQ" ? draw_into_held_ring(at, on) : void();
    }
    if (draw <= 75) return put(at, "query", on, {random_.between(100, 2000)}, harmless(random_));
    std::vector<std::string> moving;
    constexpr std::string_view too_slow_to_see = "JF0.25";  // a step in four seconds looks like rest
    for (const CommandInfo& command : catalog_.commands)
      if (command.moves && command.example != too_slow_to_see) moving.push_back(command.example);
    if (!moving.empty()) put(at, "type_motion", on, {}, random_.one_of(moving));
  }
  void draw_setting(Millis at, int on) {
    const auto draw = random_.between(1, 100);
    if (draw <= 30) return put(at, "set_position", on, {axis(), random_.between(-500, 500)});
    if (draw <= 40) return put(at, "trust", on, {axis()});
    if (draw <= 60 && !facts_.speeds.empty()) {
      const std::string name = random_.one_of(facts_.speeds);
      const int place = catalog_.find_param(name);
      if (place < 0) return;
      const ParamInfo& info = catalog_.params[static_cast<std::size_t>(place)];
      return put(at, "set_param", on,
                 {std::clamp<std::int64_t>(random_.between(300, 3000), info.minimum, info.maximum)}, name);
    }
    if (draw <= 68) return put(at, "read_params", on);
    if (draw <= 74 && catalog_.can.store) return put(at, "store", on);
    if (draw <= 84 && !catalog_.outputs.empty()) return put(at, "output", on, {1, random_.percent(50)});
    if (draw <= 92) return put(at, "read_again", on);
    put(at, "reconnect", on);
  }
  // One, or two at once.
  void draw_scripts(Millis at) {
    const auto on = static_cast<int>(beside_.between(0, devices_ - 1));
    for (int scripts = beside_.percent(30) ? 2 : 1; scripts > 0; --scripts) {
      std::vector<Step> calls;
      for (auto n = beside_.between(2, 6); n > 0; --n) calls.push_back(draw_call(on));
      put(at, "script", on, {}, script_of(calls));
      at += Millis(beside_.between(0, 300));
    }
  }
  Step draw_call(int on) {
    const std::int64_t which = beside_.between(0, static_cast<std::int64_t>(catalog_.axes.size()) - 1);
    const std::int64_t sign = beside_.sign();
    const std::int64_t way = one_more_way(sign, beside_.between(10, 300) * 10 * scale());
    const auto draw = beside_.between(1, 100);
    if (draw <= 30) return call("move_by", on, {which, way, 0});
    if (draw <= 40) return call("move_to", on, {which, way, 0});
    if (draw <= 60) return call("wait_idle", on, {beside_.between(500, 8000)});
    if (draw <= 70) return call("query", on, {beside_.between(200, 2000)}, harmless(beside_));
    if (draw <= 78) return call("type", on, {}, harmless(beside_));
    if (draw <= 84 && !catalog_.outputs.empty()) return call("output", on, {1, beside_.percent(50)});
    if (draw <= 90) return call("run", on, {beside_.between(0, std::max(1, catalog_.program.slots) - 1)});
    if (draw <= 94) return call("set_position", on, {which, beside_.between(-500, 500)});
    return call("stop", on, {-1});
  }
  static Step call(std::string verb, int on, Numbers numbers, std::string text = {}) {
    return {Millis(0), std::move(verb), on, std::move(numbers), std::move(text)};
  }
  void draw_bench(Millis at, int on) {
    const std::int64_t which = axis(), side = random_.sign();
    if (beside_.percent(25)) {
      const std::int64_t stuck = beside_.between(0, static_cast<std::int64_t>(catalog_.axes.size()) - 1);
      put(at, "jam", on, {stuck, 1});
      put(at + Millis(beside_.between(200, 5000)), "jam", on, {stuck, 0});
    }
    if (random_.percent(60)) {
      put(at, "limit", on, {which, side, 1});
      return put(at + Millis(random_.between(100, 3000)), "limit", on, {which, side, 0});
    }
    put(at, "input", on, {1, random_.percent(50)});
  }

  void draw_fault(Millis at) {
    const int on = device();
    if (!facts_.others.empty() && beside_.percent(4))
      put(at, "other_host", on, {}, beside_.one_of(facts_.others));
    const auto draw = random_.between(1, 100);
    if (draw <= 6) return put(at, "power_cycle", on);
    if (draw <= 16) return put(at, "unplug", on, {random_.mostly_small(50, 6000)});
    if (catalog_.can.window) return draw_bus_fault(at, draw);
    const std::int64_t way = random_.percent(40) ? 0 : 1;
    const Numbers bytes = {way, random_.mostly_small(0, 40), random_.mostly_small(1, 12)};
    if (draw <= 32) return put(at, "garble", on, bytes);
    if (draw <= 52) return put(at, "drop", on, bytes);
    if (draw <= 60) return put(at, "twice", on, bytes);
    if (draw <= 72) return put(at, "cut", on, {way, random_.mostly_small(50, 5000)});
    if (draw <= 88)
      return put(at, "delay", on, {way, random_.mostly_small(20, 2500), random_.mostly_small(200, 5000)});
    if (draw <= 89)
      return put(at, "gaps", on, {way, random_.between(1, 40), random_.mostly_small(200, 5000)});
    if (draw <= 91) return put(at, "babble", on, {random_.mostly_small(50, 3000)});
    put(at, "merge", on, {1, random_.mostly_small(50, 1500)});
  }
  void draw_bus_fault(Millis at, std::int64_t draw) {
    if (draw <= 45) return put(at, "silent", 0, {random_.mostly_small(20, 3000)});
    if (draw <= 75)
      return put(at, "slow_cycles", 0, {random_.mostly_small(1, 200), random_.mostly_small(100, 3000)});
    put(at, "bus_error", 0, {random_.mostly_small(1, 10)});
  }

  Random random_;
  Random beside_, tool_;  ///< what was added later: the plans of a seed stay as they were beside it
  const ModelFacts& facts_;
  const Drawing& drawing_;
  Catalog catalog_;
  Plan plan_;
  int devices_ = 1;
  std::int64_t moves_ = 0;
  std::set<std::int64_t> ways_;
};

}  // namespace

Plan draw_plan(std::string_view model, std::uint64_t seed, const Drawing& drawing) {
  const ModelFacts* facts = find_model(model);
  if (facts == nullptr) throw std::runtime_error("There is no model \"" + std::string(model) + "\".");
  return Artist(*facts, seed, drawing).draw();
}

}  // namespace hw::simulation
