// SPDX-License-Identifier: MIT
#include "odas/localization/search_plan.hpp"

#include <algorithm>
#include <cstdlib>

#include "odas/array/directivity.hpp"
#include "odas/base/error.hpp"
#include "odas/localization/delta_training.hpp"
#include "odas/localization/kernels.hpp"
#include "odas/localization/links.hpp"
#include "odas/localization/scan_level.hpp"

namespace odas {
namespace {

/// The pairs that hear at least one direction of at least one level.
std::vector<Pair> pairs_that_hear(const std::vector<Pair>& pairs, const std::vector<ScanLevel>& levels) {
  std::vector<Pair> used;
  for (std::size_t q = 0; q < pairs.size(); ++q) {
    const bool hears = std::any_of(levels.begin(), levels.end(), [q](const ScanLevel& level) {
      return std::any_of(level.active_points().begin(), level.active_points().end(),
                         [&](std::size_t u) { return level.mask(u)[q] != 0; });
    });
    if (hears) used.push_back(pairs[q]);
  }
  return used;
}

std::vector<ScanLevel> make_levels(const GeneralConfig& general, const SslConfig& ssl,
                                   const Directivity& directivity, std::span<const Pair> pairs) {
  std::vector<ScanLevel> levels;
  for (const ScanConfig& scan : ssl.scans) {
    levels.emplace_back(general, directivity, pairs, scan.level, ssl.interp_rate);
  }
  return levels;
}

SearchPlan::Cell make_cell(const ScanLevel& level, const std::vector<std::size_t>& points,
                           const SearchPlan& plan) {
  SearchPlan::Cell cell;
  cell.columns = Grid<std::uint16_t>(level.pairs(), padded(points.size()));
  cell.columns.fill(static_cast<std::uint16_t>(plan.zero_column()));
  for (std::size_t c = 0; c < points.size(); ++c) {
    const std::size_t u = points[c];
    cell.points.push_back(static_cast<std::uint32_t>(u));
    cell.pairs.push_back(static_cast<float>(level.active_pairs(u)));
    for (std::size_t q = 0; q < level.pairs(); ++q) {
      if (level.mask(u)[q] == 0) continue;
      cell.columns[q][c] = static_cast<std::uint16_t>(static_cast<int>(plan.half_lags) + level.lags(u)[q]);
    }
  }
  return cell;
}

std::size_t bytes_of(const SearchPlan& plan) {
  std::size_t bytes = plan.fine_lags.rows() * plan.fine_lags.cols() * (sizeof(std::int16_t) + 1);
  for (const auto& level : plan.levels) {
    bytes += level.directions.size() * sizeof(Vec3);
    for (const auto& cell : level.cells) {
      bytes += cell.points.size() * (sizeof(std::uint32_t) + sizeof(float)) +
               cell.columns.rows() * cell.columns.cols() * sizeof(std::uint16_t);
    }
  }
  return bytes;
}

}  // namespace

std::size_t SearchPlan::zero_column() const noexcept { return 2 * half_lags + 1 + kKernelLanes; }

SearchPlan::SearchPlan(const GeneralConfig& general, const SslConfig& ssl) {
  const Directivity directivity(general);
  const std::vector<Pair> every_pair = all_pairs(general.mics.size());
  std::vector<ScanLevel> scans = make_levels(general, ssl, directivity, every_pair);
  pairs = pairs_that_hear(every_pair, scans);
  if (pairs.empty()) {
    throw ConfigError("general.spatialfilters",
                      "no direction is heard by two microphones at once: widen general.mics[].angle or "
                      "general.spatialfilters[].angle, or lower general.gainMin");
  }
  if (pairs.size() < every_pair.size()) scans = make_levels(general, ssl, directivity, pairs);

  std::vector<std::vector<int>> deltas;
  int reach = 0;
  for (std::size_t l = 0; l < scans.size(); ++l) {
    const int fixed = ssl.scans[l].delta;
    deltas.push_back(fixed < 0 ? train_deltas(general, ssl, scans[l], pairs)
                               : std::vector<int>(pairs.size(), fixed));
    for (std::size_t q = 0; q < pairs.size(); ++q) {
      reach = std::max(reach, std::max(scans[l].max_lag(q), -scans[l].min_lag(q)) + deltas[l][q]);
    }
  }
  half_lags = static_cast<std::size_t>(reach);
  row_size = zero_column() + 1 + kKernelLanes;

  // A coarse direction from which nothing finer can be reached is no use as a winner.
  std::vector<std::vector<std::vector<std::size_t>>> links(scans.size());
  for (std::size_t l = 0; l + 1 < scans.size(); ++l) {
    links[l] = link_levels(scans[l], deltas[l], scans[l + 1], deltas[l + 1], ssl.n_matches);
  }
  const auto searchable = [&](std::size_t l, std::vector<std::size_t> points) {
    if (l + 1 < scans.size()) std::erase_if(points, [&](std::size_t u) { return links[l][u].empty(); });
    return points;
  };
  for (std::size_t l = 0; l < scans.size(); ++l) {
    Level& level = levels.emplace_back();
    const ScanLevel& scan = scans[l];
    level.number = ssl.scans[l].level;
    level.directions.assign(scan.grid().points().begin(), scan.grid().points().end());
    level.active_points = scan.active_points().size();
    for (std::size_t q = 0; q < pairs.size(); ++q) {
      level.deltas.push_back(static_cast<std::size_t>(deltas[l][q]));
      level.first.push_back(static_cast<std::size_t>(reach + scan.min_lag(q)));
      level.last.push_back(static_cast<std::size_t>(reach + scan.max_lag(q)));
    }
    if (l == 0) {
      level.cells.push_back(make_cell(scan, searchable(l, scan.active_points()), *this));
    } else {
      for (const auto& points : links[l - 1])
        level.cells.push_back(make_cell(scan, searchable(l, points), *this));
    }
    summary.scans.push_back({level.number, level.directions.size(), level.active_points});
  }

  const ScanLevel& finest = scans.back();
  fine_lags = Grid<std::int16_t>(finest.grid().size(), pairs.size());
  fine_heard = Grid<std::uint8_t>(finest.grid().size(), pairs.size());
  for (std::size_t u = 0; u < fine_lags.rows(); ++u) {
    std::copy(finest.lags(u).begin(), finest.lags(u).end(), fine_lags[u].begin());
    std::copy(finest.mask(u).begin(), finest.mask(u).end(), fine_heard[u].begin());
  }
  summary.pairs = every_pair.size();
  summary.pairs_used = pairs.size();
  summary.lags = 2 * half_lags + 1;
  summary.half_sphere = directivity.half_sphere();
  summary.heard_share =
      static_cast<double>(finest.active_points().size()) / static_cast<double>(finest.grid().size());
  summary.memory_bytes = bytes_of(*this);
}

}  // namespace odas
