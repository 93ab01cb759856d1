// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/snap_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "app/mapping/wall_line.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

const double kFacingCosine = std::cos(degrees(10.0));
const double kFirstFacingCosine = std::cos(degrees(35.0));
const double kTurnStep = degrees(0.25);  ///< turns that differ by about as much agree
constexpr double kShortestWall = 0.5;    // [m], and shortest overlap
/// How far a wall's partner may be at first [m], and in the rounds after the most agreed shift.
constexpr double kFirstReach = 3.0;
constexpr std::array<double, 5> kReaches{0.12, 0.12, 0.12, 0.06, 0.06};
/// Shifts are tried so far apart, and walls agree on one within about as much [m]: first all in reach, then those
/// around the best.
constexpr double kCoarseStep = 0.1;
constexpr double kFineStep = 0.02;
/// A direction in which walls tell less than this share of what they tell in the best one is not fixed by them.
constexpr double kLeastShare = 1e-3;

std::vector<WallLine> wallsOf(std::span<const FacedPlane> planes)
{
    std::vector<WallLine> walls;
    for (const FacedPlane& plane : planes) {
        if (const auto wall = wallLine(plane); wall && wall->length() >= kShortestWall)
            walls.push_back(*wall);
    }
    return walls;
}

/// A turn about the vertical through the frame's origin, then a shift; a step of it turns about another centre.
struct LevelMotion {
    double turn = 0.0;  ///< [rad]
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();

    void add(double angle, const Eigen::Vector2d& more, const Eigen::Vector2d& centre)
    {
        shift = Eigen::Rotation2Dd(angle) * (shift - centre) + centre + more;
        turn += angle;
    }
    WallLine operator()(const WallLine& wall) const
    {
        const Eigen::Rotation2Dd rotation(turn);
        WallLine moved;
        moved.normal = rotation * wall.normal;
        moved.from = rotation * wall.from + shift;
        moved.to = rotation * wall.to + shift;
        moved.distance = moved.normal.dot(moved.from);
        return moved;
    }
};

/// The middle of walls, and how far their ends are from it on the whole [m]: what a turn acts on as much as a shift
/// does.
std::pair<Eigen::Vector2d, double> extentOf(const std::vector<WallLine>& walls)
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (const WallLine& wall : walls)
        centre += wall.middle() / static_cast<double>(walls.size());
    double squares = 0.0;
    for (const WallLine& wall : walls)
        squares += (wall.from - centre).squaredNorm() + (wall.to - centre).squaredNorm();
    return {centre, std::sqrt(squares / (2.0 * static_cast<double>(walls.size())))};
}

bool isPartner(const WallLine& wall, const WallLine& other, double reach)
{
    return wall.normal.dot(other.normal) > kFacingCosine && std::abs(other.offset(wall.middle())) < reach &&
           overlapOf(wall, other) >= kShortestWall;
}

/// The nearest wall that one may stand over.
std::optional<WallLine> partnerOf(const WallLine& wall, const std::vector<WallLine>& others, double reach)
{
    std::optional<WallLine> best;
    for (const WallLine& other : others) {
        if (!isPartner(wall, other, reach))
            continue;
        reach = std::abs(other.offset(wall.middle()));
        best = other;
    }
    return best;
}

/// The turn on which most pairs of walls agree, by length: walls of a building are parallel to few directions. Of
/// several the least.
double agreedTurn(const std::vector<WallLine>& walls, const std::vector<WallLine>& others)
{
    std::vector<std::pair<double, double>> turns;  // [rad], and weight [m]
    for (const WallLine& wall : walls) {
        for (const WallLine& other : others) {
            if (wall.normal.dot(other.normal) < kFirstFacingCosine)
                continue;
            const double sine = wall.normal.x() * other.normal.y() - wall.normal.y() * other.normal.x();
            turns.emplace_back(std::asin(std::clamp(sine, -1.0, 1.0)), std::min(wall.length(), other.length()));
        }
    }
    std::ranges::sort(turns);
    double best = 0.0;
    double most = 0.0;
    for (const auto& [turn, weight] : turns) {
        double agreed = 0.0;
        double sum = 0.0;
        for (auto near = std::ranges::lower_bound(turns, std::pair(turn - kTurnStep, 0.0));
             near != turns.end() && near->first <= turn + kTurnStep; ++near) {
            agreed += near->second;
            sum += near->second * near->first;
        }
        if (agreed > most * (1.0 + 1e-9) || (agreed > most * (1.0 - 1e-9) && std::abs(sum / agreed) < std::abs(best))) {
            most = std::max(most, agreed);
            best = sum / agreed;
        }
    }
    return best;
}

/// By how much one wall wants a floor to shift to stand over another.
struct ShiftVote {
    Eigen::Vector2d normal;
    double shift = 0.0;   ///< along it [m]
    double weight = 0.0;  ///< how far both are beside each other [m]
};

