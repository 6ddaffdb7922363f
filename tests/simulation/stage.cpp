#include "tests/simulation/stage.h"

#include <stdexcept>
#include <utility>

#include "core/device/language.h"
#include "core/device/piece_sync.h"
#include "core/device/pieces.h"
#include "core/device/pieces_together.h"
#include "core/device/registry.h"
#include "tests/simulation/faulty_stream.h"
#include "tests/simulation/faulty_window.h"
#include "tests/simulation/steps.h"
#include "tests/simulation/watched_emulator.h"
#include "transports/memory.h"

namespace hw::simulation {
namespace {

constexpr Duration frame_period = Millis(100);  // of a slow screen; the dead-man waits for 250 ms
constexpr Duration last_stop = std::chrono::seconds(20), last_close = std::chrono::seconds(20);

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().sentence());
  return std::move(*result);
}

const ModelFacts& facts_of(const std::string& model) {
  const ModelFacts* facts = find_model(model);
  if (facts == nullptr) throw std::runtime_error("There is no model \"" + model + "\".");
  return *facts;
}

}  // namespace

// A hand on a jog button. The panel says with each frame that it is still there; a stop of this axis takes
// the hand's jog away, as the panel does.
struct Stage::Hand {
  Hand(Stage& s, int d, AxisId a, IntentId i, Instant t, LetGo h)
      : stage(s), device(d), axis(a), id(i), until(t), how(h), timer(s.time_, [this] { frame(); }) {}
  Stage& stage;
  int device;
  AxisId axis;
  IntentId id;  ///< of its jog
  Instant until;
  LetGo how;
  Timer timer;
  bool holds = true, thaws = false;

  void frame() {
    if (!holds) return;
    if (stage.now() >= until) return let_go();
    stage.send(device, intent::JogKeepAlive());
    timer.arm(std::min(until, stage.now() + frame_period));
  }
  void let_go() {
    if (!std::exchange(holds, false)) return;
    const bool frozen = how == LetGo::never;
    stage.judge_.jog_let_go(device, axis, id, frozen ? Pump::dead_man : Duration{});
    if (!frozen) stage.send(device, intent::JogStop());
    thaws = frozen;
  }
  /// The hand is needed elsewhere: a screen that had been frozen has thawed, and says first that it let go.
  void move_on() {
    how = LetGo::by_hand;
    let_go();
    if (std::exchange(thaws, false)) stage.send(device, intent::JogStop());
  }
};

Stage::Stage(const Plan& plan)
    : plan_(plan),
      facts_(facts_of(plan.model)),
      address_(must(Address::parse(plan.address()))),
      judge_(time_, faults_, facts_, facts_.wire.empty() && plan.options.find("deaf") == std::string::npos) {
  make_machines();
  open();
}

// The sessions end before what they are made of.
Stage::~Stage() {
  bench_schedule_.clear();
  group_.reset();
  closing_.clear();
  io_.restart();
}

void Stage::make_machines() {
  const DeviceType* type = find_device_type(address_.model);
  HostOptions options;
  options.byte_times = !facts_.wire.empty();
  options.name = "emulated " + address_.model;
  std::vector<HostedDevice> devices;
  for (const Address& one : address_.devices()) {
    auto inner = must(type->make_emulator(one.options));
    HostedDevice device;
    device.id = one.options.contains("id") ? one.options.at("id") : "";
    const int place = static_cast<int>(devices.size());
    device.emulator = std::make_unique<WatchedEmulator>(std::move(inner), place, judge_);
    Machine machine{device.emulator.get(), facts_.questions, {}};
    for (std::string& question : machine.questions)
      if (const auto id = question.find("{}"); id != question.npos) question.replace(id, 2, device.id);
    machines_.push_back(std::move(machine));
    devices.push_back(std::move(device));
  }
  host_ = must(EmulatorHost::make(time_, std::move(devices), options));
  for (std::size_t i = 0; i < machines_.size(); ++i) {
    machines_[i].settings = words_of(plan_);
    for (const std::string& answer : settings(i)) machines_[i].settings.merge(words_of(answer));
  }
}

