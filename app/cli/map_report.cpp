// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/map_report.h"

#include <algorithm>
#include <cmath>

#include "app/cli/text.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// A stop whose place planes tell no better than this is said to be odometry's along that direction [m].
constexpr double kWellKnown = 0.05;

std::string trustText(StopTrust trust)
{
    switch (trust) {
        case StopTrust::First:
            return "first";
        case StopTrust::Planes:
            return "planes";
        case StopTrust::OdometryDecides:
            return "odometry decides";
        case StopTrust::AgainstOdometry:
            return "planes against odometry";
        case StopTrust::OdometryAlone:
            return "odometry alone";
        case StopTrust::Unplaced:
            break;
    }
    return "not placed";
}

std::string placeText(const Pose& pose)
{
    const Eigen::Vector3d& t = pose.translation;
    return fixedText(t.x(), 2) + " " + fixedText(t.y(), 2) + " " + fixedText(t.z(), 2);
}

/// The direction in which planes know a stop worst, where that is badly.
std::string weakDirection(const MapStop& stop)
{
    const AxisStrength& shift = stop.strength.shift;
    if (shift.weakestSigma && *shift.weakestSigma <= kWellKnown)
        return {};
    const Eigen::Vector3d& weak = shift.weakest;
    return "(" + fixedText(weak.x(), 2) + " " + fixedText(weak.y(), 2) + " " + fixedText(weak.z(), 2) + ")";
}

std::string warningOf(const MapStop& stop)
{
    const std::string others = std::to_string(stop.alternatives.size());
    switch (stop.trust) {
        case StopTrust::First:
            return {};
        case StopTrust::Unplaced:
            return stop.alternatives.empty()
                       ? "its planes fix no place in the map; it is left out. Give its odometry, or scan nearer"
                       : "its planes fit " + others +
                             " places in the map and nothing tells which; it is left out. "
                             "Give its odometry";
        case StopTrust::OdometryAlone:
            return "too few of its planes are in the map; it is where odometry says, unchecked. Scan once more between";
        case StopTrust::OdometryDecides:
            return "its planes would fit " + others +
                   (stop.alternatives.size() == 1 ? " other place" : " other places") +
                   " as well; odometry alone tells which";
        case StopTrust::AgainstOdometry:
            return "its planes tell of another place than odometry, which is left out";
        case StopTrust::Planes:
            break;
    }
    if (!stop.loopRivals.empty())
        return "it may be back where the map was before, but its planes fit " + std::to_string(stop.loopRivals.size()) +
               " places there; the loop is left open. Scan once more near by";
    if (const std::string weak = weakDirection(stop); !weak.empty())
        return "its planes do not fix it along " + weak + "; odometry does";
    return {};
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
                return std::to_string(std::ranges::count(stop.matches, state, &PlaneMatch::state));
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
        for (const MapStop& stop : floor.builder.map().stops) {
            if (const std::string warning = warningOf(stop); !warning.empty())
                warnings.push_back("stop " + std::to_string(stop.stop->id) + " (" +
                                   stops[static_cast<std::size_t>(stop.stop->id)].name + "): " + warning);
        }
    }
    return warnings;
}

}  // namespace planewright
