// What a rehearsal says a program does is what the same emulated controller does when the program is loaded
// and run through session, link and driver: where every axis is to the step at moments on the way and at the
// end, which outputs are on, and how long it took to the millisecond.
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/device/controller_state.h"
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "tests/transports/agreement_cases.h"
#include "tests/transports/watched_run.h"
#include "transports/serve.h"

namespace hw {
namespace {

using namespace std::chrono_literals;
using test::AgreementCase;
using test::WatchedRun;

std::string text_of(const AgreementCase& c) {
  if (!c.text.starts_with('@')) return c.text;
  std::ifstream file(std::string(HW_TEST_DIR "/") + c.text.substr(1));
  EXPECT_TRUE(file.good()) << c.text;
  std::stringstream all;
  all << file.rdbuf();
  return all.str();
}

class RehearsalAgreement : public testing::TestWithParam<AgreementCase> {
 protected:
  /// `begins_on`: programs of the model begin on whole ones of these.
  void agrees(const char* model, Duration begins_on, bool answers_waits) {
    const AgreementCase& c = GetParam();
    open(std::string(model) + "@emulator" + c.keys);
    ASSERT_NE(session, nullptr);
    prepare(c);
    ASSERT_FALSE(HasFatalFailure());
    const std::string text = text_of(c);
    const Rehearsal rehearsed = rehearse(c, text);
    ASSERT_FALSE(HasFatalFailure());
    const std::vector<RehearsedPlace> places = places_of(rehearsed);
    run_live(c, text, places, begins_on, answers_waits);
    ASSERT_TRUE(watched->has_seen_all()) << (watched->began() ? "it was not looked at" : "nothing began");
    for (std::size_t n = 0; n < places.size(); ++n) {
      const WatchedRun::Look& seen = watched->looks()[n];
      for (std::size_t i = 0; i < static_cast<std::size_t>(seen.truth.axis_count); ++i)
        EXPECT_EQ(places[n].position[i], seen.truth.axes[i].position.value)
            << rehearsed.axes.at(i).name << " after " << places[n].t << " s";
      EXPECT_EQ(places[n].outputs, seen.outputs) << "after " << places[n].t << " s";
    }
    if (!rehearsed.finished) return;
    ASSERT_TRUE(watched->took()) << "it is still at work";
    EXPECT_NEAR(seconds(*watched->took()), rehearsed.duration_s, 0.001);
  }
  void TearDown() override {
    if (!session) return;
    asio::co_spawn(io, session->close(), asio::detached);
    time.run_for(2s);
  }

 private:
  void open(const std::string& name) {
    auto address = Address::parse(name);
    ASSERT_TRUE(address) << address.error().sentence();
    const DeviceType* type = find_device_type(address->model);
    auto inner = type->make_emulator(address->options);
    ASSERT_TRUE(inner) << inner.error().sentence();
    auto emulator = std::make_unique<WatchedRun>(std::move(*inner));
    watched = emulator.get();
    auto made = EmulatorHost::make(time, std::move(emulator), HostOptions());
    ASSERT_TRUE(made) << made.error().sentence();
    const auto opener = [host = *made](Scheduler&, Address,
                                       std::shared_ptr<BenchAccess>) -> Task<Result<Wire>> {
      Wire wire;
      if (host->is_board())
        wire.window = std::move(*host->plug_in_window());
      else
        wire.stream = std::move(*host->plug_in());
      wire.benches.push_back(host->bench());
      co_return wire;
    };
    session = Session::open(time, *address, opener, [] {}).value();
    ASSERT_TRUE(time.run_until(time.now() + 10s, [this] { return known().link.state == LinkState::good; }));
    time.run_for(2s);
  }
  [[nodiscard]] const Snapshot& known() const { return session->known(); }

  void must(IntentBody body) {
    const IntentId id = session->send(std::move(body));
    time.run_until(time.now() + 60s, [&] {
      const IntentOutcome* outcome = known().outcome_of(id);
      return outcome && outcome->state != IntentState::pending;
    });
    const IntentOutcome* outcome = known().outcome_of(id);
    ASSERT_TRUE(outcome) << "no outcome";
    ASSERT_EQ(outcome->state, IntentState::done) << outcome->sentence.view();
  }
  void prepare(const AgreementCase& c) {
    for (const IntentBody& body : c.before) {
      must(body);
      ASSERT_FALSE(HasFatalFailure());
      do {  // what is not done together comes one after the other
        ASSERT_TRUE(time.run_until(time.now() + 60s, [this] { return !known().any_axis_moving(); }));
        time.run_for(1s);
      } while (known().any_axis_moving());
    }
    for (const auto& [slot, text] : c.programs) must(intent::LoadProgram(slot, text));
    const auto stands = parse_bench_file(c.stands, session->catalog());
    ASSERT_TRUE(stands) << stands.error().sentence();
    for (const auto* hands : {&c.bench_before, &stands->at_start})
      for (const BenchCommand& hand : *hands) ASSERT_TRUE(session->bench()->operate(hand));
    must(intent::ReadParams());
    time.run_for(2s);
  }

