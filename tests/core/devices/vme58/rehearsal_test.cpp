// The data sheet's programming examples, run dry.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/devices/vme58/program_language.h"

namespace hw::vme58 {
namespace {

using testing::HasSubstr;

Rehearsal rehearse(std::string_view text, RehearseOptions options = {}) {
  auto done = program_language().rehearse(text, options);
  EXPECT_TRUE(done) << (done ? "" : done.error().sentence());
  return done ? std::move(*done) : Rehearsal();
}

TEST(Vme58Rehearsal, HomeAndMove) {
  RehearseOptions options;
  options.bench_toml = "[axis.X]\nhome = [500, 600]\n";
  const Rehearsal r =
      rehearse("AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n", options);
  EXPECT_EQ(r.error, "");
  EXPECT_TRUE(r.finished);
  ASSERT_EQ(r.axes.size(), 1u);
  EXPECT_EQ(r.axes[0].name, "X");
  EXPECT_EQ(r.axes[0].position, -10000);
  EXPECT_GT(r.duration_s, 2.5);
  EXPECT_LT(r.duration_s, 5);
}

TEST(Vme58Rehearsal, ThreeAxesTogether) {
  const Rehearsal r = rehearse(
      "AX KP2 KD6 HN\nAY KP2 KD6 HN\nAZ KP2 KD6 HN\nAM\nVL5000,5000,5000;\nAC50000,50000,50000;\n"
      "MA1000,2000,3000; GO ID\n");
  EXPECT_TRUE(r.finished) << r.error;
  ASSERT_EQ(r.axes.size(), 3u);
  EXPECT_EQ(r.axes[0].position, 1000);
  EXPECT_EQ(r.axes[1].position, 2000);
  EXPECT_EQ(r.axes[2].position, 3000);
  EXPECT_NEAR(r.duration_s, 0.7, 0.15);
}

TEST(Vme58Rehearsal, AHoleOfTenThousandCounts) {
  const Rehearsal r = rehearse(
      "AA\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\nMT,,-1000,0; "
      "GO\nCX\n");
  EXPECT_TRUE(r.finished) << r.error;
  ASSERT_EQ(r.axes.size(), 4u);
  EXPECT_NEAR(static_cast<double>(r.axes[2].minimum), -10000, 30);
  EXPECT_NEAR(static_cast<double>(r.axes[2].maximum), 10000, 30);
  EXPECT_NEAR(static_cast<double>(r.axes[3].minimum), -10000, 30);
  EXPECT_GE(r.duration_s, 78);
}

TEST(Vme58Rehearsal, WhatTheBoardRejectsIsNamedByItsLine) {
  const Rehearsal r = rehearse("AX HF\nMA1000 GO ID\n");
  EXPECT_FALSE(r.finished);
  EXPECT_THAT(r.error, HasSubstr("rejects"));
}

TEST(Vme58Rehearsal, AnEndlessTextEndsWithItsTime) {
  RehearseOptions options;
  options.for_seconds = 5;
  const Rehearsal r = rehearse("AX VL1000 JG1000\n", options);
  EXPECT_FALSE(r.finished);
  EXPECT_NEAR(r.duration_s, 5, 0.2);
  EXPECT_GT(r.axes[0].position, 4000);
}

TEST(Vme58Rehearsal, RunsOnTheModelThatItIsMeantFor) {
  RehearseOptions options;
  options.device = {{"variant", "4s4"}};
  EXPECT_THAT(rehearse("AU KP2\n", options).error, HasSubstr("KP2")) << "U is a step axis there";
  EXPECT_EQ(rehearse("AU KP2\n").error, "") << "and a servo axis here";
  options.device = {{"variant", "4"}};
  EXPECT_THAT(rehearse("AX MR10 GO\nAU MR10 GO\n", options).error, HasSubstr("AU")) << "no such axis";
  options.device = {{"jumpers", "OIO"}};
  EXPECT_EQ(rehearse("BL3\n", options).error, "");
  options.device = {{"variant", "9"}};
  EXPECT_FALSE(program_language().rehearse("AX\n", options));
}

TEST(Vme58Rehearsal, RepliesAreSentToTheHost) {
  EXPECT_THAT(rehearse("AX LP55 RP").sent_to_host, HasSubstr("55"));
}

}  // namespace
}  // namespace hw::vme58
