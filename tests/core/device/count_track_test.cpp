// The count of an axis that moves, rests and is looked at through a bad wire: no reading that is spoilt on
// the way makes an alarm, and a count that is set does.
#include "core/device/count_track.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace hw {
namespace {

/// An axis that moves to and fro, with rests; its true place at any time.
class Slide {
 public:
  explicit Slide(unsigned seed) : random_(seed) {}
  double speed = 1000, ramp = 4000;  ///< of the present motion
  std::int64_t offset = 0;           ///< by which the count was set elsewhere

  /// A new motion, or a rest.
  void next(double now) {
    place_ = at(now);
    began_ = now;
    speed = between(100, 6000), ramp = between(500, 40'000);
    way_ = between(0, 1) < 0.3 ? 0 : between(-20'000, 20'000);
    const double to_speed = std::min(speed * speed / ramp, std::abs(way_));
    const double top = std::sqrt(ramp * to_speed);
    ramp_time_ = top / ramp, cruise_ = top > 0 ? (std::abs(way_) - to_speed) / top : 0;
    ends = now + 2 * ramp_time_ + cruise_ + between(0.5, 4);
  }
  [[nodiscard]] double at(double now) const {
    const double t = now - began_, total = 2 * ramp_time_ + cruise_;
    const double sign = way_ < 0 ? -1 : 1;
    double gone = std::abs(way_);
    if (t < ramp_time_)
      gone = ramp * t * t / 2;
    else if (t < ramp_time_ + cruise_)
      gone = ramp * ramp_time_ * (t - ramp_time_ / 2);
    else if (t < total)
      gone -= ramp * (total - t) * (total - t) / 2;
    return place_ + sign * gone;
  }
  [[nodiscard]] bool moves(double now) const { return now - began_ < 2 * ramp_time_ + cruise_; }
  [[nodiscard]] double began() const { return began_; }
  [[nodiscard]] std::int8_t way() const { return way_ > 0 ? 1 : way_ < 0 ? -1 : 0; }
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

  double ends = 0;

 private:
  std::mt19937 random_;
  double place_ = 0, began_ = 0, way_ = 0, ramp_time_ = 0, cruise_ = 0;
};

/// A digit lost, doubled, or read as another one.
std::int64_t spoilt(std::int64_t value, Slide& slide) {
  std::string digits = std::to_string(value);
  const auto at = static_cast<std::size_t>(slide.between(0, static_cast<double>(digits.size()) - 0.001));
  const auto how = static_cast<int>(slide.between(0, 3));
  if (how == 0 && digits.size() > 1)
    digits.erase(at, 1);
  else if (how == 1)
    digits.insert(at, 1, digits[at]);
  else
    digits[at] = static_cast<char>('0' + static_cast<int>(slide.between(0, 9.99)));
  return digits == "-" || digits.find('-', 1) != digits.npos ? 0 : std::stoll(digits);
}

struct Played {
  int readings = 0, alarms = 0, sets = 0, found = 0;
};

/// Looks every `period` seconds; that part of the readings is spoilt; the count is set anew from time to
/// time.
Played play(unsigned seed, double period, double bad, bool sets) {
  Played played;
  Slide slide(seed);
  CountTrack track;
  double next_set = sets ? 20 : 1e9, set_at = -100;
  for (double now = 0.1; played.readings < 20'000; now += period * slide.between(0.8, 1.2)) {
    if (now > slide.ends) {
      slide.next(now);
      track.forget();  // a command goes out
    }
    const bool seen = now > slide.began() + 5 * period && slide.ends - now > 2.5 + 5 * period;
    if (now > next_set && seen) {
      const auto before = slide.offset;
      while (std::abs(slide.offset - before) < 30'000)
        slide.offset = static_cast<std::int64_t>(slide.between(-200'000, 200'000));
      next_set = now + 20, set_at = now;
      ++played.sets;
    }
    std::int64_t value = std::llround(slide.at(now)) + slide.offset;
    if (slide.between(0, 1) < bad) value = spoilt(value, slide);
    CountReading reading;
    reading.place = Steps(value);
    reading.when = Instant(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(now)));
    reading.fastest = slide.speed, reading.any_speed = 6000;
    reading.way = slide.moves(now) ? slide.way() : std::int8_t{0};
    ++played.readings;
    if (!track.add(reading)) continue;
    ++(now - set_at < 5 ? played.found : played.alarms);
  }
  return played;
}

TEST(CountTrack, NoReadingSpoiltOnTheWayMakesAnAlarm) {
  int readings = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
    for (const double period : {0.05, 0.1, 0.2, 0.5}) {
      const Played played = play(seed, period, 0.05, false);
      EXPECT_EQ(played.alarms, 0) << "seed " << seed << ", a look each " << period << " s";
      readings += played.readings;
    }
  EXPECT_EQ(readings, 3'200'000);
}

TEST(CountTrack, MotionAloneMakesNone) {
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const double period : {0.02, 0.2, 1.0}) EXPECT_EQ(play(seed, period, 0, false).alarms, 0);
}

TEST(CountTrack, ACountThatIsSetIsFoundBetweenThem) {
  Played all;
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const double period : {0.05, 0.2}) {
      const Played played = play(seed, period, 0.05, true);
      EXPECT_EQ(played.alarms, 0);
      all.sets += played.sets, all.found += played.found;
    }
  EXPECT_GT(all.sets, 500);
  EXPECT_GE(all.found, all.sets * 0.98) << all.found << " of " << all.sets;
}

}  // namespace
}  // namespace hw
