#include "tests/contract/lying_driver.h"

namespace hw {

void LieMemory::note(const IntentBody& asked, const Snapshot& now) {
  if (const auto* go = std::get_if<intent::MoveTo>(&asked))
    for (const AxisTarget& t : go->targets) targets[t.axis.index] = t.value;
  if (const auto* go = std::get_if<intent::MoveBy>(&asked))
    for (const AxisTarget& d : go->distances)
      targets[d.axis.index] = now.axes[d.axis.index].position + d.value;
  if (const auto* jog = std::get_if<intent::JogStart>(&asked)) targets.erase(jog->axis.index);
  if (const auto* home = std::get_if<intent::Home>(&asked)) {
    targets.erase(home->axis.index);
    homed |= 1u << home->axis.index;
  }
  if (const auto* set = std::get_if<intent::SetPosition>(&asked))
    for (int i = 0; i < now.axis_count; ++i)
      if (set->axis == i || set->axis < 0) {
        targets.erase(i);
        positions_set[i] = set->axis < 0 ? Steps(0) : set->value;
        positions_read[i] = now.axes[i].position;
      }
  if (const auto* set = std::get_if<intent::SetParam>(&asked))
    params[catalog.find_param(set->mnemonic)] = set->value;
  if (const auto* set = std::get_if<intent::SetPower>(&asked))
    for (int i = 0; i < now.axis_count; ++i)
      if (set->axis == i || set->axis < 0) power[i] = set->on;
  if (const auto* set = std::get_if<intent::SetOutput>(&asked))
    outputs[catalog.find_output(set->number)] = set->on;
  if (const auto* load = std::get_if<intent::LoadProgram>(&asked)) texts[load->slot] = load->text;
}

namespace {

class LyingDriver final : public Driver {
 public:
  LyingDriver(const DeviceType& honest, DriverContext context, const Lie& lie)
      : shown_(context.draft), lie_(lie), memory_(context), truth_(context.draft) {
    honest_ = honest.make_driver(around(std::move(context)));
  }

  Task<Result<>> connect(Station& station) override {
    take_over();
    auto done = co_await honest_->connect(station);
    deaf_ = !done && lie_.believes_anything;
    co_return paint(deaf_ ? Result<>() : std::move(done));
  }
  Task<Result<>> poll() override {
    if (deaf_) co_return Result<>();
    take_over();
    auto done = co_await honest_->poll();
    if (again_ && !truth_.any_axis_moving()) {
      const IntentBody again = *std::exchange(again_, std::nullopt);
      co_await honest_->perform(again);
    }
    co_return paint(std::move(done));
  }
  Task<Result<>> perform(const IntentBody& intent) override {
    take_over();
    memory_.note(intent, truth_);
    if (lie_.keeps_back && lie_.keeps_back(memory_, intent)) co_return paint(Result<>());
    IntentBody bent = intent;
    if (lie_.bends) lie_.bends(memory_, bent);
    auto done = co_await honest_->perform(bent);
    if (done && lie_.moves_twice && std::holds_alternative<intent::MoveBy>(bent)) again_ = std::move(bent);
    if (lie_.hides_failures) done = Result<>();
    co_return paint(std::move(done));
  }
  Task<Result<>> stop(int axis, bool at_once) override {
    return ordered(StopOrder{StopOrder::Of::motion, axis, at_once});
  }
  Task<Result<>> stop_jog(int axis) override {
    return ordered(StopOrder{StopOrder::Of::held_jog, axis, false});
  }
  Task<Result<>> halt_program(int thread) override {
    return ordered(StopOrder{StopOrder::Of::program, thread, false});
  }
  Task<Result<>> stop_wire(bool at_once) override { return honest_->stop_wire(at_once); }
  bool clears_up() const override { return honest_->clears_up(); }
  std::string leaves_behind() const override { return honest_->leaves_behind(); }
  void wire_lost() override {
    take_over();
    honest_->wire_lost();
    paint(Result<>());
  }
  Task<Result<std::string>> query(std::string text, Duration patience) override {
    auto reply = co_await honest_->query(std::move(text), patience);
    co_return replied(std::move(reply));
  }
  Task<Result<std::string>> query_stop(std::string text, Duration patience,
                                       std::function<void()> said) override {
    auto reply = co_await honest_->query_stop(std::move(text), patience, std::move(said));
    co_return replied(std::move(reply));
  }
  bool answers(std::string_view text) const override { return honest_->answers(text); }
  bool answers_later(std::string_view text) const override { return honest_->answers_later(text); }
  bool changes_programs(std::string_view text) const override { return honest_->changes_programs(text); }
  bool is_stop(std::string_view text) const override {
    return !lie_.knows_no_stop_text && honest_->is_stop(text);
  }
  bool stops_all(std::string_view text) const override {
    return !lie_.knows_no_stop_text && honest_->stops_all(text);
  }
  Addressees meant_for(const intent::SendText& text) const override { return honest_->meant_for(text); }
  bool recover_by(std::string_view text) override { return honest_->recover_by(text); }
  std::optional<std::string> take_recovery() override { return honest_->take_recovery(); }
  bool take_unsolicited(std::string& text) override { return honest_->take_unsolicited(text); }
  Duration moving_period() const override { return honest_->moving_period(); }
  Duration idle_period() const override { return honest_->idle_period(); }

