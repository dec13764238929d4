// SPDX-License-Identifier: MIT
#include "support/virtual_devices.hpp"

#include <chrono>
#include <climits>
#include <random>
#include <stdexcept>

#include "support/program.hpp"
#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace odas::test {
namespace {

constexpr const char* kAlsaConfiguration = "/usr/share/alsa/alsa.conf";
constexpr const char* kPulseAudio = "/usr/bin/pulseaudio";
constexpr const char* kPacat = "/usr/bin/pacat";
constexpr const char* kMap = "aux0,aux1,aux2,aux3,aux4,aux5,aux6,aux7";

}  // namespace

std::string noise_bytes(std::size_t frames, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(frames * kVirtualFrame, ' ');
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const int value = static_cast<int>(random() % 16384) - 8192;
    bytes[i] = static_cast<char>(value & 0xFF);
    bytes[i + 1] = static_cast<char>((value >> 8) & 0xFF);
  }
  return bytes;
}

VirtualCard::VirtualCard(const Scratch& scratch) {
  const auto pipe = scratch / "array8.pipe";
  if (::mkfifo(pipe.c_str(), 0600) != 0) throw std::runtime_error("no pipe to be had");
  pipe_ = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  write_file(scratch / "asound.conf",
             std::string("<") + kAlsaConfiguration +
                 ">\npcm.array8 { type file slave.pcm null file \"/dev/null\" infile \"" + pipe.string() +
                 "\" format raw hint { show on description \"A virtual array\" } }\n");
  environment_ = "ALSA_CONFIG_PATH=" + (scratch / "asound.conf").string();
}

VirtualCard::~VirtualCard() {
  stop_ = true;
  if (player_.joinable()) player_.join();
  ::close(pipe_);
}

bool VirtualCard::possible() { return std::filesystem::exists(kAlsaConfiguration); }

void VirtualCard::play(std::string bytes) {
  player_ = std::thread([this, sound = std::move(bytes)] {
    constexpr std::size_t kPeriod = 128 * kVirtualFrame;  // 8 ms
    const std::string silence(kPeriod, '\0');
    // A pipe takes what is no longer than this whole or not at all: frames stay frames.
    static_assert(kPeriod <= PIPE_BUF);
    auto start = std::chrono::steady_clock::now();
    for (std::size_t period = 0; !stop_; ++period) {
      std::this_thread::sleep_until(start + std::chrono::milliseconds(8) * period);
      const std::size_t at = period * kPeriod;
      played_ = at >= sound.size();
      const char* from = played_ ? silence.data() : sound.data() + at;
      const std::size_t size = played_ ? kPeriod : std::min(kPeriod, sound.size() - at);
      // A card would overrun. On a loaded machine that is no fault of who listens: it waits.
      while (!stop_ && ::write(pipe_, from, size) < 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      // The clock runs from when somebody listens.
      for (int waiting = 1; period == 0 && !stop_ && waiting > 0;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (::ioctl(pipe_, FIONREAD, &waiting) != 0) return;
        start = std::chrono::steady_clock::now();
      }
    }
  });
}

bool VirtualPulse::possible() { return ::access(kPulseAudio, X_OK) == 0 && ::access(kPacat, X_OK) == 0; }

VirtualPulse::VirtualPulse(const Scratch& scratch) : folder_(scratch / "pulse") {
  std::filesystem::create_directories(folder_ / "run");
  std::filesystem::permissions(folder_ / "run", std::filesystem::perms::owner_all);
  const std::string socket = (folder_ / "s").string();
  write_file(
      folder_ / "t.pa",
      "load-module module-native-protocol-unix auth-anonymous=1 socket=" + socket +
          "\nload-module module-null-sink sink_name=mic8 format=s16le rate=16000 channels=8 channel_map=" +
          kMap + " norewinds=1\n");
  environment_ = {"PULSE_SERVER=unix:" + socket, "XDG_RUNTIME_DIR=" + (folder_ / "run").string(),
                  "HOME=" + folder_.string()};
}

void VirtualPulse::start() {
  const std::string script = (folder_ / "t.pa").string();
  const std::string log = (folder_ / "log").string();
  server_ = ::fork();
  if (server_ == 0) {
    for (std::string& variable : environment_) ::putenv(variable.data());
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    ::execl(kPulseAudio, "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--realtime=no",
            "--high-priority=no", "-F", script.c_str(), nullptr);
    ::_exit(127);
  }
}

bool VirtualPulse::ready() const {
  return run_program({"/usr/bin/pactl", "list", "short", "sources"}, {.environment = environment_})
             .out.find("mic8.monitor") != std::string::npos;
}

void VirtualPulse::end() {
  if (server_ <= 0) return;
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
  server_ = -1;
}

int VirtualPulse::play(const std::filesystem::path& file) const {
  return run_program({kPacat, "-p", "--raw", "--format=s16le", "--rate=16000", "--channels=8",
                      std::string("--channel-map=") + kMap, "-d", "mic8", file.string()},
                     {.environment = environment_, .seconds = 120})
      .exit_code;
}

}  // namespace odas::test
