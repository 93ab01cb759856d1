// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/map_report.h"

#include <algorithm>
#include <cmath>

#include "app/cli/text.h"
#include "app/mapping/stop_words.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

std::string placeText(const Pose& pose)
{
    const Eigen::Vector3d& t = pose.translation;
    return fixedText(t.x(), 2) + " " + fixedText(t.y(), 2) + " " + fixedText(t.z(), 2);
}

}  // namespace

std::string mapTable(std::span<const MappedFloor> floors, std::span<const StopScan> stops)
{
    std::vector<std::vector<std::string>> rows{
        {"stop", "floor", "x y z [m]", "sigma [mm]", "sigma [deg]", "matched", "new", "open", "rests on", "scan"}};
    for (const MappedFloor& floor : floors) {
        const BuildingMap& map = floor.builder.map();
        for (std::size_t i = 0; i < map.stops.size(); ++i) {
            const MapStop& stop = map.stops[i];
            const auto count = [&](MatchState state) {
                return std::to_string(std::ranges::count(stop.matches, state, &MapMatch::state));
            };
            const Eigen::Matrix<double, 6, 1> variances = stop.covariance.diagonal();
            const double shift = std::sqrt(variances.tail<3>().maxCoeff());
            const double turn = std::sqrt(variances.head<3>().maxCoeff());
            rows.push_back({std::to_string(stop.stop->id), std::to_string(floor.floor),
                            stop.isPlaced() ? placeText(floor.frame * stop.pose) : "",
                            stop.isPlaced() ? fixedText(1e3 * shift, 1) : "",
                            stop.isPlaced() ? fixedText(toDegrees(turn), 3) : "", count(MatchState::Matched),
                            count(MatchState::New), count(MatchState::Open), trustText(stop.trust),
                            stops[static_cast<std::size_t>(stop.stop->id)].name});
        }
    }
    return tableText(rows);
}

std::vector<std::string> mapWarnings(std::span<const MappedFloor> floors, std::span<const StopScan> stops)
{
    std::vector<std::string> warnings;
    for (const MappedFloor& floor : floors) {
        warnings.insert(warnings.end(), floor.problems.begin(), floor.problems.end());
        for (const MapStop& stop : floor.builder.map().stops) {
            if (const std::string warning = warningOf(stop); !warning.empty())
                warnings.push_back("stop " + std::to_string(stop.stop->id) + " (" +
                                   stops[static_cast<std::size_t>(stop.stop->id)].name + "): " + warning);
        }
    }
    return warnings;
}

}  // namespace planewright
