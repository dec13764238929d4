// SPDX-License-Identifier: MIT
#include "odas/config/reader.hpp"

#include <algorithm>

#include <libconfig.h++>

#include "odas/config/checks.hpp"
#include "odas/config/defaults.hpp"
#include "odas/config/noise_file.hpp"
#include "odas/config/setting_reader.hpp"
#include "odas/config/source_text.hpp"

namespace odas {

namespace {

/// What libconfig says, in words that help.
std::string syntax_fault(const libconfig::ParseException& error, const SourceText& source) {
  const std::string said = error.getError();
  const std::string near = source.excerpt(error.getLine());
  std::string what = said;
  if (said == "syntax error") {
    what = "syntax error; often a ';', a ',' or a quote is missing on this line or the one before";
  } else if (said == "duplicate setting name") {
    what = "a key is given twice";
  }
  return near.empty() ? what : what + ", near: " + near;
}

/// The dictionary that sss.noise names, from beside the configuration.
void read_noise(LoadedConfiguration& loaded, const std::filesystem::path& configuration) {
  PipelineConfig& config = loaded.config.pipeline;
  CheckReport report(loaded.locations, loaded.faults);
  if (config.sss.noise.empty() || !loaded.ok()) return;
  try {
    NoiseDictionary noise = read_noise_file(configuration.parent_path() / config.sss.noise);
    const std::string misfit = misfit_of(noise, config);
    if (!misfit.empty()) return report.error("sss.noise", misfit);
    config.known_noise = std::move(noise);
  } catch (const IoError& error) { report.error("sss.noise", error.what()); }
}

LoadedConfiguration read(const SourceText& source, std::vector<Fault> faults) {
  LoadedConfiguration loaded;
  loaded.locations.set_file(source.name());
  loaded.faults = std::move(faults);
  // Where brackets or files are missing already, what libconfig adds would only confuse.
  if (loaded.ok()) {
    libconfig::Config file;
    try {
      file.readString(source.text());
      const SettingReader reader(source, loaded.locations, loaded.faults);
      reader.read(file.getRoot(), loaded.config);
      set_derived_defaults(loaded.config, loaded.locations);
      check_configuration(loaded.config, loaded.locations, loaded.faults);
      SizeConfig& size = loaded.config.pipeline.general.size;
      size.frame_size -= size.frame_size % 2;  // as ODAS has it; warned of by the checks
      read_noise(loaded, source.name());
    } catch (const libconfig::ParseException& error) {
      const Location where = source.location(error.getLine());
      loaded.faults.push_back(
          {Fault::Severity::error, "", syntax_fault(error, source), where.file, where.line});
    }
  }
  loaded.config.pipeline.wanted = wanted_of(loaded.config);
  std::stable_sort(loaded.faults.begin(), loaded.faults.end(),
                   [](const Fault& a, const Fault& b) { return a.file == b.file && a.line < b.line; });
  return loaded;
}

}  // namespace

bool LoadedConfiguration::ok() const {
  return std::none_of(faults.begin(), faults.end(),
                      [](const Fault& fault) { return fault.severity == Fault::Severity::error; });
}

LoadedConfiguration read_configuration(const std::filesystem::path& file) {
  std::vector<Fault> faults;
  const SourceText source = SourceText::from_file(file, faults);
  return read(source, std::move(faults));
}

LoadedConfiguration read_configuration_text(std::string_view text, const std::string& name) {
  std::vector<Fault> faults;
  const SourceText source = SourceText::from_text(text, name, faults);
  return read(source, std::move(faults));
}

LoadedConfiguration load_configuration(const std::filesystem::path& file) {
  LoadedConfiguration loaded = read_configuration(file);
  if (!loaded.ok()) throw ConfigError(std::move(loaded.faults));
  return loaded;
}

}  // namespace odas
