// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/mapping/simulated_floor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/geometry/minimum_rectangle.h"
#include "core/geometry/polygon_union.h"
#include "core/geometry/tangents.h"
#include "core/mapping/uncertain_plane.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kCeiling = 2.8;
constexpr double kDoorWidth = 0.9;
constexpr double kDoorHeight = 2.1;
constexpr double kHalfCorridor = 1.2;
const Eigen::Vector2d kRing{20.0, 10.0};

Eigen::Vector3d at(const Eigen::Vector2d& place, double height)
{
    return {place.x(), place.y(), height};
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& way)
{
    return {-way.y(), way.x()};
}

/// A room behind a stretch of wall that runs from a to b with the room on its right, and what stands in it.
void addRoom(FloorPlan& plan, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double thickness, double depth,
             Random& random)
{
    const Eigen::Vector2d way = (b - a).normalized();
    const Eigen::Vector2d in = -leftOf(way);
    const double side = 0.1;
    const Eigen::Vector2d nearA = a + side * way + thickness * in;
    const Eigen::Vector2d nearB = b - side * way + thickness * in;
    // One room in two has a slanted back.
    const double slant = random.uniform() < 0.5 ? random.uniform(0.2, 0.6) : 0.0;
    const Eigen::Vector2d farA = nearA + depth * in;
    const Eigen::Vector2d farB = nearB + (depth + slant) * in;
    plan.addWall(nearA, farA, 0.0, kCeiling);
    plan.addWall(farA, farB, 0.0, kCeiling);
    plan.addWall(farB, nearB, 0.0, kCeiling);
    for (int i = 0; i < 2; ++i) {
        const double along = random.uniform(0.2, 0.8);
        const Eigen::Vector2d middle = nearA + along * (nearB - nearA) + random.uniform(0.5, 0.85) * depth * in;
        const double width = random.uniform(0.5, 1.2);
        const double length = random.uniform(0.4, 0.8);
        const double height = random.uniform(0.7, 1.9);
        const double turn = random.uniform(-0.3, 0.3);
        plan.addBox(middle, {width, length}, height, turn);
    }
}

/// A side of the ring: the corridor's outer wall from a to b with the corridor on its left, rooms behind.
void addSide(FloorPlan& plan, const Eigen::Vector2d& a, const Eigen::Vector2d& b, Random& random)
{
    const double length = (b - a).norm();
    const Eigen::Vector2d way = (b - a) / length;
    const double thickness = 0.15;
    std::vector<double> doors;
    double from = 0.2;
    while (from + 3.0 < length) {
        const double width = std::min(random.uniform(3.0, 5.5), length - from - 0.2);
        const double door = from + random.uniform(0.8, width - 0.8);
        doors.push_back(door / length);
        const double depth = random.uniform(3.0, 5.0);
        addRoom(plan, a + from * way, a + (from + width) * way, thickness, depth, random);
        from += width;
    }
    plan.addWallWithDoors(a, b, kCeiling, thickness, doors);
}

}  // namespace

void FloorPlan::addFace(const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU, const Eigen::Vector3d& edgeV,
                        const Eigen::Vector3d& normal)
{
    const double distance = normal.dot(corner);
    const auto same = std::ranges::find_if(planes_, [&](const OrientedPlane& plane) {
        return (plane.normal - normal).norm() < 1e-9 && std::abs(plane.distance - distance) < 1e-9;
    });
    const int number = static_cast<int>(same - planes_.begin());
    if (same == planes_.end())
        planes_.push_back({normal, distance});
    faces_.push_back({number, corner, edgeU, edgeV});
}

void FloorPlan::addWall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bottom, double top)
{
    const Eigen::Vector2d way = b - a;
    addFace(at(a, bottom), at(way, 0.0), {0.0, 0.0, top - bottom}, -at(leftOf(way.normalized()), 0.0));
}

