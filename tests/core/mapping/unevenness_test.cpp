// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/unevenness.h"

#include <QtTest>

#include "core/mapping/map_builder.h"
#include "core/simulation/random.h"
#include "core/types/angle.h"
#include "core/types/square.h"
#include "tests/core/mapping/known_planes.h"
#include "tests/core/mapping/map_score.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class UnevennessTest : public QObject {
    Q_OBJECT

private slots:
    void flatWallsAreFoundToBeFlat();
    void unevenWallsAreFoundToBeUneven();
    void anotherFlatnessComesAndGoes();
};

namespace {

constexpr double kTold = 2e-3;

/// The ring with walls that are so uneven from sighting to sighting [m].
std::vector<SimulatedStop> ringWith(double uneven, std::uint64_t seed)
{
    auto stops = seeFloor(ringFloor(seed), ringRoute(20, seed), {}, seed);
    Random random(seed + 77);
    for (SimulatedStop& stop : stops) {
        for (ObservedPlane& plane : stop.stop.planes) {
            ObservedPlane rough = plane;
            rough.parameters.covariance.setZero();
            addFlatness(rough, uneven);
            if (uneven > 0.0)
                plane.parameters = changedBy(plane.parameters, drawn(rough.parameters.covariance, random));
        }
    }
    return stops;
}

MapBuilder joined(const std::vector<SimulatedStop>& stops)
{
    MapBuilder builder;
    for (const SimulatedStop& stop : stops) {
        if (!builder.join(stop.stop))
            qFatal("A simulated stop was refused.");
    }
    return builder;
}

}  // namespace

/// Errors of poses over their covariances have the mean of their unknowns, within a fifth, though 2 mm are told.
void UnevennessTest::flatWallsAreFoundToBeFlat()
{
    std::vector<double> poseErrors;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto stops = ringWith(0.0, seed);
        MapBuilder builder = joined(stops);

        QVERIFY(builder.adjust());

        const MapScore score = scoreMap(builder.map(), stops, ringFloor(seed).planes());
        poseErrors.insert(poseErrors.end(), score.poseErrors.begin(), score.poseErrors.end());
    }
    const double share = meanOf(poseErrors) / 6.0;
    QVERIFY2(std::abs(share - 1.0) < 0.2, qPrintable(QString::number(share)));
}

void UnevennessTest::unevenWallsAreFoundToBeUneven()
{
    const auto stops = ringWith(0.0015, 3);
    MapBuilder builder = joined(stops);
    QVERIFY(builder.adjust());
    const BuildingMap& map = builder.map();

    const double found = unevennessOf(map, kTold, kTold);

    QVERIFY2(found > 0.0008 && found < kTold, qPrintable(QString::number(found)));
}

void UnevennessTest::anotherFlatnessComesAndGoes()
{
    MapBuilder builder = joined(ringWith(0.0, 1));
    BuildingMap map = builder.map();
    const Eigen::Matrix3d before = map.stops[3].stop->planes[0].parameters.covariance;

    changeFlatness(map, kTold, 0.5 * kTold);
    const Eigen::Matrix3d less = map.stops[3].stop->planes[0].parameters.covariance;
    changeFlatness(map, 0.5 * kTold, kTold);

    // Seen from the middle of the wall its distance has lost three quarters of 2 mm squared.
    const ObservedPlane& plane = map.stops[3].stop->planes[0];
    UncertainPlane told = plane.parameters;
    told.covariance = before - less;
    QVERIFY(std::abs(seenFrom(told, middleOf(plane)).covariance(2, 2) / (0.75 * square(kTold)) - 1.0) < 1e-6);
    QVERIFY((map.stops[3].stop->planes[0].parameters.covariance - before).norm() < 1e-9 * before.norm());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UnevennessTest)
#include "unevenness_test.moc"
