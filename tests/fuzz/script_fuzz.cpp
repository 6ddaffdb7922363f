// A script made of calls with arguments as the fuzzer likes, against an emulated controller in virtual time;
// and any bytes as a script. Whatever comes, the run ends, with or without a sentence.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/script/runner.h"
#include "transports/open.h"

namespace {

using namespace hw;

constexpr const char* calls[] = {
    "c:send",       "c:query",       "c:read",     "c:move_to",  "c:move_by", "c:jog",      "c:home",
    "c:stop",       "c:abort",       "c:wait",     "c:position", "c:encoder", "c:velocity", "c:status",
    "c:input",      "c:output",      "c:analog",   "c:get",      "c:set",     "c:load",     "c:run",
    "c:pause",      "c:resume",      "c:halt",     "c:program",  "b:input",   "b:limit",    "b:home",
    "b:analog",     "b:button",      "b:jam",      "b:slip",     "b:unplug",  "b:garble",   "b:drop",
    "b:power",      "b:power_cycle", "b:place",    "b:pulses",   "b:look",    "b:at",       "hw.sleep",
    "hw.log",       "hw.open",       "hw.now",     "load",       "require",   "pairs",      "string.rep",
    "setmetatable", "select",        "c.position",
};
constexpr const char* values[] = {
    "1",
    "2",
    "0",
    "-1",
    "9",
    "1.5",
    "400",
    "-400",
    "8388607",
    "99999999",
    "1e18",
    "-1e18",
    "0/0",
    "1/0",
    "nil",
    "true",
    "false",
    "'+'",
    "'-'",
    "'limit'",
    "'1'",
    "'X'",
    "'V'",
    "'I1M400,R'",
    "'K'",
    "'lst'",
    "'M1M'",
    "'DM'",
    "'Run'",
    "{}",
    "{[1]=400}",
    "{[1]=-50,[2]=50}",
    "{[9]=1}",
    "{minus=-100,plus=100}",
    "{home={1,2}}",
    "{home=5}",
    "{counts_per_step=0/0}",
    "0.01",
    "0.5",
    "3",
    "function() b:jam(1) end",
    "function() hw.sleep(1) end",
    "c",
    "b",
    "'vxm@emulator'",
    "'LM0\\nI1M5\\nL0'",
    "print",
};

std::string script_of(const std::uint8_t* data, std::size_t size) {
  std::string text = "local c = hw.open('vxm@emulator') local b = c.bench\n";
  std::size_t i = 0;
  const auto next = [&] { return i < size ? data[i++] : std::uint8_t{0}; };
  while (i < size && text.size() < 4000) {
    const std::uint8_t call = next();
    text += std::string("pcall(function() ") + (call & 0x80 ? "" : "local x = ") +
            calls[(call & 0x7f) % std::size(calls)] + "(";
    for (int n = next() % 4; n > 0; --n) {
      text += values[next() % std::size(values)];
      if (n > 1) text += ", ";
    }
    text += ") end)\n";
  }
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  IoContext io{1};
  HybridScheduler scheduler(io, false);
  script::RunOptions options;
  options.path = "fuzz.lua";
  options.opener = make_wire_opener();
  options.print = [](std::string_view) { return hw::Result<>(); };
  options.log = [](std::string_view) {};
  options.limits.memory_bytes = 16 << 20;
  options.limits.instructions = 500'000;
  script::Runner runner(scheduler, std::move(options));
  const bool raw = data[0] & 1;
  const std::string text =
      raw ? std::string(reinterpret_cast<const char*>(data + 1), size - 1) : script_of(data + 1, size - 1);
  (void)runner.run(text);
  return 0;
}
