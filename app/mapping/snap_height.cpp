// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/snap_height.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "app/mapping/wall_line.h"
#include "core/geometry/polygon_union.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

const double kAlikeCosine = std::cos(degrees(10.0));
constexpr double kReach = 1.5;            // [m]
constexpr double kLowestStorey = 1.0;     // [m]
constexpr double kLowestRiser = 0.05;     // as it is seen; from below a tread hides its foot [m]
constexpr double kHighestRiser = 0.4;     // [m]
constexpr double kNarrowestRiser = 0.4;   // [m]
constexpr double kBesideRiser = 0.1;      // how far the same riser may be off: less than half a tread [m]
constexpr double kLeastOverlap = 0.5;     // of the smaller surface that lies over or along the other
constexpr double kSmallestLevel = 0.02;   // [m²]
constexpr double kSameHeight = 0.05;      // a plane so little above the one to stand on belongs to it [m]
constexpr double kLevelDeviation = 0.01;  // of level planes' heights [m]
constexpr double kRiserDeviation = 0.03;  // of risers' tops, which end with a slice [m]
constexpr double kAgreement = 0.03;       // heights are the same within about as much [m]

/// What can be stood on, from above, and its height in its middle.
struct LevelSurface {
    std::vector<PlanarRing> rings;
    double area = 0.0;
    Eigen::Vector2d middle;
    Eigen::Vector3d normal;
    double distance = 0.0;

    double heightAt(const Eigen::Vector2d& place) const
    {
        return (distance - normal.head<2>().dot(place)) / normal.z();
    }
    double height() const { return heightAt(middle); }
};

/// The front of a step.
struct Riser {
    WallLine line;
    double top = 0.0;  ///< [m]
};

PlanarRing fromAbove(const std::vector<Eigen::Vector3d>& ring)
{
    PlanarRing corners;
    for (const Eigen::Vector3d& corner : ring)
        corners.emplace_back(corner.head<2>());
    return corners;
}

std::vector<LevelSurface> levelSurfaces(std::span<const FacedPlane> planes)
{
    std::vector<LevelSurface> surfaces;
    for (const FacedPlane& plane : planes) {
        if (plane.normal.z() > -kAlikeCosine)
            continue;
        const Outline outline = outlineOf(plane.parts, plane.normal, plane.distance);
        if (outline.area < kSmallestLevel)
            continue;
        LevelSurface& surface = surfaces.emplace_back();
        surface.area = outline.area * -plane.normal.z();
        surface.middle = outline.centroid.head<2>();
        surface.normal = plane.normal;
        surface.distance = plane.distance;
        for (const Outline::Polygon& part : plane.parts) {
            surface.rings.push_back(fromAbove(part.ring));
            std::ranges::transform(part.holes, std::back_inserter(surface.rings), fromAbove);
        }
    }
    return surfaces;
}

std::vector<Riser> risers(std::span<const FacedPlane> planes)
{
    std::vector<Riser> found;
    for (const FacedPlane& plane : planes) {
        const std::optional<WallLine> line = wallLine(plane);
        if (!line || line->length() < kNarrowestRiser)
            continue;
        Eigen::AlignedBox1d heights;
        for (const Outline::Polygon& part : plane.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                heights.extend(corner.tail<1>());
        }
        const double seen = heights.sizes().x();
        if (seen >= kLowestRiser && seen <= kHighestRiser)
            found.push_back({*line, heights.max().x()});
    }
    return found;
}

/// What a floor is walked on: the largest surface.
std::optional<LevelSurface> groundOf(const std::vector<LevelSurface>& surfaces)
{
    const auto largest = std::ranges::max_element(surfaces, {}, &LevelSurface::area);
    return largest == surfaces.end() ? std::nullopt : std::optional(*largest);
}

/// By how much one surface wants a floor to be lifted to be at the height of another.
struct LiftVote {
    double lift = 0.0;       ///< [m]
    double deviation = 0.0;  ///< [m]
};

/// Of one surface: a vote for each partner in reach.
using Votes = std::vector<LiftVote>;

std::optional<LiftVote> voteOf(const LevelSurface& surface, const LevelSurface& other)
{
    const LevelSurface& smaller = surface.area < other.area ? surface : other;
    const double lift = other.heightAt(smaller.middle) - surface.heightAt(smaller.middle);
    if (std::abs(lift) > kReach || sharedArea(surface.rings, other.rings) < kLeastOverlap * smaller.area)
        return std::nullopt;
    return LiftVote{lift, kLevelDeviation};
}

