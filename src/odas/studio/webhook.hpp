// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace odas {

/// Sends texts of JSON to an address on the web, one POST after another, in a thread of its own.
///
/// Who does not answer, or answers with an error of his own (5xx, 429), is tried again, later each time, and
/// after kTries the text is given up; one who refuses (3xx, 4xx) has it at once. No redirects are followed:
/// what a microphone hears goes nowhere but where its owner says. What finds no room in the queue is dropped.
/// Texts that are lost are counted, and the first of each spell is said.
class Webhook {
 public:
  static constexpr std::size_t kQueue = 256;
  static constexpr int kTries = 5;

  struct Options {
    std::string url;
    std::chrono::milliseconds timeout{5000};
    std::chrono::milliseconds first_pause{500};  // before it is tried again; doubles each time
    std::chrono::milliseconds farewell{1000};    // for what is left at the end
    std::function<void(const std::string& level, const std::string& text)> say{};
  };

  /// Throws ConfigError: no address of the web, or this build has no webhooks.
  explicit Webhook(Options options);
  ~Webhook();
  Webhook(const Webhook&) = delete;
  Webhook& operator=(const Webhook&) = delete;

  /// Any thread; never waits.
  void post(std::string text);

  [[nodiscard]] std::uint64_t sent() const noexcept;
  [[nodiscard]] std::uint64_t lost() const noexcept;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace odas