 private:
  DriverContext around(DriverContext context) {
    DriverContext own{context.scheduler,
                      context.catalog,
                      truth_,
                      [this, notify = context.notify](Notice notice) {
                        if (!lie_.withholds || !lie_.withholds(notice)) notify(std::move(notice));
                      },
                      [this, changed = context.changed] {
                        paint(Result<>());
                        changed();
                      },
                      context.stop_heard,
                      context.sample};
    return own;
  }
  Task<Result<>> ordered(StopOrder order) {
    take_over();
    again_.reset();
    if (lie_.orders) lie_.orders(order);
    if (!order.is_sent) co_return paint(Result<>());
    auto done = co_await send(order);
    co_return paint(std::move(done));
  }
  Task<Result<>> send(const StopOrder& order) {
    if (order.of == StopOrder::Of::held_jog) return honest_->stop_jog(order.which);
    if (order.of == StopOrder::Of::program) return honest_->halt_program(order.which);
    return honest_->stop(order.which, order.at_once);
  }
  Result<std::string> replied(Result<std::string> reply) {
    if (reply && lie_.replies) lie_.replies(memory_, *reply);
    paint(Result<>());
    return reply;
  }
  /// What the pump writes itself is true. Trust it settles on the user's word only.
  void take_over() {
    keep_the_pumps(truth_, shown_);
    for (std::size_t i = 0; i < shown_.axes.size(); ++i)
      if (!(shown_.axes[i].trust == painted_trust_[i])) truth_.axes[i].trust = shown_.axes[i].trust;
  }
  Result<> paint(Result<> done) {
    Snapshot painted = truth_;
    keep_the_pumps(painted, shown_);
    if (lie_.paints) lie_.paints(memory_, painted);
    shown_ = painted;
    for (std::size_t i = 0; i < shown_.axes.size(); ++i) painted_trust_[i] = shown_.axes[i].trust;
    return done;
  }
  static void keep_the_pumps(Snapshot& to, const Snapshot& from) {
    to.sequence = from.sequence;
    to.at = from.at;
    to.link = from.link;
    to.poll_period = from.poll_period;
    to.store_count = from.store_count;
    to.program_changes = from.program_changes;
    to.program_changed_by = from.program_changed_by;
    to.fates = from.fates;
  }

  Snapshot& shown_;
  const Lie& lie_;
  LieMemory memory_;
  Snapshot truth_;
  std::array<PositionTrust, max_axes> painted_trust_{};
  std::unique_ptr<Driver> honest_;
  std::optional<IntentBody> again_;
  bool deaf_ = false;  ///< nobody that it understands is there
};

}  // namespace

std::unique_ptr<Driver> make_lying_driver(const DeviceType& honest, DriverContext context, const Lie& lie) {
  return std::make_unique<LyingDriver>(honest, std::move(context), lie);
}

}  // namespace hw