std::optional<LiftVote> voteOf(const Riser& riser, const Riser& other)
{
    const double lift = other.top - riser.top;
    if (riser.line.normal.dot(other.line.normal) < kAlikeCosine ||
        std::abs(other.line.offset(riser.line.middle())) > kBesideRiser ||
        overlapOf(riser.line, other.line) < kLeastOverlap * std::min(riser.line.length(), other.line.length()) ||
        std::abs(lift) > kReach)
        return std::nullopt;
    return LiftVote{lift, kRiserDeviation};
}

template <typename Surface>
void collectVotes(const std::vector<Surface>& surfaces, const std::vector<Surface>& others, std::vector<Votes>& votes)
{
    for (const Surface& surface : surfaces) {
        Votes ofSurface;
        for (const Surface& other : others) {
            if (const auto vote = voteOf(surface, other))
                ofSurface.push_back(*vote);
        }
        if (!ofSurface.empty())
            votes.push_back(std::move(ofSurface));
    }
}

/// How well a vote agrees with a lift: 1 where it is the same.
double agreement(const LiftVote& vote, double lift)
{
    return std::exp(-0.5 * square((vote.lift - lift) / kAgreement));
}

const LiftVote& nearestVote(const Votes& votes, double lift)
{
    return *std::ranges::min_element(votes, {}, [&](const LiftVote& vote) { return std::abs(vote.lift - lift); });
}

/// The vote on which most surfaces agree; of several the least.
std::optional<double> agreedLift(const std::vector<Votes>& votes, double least, double most)
{
    std::optional<double> best;
    double agreed = 0.0;
    for (const Votes& candidates : votes) {
        for (const LiftVote& candidate : candidates) {
            if (candidate.lift < least || candidate.lift > most)
                continue;
            double sum = 0.0;
            for (const Votes& ofSurface : votes)
                sum += agreement(nearestVote(ofSurface, candidate.lift), candidate.lift);
            const bool isAsGood = sum > agreed * (1.0 - 1e-9);
            if (sum > agreed * (1.0 + 1e-9) || (isAsGood && std::abs(candidate.lift) < std::abs(*best))) {
                agreed = std::max(agreed, sum);
                best = candidate.lift;
            }
        }
    }
    return best;
}

/// The mean of the votes around a lift, those that agree better and are known better counting for more.
HeightSnap refined(double lift, const std::vector<Votes>& votes)
{
    HeightSnap snap;
    snap.lift = lift;
    constexpr int kRounds = 5;
    for (int round = 0; round < kRounds; ++round) {
        double sum = 0.0;
        double weights = 0.0;
        double squares = 0.0;
        int surfaces = 0;
        for (const Votes& ofSurface : votes) {
            const LiftVote& vote = nearestVote(ofSurface, snap.lift);
            if (std::abs(vote.lift - snap.lift) > 2.0 * kAgreement)
                continue;
            const double weight = agreement(vote, snap.lift) / square(vote.deviation);
            sum += weight * vote.lift;
            weights += weight;
            squares += square(vote.lift - snap.lift);
            ++surfaces;
        }
        if (surfaces == 0)
            break;
        snap = {sum / weights, surfaces, std::sqrt(squares / surfaces)};
    }
    return snap;
}

}  // namespace

std::optional<HeightSnap> snapHeight(std::span<const FacedPlane> floor, std::span<const FacedPlane> onto)
{
    std::vector<LevelSurface> levels = levelSurfaces(floor);
    std::vector<LevelSurface> otherLevels = levelSurfaces(onto);
    std::vector<Riser> fronts = risers(floor);
    std::vector<Riser> otherFronts = risers(onto);
    const auto ground = groundOf(levels);
    const auto otherGround = groundOf(otherLevels);
    if (!ground || !otherGround)
        return std::nullopt;
    const double apart = ground->height() - otherGround->height();
    if (std::abs(apart) < kLowestStorey)
        return std::nullopt;

    // What the upper one sees above its floor is its own.
    const bool isUpper = apart > 0.0;
    const LevelSurface& upperGround = isUpper ? *ground : *otherGround;
    const auto isAbove = [&](double height, const Eigen::Vector2d& place) {
        return height > upperGround.heightAt(place) + kSameHeight;
    };
    std::erase_if(isUpper ? levels : otherLevels,
                  [&](const LevelSurface& surface) { return isAbove(surface.height(), surface.middle); });
    std::erase_if(isUpper ? fronts : otherFronts,
                  [&](const Riser& riser) { return isAbove(riser.top, riser.line.from); });
    std::vector<Votes> votes;
    collectVotes(levels, otherLevels, votes);
    collectVotes(fronts, otherFronts, votes);

    const double least = isUpper ? kLowestStorey - apart : -kReach;
    const double most = isUpper ? kReach : -kLowestStorey - apart;
    const auto agreed = agreedLift(votes, least, most);
    return agreed ? std::optional(refined(*agreed, votes)) : std::nullopt;
}

}  // namespace planewright