std::vector<std::string> Stage::settings(std::size_t machine) const {
  const Machine& m = machines_[machine];
  return settings_of(*m.emulator, time_.now(), m.questions);
}

// A wire that carries nothing cannot take away what is left; a controller at work answers nothing, and one
// that a later session is still taking its leave of would hear the question in the middle of a text.
bool Stage::may_judge_what_is_left(Instant closed_at) const {
  constexpr Duration cleared_up = std::chrono::seconds(5);
  const Instant hurt = std::max(faults_.carries_since(now()), faults_.in.hurt());
  return !group_ && closing_now_ == 0 && !host_->is_board() && hurt + cleared_up < closed_at;
}

void Stage::judge_what_is_left(std::size_t machine) {
  const Machine& m = machines_[machine];
  MachineTruth truth;
  m.emulator->report_truth(truth);
  if (m.reported || !truth.powered || truth.program || truth.moving() != 0) return;
  const std::vector<std::string> answers = settings(machine);
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (const std::string& word : words_of(answers[i]))
      if (!m.settings.contains(word) && !is_typed_in_part(plan_, word))
        judge_.left_behind(static_cast<int>(machine), m.questions[i], word);
}

WireOpener Stage::opener() {
  return [this](Scheduler& scheduler, Address, std::shared_ptr<BenchAccess>) -> Task<Result<Wire>> {
    Wire wire;
    if (host_->is_board()) {
      auto window = host_->plug_in_window();
      if (!window) co_return fail(window.error());
      wire.window = make_faulty_window(scheduler, std::move(*window), faults_);
    } else {
      auto stream = host_->plug_in();
      if (!stream) co_return fail(stream.error());
      wire.stream = make_faulty_stream(scheduler, std::move(*stream), faults_);
    }
    for (std::size_t i = 0; i < host_->device_count(); ++i) wire.benches.push_back(host_->bench(i));
    co_return wire;
  };
}

Session* Stage::session(int device) const {
  if (!group_ || device >= static_cast<int>(group_->members().size())) return nullptr;
  return group_->members()[static_cast<std::size_t>(device)].get();
}

// A port is opened exclusively: not while a tab that closes has something to take away there.
void Stage::open() {
  opens_later_ = closing_now_ > 0;
  if (group_ || opens_later_) return;
  group_ = must(SessionGroup::open(time_, address_, opener(), [] {}));
  std::vector<std::shared_ptr<Session>> sessions = group_->members();
  judge_.opened(std::move(sessions));
}

void Stage::close() {
  opens_later_ = false;
  if (!group_) return;
  for (const auto& hand : bench_schedule_) hand->holds = false;
  judge_.closing();
  const auto call = judge_.call_begun("close", Judge::longest_close);
  for (std::size_t i = 0; i < group_->members().size(); ++i)
    group_->members()[i]->notices().drain([&](const Notice& n) {
      if (n.kind == Notice::Kind::warning || n.kind == Notice::Kind::error)
        judge_.reported(static_cast<int>(i), n.text);
    });
  ++closing_now_;
  asio::co_spawn(io_, close_and_look(group_, call), asio::detached);
  closing_.push_back(std::move(group_));
  group_.reset();
}

Task<> Stage::close_and_look(std::shared_ptr<SessionGroup> group, int call) {
  const Instant closed_at = now();
  bool connected = true;
  for (const auto& member : group->members()) connected = connected && member->known().link.connected();
  co_await group->close();
  judge_.call_ended(call);
  Event never(time_);
  constexpr Duration opening_takes = Millis(50);  // the last answer comes in meanwhile
  co_await never.wait_until(now() + opening_takes);
  if (--closing_now_ == 0 && opens_later_) open();
  for (std::size_t i = 0; i < machines_.size(); ++i)
    group->members()[i]->notices().drain([&](const Notice&) { machines_[i].reported = true; });
  if (!connected) co_return;
  constexpr Duration arrives = std::chrono::seconds(1);
  co_await never.wait_until(now() + arrives);  // what is on the wire
  if (!may_judge_what_is_left(closed_at)) co_return;
  for (std::size_t i = 0; i < machines_.size(); ++i) judge_what_is_left(i);
}

