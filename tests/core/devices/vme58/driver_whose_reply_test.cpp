// Whose reply is it: each question of the driver, its reply late, shifted by one, doubled or merged with the
// next. What is shown is the truth or not known, and when it is over everything is known again.
#include <deque>
#include <tuple>

#include "core/devices/vme58/codec.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using vme58::ReplyForm;

enum class Bent : std::uint8_t { late, very_late, shifted, doubled, doubled_late, merged };
enum class Question : std::uint8_t { flags, slips, loop, number, greeting };
using Row = std::tuple<Question, Bent>;

constexpr const char* bent_names[] = {"late", "very_late", "shifted", "doubled", "doubled_late", "merged"};
constexpr const char* question_names[] = {"QI", "RL", "EA", "RQ_and_RP", "WY"};

bool is_reply_to(Question question, std::string_view reply) {
  switch (question) {
    case Question::flags: return vme58::fits({ReplyForm::Of::flags, 8}, reply);
    case Question::slips: return vme58::fits({ReplyForm::Of::slips, 8}, reply);
    case Question::loop: return vme58::fits({ReplyForm::Of::loop}, reply);
    case Question::number: return vme58::fits({ReplyForm::Of::numbers}, reply);
    case Question::greeting: return vme58::fits({ReplyForm::Of::greeting}, reply);
  }
  return false;
}

/// Stands between the board's ring of replies and the driver, who reads one of this test's instead.
class BendingWindow final : public Window {
 public:
  BendingWindow(Scheduler& time, std::unique_ptr<Window> window) : time_(time), window_(std::move(window)) {}
  void listen(Listener* listener) override { window_->listen(listener); }
  [[nodiscard]] bool reports_interrupts() const override { return window_->reports_interrupts(); }
  [[nodiscard]] std::string describe() const override { return window_->describe(); }
  Task<Result<>> run(std::span<BusCycle> cycles) override {
    for (BusCycle& c : cycles)
      if (c.write && c.offset == vme58::at::input_get_index) c.value = static_cast<std::uint32_t>(board_get_);
    auto done = co_await window_->run(cycles);
    if (!done) co_return done;
    auto drained = co_await drain();
    if (!drained) co_return drained;
    release();
    for (BusCycle& c : cycles) {
      if (c.write) continue;
      if (c.offset == vme58::at::input_put_index) c.value = static_cast<std::uint32_t>(put_);
      if (c.offset >= vme58::at::input_buffer && c.offset < vme58::at::input_buffer + 2 * vme58::ring_cells)
        c.value = static_cast<unsigned char>(
            cells_[static_cast<std::size_t>(c.offset - vme58::at::input_buffer) / 2]);
    }
    co_return Result<>();
  }
  /// Each third reply of the row, from now on; none: all go as they come.
  std::optional<Row> row;
  int bent = 0;

 private:
  struct Due {
    Instant at;
    std::string bytes;
  };
  Task<Result<>> drain() {
    std::vector<BusCycle> look{BusCycle::read(2, vme58::at::input_put_index)};
    auto done = co_await window_->run(look);
    if (!done) co_return done;
    const int board_put = static_cast<int>(look.front().value);
    if (board_put == board_get_) co_return Result<>();
    std::vector<BusCycle> reads;
    vme58::append_reply_reads(reads, board_get_, vme58::waiting(board_put, board_get_));
    done = co_await window_->run(reads);
    if (!done) co_return done;
    received_ += vme58::reply_text(reads);
    board_get_ = board_put;
    while (auto reply = vme58::take_reply(received_)) bend(*reply);
    co_return Result<>();
  }
  static std::string framed(const std::string& text) { return "\n\r" + text + "\n\r"; }
  void send(const std::string& bytes, Duration later = {}) {
    Instant due = time_.now() + later;
    if (!queue_.empty()) due = std::max(due, queue_.back().at);  // the board answers in the order of its ring
    queue_.push_back({due, bytes});
  }
  void bend(const std::string& reply) {
    const std::string before = std::exchange(before_, reply);
    const std::string joined = std::exchange(held_, {}) + reply;
    const bool meant = row && is_reply_to(std::get<0>(*row), reply) && matched_++ % 3 == 0;
    if (!meant || joined != reply) return send(framed(joined));
    ++bent;
    switch (std::get<1>(*row)) {
      case Bent::late: return send(framed(reply), Millis(600));
      case Bent::very_late: return send(framed(reply), Millis(2300));
      case Bent::shifted: send(framed(before)); return send(framed(reply));
      case Bent::doubled: send(framed(reply)); return send(framed(reply));
      case Bent::doubled_late:
        send(framed(reply));
        extra_ = Due{time_.now() + Millis(3), framed(reply)};
        return;
      case Bent::merged: held_ = reply; return;
    }
  }
  void release() {
    if (extra_ && time_.now() >= extra_->at) queue_.push_back(*std::exchange(extra_, std::nullopt));
    for (; !queue_.empty() && time_.now() >= queue_.front().at; queue_.pop_front())
      for (const char c : queue_.front().bytes) {
        cells_[static_cast<std::size_t>(put_)] = c;
        put_ = vme58::advanced(put_, 1);
      }
  }

