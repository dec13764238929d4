// SPDX-License-Identifier: MIT
#include "odas/tracking/config.hpp"

namespace odas {

Schema GaussianConfig::schema() {
  static const std::vector<Field> fields{
      field<&GaussianConfig::weight>("weight", "", kNotNegative, "weight in the mixture"),
      field<&GaussianConfig::mu>("mu", "", kAny, "mean of E"),
      field<&GaussianConfig::sigma2>("sigma2", "", kPositive, "variance of E"),
  };
  return fields;
}

Schema TargetConfig::schema() {
  static const std::vector<Field> fields{
      field<&TargetConfig::tag>("tag", "", kAny,
                                "its name in the tracks; at most 63 bytes, not empty, not \"dynamic\""),
      field<&TargetConfig::x>("x", "", kAny, "direction"),
      field<&TargetConfig::y>("y", "", kAny, "direction"),
      field<&TargetConfig::z>("z", "", kAny, "direction"),
  };
  return fields;
}

Schema KalmanConfig::schema() {
  static const std::vector<Field> fields{
      field<&KalmanConfig::sigma_q>("sigmaQ", "1/s per hop^1/2", kPositive,
                                    "how much the velocity may change from hop to hop"),
  };
  return fields;
}

Schema ParticleConfig::schema() {
  static const std::vector<Field> fields{
      field<&ParticleConfig::n_particles>("nParticles", "", {1, 1000000}, "particles per track"),
      field<&ParticleConfig::st_alpha>("st_alpha", "1/s", kNotNegative, "damping of those that stand still"),
      field<&ParticleConfig::st_beta>("st_beta", "1/s", kNotNegative, "excitation of those that stand still"),
      field<&ParticleConfig::st_ratio>("st_ratio", "", kUnit, "share of those that stand still"),
      field<&ParticleConfig::ve_alpha>("ve_alpha", "1/s", kNotNegative,
                                       "damping of those that keep their velocity"),
      field<&ParticleConfig::ve_beta>("ve_beta", "1/s", kNotNegative,
                                      "excitation of those that keep their velocity"),
      field<&ParticleConfig::ve_ratio>("ve_ratio", "", kUnit, "share of those that keep their velocity"),
      field<&ParticleConfig::ac_alpha>("ac_alpha", "1/s", kNotNegative, "damping of those that accelerate"),
      field<&ParticleConfig::ac_beta>("ac_beta", "1/s", kNotNegative, "excitation of those that accelerate"),
      field<&ParticleConfig::ac_ratio>("ac_ratio", "", kUnit, "share of those that accelerate"),
      field<&ParticleConfig::n_min>("Nmin", "", kUnit,
                                    "share of effective particles below which they are drawn anew"),
  };
  return fields;
}

Schema SstConfig::schema() {
  static const std::vector<Field> fields{
      field<&SstConfig::mode>("mode", "", kAny, "filter that follows a source",
                              {"kalman", "particle", "bernoulli"}),
      field<&SstConfig::add>("add", "", kAny, "dynamic: sources come and go; static: only the targets",
                             {"dynamic", "static"}),
      field<&SstConfig::active>("active", "", kAny, "Gaussian mixture of E where a source sounds"),
      field<&SstConfig::inactive>("inactive", "", kAny, "Gaussian mixture of E where none does"),
      field<&SstConfig::sigma_r2_prob>("sigmaR2_prob", "", kPositive,
                                       "variance of an observation, track on probation"),
      field<&SstConfig::sigma_r2_active>("sigmaR2_active", "", kPositive,
                                         "variance of an observation, active track"),
      field<&SstConfig::sigma_r2_target>("sigmaR2_target", "", kPositive,
                                         "variance of an observation, target"),
      field<&SstConfig::p_false>("Pfalse", "", kUnit, "prior of a false detection"),
      field<&SstConfig::p_new>("Pnew", "", kUnit, "prior of a new source"),
      field<&SstConfig::p_track>("Ptrack", "", kUnit, "prior of a followed source"),
      field<&SstConfig::theta_new>("theta_new", "", kUnit, "probability over which a track is created"),
      field<&SstConfig::n_prob>("N_prob", "hops", {1, 1000000}, "length of the probation"),
      field<&SstConfig::theta_prob>("theta_prob", "", kUnit, "mean activity that ends the probation well"),
      field<&SstConfig::n_tracks>("nTracks", "", {0, 64},
                                  "tracks at a time; 0: as many as N_inactive has numbers"),
      field<&SstConfig::n_inactive>("N_inactive", "hops", {1, 1000000000},
                                    "patience when 1, 2, ... tracks live; the last number holds for more; "
                                    "its length is the number of tracks, if nTracks does not say it"),
      field<&SstConfig::theta_inactive>("theta_inactive", "", kUnit,
                                        "activity below which a track counts as silent"),
      field<&SstConfig::memory>("memory", "s", kNotNegative,
                                "time within which a source that comes back, at most 15 degrees from where "
                                "its track ended, keeps its id; 0: none does"),
      field<&SstConfig::kalman>("kalman", "", kAny, "the Kalman filter"),
      field<&SstConfig::particle>("particle", "", kAny, "the particle filter"),
      field<&SstConfig::target>("target", "", kAny, "directions that are always followed"),
  };
  return fields;
}

}  // namespace odas
