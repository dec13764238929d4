// SPDX-License-Identifier: MIT
#include "odas/io/card_owner.hpp"

#include <fstream>
#include <vector>

namespace odas {
namespace {

struct Card {
  std::string name;  // its number or id
  std::string device = "0";
};

/// Of "hw:CARD=Array,DEV=0" or "plughw:1,0": what is said, by name or by place.
Card card_of(const std::string& pcm) {
  Card card;
  const std::size_t colon = pcm.find(':');
  if (colon == std::string::npos) return card;
  std::size_t place = 0;
  for (std::size_t at = colon + 1; at <= pcm.size(); ++place) {
    const std::size_t end = std::min(pcm.find(',', at), pcm.size());
    std::string value = pcm.substr(at, end - at);
    const std::size_t equals = value.find('=');
    const std::string key = equals == std::string::npos ? "" : value.substr(0, equals);
    if (!key.empty()) value = value.substr(equals + 1);
    if (key == "CARD" || (key.empty() && place == 0)) card.name = value;
    if (key == "DEV" || (key.empty() && place == 1)) card.device = value;
    at = end + 1;
  }
  return card;
}

}  // namespace

std::string owner_of_card(const std::string& pcm, const std::filesystem::path& proc) {
  const Card card = card_of(pcm);
  if (card.name.empty() || card.name.find('/') != std::string::npos) return "";
  const bool number = card.name.find_first_not_of("0123456789") == std::string::npos;
  // Beside card0, card1, ... there is a link by the id of each.
  const auto folder = proc / "asound" / (number ? "card" + card.name : card.name);
  std::ifstream status(folder / ("pcm" + card.device + "c") / "sub0" / "status");
  for (std::string word; status >> word;) {
    std::string process;
    if (word != "owner_pid" || !(status >> word >> process)) continue;
    std::ifstream command(proc / process / "comm");
    std::string name;
    std::getline(command, name);
    return (name.empty() ? "a program" : name) + " (process " + process + ")";
  }
  return "";
}

}  // namespace odas
