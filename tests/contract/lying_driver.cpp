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
      : shown_(context.snapshot), lie_(lie), memory_(context), truth_(context.snapshot) {
    honest_ = honest.make_driver(around(std::move(context)));
  }

  void attach(Station& station) override { honest_->attach(station); }
  Task<Result<>> connect() override {
    take_over();
    auto done = co_await honest_->connect();
    deaf_ = !done && lie_.believes_anything;
    co_return paint(deaf_ ? Result<>() : std::move(done));
  }
  Task<Result<>> poll(Round round) override {
    if (deaf_) co_return Result<>();
    take_over();
    auto done = co_await honest_->poll(round);
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
  Task<Result<std::string>> stop(const StopOrder& order) override {
    take_over();
    again_.reset();
    const BentStop bent = bend(order);
    Result<std::string> done{std::string()};
    if (bent.is_sent) done = co_await honest_->stop(bent.order);
    co_return replied(std::move(done));
  }
  [[nodiscard]] LastWill last_will(unsigned axes) const override { return honest_->last_will(axes); }
  StopProgress stop_progress(const StopOrder& order) override {
    const BentStop bent = bend(order);
    if (!bent.is_sent) return StopProgress::stands();
    take_over();
    StopProgress progress = honest_->stop_progress(bent.order);
    paint(Result<>());
    return progress;
  }
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
  TextMeaning meaning_of(const intent::SendText& text) const override {
    TextMeaning meaning = honest_->meaning_of(text);
    if (lie_.knows_no_stop_text) meaning.stops = TextMeaning::Stops::nothing;
    return meaning;
  }
  void note_broadcast(const std::string& text) override { honest_->note_broadcast(text); }
  Duration moving_period() const override { return honest_->moving_period(); }
  Duration idle_period() const override { return honest_->idle_period(); }

 private:
  DriverContext around(DriverContext context) {
    DriverContext own{context.scheduler,
                      context.catalog,
                      truth_,
                      context.texts,
                      [this, notify = context.notify](Notice notice) {
                        if (!lie_.withholds || !lie_.withholds(notice)) notify(std::move(notice));
                      },
                      [this, changed = context.changed] {
                        paint(Result<>());
                        changed();
                      },
                      context.sample};
    return own;
  }
  [[nodiscard]] BentStop bend(const StopOrder& order) const {
    BentStop bent{order};
    if (lie_.orders) lie_.orders(bent);
    return bent;
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
    to.outcomes = from.outcomes;
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
