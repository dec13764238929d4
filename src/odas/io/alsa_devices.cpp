// SPDX-License-Identifier: MIT
#include "odas/io/alsa_devices.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <string_view>

#include <alsa/asoundlib.h>
#include <unistd.h>

#include "odas/io/card_owner.hpp"

namespace odas {
namespace {

/// Beside the cards themselves, ALSA names many ways to convert and to route; none of them is a device.
bool is_converter(std::string_view name) {
  constexpr std::array kFamilies{"hw",       "plughw",    "sysdefault", "front",      "rear",      "side",
                                 "surround", "center",    "iec958",     "spdif",      "hdmi",      "dmix",
                                 "dsnoop",   "usbstream", "null",       "samplerate", "speexrate", "lavrate",
                                 "upmix",    "vdownmix",  "jack",       "oss",        "speex"};
  const std::string_view family = name.substr(0, name.find(':'));
  return std::any_of(kFamilies.begin(), kFamilies.end(), [&](std::string_view converter) {
    return family == converter || (converter == "surround" && family.starts_with(converter));
  });
}

struct Freed {
  void operator()(char* text) const noexcept { std::free(text); }
};
using Text = std::unique_ptr<char, Freed>;

std::string hint(const void* hints, const char* what) {
  const Text text(snd_device_name_get_hint(hints, what));
  return text ? text.get() : "";
}

void add_card(int number, std::vector<CaptureDevice>& devices) {
  snd_ctl_t* control = nullptr;
  if (snd_ctl_open(&control, ("hw:" + std::to_string(number)).c_str(), SND_CTL_NONBLOCK) < 0) return;
  const std::unique_ptr<snd_ctl_t, int (*)(snd_ctl_t*)> closed(control, snd_ctl_close);
  snd_ctl_card_info_t* card = nullptr;
  snd_ctl_card_info_malloc(&card);
  const std::unique_ptr<snd_ctl_card_info_t, void (*)(snd_ctl_card_info_t*)> card_freed(
      card, snd_ctl_card_info_free);
  snd_pcm_info_t* pcm = nullptr;
  snd_pcm_info_malloc(&pcm);
  const std::unique_ptr<snd_pcm_info_t, void (*)(snd_pcm_info_t*)> pcm_freed(pcm, snd_pcm_info_free);
  if (snd_ctl_card_info(control, card) < 0) return;
  for (int device = -1; snd_ctl_pcm_next_device(control, &device) >= 0 && device >= 0;) {
    snd_pcm_info_set_device(pcm, static_cast<unsigned>(device));
    snd_pcm_info_set_subdevice(pcm, 0);
    snd_pcm_info_set_stream(pcm, SND_PCM_STREAM_CAPTURE);
    if (snd_ctl_pcm_info(control, pcm) < 0) continue;  // it only plays
    CaptureDevice found = ask_alsa_device("hw:CARD=" + std::string(snd_ctl_card_info_get_id(card)) +
                                          ",DEV=" + std::to_string(device));
    found.description = std::string(snd_ctl_card_info_get_name(card)) + ", " + snd_pcm_info_get_name(pcm);
    devices.push_back(std::move(found));
  }
}

void add_named(std::vector<CaptureDevice>& devices) {
  void** hints = nullptr;
  if (snd_device_name_hint(-1, "pcm", &hints) < 0) return;
  for (void** at = hints; *at != nullptr; ++at) {
    const std::string name = hint(*at, "NAME");
    const std::string way = hint(*at, "IOID");
    if (is_converter(name) || way == "Output") continue;
    CaptureDevice found = ask_alsa_device(name);
    if (!found.problem.empty()) continue;  // "default" of a machine without a card, and its like
    found.description = hint(*at, "DESC");
    devices.push_back(std::move(found));
  }
  snd_device_name_free_hint(hints);
}

/// Cards that are there and may not be used are not even seen by ALSA.
std::string forbidden() {
  const std::filesystem::path folder = "/dev/snd";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().filename().string().starts_with("control") &&
        ::access(entry.path().c_str(), R_OK) != 0 && errno == EACCES) {
      return entry.path().string() + " may not be read" + alsa_advice(-EACCES, "", "");
    }
  }
  return "";
}

}  // namespace

std::string alsa_advice(int error, const std::string& name, const std::string& owner) {
  switch (-error) {
    case EBUSY:
      return (owner.empty() ? "; another program captures from it" : "; " + owner + " captures from it") +
             ": end that, or share the card by PulseAudio (type = \"pulseaudio\") or by ALSA's dsnoop";
    case EACCES:
    case EPERM:
      return "; may you use sound cards? sudo usermod -aG audio $USER, and log in again";
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return std::string("; 'odas devices' lists those that are there") +
             (name.starts_with("hw:") ? ", by names that a reboot does not change"
                                      : ", with ALSA's own names");
    default:
      return "";
  }
}

CaptureDevice ask_alsa_device(const std::string& name, const AlsaOpener& open) {
  CaptureDevice device;
  device.system = "ALSA";
  device.name = name;
  int error = 0;
  if (const std::unique_ptr<AlsaPcm> pcm = open(name, error)) {
    device.offer = pcm->offer(std::nullopt, std::nullopt);
    if (device.offer.max_channels == 0) device.problem = "it offers nothing that odas can read";
  } else {
    device.problem = alsa_error(error) + alsa_advice(error, name, error == -EBUSY ? owner_of_card(name) : "");
  }
  return device;
}

std::vector<CaptureDevice> list_alsa_devices(std::string& fault) {
  std::vector<CaptureDevice> devices;
  for (int card = -1; snd_card_next(&card) >= 0 && card >= 0;) add_card(card, devices);
  fault = devices.empty() ? forbidden() : "";
  add_named(devices);
  return devices;
}

}  // namespace odas
