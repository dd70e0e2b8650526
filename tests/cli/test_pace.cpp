// Simulated time against the clock, with a clock that the test moves.
#include <gtest/gtest.h>

#include "apps/sluice/play/pace.hpp"

namespace sluice::test {
namespace {

const app::Clock::time_point start{};
app::Clock::time_point after(double seconds) {
  return start + std::chrono::duration_cast<app::Clock::duration>(std::chrono::duration<double>(seconds));
}

TEST(Pace, AsksForAsMuchTimeAsHasPassedTimesTheSpeed) {
  app::Pace pace(4);
  pace.begin(10, after(3));
  EXPECT_EQ(pace.target(after(3)), 10);
  EXPECT_EQ(pace.target(after(3.5)), 12);
  pace.set_speed(0.5, after(4));
  EXPECT_EQ(pace.target(after(4)), 14);
  EXPECT_EQ(pace.target(after(6)), 15);
}

TEST(Pace, WhatWasKeptUpWithGoesAtItsSpeed) {
  app::Pace pace(2);
  pace.begin(0, start);
  EXPECT_EQ(pace.factor(), 0) << "not known yet";
  pace.reached(0.38, true, after(0.2));
  EXPECT_EQ(pace.factor(), 0);
  pace.reached(1.18, true, after(0.6));  // a little behind, as the steps have it
  EXPECT_EQ(pace.factor(), 2);
  EXPECT_EQ(pace.target(after(1)), 2) << "what is behind is made good";
}

TEST(Pace, WhatWasNotIsGivenUpAndTheFactorSaysSo) {
  app::Pace pace(1);
  pace.begin(0, start);
  pace.reached(0.1, false, after(0.4));
  EXPECT_EQ(pace.target(after(0.4)), 0.1);
  EXPECT_EQ(pace.target(after(0.5)), 0.2);
  pace.reached(0.2, false, after(0.8));
  EXPECT_DOUBLE_EQ(pace.factor(), 0.25);
  pace.reached(0.8, true, after(1.4));
  EXPECT_EQ(pace.factor(), 1) << "it keeps up again";
  pace.begin(0, after(2));
  EXPECT_EQ(pace.factor(), 0);
}

TEST(Pace, SpeedsStayWithinTheirLimits) {
  EXPECT_EQ(app::changed_speed(1, 2), 2);
  EXPECT_EQ(app::changed_speed(-1, 0.5), -0.5);
  EXPECT_EQ(app::changed_speed(800, 2), app::most_speed);
  EXPECT_EQ(app::changed_speed(-0.0015, 0.5), -app::least_speed);
}

TEST(Playhead, MovesAsFarAsTheClockAndStopsAtTheEnd) {
  app::Playhead head(100, 25, 2);  // 50 frames a second
  EXPECT_FALSE(head.advance(0.5));
  EXPECT_EQ(head.frame(), 25u);
  EXPECT_FALSE(head.advance(0.01));
  EXPECT_EQ(head.frame(), 25u);
  EXPECT_FALSE(head.advance(0.01));
  EXPECT_EQ(head.frame(), 26u);
  EXPECT_TRUE(head.advance(5));
  EXPECT_EQ(head.frame(), 100u);
  EXPECT_TRUE(head.at_end());
  head.set_speed(-1);
  EXPECT_FALSE(head.at_end());
  EXPECT_FALSE(head.advance(1));
  EXPECT_EQ(head.frame(), 75u);
  EXPECT_TRUE(head.advance(4));
  EXPECT_EQ(head.frame(), 0u);
  EXPECT_TRUE(head.at_end());
  head.rewind();
  EXPECT_EQ(head.frame(), 100u);
}

TEST(Playhead, GoesAnywhereWithinTheRecording) {
  app::Playhead head(10, 25, 1);
  head.go_to(7);
  head.move(-2);
  EXPECT_EQ(head.frame(), 5u);
  head.move(99);
  EXPECT_EQ(head.frame(), 10u);
  head.move(-99);
  EXPECT_EQ(head.frame(), 0u);
  app::Playhead single(0, 25, 1);
  EXPECT_TRUE(single.advance(1));
  EXPECT_EQ(single.frame(), 0u);
}

}  // namespace
}  // namespace sluice::test
