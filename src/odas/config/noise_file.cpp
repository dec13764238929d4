// SPDX-License-Identifier: MIT
#include "odas/config/noise_file.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <locale>
#include <sstream>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr const char* kTitle = "odas noise 1";
constexpr std::size_t kMostMics = 128;
constexpr std::size_t kLongestFrame = 65536;
constexpr float kSamePlace = 5e-4F;  // m

/// Of the lower triangle, row by row: real and imaginary part, little-endian.
void write_float(std::ostream& out, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (unsigned shift = 0; shift < 32; shift += 8) out.put(static_cast<char>((bits >> shift) & 0xFFU));
}

float read_float(std::istream& in) {
  std::uint32_t bits = 0;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bits |= (static_cast<std::uint32_t>(in.get()) & 0xFFU) << shift;
  }
  return std::bit_cast<float>(bits);
}

class Reader {
 public:
  Reader(std::istream& in, const std::filesystem::path& file) : in_(in), file_(file) {}

  NoiseDictionary read() {
    std::string title;
    std::getline(in_, title);
    if (title != kTitle) fail("is no noise dictionary of this version: make one with odas learn-noise");
    NoiseDictionary dictionary;
    std::size_t mics = 0;
    std::size_t entries = 0;
    dictionary.sample_rate = static_cast<int>(count("rate", 1, 1 << 20));
    dictionary.hop_size = count("hop", 1, kLongestFrame);
    dictionary.frame_size = count("frame", 2, kLongestFrame);
    mics = count("mics", 1, kMostMics);
    for (std::size_t m = 0; m < mics; ++m) {
      const auto p = numbers<3>("mic");
      dictionary.mics.push_back({p[0], p[1], p[2]});
    }
    entries = count("entries", 1, NoiseDictionary::kMostEntries);
    for (std::size_t e = 0; e < entries; ++e) {
      const auto v = numbers<3>("entry");
      dictionary.entries.push_back({v[0], v[1], v[2], {}});
    }
    std::string word;
    if (!std::getline(in_, word) || word != "data") fail("has no data");
    for (NoiseDictionary::Entry& entry : dictionary.entries) read_scm(dictionary, entry);
    return dictionary;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw IoError(file_.string() + " " + what); }

  /// A line: a word, and numbers.
  template <std::size_t N>
  std::array<float, N> numbers(const std::string& word) {
    std::string text;
    std::getline(in_, text);
    std::istringstream line(text);
    line.imbue(std::locale::classic());
    std::string first;
    std::array<float, N> values{};
    line >> first;
    for (float& value : values) line >> value;
    if (!line || first != word) fail("is damaged: no line \"" + word + "\" where one must be");
    return values;
  }

  std::size_t count(const std::string& word, std::size_t least, std::size_t most) {
    const float value = numbers<1>(word)[0];
    if (!(value >= static_cast<float>(least) && value <= static_cast<float>(most))) {
      fail("is damaged: \"" + word + "\" is out of range");
    }
    return static_cast<std::size_t>(value);
  }

  void read_scm(const NoiseDictionary& dictionary, NoiseDictionary::Entry& entry) {
    const std::size_t mics = dictionary.mics.size();
    const std::size_t size = mics * mics;
    for (std::size_t k = 0; k < dictionary.bins(); ++k) {
      entry.scm.resize((k + 1) * size);
      cfloat* r = entry.scm.data() + k * size;
      for (std::size_t i = 0; i < mics; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          const float real = read_float(in_);
          const float imaginary = read_float(in_);
          if (!in_) fail("is cut short");
          const bool fits =
              std::isfinite(real) && std::isfinite(imaginary) && (i != j || (real >= 0 && imaginary == 0));
          if (!fits) fail("is damaged: it holds what is no covariance");
          r[i * mics + j] = {real, imaginary};
          r[j * mics + i] = {real, -imaginary};
        }
      }
    }
  }

  std::istream& in_;
  const std::filesystem::path& file_;
};

}  // namespace

void write_noise_file(const NoiseDictionary& dictionary, const std::filesystem::path& file) {
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  out.imbue(std::locale::classic());
  out.precision(9);
  out << kTitle << "\nrate " << dictionary.sample_rate << "\nhop " << dictionary.hop_size << "\nframe "
      << dictionary.frame_size << "\nmics " << dictionary.mics.size() << '\n';
  for (const Vec3 p : dictionary.mics) out << "mic " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  out << "entries " << dictionary.entries.size() << '\n';
  for (const NoiseDictionary::Entry& entry : dictionary.entries) {
    out << "entry " << entry.share << ' ' << entry.likeness << ' ' << entry.deviation << '\n';
  }
  out << "data\n";
  const std::size_t mics = dictionary.mics.size();
  for (std::size_t e = 0; e < dictionary.entries.size(); ++e) {
    for (std::size_t k = 0; k < dictionary.bins(); ++k) {
      const std::span<const cfloat> r = dictionary.scm(e, k);
      for (std::size_t i = 0; i < mics; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          write_float(out, r[i * mics + j].real());
          write_float(out, i == j ? 0 : r[i * mics + j].imag());
        }
      }
    }
  }
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw IoError("cannot write " + file.string() + (error ? ": " + error.message() : ""));
  }
}

NoiseDictionary read_noise_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw IoError("cannot read " + file.string() + ": make it with odas learn-noise, or leave out sss.noise");
  }
  return Reader(in, file).read();
}

std::string misfit_of(const NoiseDictionary& dictionary, const PipelineConfig& config) {
  const GeneralConfig& general = config.general;
  const auto other = [](const char* what, std::size_t learned, std::size_t now) {
    return std::string("was learned with ") + what + " " + std::to_string(learned) + ", not " +
           std::to_string(now) + ": learn again";
  };
  const auto rate = static_cast<std::size_t>(general.samplerate.mu);
  const auto hop = static_cast<std::size_t>(general.size.hop_size);
  const std::size_t frame = separation_frame(config);
  if (static_cast<std::size_t>(dictionary.sample_rate) != rate) {
    return other("a rate of", static_cast<std::size_t>(dictionary.sample_rate), rate);
  }
  if (dictionary.hop_size != hop) return other("a hop of", dictionary.hop_size, hop);
  if (dictionary.frame_size != frame) return other("a frame of", dictionary.frame_size, frame);
  if (dictionary.mics.size() != general.mics.size()) {
    return other("microphones:", dictionary.mics.size(), general.mics.size());
  }
  for (std::size_t m = 0; m < dictionary.mics.size(); ++m) {
    const auto& mu = general.mics[m].mu;
    if (norm(dictionary.mics[m] - Vec3{mu[0], mu[1], mu[2]}) > kSamePlace) {
      return "was learned with microphone " + std::to_string(m + 1) + " at another place: learn again";
    }
  }
  return "";
}

}  // namespace odas
