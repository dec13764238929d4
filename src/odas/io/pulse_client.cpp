// SPDX-License-Identifier: MIT
#include "odas/io/pulse_client.hpp"

#include <algorithm>

#include <pulse/pulseaudio.h>

namespace odas {
namespace {

SampleFormat format_of(pa_sample_format_t format) {
  switch (format) {
    case PA_SAMPLE_U8:
      return SampleFormat::u8;
    case PA_SAMPLE_S24LE:
      return SampleFormat::s24_3;
    case PA_SAMPLE_S24_32LE:
      return SampleFormat::s24;
    case PA_SAMPLE_S32LE:
      return SampleFormat::s32;
    case PA_SAMPLE_FLOAT32LE:
      return SampleFormat::f32;
    default:
      return SampleFormat::s16;  // into which the server converts the rare ones
  }
}

PulseDevice device_of(const pa_source_info& info) {
  PulseDevice device;
  device.name = info.name;
  device.description = info.description != nullptr ? info.description : "";
  device.monitor = info.monitor_of_sink != PA_INVALID_INDEX;
  CaptureOffer& offer = device.offer;
  offer.formats = {format_of(info.sample_spec.format)};
  offer.min_channels = offer.max_channels = info.sample_spec.channels;
  offer.min_rate = offer.max_rate = static_cast<int>(info.sample_spec.rate);
  offer.rates = {offer.min_rate};
  return device;
}

}  // namespace

struct PulseClient::Loop {
  pa_mainloop* loop = pa_mainloop_new();
  ~Loop() { pa_mainloop_free(loop); }
};

PulseClient::PulseClient() : loop_(std::make_unique<Loop>()) {
  context_ = pa_context_new(pa_mainloop_get_api(loop_->loop), "odas");
}

PulseClient::~PulseClient() {
  pa_context_disconnect(context_);
  pa_context_unref(context_);
}

std::string PulseClient::connect(Clock::time_point deadline, bool spawn) {
  const auto flags = spawn ? PA_CONTEXT_NOFLAGS : PA_CONTEXT_NOAUTOSPAWN;
  if (pa_context_connect(context_, nullptr, flags, nullptr) < 0) return error();
  for (;;) {
    const pa_context_state_t state = pa_context_get_state(context_);
    if (state == PA_CONTEXT_READY) return "";
    if (!PA_CONTEXT_IS_GOOD(state)) return error();
    if (Clock::now() >= deadline) return "no answer";
    run(deadline - Clock::now());
  }
}

bool PulseClient::good() const { return pa_context_get_state(context_) == PA_CONTEXT_READY; }

std::string PulseClient::error() const { return pa_strerror(pa_context_errno(context_)); }

void PulseClient::run(Clock::duration at_most) {
  const auto microseconds = std::chrono::ceil<std::chrono::microseconds>(at_most).count();
  const auto limited = std::clamp<std::int64_t>(microseconds, 0, 100000);
  if (pa_mainloop_prepare(loop_->loop, static_cast<int>(limited)) < 0) return;
  if (pa_mainloop_poll(loop_->loop) < 0) return;
  pa_mainloop_dispatch(loop_->loop);
}

bool PulseClient::finish(pa_operation* operation, Clock::time_point deadline) {
  if (operation == nullptr) return false;
  while (pa_operation_get_state(operation) == PA_OPERATION_RUNNING && good() && Clock::now() < deadline) {
    run(deadline - Clock::now());
  }
  const bool done = pa_operation_get_state(operation) == PA_OPERATION_DONE;
  if (!done) pa_operation_cancel(operation);
  pa_operation_unref(operation);
  return done;
}

std::optional<PulseDevice> PulseClient::source(const std::string& name, Clock::time_point deadline) {
  std::optional<PulseDevice> found;
  const auto note = [](pa_context*, const pa_source_info* info, int, void* to) {
    if (info != nullptr) *static_cast<std::optional<PulseDevice>*>(to) = device_of(*info);
  };
  finish(pa_context_get_source_info_by_name(context_, name.c_str(), note, &found), deadline);
  return found;
}

std::vector<PulseDevice> PulseClient::sources(Clock::time_point deadline) {
  std::vector<PulseDevice> all;
  const auto note = [](pa_context*, const pa_source_info* info, int, void* to) {
    if (info != nullptr) static_cast<std::vector<PulseDevice>*>(to)->push_back(device_of(*info));
  };
  finish(pa_context_get_source_info_list(context_, note, &all), deadline);
  return all;
}

}  // namespace odas