void Stage::send(int device, IntentBody body) {
  sent_ = 0;
  Session* s = session(device);
  if (s == nullptr) return;
  const bool keep_alive = std::holds_alternative<intent::JogKeepAlive>(body);
  const IntentId id = s->send(std::move(body));
  if (keep_alive) return;
  judge_.intent_sent(device, id);
  sent_ = id;
}

void Stage::type(int device, std::string text) {
  Session* s = session(device);
  if (s == nullptr) return;
  sent_ = s->send(intent::SendText(text));
  judge_.text_typed(device, sent_, std::move(text));
}

IntentId Stage::move(int device, std::uint32_t axes, Steps distance, IntentBody body) {
  Session* s = session(device);
  if (s == nullptr) return 0;
  const bool homes =
      std::holds_alternative<intent::Home>(body) || std::holds_alternative<intent::SendText>(body);
  const IntentId id = s->send(std::move(body));
  judge_.intent_sent(device, id);
  judge_.motion_asked(device, axes, id, distance, homes);
  return sent_ = id;
}

/// Ways of 100 steps of the first axis, half as far of the next, and as many lines of 20 with the tool on.
static sequence::Sequence chains(const std::vector<std::string>& axes, int output, int ways, int lines) {
  namespace seq = sequence;
  seq::Sequence drawing;
  for (const std::string& name : axes) drawing.axes.push_back({name, 1});
  drawing.pen_up = {{seq::Output{output, false}}};
  drawing.pen_down = {{seq::Output{output, true}}};
  drawing.steps = {{seq::Pen{false}}, {seq::Speed{{3000, 0, 100}}}};
  double at = 0;
  const auto go_on = [&](double by) {
    seq::Move move;
    at += by;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) move.to[axis] = at / static_cast<double>(1 + axis);
    drawing.steps.push_back({move});
    drawing.steps.push_back({seq::WaitMotion{}});
  };
  for (int way = 0; way < ways; ++way) {
    go_on(100);
    drawing.steps.push_back({seq::Pen{true}});
    for (int line = 0; line < lines; ++line) go_on(20);
    drawing.steps.push_back({seq::Pen{false}});
  }
  return drawing;
}

void Stage::run_in_pieces(int device, int ways, int lines) {
  Session* s = session(device);
  if (s == nullptr) return;
  const int output = s->catalog().output_number(static_cast<std::size_t>(facts_.tool_output));
  const sequence::Sequence drawing = chains({s->catalog().axes[0].name}, output, ways, lines);
  auto pieces = s->type().language().in_pieces(drawing, s->catalog());
  if (!pieces) return;
  Words& settings = machines_[static_cast<std::size_t>(device)].settings;
  for (const Piece& piece : pieces->all)
    for (const PieceAct& act : piece.does)
      if (const auto* load = act.what ? std::get_if<intent::LoadProgram>(&*act.what) : nullptr)
        settings.merge(words_of(load->text));
  for (const Step& step : plan_.steps) {
    if (step.verb != "override_speed" || step.device != device || !pieces->text_at) continue;
    for (const Piece& piece : pieces->all)
      if (const auto text = pieces->text_at(piece, static_cast<int>(step.number(0))))
        settings.merge(words_of(*text));
  }
  move(device, Judge::all_axes, Steps(),
       intent::RunInPieces(std::make_shared<const Pieces>(std::move(*pieces))));
}

