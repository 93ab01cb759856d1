// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/stop_words.h"

#include "core/types/angle_text.h"

namespace planewright {

namespace {

/// A stop whose place planes tell no better than this is said to be odometry's along that direction [m].
constexpr double kWellKnown = 0.05;

/// The direction in which planes know a stop worst, where that is badly.
std::string weakDirection(const MapStop& stop)
{
    const AxisStrength& shift = stop.strength.shift;
    if (shift.weakestSigma && *shift.weakestSigma <= kWellKnown)
        return {};
    const Eigen::Vector3d& weak = shift.weakest;
    return "(" + fixedText(weak.x(), 2) + " " + fixedText(weak.y(), 2) + " " + fixedText(weak.z(), 2) + ")";
}

bool hasOdometry(const MapStop& stop)
{
    return stop.stop && stop.stop->odometry;
}

std::string otherPlaces(const MapStop& stop)
{
    const std::size_t places = stop.alternatives.size();
    return std::to_string(places) + (places == 1 ? " other place" : " other places");
}

std::string whyUnplaced(const MapStop& stop)
{
    const std::size_t places = stop.alternatives.size();
    if (places > 0 && hasOdometry(stop))
        return "its planes fit " + otherPlaces(stop) + " in the map better than that of odometry, but not clearly so";
    if (places > 1)
        return "its planes fit " + std::to_string(places) + " places in the map and nothing tells which";
    return places == 1 ? "its planes fit a place in the map but do not fix it there"
                       : "its planes fix no place in the map";
}

}  // namespace

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

std::string warningOf(const MapStop& stop)
{
    switch (stop.trust) {
        case StopTrust::First:
            return {};
        case StopTrust::Unplaced:
            return whyUnplaced(stop) + "; it is left out. " +
                   (hasOdometry(stop) ? "Check its odometry, or scan once more between"
                                      : "Give its odometry, or scan nearer");
        case StopTrust::OdometryAlone:
            return "too few of its planes are in the map; it is where odometry says, unchecked. Scan once more between";
        case StopTrust::OdometryDecides:
            return "its planes would fit " + otherPlaces(stop) + " as well; odometry alone tells which";
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

}  // namespace planewright
