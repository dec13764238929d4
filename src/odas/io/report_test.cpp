// SPDX-License-Identifier: MIT
#include "odas/io/report.hpp"

#include <cmath>
#include <fstream>
#include <iterator>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

#include "odas/base/error.hpp"

namespace odas::report_test {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "voices"); }

  void write_tone(const std::string& file, int seconds) const {
    SndfileHandle sound((folder_ / file).string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 1, 16000);
    std::vector<float> samples(static_cast<std::size_t>(seconds) * 16000);
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i] = 0.3F * std::sin(static_cast<float>(i) * 0.1F);
    sound.writef(samples.data(), static_cast<sf_count_t>(samples.size()));
  }

  ReportData two_sources() const {
    write_tone("voices/source_1.wav", 2);
    write_tone("voices/source_2.wav", 1);
    write_tone("microphone_1.wav", 4);
    ReportHistory history(128, 16000);
    for (HopIndex t = 1; t <= 500; ++t) {
      std::array<Track, 2> tracks{};
      if (t <= 250) tracks[0] = {1, "dynamic", direction_of(170 + 0.2F * static_cast<float>(t), 20), 0.9F};
      if (t > 200 && t <= 325) tracks[1] = {2, "dynamic", direction_of(-60, 5), 0.7F};
      history.add(t, std::array{Potential{direction_of(-60, 5), 0.4F}}, tracks);
    }
    ReportData data;
    data.title = "talk.wav";
    data.seconds = 4;
    data.mics = {{0.03F, 0, 0}, {0, 0.03F, 0}, {-0.03F, 0, 0}, {0, -0.03F, 0}};
    for (auto& s : history.sources()) {
      const std::string file = "voices/source_" + std::to_string(s.id) + ".wav";
      const double start = s.from_s;
      data.sources.push_back({std::move(s), ReportClip{file, start}});
    }
    data.potentials = history.potentials();
    data.reference = ReportClip{"microphone_1.wav", 0};
    data.facts = {{"Recording", "talk.wav"}, {"Array", "four.cfg"}};
    return data;
  }

  std::string page(const ReportData& data, std::uintmax_t limit = kMaxEmbeddedAudio) const {
    write_report(folder_ / "report.html", data, limit);
    std::ifstream in(folder_ / "report.html", std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  static nlohmann::json data_of(const std::string& page) {
    const std::string open = R"(<script type="application/json" id="data">)";
    const std::size_t from = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
  }

  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  }

  test::Scratch scratch_;
  fs::path folder_ = scratch_.folder();
};

TEST_F(Report, loads_nothing_from_anywhere) {
  const std::string text = page(two_sources());
  EXPECT_EQ(text.find("http://"), std::string::npos);
  EXPECT_EQ(text.find("https://"), std::string::npos);
  for (const char* load : {" src=", " srcset=", "@import", "url(", "import(", "fetch("}) {
    EXPECT_EQ(text.find(load), std::string::npos) << load;
  }
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
}

TEST_F(Report, fills_every_place_of_the_page) {
  const std::string text = page(two_sources());
  EXPECT_EQ(text.find("{{"), std::string::npos);
  EXPECT_NE(text.find("<title>talk.wav"), std::string::npos);
  EXPECT_NE(text.find("prefers-color-scheme"), std::string::npos);
  EXPECT_NE(text.find("drawSphere"), std::string::npos);
}

TEST_F(Report, carries_each_source_with_its_way_and_its_outline) {
  const auto json = data_of(page(two_sources()));
  ASSERT_EQ(json["sources"].size(), 2U);
  const auto& first = json["sources"][0];
  EXPECT_EQ(first["id"], 1);
  EXPECT_EQ(first["file"], "voices/source_1.wav");
  EXPECT_DOUBLE_EQ(first["length"], 2.0);
  EXPECT_EQ(first["peaks"].size(), 900U);
  EXPECT_EQ(first["peak_db"], -10);
  EXPECT_NEAR(first["places"]["azimuth"]["from"], 175, 2);
  EXPECT_NEAR(first["places"]["azimuth"]["to"], -145, 2);
  for (const char* key : {"x", "y", "z", "activity"}) EXPECT_EQ(first[key].size(), first["t"].size());
  EXPECT_NEAR(json["sources"][1]["places"]["azimuth"]["mean"], -60, 0.1);
  EXPECT_EQ(json["mics"].size(), 4U);
  EXPECT_EQ(json["reference"]["file"], "microphone_1.wav");
  EXPECT_EQ(json["potentials"]["t"].size(), json["potentials"]["azimuth"].size());
}

TEST_F(Report, carries_the_sound_up_to_the_limit_and_links_to_it_above) {
  const ReportData data = two_sources();
  EXPECT_EQ(count(page(data), R"(id="audio-)"), 3U);
  EXPECT_NE(page(data).find(R"(id="audio-0">UklGR)"), std::string::npos);  // "RIFF"
  const std::string linked = page(data, 1000);
  EXPECT_EQ(count(linked, R"(id="audio-)"), 0U);
  EXPECT_EQ(data_of(linked)["sources"][0]["file"], "voices/source_1.wav");
}

TEST_F(Report, escapes_what_the_user_named) {
  ReportData data = two_sources();
  const std::string evil = "</script><script>alert('&amp;')</script><!--\xff\"";
  data.title = evil;
  data.sources[0].history.tag = evil;
  data.facts.emplace_back(evil, evil);
  data.warnings = {evil};
  const std::string text = page(data);
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  EXPECT_EQ(text.find("<!--"), std::string::npos);
  const auto json = data_of(text);
  EXPECT_EQ(json["warnings"][0].get<std::string>().find("</script><script>alert('&amp;')</script><!--"), 0U);
  EXPECT_EQ(json["sources"][0]["tag"], json["warnings"][0]);
}

TEST_F(Report, of_silence_is_a_page_too) {
  ReportData data;
  data.title = "silence.wav";
  data.seconds = 1;
  const auto json = data_of(page(data));
  EXPECT_TRUE(json["sources"].empty());
  EXPECT_TRUE(json["sources"].is_array());
  EXPECT_TRUE(json["potentials"]["t"].is_array());
  EXPECT_TRUE(json["warnings"].is_array());
  EXPECT_FALSE(json.contains("reference"));
}

TEST_F(Report, leaves_an_old_page_alone_when_a_new_one_cannot_be_written) {
  ReportData data = two_sources();
  const std::string before = page(data);
  data.sources[0].voice->file = "voices/gone.wav";
  EXPECT_THROW(write_report(folder_ / "report.html", data), IoError);
  std::ifstream in(folder_ / "report.html", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), before);
  EXPECT_FALSE(fs::exists(folder_ / "report.html.part"));
  EXPECT_THROW(write_report(folder_ / "no_such_folder" / "report.html", data), IoError);
}

}  // namespace
}  // namespace odas::report_test
