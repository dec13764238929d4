// SPDX-License-Identifier: MIT
#include "odas/studio/document.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/source_text.hpp"
#include "odas/io/file_descriptor.hpp"

namespace odas {
namespace {

bool stays(const InterfaceConfig& interface, Outputs outputs) {
  static constexpr std::array<std::string_view, 3> kNetwork{"socket", "socket_listen", "udp"};
  return outputs == Outputs::all ||
         std::find(kNetwork.begin(), kNetwork.end(), interface.type) != kNetwork.end();
}

template <class Output>
void leave_out(Output& output, Outputs outputs) {
  if (!stays(output.interface, outputs)) output.interface.type = "blackhole";
  std::erase_if(output.interfaces, [&](const auto& place) { return !stays(place, outputs); });
}

Configuration as_it_runs(Configuration config, Outputs outputs) {
  config.raw.interface.paced = true;
  leave_out(config.potential, outputs);
  leave_out(config.tracked, outputs);
  leave_out(config.category, outputs);
  leave_out(config.separated, outputs);
  leave_out(config.postfiltered, outputs);
  Wanted& wanted = config.pipeline.wanted;
  wanted.potentials = wanted.tracks = wanted.separated = wanted.postfiltered = wanted.categories = true;
  wanted.mics = wanted.power_map = true;
  return config;
}

IoError cannot_write(const std::filesystem::path& file) {
  return IoError("cannot write " + file.string() + ": " + std::strerror(errno));
}

}  // namespace

std::string Document::source_name() const { return file.empty() ? name + ".cfg" : file.string(); }

Document read_document(const std::string& file_or_array) {
  Document document;
  document.file = find_configuration(file_or_array);
  document.name = document.file.stem().string();
  std::vector<Fault> faults;
  document.text = SourceText::from_file(document.file, faults).written();
  if (document.text.empty() && !faults.empty()) throw ConfigError(std::move(faults));
  return document;
}

std::string hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<std::uint8_t>(c);
    hash *= 0x100000001b3U;
  }
  return fmt::format("{:016x}", hash);
}

CheckedDocument check_document(Document document, Outputs outputs) {
  CheckedDocument checked;
  checked.loaded = read_configuration_text(document.text, document.source_name());
  if (!checked.loaded.ok()) throw ConfigError(std::move(checked.loaded.faults));
  checked.config = as_it_runs(checked.loaded.config, outputs);
  try {
    checked.pipeline = std::make_unique<Pipeline>(checked.config.pipeline);
  } catch (const ConfigError& error) { throw checked.loaded.locations.locate(error); }
  checked.document = std::move(document);
  return checked;
}

void save_text(const std::filesystem::path& file, std::string_view text) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  // A link stays one: what it leads to is written.
  const std::filesystem::path target = std::filesystem::weakly_canonical(file, error);
  const std::filesystem::path& to = error ? file : target;
  const std::string draft = to.string() + ".new";
  const FileDescriptor out(::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (out.get() < 0) throw cannot_write(to);
  while (!text.empty()) {
    const ssize_t written = ::write(out.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const IoError fault = cannot_write(to);
      ::unlink(draft.c_str());
      throw fault;
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(out.get()) != 0 || std::rename(draft.c_str(), to.c_str()) != 0) {
    const IoError fault = cannot_write(to);
    ::unlink(draft.c_str());
    throw fault;
  }
}

}  // namespace odas