/// Of each wall that has partners in reach.
std::vector<std::vector<ShiftVote>> shiftVotes(const std::vector<WallLine>& walls, const std::vector<WallLine>& others)
{
    std::vector<std::vector<ShiftVote>> votes;
    for (const WallLine& wall : walls) {
        std::vector<ShiftVote> ofWall;
        for (const WallLine& other : others) {
            if (isPartner(wall, other, kFirstReach))
                ofWall.push_back({other.normal, -other.offset(wall.middle()), overlapOf(wall, other)});
        }
        if (!ofWall.empty())
            votes.push_back(std::move(ofWall));
    }
    return votes;
}

/// How many metres of walls agree on a shift, each with the partner that agrees best.
double agreementOn(const Eigen::Vector2d& shift, double within, const std::vector<std::vector<ShiftVote>>& votes)
{
    double agreed = 0.0;
    for (const std::vector<ShiftVote>& ofWall : votes) {
        double best = 0.0;
        for (const ShiftVote& vote : ofWall)
            best =
                std::max(best, vote.weight * std::exp(-0.5 * square((vote.normal.dot(shift) - vote.shift) / within)));
        agreed += best;
    }
    return agreed;
}

/// The shift around one on which most walls agree; of several the nearest.
Eigen::Vector2d bestShift(const Eigen::Vector2d& around, double reach, double step,
                          const std::vector<std::vector<ShiftVote>>& votes)
{
    const int steps = static_cast<int>(std::lround(reach / step));
    Eigen::Vector2d best = around;
    double most = agreementOn(around, step, votes);
    for (int x = -steps; x <= steps; ++x) {
        for (int y = -steps; y <= steps; ++y) {
            const Eigen::Vector2d shift = around + step * Eigen::Vector2d(x, y);
            const double agreed = agreementOn(shift, step, votes);
            const bool isAsGood = agreed > most * (1.0 - 1e-9);
            if (agreed > most * (1.0 + 1e-9) || (isAsGood && shift.norm() < best.norm())) {
                most = std::max(most, agreed);
                best = shift;
            }
        }
    }
    return best;
}

}  // namespace

Result<FloorSnap> snapFloor(std::span<const FacedPlane> floor, std::span<const FacedPlane> onto)
{
    const std::vector<WallLine> walls = wallsOf(floor);
    const std::vector<WallLine> others = wallsOf(onto);
    const auto [middle, radius] = walls.empty() ? std::pair(Eigen::Vector2d(0.0, 0.0), 1.0) : extentOf(walls);
    LevelMotion motion;
    motion.add(agreedTurn(walls, others), Eigen::Vector2d::Zero(), middle);
    std::vector<WallLine> turned = walls;
    std::ranges::transform(turned, turned.begin(), motion);
    // Floors differ in their rooms: the nearest wall is not always the one that goes on above.
    const auto votes = shiftVotes(turned, others);
    const Eigen::Vector2d coarse = bestShift(Eigen::Vector2d::Zero(), kFirstReach, kCoarseStep, votes);
    motion.add(0.0, bestShift(coarse, kCoarseStep, kFineStep, votes), middle);
    FloorSnap snap;
    for (const double reach : kReaches) {
        // Of the turn, as far as it moves what is at the radius, and the shift: each wall's ends against its partner's
        // line; a metre of wall counts once.
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        const Eigen::Vector2d centre = Eigen::Rotation2Dd(motion.turn) * middle + motion.shift;
        snap.walls = 0;
        double squares = 0.0;
        for (const WallLine& wall : walls) {
            const WallLine moved = motion(wall);
            const auto partner = partnerOf(moved, others, reach);
            if (!partner)
                continue;
            ++snap.walls;
            squares += square(partner->offset(moved.middle()));
            for (const Eigen::Vector2d& end : {moved.from, moved.to}) {
                const Eigen::Vector2d arm = (end - centre) / radius;
                const Eigen::Vector3d row(partner->normal.dot(Eigen::Vector2d(-arm.y(), arm.x())), partner->normal.x(),
                                          partner->normal.y());
                const double off = partner->offset(end);
                information += moved.length() * row * row.transpose();
                gradient += moved.length() * off * row;
            }
        }
        if (snap.walls == 0)
            return fail(
                ErrorCode::Usage,
                "No wall of the floor stands within three metres of a wall of the other one. Move the floor nearer "
                "first.");
        snap.rms = std::sqrt(squares / snap.walls);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(information);
        const double least = kLeastShare * axes.eigenvalues()[2];
        Eigen::Vector3d step = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (axes.eigenvalues()[i] > least)
                step -= axes.eigenvectors().col(i).dot(gradient) / axes.eigenvalues()[i] * axes.eigenvectors().col(i);
        }
        snap.isFixed = axes.eigenvalues()[0] > least;
        motion.add(step[0] / radius, step.tail<2>(), centre);
    }
    snap.motion.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(motion.turn, Eigen::Vector3d::UnitZ()));
    snap.motion.translation = {motion.shift.x(), motion.shift.y(), 0.0};
    std::vector<FacedPlane> there(floor.begin(), floor.end());
    std::ranges::transform(there, there.begin(), [&](const FacedPlane& plane) { return moved(plane, snap.motion); });
    snap.height = snapHeight(there, onto);
    if (snap.height)
        snap.motion.translation.z() = snap.height->lift;
    return snap;
}

}  // namespace planewright