  Rehearsal rehearse(const AgreementCase& c, const std::string& text) {
    BenchView bench;
    session->bench()->look(bench);
    auto state = std::make_shared<ControllerState>();
    state->now = known();
    for (const auto& [slot, held] : c.programs) state->programs[slot] = held;
    RehearseOptions options = rehearse_from(std::move(state), bench, session->catalog());
    options.slot = c.slot;
    options.for_seconds = c.seconds;
    options.bench_toml = c.bench;
    options.track_every_s = 0.05;
    auto done = session->type().language().rehearse(text, options);
    EXPECT_TRUE(done) << done.error().sentence();
    return done ? std::move(*done) : Rehearsal();
  }

  /// Some of them, one after the other through all of the run, and how it ends.
  static std::vector<RehearsedPlace> places_of(const Rehearsal& rehearsed) {
    constexpr std::size_t moments = 12;
    std::vector<RehearsedPlace> all;
    for (std::size_t n = 1; n <= moments; ++n) {
      const RehearsedPlace& place = rehearsed.track[(rehearsed.track.size() - 1) * n / (moments + 1)];
      if (place.t > (all.empty() ? 0 : all.back().t) && place.t < rehearsed.duration_s) all.push_back(place);
    }
    RehearsedPlace end;
    end.t = rehearsed.duration_s, end.outputs = rehearsed.track.back().outputs;
    for (std::size_t i = 0; i < rehearsed.axes.size(); ++i) end.position[i] = rehearsed.axes[i].position;
    all.push_back(end);
    return all;
  }

  void run_live(const AgreementCase& c, const std::string& text, const std::vector<RehearsedPlace>& places,
                Duration begins_on, bool answers_waits) {
    const auto hands = parse_bench_file(c.bench, session->catalog());
    ASSERT_TRUE(hands) << hands.error().sentence();
    const bool threads = session->catalog().program.threads > 0;
    must(intent::LoadProgram(threads ? 0 : c.slot, text));
    ASSERT_FALSE(HasFatalFailure());
    std::vector<Duration> moments;
    for (const RehearsedPlace& place : places) moments.push_back(from_seconds(place.t));
    watched->arm(*hands, std::move(moments), begins_on, answers_waits);
    const IntentId id = session->send(intent::RunProgram(c.slot));
    time.run_until(time.now() + from_seconds(places.back().t) + 5s,
                   [this] { return watched->has_seen_all(); });
    const IntentOutcome* outcome = known().outcome_of(id);
    EXPECT_TRUE(!outcome || outcome->state != IntentState::refused) << outcome->sentence.view();
    time.run_for(1s);
  }

  IoContext io;
  VirtualScheduler time{io};
  WatchedRun* watched = nullptr;  ///< of the session's wire
  std::shared_ptr<Session> session;
};

std::string name_of_case(const testing::TestParamInfo<AgreementCase>& info) { return info.param.name; }

class VxmAgreement : public RehearsalAgreement {};
TEST_P(VxmAgreement, OfARehearsalAndARun) { agrees("vxm", {}, true); }
INSTANTIATE_TEST_SUITE_P(Manual, VxmAgreement, testing::ValuesIn(test::vxm_cases()), name_of_case);

class PmxAgreement : public RehearsalAgreement {};
TEST_P(PmxAgreement, OfARehearsalAndARun) { agrees("pmx-4ex-sa", 1ms, false); }
INSTANTIATE_TEST_SUITE_P(Manual, PmxAgreement, testing::ValuesIn(test::pmx_cases()), name_of_case);

class DmxAgreement : public RehearsalAgreement {};
TEST_P(DmxAgreement, OfARehearsalAndARun) { agrees("dmx-k-sa", 1ms, false); }
INSTANTIATE_TEST_SUITE_P(Manual, DmxAgreement, testing::ValuesIn(test::dmx_cases()), name_of_case);

class Vme58Agreement : public RehearsalAgreement {};
TEST_P(Vme58Agreement, OfARehearsalAndARun) { agrees("vme58", {}, false); }
INSTANTIATE_TEST_SUITE_P(Manual, Vme58Agreement, testing::ValuesIn(test::vme58_cases()), name_of_case);

}  // namespace
}  // namespace hw
