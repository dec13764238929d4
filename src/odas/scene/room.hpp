// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "odas/base/vec3.hpp"
#include "odas/scene/delay_filter.hpp"
#include "odas/scene/scene.hpp"

namespace odas {

/// Which reflections to take: by how many walls they met.
struct Orders {
  int first = 0;
  int last = 1 << 20;
};

/// A shoebox room: impulse responses from a point to the microphones, by image sources.
///
/// Method: each image at distance d, after n walls, gives beta^n / d at d / c, times the gain of the
/// microphone's pattern for its direction. The direct path at 1 m has gain 1.
/// Symbols: beta: pressure reflection of all walls alike, 0..1.
/// beta comes from the rt60 asked for by bisection, until the energy that the images bring decays as asked
/// (from -5 to -35 dB, times two): the formulas of Sabine and Eyring take a field to be diffuse, which a
/// shoebox without scattering is not.
/// Images of up to two walls go through DelayFilter one by one, the others through an ImpulseTrain.
/// Of those that met n > 12 walls, of which there are many more than samples, a random choice of (12 / n)^2
/// stands for all, louder by n / 12: as much energy from the same directions, and the same images for all
/// microphones and places of the source, so that what one microphone hears fits what the next does.
/// Source: Allen and Berkley, JASA 65(4), 1979; Lehmann and Johansson, JASA 124(1), 2008.
/// Fails: no scattering, no absorption by frequency, no diffraction by the array's body. At 0 Hz all images
/// add up, which no ear or microphone would hear: what is played should have nothing there.
class Room {
 public:
  explicit Room(const Scene& scene);

  /// Samples that every response has.
  [[nodiscard]] std::size_t response_length(float farthest_source) const noexcept;
  /// Adds to `response` what comes from `source` (m, from the middle of the array) to `mic`.
  void add_response(Vec3 source, const SceneMic& mic, Orders orders, std::span<float> response) const;
  /// 0 in the free field.
  [[nodiscard]] float reflection() const noexcept { return reflection_; }

 private:
  struct Echo {
    Vec3 shift;  // of the image from the source's place, or from its mirror image, m
    Vec3 side;   // 1; -1: mirrored
    float gain;  // at 1 m
    int walls;
  };
  struct Image {
    float offset;  // along one axis, from the microphone, m
    int walls;
  };
  void images_along(float length, float source, float mic, float radius, Orders orders,
                    std::vector<Image>& images) const;
  void add_echoes(Vec3 source, const SceneMic& mic, Orders orders, std::span<float> response) const;
  template <class Visit>
  void for_each_image(Vec3 source, Vec3 mic, Orders orders, float radius, Visit&& visit) const;
  [[nodiscard]] double decay_time(const std::vector<std::vector<double>>& energy, double reflection) const;
  void match_decay(Vec3 source);
  void choose_echoes();

  Vec3 size_;
  Vec3 middle_;
  float rt60_;
  float speed_;
  float rate_;
  float reflection_ = 0;
  std::vector<float> powers_;  // [walls]
  std::vector<Echo> echoes_;   // by walls
  DelayFilter delay_;
};

}  // namespace odas
