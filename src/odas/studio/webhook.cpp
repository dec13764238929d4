// SPDX-License-Identifier: MIT
#include "odas/studio/webhook.hpp"

#include "odas/base/error.hpp"

#ifdef ODAS_WITH_WEBHOOKS

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include <curl/curl.h>
#include <fmt/format.h>

namespace odas {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongestPause{30};

std::size_t pass_over(char*, std::size_t size, std::size_t count, void*) { return size * count; }

}  // namespace

class Webhook::Body {
 public:
  explicit Body(Options options) : options_(std::move(options)) {
    static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
    multi_.reset(curl_multi_init());
    if (ready != CURLE_OK || !multi_) throw IoError("cannot start libcurl");
    thread_ = std::thread([this] { run(); });
  }
  ~Body() {
    {
      const std::scoped_lock lock(mutex_);
      until_ = Clock::now() + options_.farewell;
      ending_ = true;
    }
    wake_.notify_all();
    curl_multi_wakeup(multi_.get());
    thread_.join();
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  void post(std::string text) {
    bool full = false;
    {
      const std::scoped_lock lock(mutex_);
      full = queue_.size() >= kQueue;
      if (!full) queue_.push_back(std::move(text));
    }
    if (full) lose("its queue is full");
    wake_.notify_all();
  }

  std::atomic<std::uint64_t> sent{0}, lost{0};

 private:
  struct Free {
    void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
  };
  struct FreeEasy {
    void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
  };

  /// What an attempt came to: "": he has it.
  struct Answer {
    std::string fault;
    bool again = false;
  };

  void run() {
    for (;;) {
      std::string text;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] { return ending_ || !queue_.empty(); });
        if (queue_.empty()) return;
        text = std::move(queue_.front());
        queue_.pop_front();
      }
      deliver(text);
    }
  }

  void deliver(const std::string& text) {
    std::chrono::milliseconds pause = options_.first_pause;
    for (int attempt = 1;; ++attempt) {
      const Answer answer = over() ? Answer{"there was no time left for it"} : send(text);
      if (answer.fault.empty()) {
        ++sent;
        said_ = false;
        return;
      }
      if (!answer.again || attempt == kTries || ending_) return lose(answer.fault);
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, pause, [&] { return ending_.load(); });
      pause = std::min<std::chrono::milliseconds>(2 * pause, kLongestPause);
    }
  }

  [[nodiscard]] bool over() const { return ending_ && Clock::now() >= until_; }

  Answer send(const std::string& text) {
    const std::unique_ptr<CURL, FreeEasy> easy(curl_easy_init());
    const std::unique_ptr<curl_slist, Free> headers(
        curl_slist_append(nullptr, "Content-Type: application/json"));
    CURL* const to = easy.get();
    curl_easy_setopt(to, CURLOPT_URL, options_.url.c_str());
    curl_easy_setopt(to, CURLOPT_FOLLOWLOCATION, 0L);
    curl_easy_setopt(to, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(to, CURLOPT_TIMEOUT_MS, static_cast<long>(options_.timeout.count()));
    curl_easy_setopt(to, CURLOPT_HTTPHEADER, headers.get());
    curl_easy_setopt(to, CURLOPT_USERAGENT, "odas");
    curl_easy_setopt(to, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(text.size()));
    curl_easy_setopt(to, CURLOPT_POSTFIELDS, text.data());
    curl_easy_setopt(to, CURLOPT_WRITEFUNCTION, pass_over);
    curl_multi_add_handle(multi_.get(), to);
    int running = 1;
    while (running > 0 && !over() && curl_multi_perform(multi_.get(), &running) == CURLM_OK && running > 0) {
      curl_multi_poll(multi_.get(), nullptr, 0, 100, nullptr);
    }
    CURLcode code = CURLE_OPERATION_TIMEDOUT;
    int left = 0;
    while (const CURLMsg* message = curl_multi_info_read(multi_.get(), &left)) {
      if (message->msg == CURLMSG_DONE) code = message->data.result;
    }
    long status = 0;
    curl_easy_getinfo(to, CURLINFO_RESPONSE_CODE, &status);
    curl_multi_remove_handle(multi_.get(), to);
    if (code != CURLE_OK) return {curl_easy_strerror(code), true};
    if (status >= 200 && status < 300) return {};
    if (status >= 300 && status < 400) {
      return {
          fmt::format("it answers {}: redirects are not followed, give the address where it leads", status)};
    }
    return {fmt::format("it answers {}", status), status >= 500 || status == 429 || status == 408};
  }

  void lose(const std::string& why) {
    ++lost;
    if (said_.exchange(true) || !options_.say) return;
    options_.say("warning", fmt::format("an event did not reach {}: {}; more that are lost are counted",
                                        options_.url, why));
  }

  Options options_;
  std::unique_ptr<CURLM, Free> multi_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::string> queue_;
  Clock::time_point until_;  // written before ending_
  std::atomic<bool> ending_{false};
  std::atomic<bool> said_{false};
  std::thread thread_;
};

Webhook::Webhook(Options options) {
  if (!options.url.starts_with("http://") && !options.url.starts_with("https://")) {
    throw ConfigError("studio.events.url",
                      "\"" + options.url + "\" is no address of the web: it begins with http:// or https://");
  }
  body_ = std::make_unique<Body>(std::move(options));
}
Webhook::~Webhook() = default;
void Webhook::post(std::string text) { body_->post(std::move(text)); }
std::uint64_t Webhook::sent() const noexcept { return body_->sent; }
std::uint64_t Webhook::lost() const noexcept { return body_->lost; }

}  // namespace odas

#else

namespace odas {

class Webhook::Body {};
Webhook::Webhook(Options) {
  throw ConfigError("studio.events.url",
                    "this build sends no events: it was made with -DODAS_WITH_WEBHOOKS=OFF");
}
Webhook::~Webhook() = default;
void Webhook::post(std::string) {}
std::uint64_t Webhook::sent() const noexcept { return 0; }
std::uint64_t Webhook::lost() const noexcept { return 0; }

}  // namespace odas

#endif
