// SPDX-License-Identifier: MIT
#include "odas/studio/run_figures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::run_figures_test {
namespace {

TEST(RunFigures, are_those_of_this_process) {
  EXPECT_GT(resident_bytes(), 1'000'000U);
  const double before = process_cpu_seconds();
  volatile double sum = 0;
  while (process_cpu_seconds() <= before) sum = sum + 1;
  EXPECT_GT(process_cpu_seconds(), before);
}

TEST(RunFigures, follow_the_run) {
  HealthFigures figures;
  EXPECT_GT(figures.read().at("rss_bytes").get<double>(), 0);
  const auto run = std::make_shared<RunFigures>();
  run->lost_records = 7;
  figures.begin(run);
  EXPECT_EQ(figures.read().at("lost_records"), 7);
  EXPECT_TRUE(figures.read().at("stages").empty());

  Metrics engine;
  engine.hops = 10;
  engine.stage_times[static_cast<std::size_t>(Stage::noise)] = 250;  // ns: nothing but looks at the clock
  engine.stage_times[static_cast<std::size_t>(Stage::localization)] = 420'000;
  engine.stage_times[static_cast<std::size_t>(Stage::separation)] = 73'000;
  run->engine.note_engine(engine);
  EXPECT_EQ(figures.read().at("stages").dump(), R"([["localization",42.0],["separation",7.3]])");
}

}  // namespace
}  // namespace odas::run_figures_test