void FloorPlan::addLevel(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height, bool seenFromAbove)
{
    addFace(at(low, height), {high.x() - low.x(), 0.0, 0.0}, {0.0, high.y() - low.y(), 0.0},
            seenFromAbove ? Eigen::Vector3d(-Eigen::Vector3d::UnitZ()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
}

void FloorPlan::addBox(const Eigen::Vector2d& middle, const Eigen::Vector2d& size, double height, double turn)
{
    const Eigen::Rotation2Dd rotation(turn);
    const Eigen::Vector2d u = rotation * Eigen::Vector2d(0.5 * size.x(), 0.0);
    const Eigen::Vector2d v = rotation * Eigen::Vector2d(0.0, 0.5 * size.y());
    // Clockwise seen from above: the outside is on the left.
    addWall(middle - u - v, middle - u + v, 0.0, height);
    addWall(middle - u + v, middle + u + v, 0.0, height);
    addWall(middle + u + v, middle + u - v, 0.0, height);
    addWall(middle + u - v, middle - u - v, 0.0, height);
    addFace(at(middle - u - v, height), at(2.0 * u, 0.0), at(2.0 * v, 0.0), -Eigen::Vector3d::UnitZ());
}

void FloorPlan::addWallWithDoors(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double top, double thickness,
                                 const std::vector<double>& doors, bool closed)
{
    const double length = (b - a).norm();
    const Eigen::Vector2d way = (b - a) / length;
    const Eigen::Vector2d in = -thickness * leftOf(way);
    const auto both = [&](double from, double to, double bottom, double height) {
        addWall(a + from * way, a + to * way, bottom, height);
        addWall(a + to * way + in, a + from * way + in, bottom, height);
    };
    double from = 0.0;
    for (const double door : doors) {
        const double left = door * length - 0.5 * kDoorWidth;
        const double right = left + kDoorWidth;
        both(from, left, 0.0, top);
        both(left, right, kDoorHeight, top);
        addWall(a + left * way, a + left * way + in, 0.0, kDoorHeight);
        addWall(a + right * way + in, a + right * way, 0.0, kDoorHeight);
        if (closed)
            addWall(a + left * way + in, a + right * way + in, 0.0, kDoorHeight);
        from = right;
    }
    both(from, length, 0.0, top);
}

FloorPlan ringFloor(std::uint64_t seed)
{
    Random random(seed, 1);
    FloorPlan plan;
    plan.addLevel({-8.0, -8.0}, {kRing.x() + 8.0, kRing.y() + 8.0}, 0.0, true);
    plan.addLevel({-8.0, -8.0}, {kRing.x() + 8.0, kRing.y() + 8.0}, kCeiling, false);
    // The core, seen from outside: clockwise.
    const double h = kHalfCorridor;
    const Eigen::Vector2d inner[4] = {{h, h}, {h, kRing.y() - h}, {kRing.x() - h, kRing.y() - h}, {kRing.x() - h, h}};
    for (int i = 0; i < 4; ++i) {
        const double length = (inner[(i + 1) % 4] - inner[i]).norm();
        std::vector<double> doors;
        for (double at = random.uniform(1.0, 2.5); at < length - 1.0; at += random.uniform(2.0, 5.0))
            doors.push_back(at / length);
        plan.addWallWithDoors(inner[i], inner[(i + 1) % 4], kCeiling, random.uniform(0.05, 0.1), doors, true);
    }
    // Pillars on the core's long sides, out into the corridor.
    for (const double y : {h, kRing.y() - h}) {
        for (double x = random.uniform(2.0, 4.0); x < kRing.x() - 2.0; x += random.uniform(3.0, 6.0)) {
            const double width = random.uniform(0.3, 0.6);
            plan.addBox({x, y}, {width, 0.4}, kCeiling, 0.0);
        }
    }
    // The outer walls, the corridor on their left: counter-clockwise.
    const Eigen::Vector2d outer[4] = {
        {-h, -h}, {kRing.x() + h, -h}, {kRing.x() + h, kRing.y() + h}, {-h, kRing.y() + h}};
    for (int i = 0; i < 4; ++i)
        addSide(plan, outer[i], outer[(i + 1) % 4], random);
    return plan;
}

std::vector<Pose> ringRoute(int stops, std::uint64_t seed)
{
    Random random(seed, 2);
    std::vector<Pose> route;
    const double around = 2.0 * (kRing.x() + kRing.y());
    for (int i = 0; i < stops; ++i) {
        const double way = around * (i + 0.5) / stops;
        Eigen::Vector2d place;
        double heading = 0.0;
        if (way < kRing.x()) {
            place = {way, 0.0};
        } else if (way < kRing.x() + kRing.y()) {
            place = {kRing.x(), way - kRing.x()};
            heading = degrees(90.0);
        } else if (way < 2.0 * kRing.x() + kRing.y()) {
            place = {2.0 * kRing.x() + kRing.y() - way, kRing.y()};
            heading = degrees(180.0);
        } else {
            place = {0.0, around - way};
            heading = degrees(270.0);
        }
        place.x() += random.uniform(-0.3, 0.3);
        place.y() += random.uniform(-0.3, 0.3);
        const double turn = random.uniform(-0.2, 0.2);
        const double roll = random.uniform(-0.005, 0.005);
        const double pitch = random.uniform(-0.005, 0.005);
        const double height = random.uniform(1.095, 1.105);
        route.push_back({Eigen::Quaterniond(Eigen::AngleAxisd(heading + turn, Eigen::Vector3d::UnitZ())) *
                             rotationAbout({roll, pitch, 0.0}),
                         at(place, height)});
    }
    return route;
}

Eigen::VectorXd drawn(const Eigen::MatrixXd& covariance, Random& random)
{
    Eigen::VectorXd independent(covariance.rows());
    for (Eigen::Index i = 0; i < independent.size(); ++i)
        independent[i] = random.normalPair().first;
    return covariance.llt().matrixL() * independent;
}

SimulatedStop seeFrom(const FloorPlan& plan, const Pose& pose, const SightNoise& noise, Random& random)
{
    struct Seen {
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        int hits = 0;
        std::map<std::size_t, std::vector<Eigen::Vector3d>> points;  // by face, in the stop's frame
    };
    struct Near {
        std::size_t face;
        Eigen::Vector3d normal;
        double ahead;
        Eigen::Vector3d toU;
        Eigen::Vector3d toV;
    };
    const Eigen::Vector3d& eye = pose.translation;
    std::vector<Near> near;
    for (std::size_t f = 0; f < plan.faces().size(); ++f) {
        const Face& face = plan.faces()[f];
        const OrientedPlane& plane = plan.planes()[static_cast<std::size_t>(face.plane)];
        const double ahead = plane.distance - plane.normal.dot(eye);
        if (ahead > 0.0 && ahead < noise.reach)
            near.push_back(
                {f, plane.normal, ahead, face.edgeU / face.edgeU.squaredNorm(), face.edgeV / face.edgeV.squaredNorm()});
    }
    const Pose back = pose.inverse();
    std::map<int, Seen> seen;
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < noise.rays; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / noise.rays;
        const double radius = std::sqrt(1.0 - z * z);
        const Eigen::Vector3d direction{radius * std::cos(golden * i), radius * std::sin(golden * i), z};
        double best = noise.reach;
        const Near* hit = nullptr;
        for (const Near& each : near) {
            const double towards = each.normal.dot(direction);
            if (towards * best <= each.ahead)
                continue;
            const Eigen::Vector3d offset = eye + each.ahead / towards * direction - plan.faces()[each.face].corner;
            const double u = offset.dot(each.toU);
            const double v = offset.dot(each.toV);
            if (u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0) {
                best = each.ahead / towards;
                hit = &each;
            }
        }
        if (hit == nullptr)
            continue;
        const Eigen::Vector3d point = back * (eye + best * direction);
        const Eigen::Vector3d normal = back.rotation * hit->normal;
        const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(normal);
        const double incidence = normal.dot(point) / point.norm();
        const Eigen::Vector3d row{tangents.col(0).dot(point), tangents.col(1).dot(point), -1.0};
        Seen& plane = seen[plan.faces()[hit->face].plane];
        plane.information +=
            noise.pointsPerRay / square(noise.range * std::max(incidence, 0.05)) * row * row.transpose();
        plane.points[hit->face].push_back(point);
        ++plane.hits;
    }

    constexpr double kLeastPoints = 150.0;
    constexpr double kLeastArea = 0.08;  // [m²]
    SimulatedStop found;
    found.truth = pose;
    for (const auto& [number, plane] : seen) {
        if (plane.hits * noise.pointsPerRay < kLeastPoints)
            continue;
        const OrientedPlane& truth = plan.planes()[static_cast<std::size_t>(number)];
        UncertainPlane parameters;
        parameters.normal = back.rotation * truth.normal;
        parameters.distance = truth.distance - truth.normal.dot(eye);
        parameters.tangents = tangentsOf(parameters.normal);
        parameters.covariance = plane.information.inverse();
        parameters.covariance.diagonal() +=
            Eigen::Vector3d(square(noise.angle), square(noise.angle), square(noise.distance));
        // No extraction reports a plane that is known so badly.
        constexpr double kWorstAngle = degrees(1.5);
        if (parameters.covariance.diagonal().head<2>().maxCoeff() > square(kWorstAngle))
            continue;
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const auto& [face, points] : plane.points) {
            for (const Eigen::Vector3d& point : points)
                middle += point / plane.hits;
        }
        // About the middle of the points, where angles and distance are independent: however badly the angles are
        // known.
        UncertainPlane there = seenFrom(parameters, middle);
        const Eigen::Vector3d error = drawn(there.covariance, random);
        there.normal = (there.normal + there.tangents * error.head<2>()).normalized();
        there.distance += error.z();
        const UncertainPlane before = there;
        there.tangents = tangentsOf(there.normal);
        there.covariance = covarianceIn(there, before);
        parameters = seenFrom(there, -middle);
        // Outlines lie on the plane that is seen.
        const PlaneFrame frame(parameters.normal, parameters.distance, Eigen::Vector3d::UnitZ());
        std::vector<Outline::Polygon> parts;
        double area = 0.0;
        for (const auto& [face, points] : plane.points) {
            PlanarRing flat;
            for (const Eigen::Vector3d& point : points)
                flat.push_back(frame.toPlane(point));
            const PlanarRing hull = convexHull(flat);
            if (hull.size() < 3)
                continue;
            area += signedArea(hull);
            Outline::Polygon& part = parts.emplace_back();
            for (const Eigen::Vector2d& corner : hull)
                part.ring.push_back(frame.toSpace(corner));
        }
        if (area < kLeastArea || parameters.distance < 0.05)
            continue;
        found.stop.planes.push_back({static_cast<int>(found.stop.planes.size()), parameters, parts});
        found.planes.push_back(number);
    }
    return found;
}

std::vector<SimulatedStop> seeFloor(const FloorPlan& plan, const std::vector<Pose>& route, const SightNoise& noise,
                                    std::uint64_t seed)
{
    Random random(seed, 3);
    std::vector<SimulatedStop> stops;
    for (std::size_t i = 0; i < route.size(); ++i) {
        SimulatedStop seen = seeFrom(plan, route[i], noise, random);
        seen.stop.id = static_cast<int>(i);
        if (i > 0) {
            const Pose motion = route[i - 1].inverse() * route[i];
            const Matrix6d covariance = odometryCovariance(motion, {});
            const Vector6d error = noise.odometryScale * drawn(covariance, random);
            seen.stop.odometry = Motion{withError(motion, error), covariance};
        }
        stops.push_back(std::move(seen));
    }
    return stops;
}

}  // namespace planewright
