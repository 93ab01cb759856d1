// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <Eigen/Geometry>
#include <QTest>

#include "core/formats/recording_csv.h"
#include "core/params/presets.h"
#include "simulated_room.h"

using namespace planewright;

namespace {

/// A real recording: of the folder that PLANEWRIGHT_TEST_DATA names, or of the samples that come with the program.
std::string pathOf(const std::string& name)
{
    const QByteArray data = qgetenv("PLANEWRIGHT_TEST_DATA");
    const std::string path = data.isEmpty() ? PLANEWRIGHT_SOURCE_DIR "/resources/samples/" + name
                                            : data.toStdString() + "/recordings/" + name;
    qInfo("reading %s", path.c_str());
    return path;
}

std::shared_ptr<const Snapshot> planesOf(const std::string& name)
{
    const std::string path = pathOf(name);
    std::ifstream file(path, std::ios::binary);
    const auto read = readRecordingCsv(file, path);
    if (!read)
        qFatal("%s", read.error().message.c_str());
    Parameters parameters;
    apply(*sensorOfScanner(read->recording.description.scanner), parameters);
    return extracted(read->recording, parameters);
}

/// The plane with most points among those whose normal is within an angle of an axis; null where there is none.
const Plane* largestAlong(const Snapshot& snapshot, const Eigen::Vector3d& axis, double angle)
{
    const Plane* largest = nullptr;
    for (const auto& plane : snapshot.planes) {
        const bool along = std::abs(plane->normal.dot(axis)) > std::cos(angle);
        if (along && (largest == nullptr || plane->points > largest->points))
            largest = plane.get();
    }
    return largest;
}

double angleBetween(const Plane& a, const Plane& b)
{
    return std::atan2(a.normal.cross(b.normal).norm(), std::abs(a.normal.dot(b.normal)));
}

}  // namespace

class RealRecordingsTest : public QObject {
    Q_OBJECT

private slots:
    void theLobbyHasAFloorAndWallsAtRightAngles();
    void theDeskHasATopAndWallsBehindIt();
};

void RealRecordingsTest::theLobbyHasAFloorAndWallsAtRightAngles()
{
    const auto lobby = planesOf("lobby.csv.gz");

    const Plane* floor = largestAlong(*lobby, Eigen::Vector3d::UnitZ(), degrees(10.0));
    QVERIFY(floor != nullptr && floor->points > 10000);
    int walls = 0;
    for (const auto& plane : lobby->planes) {
        if (plane->points < 1000 || std::abs(plane->normal.x()) < 0.9)
            continue;
        ++walls;
        QVERIFY2(std::abs(toDegrees(angleBetween(*floor, *plane)) - 90.0) < 3.0,
                 qPrintable(QString::number(plane->id)));
    }
    // One on the right at 4.8 m, on the left the wall and what stands before it.
    QVERIFY(walls >= 3);
}

void RealRecordingsTest::theDeskHasATopAndWallsBehindIt()
{
    const auto desk = planesOf("desk.csv.gz");

    // The stand was not level: the top is tilted against its axes.
    const bool top = std::any_of(desk->planes.begin(), desk->planes.end(), [](const auto& plane) {
        return plane->points > 3000 && std::abs(plane->normal.z()) > std::cos(degrees(25.0)) && plane->distance < 0.3;
    });
    const Plane* behind = largestAlong(*desk, Eigen::Vector3d::UnitY(), degrees(10.0));
    const Plane* aside = largestAlong(*desk, Eigen::Vector3d::UnitX(), degrees(10.0));
    QVERIFY(top);
    QVERIFY(behind != nullptr && behind->points > 1000);
    QVERIFY(aside != nullptr && aside->points > 5000);
}

QTEST_GUILESS_MAIN(RealRecordingsTest)
#include "real_recordings_test.moc"
