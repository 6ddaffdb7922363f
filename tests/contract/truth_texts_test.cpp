// The maker's own text: questions and their replies, stops, the examples that are shown, and devices that
// are none of this kind.
#include <cctype>
#include <set>

#include "core/device/command_form.h"
#include "tests/contract/nobody.h"
#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

// ---- forms

std::vector<std::string> examples_that_do_not_fit(const Catalog& c) {
  std::vector<std::string> all;
  for (const CommandInfo& command : c.commands)
    if (command.example.empty() ||
        CommandForm(command, c.axes).match(command.example) != CommandForm::Match::whole)
      all.push_back(command.form + ": " + command.example);
  return all;
}

TEST_P(TruthTest, ExamplesFitTheirForms) {
  Catalog c = session->catalog();
  EXPECT_THAT(examples_that_do_not_fit(c), testing::IsEmpty());
  const std::size_t commands = c.commands.size();
  for (std::size_t i = 0; i < commands; ++i) c.commands[i].example = c.commands[(i + 1) % commands].example;
  EXPECT_GT(examples_that_do_not_fit(c).size(), commands / 2) << "what stands in the next row does not";
}

// ---- questions

class TextTest : public TruthTest {
 protected:
  Result<std::string> ask(std::string text) {
    std::optional<Result<std::string>> reply;
    asio::co_spawn(io, ask_into(std::move(text), reply), asio::detached);
    run_until([&] { return reply.has_value(); }, seconds(20));
    EXPECT_TRUE(reply.has_value());
    return reply ? *reply : Result<std::string>();
  }
  /// What has come in since the last call that was no poll's.
  std::string received() {
    std::string all;
    session->traffic().drain([&](const TrafficEntry& e) {
      if (e.way == Way::received && e.kind != TrafficKind::poll) all += e.bytes;
    });
    return all;
  }
  /// Commands that ask and do nothing else, as far as their form shows.
  std::vector<std::string> questions() {
    std::vector<std::string> all;
    for (const CommandInfo& command : session->catalog().commands)
      if (!command.moves && !command.stored && command.example.find('=') == std::string::npos &&
          session->pump().meaning_of(command.example).answered == TextMeaning::Answered::at_once &&
          !session->pump().meaning_of(command.example).is_stop())
        all.push_back(command.example);
    return all;
  }

 private:
  Task<> ask_into(std::string text, std::optional<Result<std::string>>& reply) {
    auto got = co_await session->pump().query(std::move(text), seconds(2));
    reply = std::move(got);
  }
};
INSTANTIATE_TEST_SUITE_P(Every, TextTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(TextTest, AReplyIsWhatCameOnTheWireForThisQuestion) {
  std::set<std::string> replies;
  for (const std::string& question : questions()) {
    received();
    const auto reply = ask(question);
    if (!reply) continue;  // no answer to the example, as it stands
    const std::string came = received();
    EXPECT_FALSE(reply->empty() &&
                 std::any_of(came.begin(), came.end(), [](unsigned char c) { return std::isgraph(c); }))
        << question << ": " << testing::PrintToString(came);
    EXPECT_THAT(came, testing::HasSubstr(*reply)) << question;
    replies.insert(*reply);
  }
  EXPECT_GE(replies.size(), 4u) << "else the reply to another question would look the same";
}

// ---- stops

TEST_P(TextTest, AStopInTheMakersWordsGoesBeforeWhatWaits) {
  const std::vector<CommandInfo> commands = session->catalog().commands;
  std::vector<std::string> stops;  // of the first axis, as the machine takes them
  for (const CommandInfo& command : commands) {
    if (command.moves || command.stored || command.help.find("stop") == std::string::npos) continue;
    reopen();
    must(intent::MoveBy({{id(0), Steps(40000)}}, Pps(2000)));
    run(Millis(500));
    session->send(intent::SendText(command.example));
    run(seconds(5));
    const Steps there = load();
    run(seconds(1));
    if (load() == there) stops.push_back(command.example);
  }
  EXPECT_FALSE(stops.empty());
  for (const std::string& stop : stops) {
    reopen();
    const IntentId move = session->send(intent::MoveBy({{id(0), Steps(400)}}));
    session->send(intent::SendText(stop));
    run(seconds(5));
    ASSERT_TRUE(now().outcome_of(move)) << stop;
    EXPECT_EQ(now().outcome_of(move)->state, IntentState::refused) << stop;
    EXPECT_EQ(load(), Steps(0)) << stop;
  }
}

// ---- devices of another kind

class ForeignTest : public TruthTest {
 protected:
  void expect_disbelieved(Session& session, const std::string& what) {
    run(seconds(15));
    EXPECT_FALSE(session.known().link.connected()) << what;
    EXPECT_FALSE(session.known().link.sentence.empty()) << what;
    EXPECT_FALSE(session.known().axes[0].position_known) << what;
    asio::co_spawn(io, session.close(), asio::detached);
    run(seconds(2));
  }
};
INSTANTIATE_TEST_SUITE_P(Every, ForeignTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(ForeignTest, AForeignDeviceIsNotTakenForThisOne) {
  for (const DeviceType* other : types_under_test()) {
    if (other->model == GetParam()->model) continue;
    const auto catalog = other->make_catalog({});
    ASSERT_TRUE(catalog);
    if (catalog->can.window != session->catalog().can.window) continue;  // no plug fits
    const WireOpener usual = make_wire_opener();
    const WireOpener foreign = [usual, other](Scheduler& s, Address a, std::shared_ptr<BenchAccess> again) {
      a.model = other->model;
      return usual(s, std::move(a), std::move(again));
    };
    const auto opened = open_by(foreign);
    expect_disbelieved(*opened, std::string(other->model));
  }
}

TEST_P(ForeignTest, ADeviceThatAnswersRubbishIsNotTakenForAController) {
  const bool window = session->catalog().can.window;
  for (const Habit habit : {Habit::echo, Habit::ones, Habit::noise}) {
    const WireOpener rubbish = [=](Scheduler& s, Address,
                                   std::shared_ptr<BenchAccess>) -> Task<Result<Wire>> {
      co_return wire_to_nobody(s, habit, window);
    };
    const auto opened = open_by(rubbish);
    expect_disbelieved(*opened, fmt::format("habit {}", static_cast<int>(habit)));
  }
}

}  // namespace
}  // namespace hw
