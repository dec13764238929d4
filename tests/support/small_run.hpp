// SPDX-License-Identifier: MIT
// A small array, a recording of it, and the programs that run it from a file, as a user would.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/fake_io.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include <sndfile.hh>

namespace odas::test {

/// A folder with a configuration of three microphones, its recording, and its outputs.
class SmallRun {
 public:
  static constexpr std::size_t kMics = 3;

  /// Text of the sections of the configuration that tests change.
  std::string source = R"(type = "file"; path = "mics.raw";)";
  std::string potential = R"(format = "json"; interface: { type = "file"; path = "pots.json"; };)";
  std::string tracked = R"(format = "json"; interface: { type = "file"; path = "tracks.json"; };)";
  std::string separated = R"(interface: { type = "file"; path = "separated.raw"; };)";
  std::string general;
  int bits = 16;

  [[nodiscard]] std::string configuration() const {
    return "raw: { fS = 16000; hopSize = 128; nBits = " + std::to_string(bits) +
           "; nChannels = 3; interface: { " + source + " }; };\n" +
           "general: { mics = ( { mu = (0.0, 0.0, 0.0); }, { mu = (0.05, 0.0, 0.0); },\n"
           "                    { mu = (0.0, 0.05, 0.0); } ); " +
           general + " };\n" + "ssl: { scans = ( { level = 1; delta = 1; } ); potential: { " + potential +
           " }; };\n" + "sst: { tracked: { " + tracked + " }; };\n" + "sss: { separated: { " + separated +
           " }; };\n";
  }

  /// Noise of which a part is common to all microphones, so that somebody is there. [mic][frame]
  [[nodiscard]] static Grid<float> sound(std::size_t frames) {
    Grid<float> samples = noise(kMics, frames);
    const Grid<float> common = noise(1, frames, 9);
    for (std::size_t m = 0; m < kMics; ++m) {
      for (std::size_t i = 2; i < frames; ++i) samples[m][i] = 0.3F * samples[m][i] + common[0][i - m];
    }
    return samples;
  }

  /// Writes [channel][frame] by way of libsndfile.
  void record(const std::string& name, const Grid<float>& samples, int format, int rate = 16000) const {
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < samples.cols(); ++i) {
      for (std::size_t c = 0; c < samples.rows(); ++c) interleaved.push_back(samples[c][i]);
    }
    SndfileHandle file((scratch_ / name).string(), SFM_WRITE, format, static_cast<int>(samples.rows()), rate);
    file.writef(interleaved.data(), static_cast<sf_count_t>(samples.cols()));
  }
  void record_raw(const Grid<float>& samples) const {
    record("mics.raw", samples, SF_FORMAT_RAW | SF_FORMAT_PCM_16 | SF_ENDIAN_LITTLE);
  }
  void record_wav(const Grid<float>& samples, int rate = 16000) const {
    record("mics.wav", samples, SF_FORMAT_WAV | SF_FORMAT_PCM_16, rate);
  }

  /// `odaslive -c run.cfg`, in the folder.
  [[nodiscard]] ProgramRun odaslive(std::vector<std::string> more = {}, ProgramOptions options = {}) const {
    return run({program_path("odaslive"), "-c", "run.cfg"}, std::move(more), std::move(options));
  }
  /// `odas live -c run.cfg`, in the folder.
  [[nodiscard]] ProgramRun odas_live(std::vector<std::string> more = {}, ProgramOptions options = {}) const {
    return run({program_path("odas"), "live", "-c", "run.cfg"}, std::move(more), std::move(options));
  }

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return scratch_ / name; }
  [[nodiscard]] std::string text(const std::string& name) const { return content(scratch_ / name); }

 private:
  [[nodiscard]] ProgramRun run(std::vector<std::string> command, std::vector<std::string> more,
                               ProgramOptions options) const {
    write_file(scratch_ / "run.cfg", configuration());
    command.insert(command.end(), more.begin(), more.end());
    options.working_directory = scratch_.folder();
    return run_program(command, options);
  }

  Scratch scratch_;
};

inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace odas::test