void Stage::run_together(int ways, int lines) {
  constexpr std::size_t drawers = 2;
  if (!group_ || machines_.size() < drawers) return;
  const Catalog& first = session(0)->catalog();
  const std::vector<const Catalog*> catalogs{&first, &session(1)->catalog()};
  const auto bus = catalog_together(catalogs);
  const int output = first.output_number(static_cast<std::size_t>(facts_.tool_output));
  const auto drawing = chains({bus->axes[0].name, bus->axes[1].name}, output, ways, lines);
  std::vector<Pieces> parts = must(pieces_together(drawing, *bus, 0));
  auto seats = PieceSync::seats(drawers);
  judge_.draws_with_tool(0);
  for (std::size_t i = 0; i < drawers; ++i) {
    for (const Piece& piece : parts[i].all)
      for (const PieceAct& act : piece.does)
        if (const auto* set = act.what ? std::get_if<intent::SetParam>(&*act.what) : nullptr)
          machines_[i].settings.merge(words_of(std::to_string(set->value)));
    move(static_cast<int>(i), Judge::all_axes, Steps(),
         intent::RunInPieces(std::make_shared<const Pieces>(std::move(parts[i])), std::move(seats[i])));
  }
}

void Stage::stop(int device, std::uint32_t axes, StopKind kind, IntentBody body) {
  if (session(device) == nullptr) return;
  for (const auto& hand : bench_schedule_)
    if (hand->device == device && (axes >> hand->axis.index & 1u) != 0) hand->holds = false;
  judge_.stop_asked(device, axes, kind);
  judge_.stop_sent(device, sent_ = session(device)->send(std::move(body)));
}

void Stage::stop_all_devices(bool at_once) {
  if (!group_) return;
  for (const auto& hand : bench_schedule_) hand->holds = false;
  for (int device = 0; device < static_cast<int>(group_->members().size()); ++device)
    judge_.stop_asked(device, Judge::all_axes, at_once ? StopKind::at_once : StopKind::ramp);
  const std::vector<IntentId> ids = group_->stop(at_once);
  for (std::size_t device = 0; device < ids.size(); ++device)
    judge_.stop_sent(static_cast<int>(device), ids[device]);
}

void Stage::jog(int device, AxisId axis, Sign sign, Duration held, LetGo how) {
  if (session(device) == nullptr) return;
  for (const auto& hand : bench_schedule_) hand->move_on();  // there is one
  const IntentId id = move(device, 1u << axis.index, Steps(), intent::JogStart(axis, sign));
  std::erase_if(bench_schedule_, [](const auto& hand) { return !hand->holds; });
  bench_schedule_.push_back(std::make_unique<Hand>(*this, device, axis, id, now() + held, how));
  bench_schedule_.back()->timer.arm(now() + std::min(held, frame_period));
}

void Stage::stop_closing(int device, std::string text) {
  if (closing_.empty() || device >= static_cast<int>(closing_.back()->members().size())) return;
  Session& leaving = *closing_.back()->members()[static_cast<std::size_t>(device)];
  const LinkHealth& link = leaving.snapshot().link;
  if (link.state == LinkState::closed) return;
  if (link.connected()) judge_.stop_asked_closing(device);  // else it is told that it does not arrive
  leaving.send(intent::SendText(std::move(text)));
}

void Stage::query_stop(int device, std::uint32_t axes, std::string text, Duration patience) {
  if (session(device) == nullptr) return;
  judge_.stop_asked(device, axes, StopKind::typed);
  query(device, std::move(text), patience);
}

void Stage::query(int device, std::string text, Duration patience) {
  if (Session* s = session(device))
    asio::co_spawn(io_, answers(s->shared_from_this(), std::move(text), patience), asio::detached);
}

Task<bool> Stage::answers(std::shared_ptr<Session> session, std::string text, Duration patience) {
  const int call = judge_.call_begun("query", patience + Judge::longest_outcome);
  const std::string question = text;
  const auto answer = co_await session->pump().query(std::move(text), patience);
  if (answer) judge_.answered(question, *answer);
  judge_.call_ended(call);
  co_return answer.has_value();
}

void Stage::wait_until_idle(int device, Duration patience) {
  if (Session* s = session(device))
    asio::co_spawn(io_, is_idle(s->shared_from_this(), device, patience), asio::detached);
}

Task<bool> Stage::is_idle(std::shared_ptr<Session> session, int device, Duration patience) {
  const int call = judge_.call_begun("wait", patience + Judge::longest_outcome);
  const Instant begun = now();
  const auto idle = co_await session->wait_until_idle(patience);
  if (idle) judge_.reported_idle(device, begun);
  judge_.call_ended(call);
  co_return idle.has_value();
}

