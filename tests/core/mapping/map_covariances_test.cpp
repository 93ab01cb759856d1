// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/map_covariances.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/test_program.h"

namespace planewright {

class MapCovariancesTest : public QObject {
    Q_OBJECT

private slots:
    void odometryAloneIsAsGoodAsOdometry();
    void sightingsThatDisagreeTellNothingOfAllTogether();
    void whatNothingFixesIsAnError();
};

namespace {

const Pose kSecond = poseAt({0.0, 8.0, 0.0}, {0.0, 0.0, 0.3});
const Pose kThird = poseAt({2.0, 10.0, 0.0}, {0.0, 0.0, -0.2});

Matrix6d toldCovariance()
{
    Vector6d variances;
    variances << Eigen::Vector3d::Constant(square(degrees(0.5))), Eigen::Vector3d::Constant(square(0.1));
    return variances.asDiagonal();
}

MapStop stopAt(const Pose& pose, StopTrust trust)
{
    MapStop stop;
    stop.stop = std::make_shared<Stop>();
    stop.pose = pose;
    stop.trust = trust;
    return stop;
}

/// Three stops, the second known from the first by odometry alone; the second and the third see three walls together,
/// each so far turned from the other's view [rad].
BuildingMap mapOf(double disagreement)
{
    BuildingMap map;
    map.stops = {stopAt({}, StopTrust::First), stopAt(kSecond, StopTrust::OdometryAlone),
                 stopAt(kThird, StopTrust::Planes)};
    map.stops[1].odometry = StopMotion{0, {kSecond, toldCovariance()}};
    const std::vector<std::pair<Eigen::Vector3d, double>> walls{
        {Eigen::Vector3d::UnitX(), 12.0}, {Eigen::Vector3d::UnitY(), 15.0}, {-Eigen::Vector3d::UnitZ(), 1.1}};
    for (std::size_t number = 0; number < walls.size(); ++number) {
        const UncertainPlane known = planeKnownTo(walls[number].first, walls[number].second, degrees(0.01), 1e-4);
        map.planes.push_back({known, {}, {}});
        for (const std::size_t n : {std::size_t{1}, std::size_t{2}}) {
            ObservedPlane seen;
            const double side = n == 1 ? 0.5 : -0.5;
            seen.parameters =
                inMap(changedBy(known, {side * disagreement, side * disagreement, 0.0}), map.stops[n].pose.inverse());
            auto stop = std::make_shared<Stop>(*map.stops[n].stop);
            map.planes[number].sightings.push_back({n, stop->planes.size()});
            stop->planes.push_back(seen);
            map.stops[n].stop = stop;
            map.stops[n].matches.push_back({MatchState::Matched, number, {}, 0.0, false});
        }
    }
    return map;
}

}  // namespace

void MapCovariancesTest::odometryAloneIsAsGoodAsOdometry()
{
    BuildingMap map = mapOf(0.0);

    QVERIFY(computeCovariances(map));

    QVERIFY(map.stops[1].covariance.isApprox(toldCovariance(), 1e-6));
    // The third hangs on the second: it turns with it, and is carried.
    const Matrix6d carry = carriedBy(kThird.translation - kSecond.translation);
    const Matrix6d carried = carry * toldCovariance() * carry.transpose();
    QVERIFY((map.stops[2].covariance - carried).norm() < 0.01 * carried.norm());
}

/// A degree apart, a hundred times what they are told to be off: turned together, both stops see just the same.
void MapCovariancesTest::sightingsThatDisagreeTellNothingOfAllTogether()
{
    BuildingMap map = mapOf(degrees(1.0));

    QVERIFY(computeCovariances(map));

    for (Eigen::Index i = 0; i < 6; ++i)
        QVERIFY(map.stops[1].covariance(i, i) > 0.99 * toldCovariance()(i, i));
}

void MapCovariancesTest::whatNothingFixesIsAnError()
{
    BuildingMap map = mapOf(0.0);
    map.stops[1].odometry.reset();

    const auto computed = computeCovariances(map);

    QVERIFY(!computed);
    QVERIFY(computed.error().message.find("add odometry") != std::string::npos);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MapCovariancesTest)
#include "map_covariances_test.moc"