  Scheduler& time_;
  std::unique_ptr<Window> window_;
  int board_get_ = 0, put_ = 0, matched_ = 0;
  std::array<char, vme58::ring_cells> cells_{};
  std::string received_, before_ = "0", held_;
  std::deque<Due> queue_;
  std::optional<Due> extra_;
};

class Vme58WhoseReply : public test::Vme58Rig, public testing::WithParamInterface<Row> {
 protected:
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    auto bending = std::make_unique<BendingWindow>(time, std::move(window));
    bending_ = bending.get();
    return bending;
  }
  /// All that is shown is so.
  void look(const char* when) {
    const bool on = switch_on_;
    for (int i = 0; i < 8; ++i) {
      const AxisState& a = axis(i);
      if (a.limits_known && time.now() > switched_at_ + Millis(300)) {
        EXPECT_EQ(a.limit_plus, i == 0 && on) << when << ", axis " << i;
        EXPECT_FALSE(a.limit_minus) << when << ", axis " << i;
      }
      EXPECT_FALSE(a.slipped) << when << ", axis " << i;
      if (a.loop != Loop::unknown && a.loop != Loop::none) {
        EXPECT_EQ(a.loop == Loop::open, i == 1) << when << ", axis " << i;
      }
      if ((now().queue_known >> i & 1) != 0 && i != 4) {  // that one moves
        EXPECT_EQ(now().queue_free[static_cast<std::size_t>(i)] < 200, i == 3) << when << ", axis " << i;
      }
      if (a.activity == Activity::idle && a.ended_by == EndedBy::target && a.has_target) {
        EXPECT_EQ(a.command, a.target) << when << ", axis " << i;
      }
    }
    ASSERT_EQ(now().restarts, 0u) << when;
  }
  void watch(Duration time_for, const char* when) {
    for (Duration d{}; d < time_for && !HasFailure(); d += Millis(10)) {
      run(Millis(10));
      look(when);
    }
  }
  void flip_the_switch() {
    switch_on_ = !switch_on_;
    switched_at_ = time.now();
    operate(bench::Limit(AxisId{0}, Sign::plus, switch_on_));
  }
  /// Answered rightly or not at all.
  void ask(const char* text, const char* right, bool must = false) {
    const auto reply = query(text);
    if (reply || must) {
      EXPECT_EQ(reply.value_or("no answer"), right) << text;
    }
  }
  void ask_all(bool must = false) {
    // One number before another, that nobody has asked for, looks like the answer to a typed question.
    if (bending_->row == Row(Question::number, Bent::shifted)) return;
    ask("AX RP", "100", must), ask("AZ RP", "300", must), ask("AT RP", "400", must);
    ask("AX RE", "100", must), ask("RL", "NNNNNNNN", must);
  }

  BendingWindow* bending_ = nullptr;
  bool switch_on_ = false;
  Instant switched_at_{};
};

TEST_P(Vme58WhoseReply, ShownValuesAreTrueOrUnknown) {
  ASSERT_TRUE(query("AX LP100 AZ LP300 AT LP400 AY HF AX HN AT WT60000 MR10 GO AX"));
  run(Seconds(2));
  session->send(intent::Watch(~0u));
  bending_->row = GetParam();
  int moves = 0;
  for (int turn = 0; turn < 4; ++turn) {
    flip_the_switch();
    watch(Millis(700), "behind a switch");
    session->send(intent::ReadAgain());
    watch(Millis(300), "read again");
    ask_all();
    watch(Millis(500), "behind questions");
    const IntentOutcome moved = perform(intent::MoveBy({{AxisId{4}, Steps(10)}}, Pps{100}));
    EXPECT_TRUE(moved.state == IntentState::done || moved.state == IntentState::refused)
        << moved.sentence.view();
    moves += moved.state == IntentState::done;
    watch(Millis(1500), "behind a move");
  }
  bending_->row.reset();
  watch(Seconds(8), "when it is over");
  EXPECT_EQ(now().link.state, LinkState::good) << now().link.sentence.view();
  EXPECT_TRUE(axis(0).limits_known);
  EXPECT_EQ(axis(4).position, Steps(10 * moves));
  EXPECT_NE(axis(1).loop, Loop::unknown);
  EXPECT_EQ(now().queue_known & 0xFFu, 0xFFu);
  ask_all(true);
}

std::string name_of(const testing::TestParamInfo<Row>& info) {
  return std::string(question_names[static_cast<int>(std::get<0>(info.param))]) + "_" +
         bent_names[static_cast<int>(std::get<1>(info.param))];
}
INSTANTIATE_TEST_SUITE_P(Table, Vme58WhoseReply,
                         testing::Combine(testing::Values(Question::flags, Question::slips, Question::loop,
                                                          Question::number, Question::greeting),
                                          testing::Values(Bent::late, Bent::very_late, Bent::shifted,
                                                          Bent::doubled, Bent::doubled_late, Bent::merged)),
                         name_of);

}  // namespace
}  // namespace hw