void Stage::script(int device, std::string_view calls) {
  Session* s = session(device);
  if (s != nullptr) asio::co_spawn(io_, play(s->shared_from_this(), must(calls_of(calls))), asio::detached);
}

Task<> Stage::play(std::shared_ptr<Session> session, std::vector<Step> calls) {
  for (Step& call : calls) {
    if (this->session(call.device) != session.get()) co_return;  // its tab is closed
    judge_.remark("script: " + call.written());
    if (!co_await returns(session, std::move(call))) co_return;
  }
}

Task<bool> Stage::returns(std::shared_ptr<Session> session, Step call) {
  const auto patience = [&call] { return Millis(call.number(0)); };
  if (call.verb == "wait_idle") co_return co_await is_idle(session, call.device, patience());
  if (call.verb == "query") co_return co_await answers(session, std::move(call.text), patience());
  sent_ = 0;
  find_verb(call.verb)->perform(*this, call);
  if (sent_ == 0) co_return true;
  const auto done = co_await session->outcome(sent_);
  co_return done.has_value();
}

void Stage::wait_in_vain(int device, Duration patience) {
  Session* s = session(device);
  if (s == nullptr) return;
  auto ask = [](std::shared_ptr<Session> session, Duration wait, Judge& judge) -> Task<> {
    const auto idle = co_await session->wait_until_idle(wait);
    if (idle) judge.call_went_wrong("A wait has said that all is well, and it was not.");
  };
  asio::co_spawn(io_, ask(s->shared_from_this(), patience, judge_), asio::detached);
}

void Stage::must_connect(int device) {
  Session* s = session(device);
  if (s == nullptr) return;
  auto ask = [](std::shared_ptr<Session> session, Judge& judge) -> Task<> {
    const auto connected = co_await session->wait_until_connected();
    if (!connected) judge.call_went_wrong("Opening has failed: " + connected.error().sentence());
  };
  asio::co_spawn(io_, ask(s->shared_from_this(), judge_), asio::detached);
}

void Stage::operate(int device, BenchCommand command) {
  if (device < static_cast<int>(host_->device_count()))
    (void)host_->bench(static_cast<std::size_t>(device))->operate(command);
}

void Stage::other_host_sends(std::string_view bytes) {
  if (host_->is_board()) return;
  if (!other_host_) {
    auto [ours, theirs] = make_memory_pair(time_);
    host_->attach(std::move(theirs));
    other_host_ = std::move(ours);
  }
  other_host_->send(bytes);
}

void Stage::cut_power(int device) {
  constexpr Duration fast_hand = Millis(300);
  operate(device, bench::Power(false));
  power_.push_back(std::make_unique<Timer>(time_, [this, device] { operate(device, bench::Power(true)); }));
  power_.back()->arm(now() + fast_hand);
}

void Stage::unplug(Duration how_long) {
  const Instant again = now() + how_long;
  faults_.unplugged_until = std::max(faults_.unplugged_until, again);
  operate(0, bench::Unplug(true));
  if (!plug_in_) plug_in_ = std::make_unique<Timer>(time_, [this] { operate(0, bench::Unplug(false)); });
  plug_in_->arm(faults_.unplugged_until);
}

void Stage::run() {
  const auto failed = [this] { return judge_.finding().has_value(); };
  for (const Step& step : plan_.steps) {
    if (time_.run_until(Instant(step.at), failed)) return;
    judge_.remark(step.written());
    find_verb(step.verb)->perform(*this, step);
  }
  if (time_.run_until(Instant(plan_.length), failed)) return;
  finish();
}

// Whatever came before: a stop, a while, and everything must be closed and answered.
void Stage::finish() {
  const auto failed = [this] { return judge_.finding().has_value(); };
  judge_.remark("the end: all is stopped, then closed");
  stop_all_devices(false);
  if (time_.run_until(now() + last_stop, failed)) return;
  close();
  if (time_.run_until(now() + last_close, failed)) return;
  judge_.ended();
}

}  // namespace hw::simulation
