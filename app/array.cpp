// SPDX-License-Identifier: MIT
// odas array: what the geometry of an array lets it hear.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "commands.hpp"
#include "png_canvas.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "odas/array/doa_error.hpp"
#include "odas/array/sphere_grid.hpp"
#include "odas/base/error.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/reader.hpp"
#include "odas/io/array_drawing.hpp"
#include "odas/pipeline/pipeline.hpp"

namespace odas {
namespace {

struct ArrayArguments {
  std::string array, svg, png;
  double tdoa_error_us = 0;  // 0: that of the sampling
};

/// A TDoA is read off at steps of an interpolated sample: the error is even over one of them.
double sampling_error_s(const PipelineConfig& pipeline) {
  return 1.0 / (pipeline.general.samplerate.mu * pipeline.ssl.interp_rate * std::sqrt(12.0));
}

std::string words_of(Vec3 u) {
  return fmt::format("azimuth {:.0f}, elevation {:.0f}", azimuth_deg(u), elevation_deg(u));
}

void print_size(const GeneralConfig& general) {
  struct Distance {
    float metres;
    Pair pair;
  };
  std::vector<Distance> distances;
  for (const Pair& pair : all_pairs(general.mics.size())) {
    distances.push_back({norm(position(general.mics[pair.i]) - position(general.mics[pair.j])), pair});
  }
  if (distances.empty())
    throw ConfigError("general.mics", "one microphone hears no direction: two are the least");
  const auto [closest, widest] =
      std::minmax_element(distances.begin(), distances.end(),
                          [](const Distance& a, const Distance& b) { return a.metres < b.metres; });
  const auto words = [](const Distance& d) {
    return fmt::format("{:.1f} mm, microphones {} and {}", 1000 * d.metres, d.pair.i + 1, d.pair.j + 1);
  };
  fmt::print("  aperture        {}\n  closest pair    {}\n", words(*widest), words(*closest));
  if (closest->metres <= 0) {
    fmt::print("                  they are in one place: is a position wrong?\n");
  } else {
    const float c = general.speedofsound.mu;
    fmt::print(
        "  aliasing        a pair alone is ambiguous from {:.0f} Hz (widest) or {:.0f} Hz (closest) on\n",
        c / (2 * widest->metres), c / (2 * closest->metres));
  }
}

void print_search(const Pipeline::Plan& plan) {
  fmt::print("  pairs           {} of {} hear a common direction\n", plan.pairs_used, plan.pairs);
  for (const Pipeline::Plan::Scan& scan : plan.scans) {
    fmt::print("  search          {} of {} directions at level {}\n", scan.active_points, scan.points,
               scan.level);
  }
}

void print_shape(const GeneralConfig& general, bool half_sphere) {
  switch (shape_of(general.mics)) {
    case ArrayShape::point:
      fmt::print("All microphones are in one place: nothing tells directions apart.\n");
      break;
    case ArrayShape::line:
      fmt::print(
          "All microphones are on a line: every direction looks like all others at the same angle to the "
          "line, a\n"
          "cone. There is no height, and no telling of the two sides; give the side by "
          "general.spatialfilters.\n");
      break;
    case ArrayShape::plane:
      fmt::print(
          "All microphones are in a plane: a direction and its mirror image on the other side look the "
          "same{}.\n"
          "Towards the plane, elevation is the vaguer.\n",
          half_sphere ? ",\nand only the side that they point to is searched" : "");
      break;
    case ArrayShape::volume:
      fmt::print("The array has depth: no direction has a mirror image.\n");
      break;
  }
}

void print_error(const DoaError& error, std::span<const Vec3> directions, double tdoa_error_s) {
  struct Worst {
    const char* what;
    double DoaError::At::*part;
    double sum = 0, most = -1;
    Vec3 where{};
  };
  std::array<Worst, 2> parts{Worst{"azimuth", &DoaError::At::azimuth_deg},
                             Worst{"elevation", &DoaError::At::elevation_deg}};
  std::size_t heard = 0;
  for (const Vec3& u : directions) {
    const auto at = error.at(u);
    if (!at) continue;
    ++heard;
    for (Worst& part : parts) {
      part.sum += (*at).*part.part;
      if ((*at).*part.part > part.most) {
        part.most = (*at).*part.part;
        part.where = u;
      }
    }
  }
  fmt::print("\nExpected error, if each TDoA is wrong by {:.1f} us (deviation), in degrees on the sphere\n",
             1e6 * tdoa_error_s);
  for (const Worst& part : parts) {
    if (heard == 0) break;
    fmt::print("  {:<14}  {:.1f} in the mean, {:.1f} at worst: {}\n", part.what,
               part.sum / static_cast<double>(heard), part.most, words_of(part.where));
  }
}

void print_ambiguities(const DoaError& error, std::span<const Vec3> directions) {
  constexpr double kFar = 30;
  constexpr std::size_t kShown = 8, kCounted = 100000;
  const auto found = error.ambiguities(directions, kFar, kCounted);
  fmt::print("\n");
  if (found.empty()) {
    fmt::print("No two directions that are searched and {:.0f} degrees apart look alike.\n", kFar);
    return;
  }
  fmt::print("{} pairs of directions {:.0f} degrees apart or more look alike, as\n", found.size(), kFar);
  for (std::size_t i = 0; i < std::min(kShown, found.size()); ++i) {
    fmt::print("  {:<30} and {:<30} ({:.0f} degrees apart)\n", words_of(found[i].a), words_of(found[i].b),
               found[i].apart_deg());
  }
}

void draw(const ArrayArguments& arguments, const Configuration& config, const DoaError& error,
          double tdoa_error_s) {
  ArrayPicture picture;
  picture.title = arguments.array;
  picture.general = &config.pipeline.general;
  picture.error = &error;
  picture.subtitle =
      fmt::format("{} microphones, aperture {:.1f} mm; errors for TDoAs that are wrong by {:.1f} us",
                  picture.general->mics.size(), 1000 * aperture(picture.general->mics), 1e6 * tdoa_error_s);
  for (const ArrayFile& file : array_files(array_folders())) {
    if (file.name == arguments.array && !file.title.empty()) picture.title = file.title;
  }
  const std::vector<int>& map = config.mapping.map;
  for (std::size_t m = 0; m < picture.general->mics.size(); ++m) {
    const int channel = m < map.size() ? map[m] : map.empty() ? static_cast<int>(m) + 1 : 0;
    picture.channels.push_back(channel > 0 ? fmt::format("{}", channel) : "");
  }
  const auto on = [&](Canvas& canvas) { draw_array(canvas, picture); };
  if (!arguments.svg.empty()) write_svg(arguments.svg, kArrayDrawingWidth, kArrayDrawingHeight, on);
  if (!arguments.png.empty()) write_png(arguments.png, kArrayDrawingWidth, kArrayDrawingHeight, on);
}

void show(const ArrayArguments& arguments) {
  LoadedConfiguration loaded = load_configuration(find_configuration(arguments.array));
  for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  PipelineConfig& pipeline = loaded.config.pipeline;
  const GeneralConfig& general = pipeline.general;
  pipeline.wanted = {true, false, false, false};
  try {
    fmt::print("Array of {} microphones\n", general.mics.size());
    print_size(general);
    const Pipeline::Plan plan = Pipeline(pipeline).plan();
    print_search(plan);
    print_shape(general, plan.half_sphere);
  } catch (const ConfigError& error) { throw loaded.locations.locate(error); }

  const double tdoa_error_s =
      arguments.tdoa_error_us > 0 ? 1e-6 * arguments.tdoa_error_us : sampling_error_s(pipeline);
  const DoaError error(general, tdoa_error_s);
  const SphereGrid fine(3), coarse(2);
  print_error(error, fine.points(), tdoa_error_s);
  print_ambiguities(error, coarse.points());
  if (std::fflush(stdout) != 0) throw IoError("cannot write to standard output");
  draw(arguments, loaded.config, error, tdoa_error_s);
}

}  // namespace

void add_array(CLI::App& app) {
  CLI::App* command = app.add_subcommand("array", "Check the geometry of an array, and draw it");
  auto arguments = std::make_shared<ArrayArguments>();
  command->add_option("ARRAY", arguments->array, "Configuration: a file, or the name of an array")
      ->type_name("")
      ->required();
  command->add_option("--svg", arguments->svg, "Draw the array into this SVG")->type_name("FILE");
  command->add_option("--png", arguments->png, "Draw it into this PNG")->type_name("FILE");
  command
      ->add_option("--tdoa-error", arguments->tdoa_error_us,
                   "Deviation of a pair's TDoA; without it, that of reading it off the interpolated samples")
      ->type_name("US")
      ->check(CLI::Range(0.01, 10000.0));
  command->footer(
      "Prints the size of the array, from where on its pairs alias, what is searched, how exact directions "
      "can\n"
      "be at best (the Cramer-Rao bound from TDoAs; echo and noise make more of it), and which directions "
      "look\n"
      "alike. The drawing shows the microphones from above and from the side, in mm, and the expected "
      "error.\n\n"
      "Examples:\n"
      "  odas array respeaker_usb_4_mic --png array.png\n"
      "  odas array my_array.cfg --tdoa-error 20");
  command->callback([arguments] { show(*arguments); });
}

}  // namespace odas
