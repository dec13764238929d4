// SPDX-License-Identifier: MIT
#include "odas/scene/bench_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <fstream>
#include <mutex>
#include <numbers>
#include <sstream>
#include <thread>

#include <unistd.h>

#include "odas/array/doa_error.hpp"
#include "odas/base/error.hpp"
#include "odas/scene/ideal_beamformer.hpp"
#include "odas/scene/scene_output.hpp"
#include "odas/scene/simulate.hpp"
#include "odas/scene/sound.hpp"
#include "odas/scene/tdoa_bound.hpp"
#include "odas/scene/truth_file.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNote = "bench.txt";
constexpr int kRuler = 3;  // of what is kept: a step whenever scenes come out otherwise

/// What a kept scene depends on.
std::string note_of(const BenchScene& scene, const GeneralConfig& array, bool voices) {
  std::ostringstream note;
  note << kRuler << ' ' << scene.text() << " hop=" << array.size.hop_size << " rate=" << array.samplerate.mu;
  for (const MicConfig& mic : array.mics) {
    for (const float x : mic.mu) note << ' ' << x;
    for (const float x : mic.direction) note << ' ' << x;
    note << ' ' << mic.angle[0];
  }
  if (voices) note << " ideal_beamformer";
  return note.str();
}

fs::path folder_of(const BenchScene& scene, const fs::path& folder) {
  std::string name = scene.name();
  std::ranges::replace(name, '/', '_');
  return folder / name;
}

std::optional<BenchSound> kept(const fs::path& folder, const std::string& note, bool voices) {
  std::ifstream in(folder / kNote);
  std::string line;
  if (!std::getline(in, line) || line != note) return std::nullopt;
  BenchSound sound;
  if (double sdr = 0; voices && in >> sdr) sound.ideal_beamformer_sdr_db = sdr;
  for (double bound = 0; in >> bound;) sound.tdoa_bounds.push_back(bound);
  sound.played.truth = read_truth(folder);
  auto known = read_known_sound(folder, sound.played.truth);
  if (!known) return std::nullopt;
  sound.played.sound = std::move(*known);
  sound.played.mics = read_channels(folder / "mics.wav");
  return sound;
}

/// Others may read and write there at the same time: a scene is there as a whole, or not at all.
void put_in_place(const fs::path& part, const fs::path& place) {
  std::error_code error;
  fs::remove_all(place, error);
  fs::rename(part, place, error);
  if (error) fs::remove_all(part, error);  // somebody else was faster, with the same scene
}

}  // namespace

BenchSound bench_sound(const BenchScene& bench, const GeneralConfig& array, const fs::path& folder,
                       bool voices) {
  const std::string note = note_of(bench, array, voices);
  const fs::path place = folder_of(bench, folder);
  if (!folder.empty()) {
    if (auto sound = kept(place, note, voices)) return std::move(*sound);
  }
  const Scene scene = make_scene(bench, array);
  SimulatedScene simulated = simulate(scene, {}, voices ? Images::of_all : Images::of_the_first);
  const fs::path part = place.string() + "." + std::to_string(getpid()) + ".part";
  if (!folder.empty()) write_scene(scene, simulated, RecordingFormat::wav, part);
  BenchSound sound;
  if (voices) {
    sound.ideal_beamformer_sdr_db = ideal_beamformer_sdr_db(simulated.mics, simulated.images_at_all);
  }
  sound.played = played(scene, std::move(simulated));
  sound.tdoa_bounds = tdoa_bounds(scene, sound.played);
  if (folder.empty()) return sound;
  std::ofstream out(part / kNote);
  out.precision(17);
  out << note << '\n';
  if (sound.ideal_beamformer_sdr_db) out << *sound.ideal_beamformer_sdr_db << '\n';
  for (const double bound : sound.tdoa_bounds) out << bound << '\n';
  out.close();
  if (!out) throw IoError("cannot write all of " + (part / kNote).string());
  put_in_place(part, place);
  return sound;
}

std::optional<BenchBound> bench_bound(const BenchSound& sound, const GeneralConfig& array) {
  const double mean_of_gaussian = std::sqrt(2 / std::numbers::pi);
  constexpr std::size_t kEvery = 50;  // hops
  BenchBound sum;
  double count = 0;
  for (std::size_t t = 0; t < sound.tdoa_bounds.size(); ++t) {
    const DoaError error(array, sound.tdoa_bounds[t]);
    const KnownSource& source = sound.played.truth.sources[t];
    for (std::size_t h = 0; h < source.direction.size(); h += kEvery) {
      const Direction& d = source.direction[h];
      const auto at = error.at({static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)});
      if (!at) continue;
      sum.azimuth_deg += at->azimuth_deg / std::max(0.05, std::hypot(d.x, d.y));
      sum.angle_deg += at->angle_deg();
      count += 1;
    }
  }
  if (count == 0) return std::nullopt;
  return BenchBound{mean_of_gaussian * sum.azimuth_deg / count, mean_of_gaussian * sum.angle_deg / count};
}

void for_each_in_parallel(std::size_t count, std::size_t jobs, const std::atomic<bool>* stop,
                          const std::function<void(double)>& progress,
                          const std::function<void(std::size_t)>& work) {
  using namespace std::chrono_literals;
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t next = 0, done = 0, running = std::min(jobs, count);
  std::exception_ptr failure;
  const auto worker = [&] {
    std::unique_lock lock(mutex);
    while (next < count && !failure && (stop == nullptr || !*stop)) {
      const std::size_t mine = next++;
      lock.unlock();
      std::exception_ptr mishap;
      try {
        work(mine);
      } catch (...) { mishap = std::current_exception(); }
      lock.lock();
      ++done;
      if (mishap && !failure) failure = mishap;
      changed.notify_one();
    }
    --running;
    changed.notify_one();
  };
  std::vector<std::jthread> threads;
  for (std::size_t j = running; j > 0; --j) threads.emplace_back(worker);
  {
    std::unique_lock lock(mutex);
    while (running > 0) {
      changed.wait_for(lock, 100ms);
      if (progress)
        progress(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(1, count)));
    }
  }
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace odas
