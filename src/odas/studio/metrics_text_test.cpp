// SPDX-License-Identifier: MIT
#include "odas/studio/metrics_text.hpp"

#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::metrics_text_test {
namespace {

TEST(MetricsText, is_what_Prometheus_reads) {
  const auto stages = nlohmann::json::parse(R"([["localization",250],["separation",7]])");
  const auto beams = nlohmann::json::parse(R"([[0,7,14.5,-3.0,20.0],[3,9,null,6.0,null]])");
  const std::string text = metrics_text({{"hops", 1500},
                                         {"hop_p99_us", 250.0},
                                         {"temperature", nullptr},
                                         {"unknown", 3},
                                         {"stages", stages},
                                         {"beams", beams}});
  EXPECT_NE(text.find("odas_stage_seconds{stage=\"localization\"} 0.00025\n"), std::string::npos);
  EXPECT_NE(text.find("odas_beam_white_noise_gain_decibels{slot=\"3\"} 6\n"), std::string::npos);
  EXPECT_EQ(text.find("odas_beam_snr_decibels{slot=\"3\"}"), std::string::npos);
  EXPECT_NE(text.find("# TYPE odas_hops_total counter\nodas_hops_total 1500\n"), std::string::npos);
  EXPECT_NE(text.find("odas_hop_seconds_p99 0.00025\n"), std::string::npos);
  EXPECT_EQ(text.find("temperature"), std::string::npos);
  const std::regex line(
      R"((# (HELP|TYPE) [a-z_0-9]+ .+|[a-z_][a-z_0-9]*(\{[a-z]+="[a-z0-9]+"\})? -?[0-9.e+-]+)\n)");
  std::size_t matched = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at)
    matched += static_cast<std::size_t>(at->length());
  EXPECT_EQ(matched, text.size());
}

}  // namespace
}  // namespace odas::metrics_text_test
