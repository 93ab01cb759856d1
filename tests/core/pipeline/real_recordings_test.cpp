// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include <Eigen/Geometry>
#include <QTest>

#include "core/formats/recording_csv.h"
#include "core/params/presets.h"
#include "simulated_room.h"
#include "tests/test_program.h"

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

std::shared_ptr<const Snapshot> planesOf(const std::string& name, const QString& preset)
{
    const std::string path = pathOf(name);
    std::ifstream file(path, std::ios::binary);
    const auto read = readRecordingCsv(file, path);
    if (!read)
        qFatal("%s", read.error().message.c_str());
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
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

/// The box around those segments of a plane whose middle is on the stair of the lobby: 5 m wide, from 5 m ahead on.
Eigen::AlignedBox3d partOnStair(const Plane& plane, const Snapshot& snapshot)
{
    const Eigen::AlignedBox3d stair(Eigen::Vector3d(-1.5, 4.9, -0.6), Eigen::Vector3d(4.1, 9.7, 1.6));
    Eigen::AlignedBox3d box;
    for (const SegmentId& id : plane.segments) {
        const LineSegment& segment = snapshot.segments[id];
        if (stair.contains(segment.midpoint()))
            box.extend(segment.midpoint());
    }
    return box;
}

/// Mean height of a plane's segments above the pitch axis [m].
double meanHeight(const Plane& plane, const Snapshot& snapshot)
{
    double sum = 0.0;
    for (const SegmentId& id : plane.segments)
        sum += snapshot.segments[id].midpoint().z();
    return sum / static_cast<double>(plane.segments.size());
}

double angleBetween(const Plane& a, const Plane& b)
{
    return std::atan2(a.normal.cross(b.normal).norm(), std::abs(a.normal.dot(b.normal)));
}

void eachPreset()
{
    QTest::addColumn<QString>("preset");
    for (const Preset& preset : methodPresets())
        QTest::newRow(preset.name.data()) << QString::fromUtf8(preset.name.data());
}

}  // namespace

class RealRecordingsTest : public QObject {
    Q_OBJECT

private slots:
    void theLobbyHasAFloorAndWallsAtRightAngles_data() { eachPreset(); }
    void theLobbyHasAFloorAndWallsAtRightAngles();
    void theLobbysStairIsItsRisersAndNoSlope_data() { eachPreset(); }
    void theLobbysStairIsItsRisersAndNoSlope();
    void theDeskHasATopAndWallsBehindIt_data() { eachPreset(); }
    void theDeskHasATopAndWallsBehindIt();
};

void RealRecordingsTest::theLobbyHasAFloorAndWallsAtRightAngles()
{
    QFETCH(const QString, preset);
    const auto lobby = planesOf("lobby.csv.gz", preset);

    const Plane* floor = largestAlong(*lobby, Eigen::Vector3d::UnitZ(), degrees(10.0));
    QVERIFY(floor != nullptr && floor->points > 10000);
    int walls = 0;
    for (const auto& plane : lobby->planes) {
        // From 2 m up the walls lean over: the vaults begin.
        if (plane->points < 1000 || std::abs(plane->normal.x()) < 0.9 || meanHeight(*plane, *lobby) > 2.0)
            continue;
        ++walls;
        QVERIFY2(std::abs(toDegrees(angleBetween(*floor, *plane)) - 90.0) < 3.0,
                 qPrintable(QString::number(plane->id)));
    }
    // One on the right at 4.8 m, on the left the wall and what stands before it.
    QVERIFY(walls >= 3);
}

void RealRecordingsTest::theLobbysStairIsItsRisersAndNoSlope()
{
    QFETCH(const QString, preset);
    // Steps of 0.34 m by 0.16 m; in the middle of the stair the first riser is 5.12 m ahead. The slope over them is 25°
    // steep. Six risers are seen in five slices and more, and of all that is seen of one 0.1 m is high.
    const auto lobby = planesOf("lobby.csv.gz", preset);

    std::array<int, 6> planesAtRiser{};
    for (const auto& plane : lobby->planes) {
        const Eigen::AlignedBox3d part = partOnStair(*plane, *lobby);
        if (part.isEmpty())
            continue;
        const double tilt = toDegrees(std::acos(std::abs(plane->normal.z())));
        QVERIFY2(tilt < 10.0 || tilt > 35.0 || part.sizes().y() < 2.0 * 0.34, qPrintable(QString::number(plane->id)));
        const double steps = (part.center().y() - 5.12) / 0.335;
        const int riser = static_cast<int>(std::lround(steps));
        if (tilt > 35.0 && std::abs(plane->normal.x()) < 0.1 && part.sizes().y() < 0.17 && riser >= 0 && riser < 6 &&
            std::abs(steps - riser) < 0.25)
            ++planesAtRiser[static_cast<std::size_t>(riser)];
    }
    QVERIFY(std::count(planesAtRiser.begin(), planesAtRiser.end(), 1) >= 5);
    const auto level = std::count_if(lobby->planes.begin(), lobby->planes.end(), [](const auto& plane) {
        return plane->normal.z() < -std::cos(degrees(10.0)) && plane->points > 300;
    });
    QCOMPARE(level, 1);  // the floor
}

void RealRecordingsTest::theDeskHasATopAndWallsBehindIt()
{
    QFETCH(const QString, preset);
    const auto desk = planesOf("desk.csv.gz", preset);

    // The top is level to 2° beam by beam, 8 to 10 cm below the pitch axis: of its few centimetres in front of the
    // stand, ranges of 0.2 m are off by more than that from side to side.
    const bool top = std::any_of(desk->planes.begin(), desk->planes.end(), [](const auto& plane) {
        return plane->points > 3000 && std::abs(plane->normal.z()) > std::cos(degrees(25.0)) && plane->distance < 0.3;
    });
    const Plane* behind = largestAlong(*desk, Eigen::Vector3d::UnitY(), degrees(10.0));
    const Plane* aside = largestAlong(*desk, Eigen::Vector3d::UnitX(), degrees(10.0));
    QVERIFY(top);
    QVERIFY(behind != nullptr && behind->points > 1000);
    QVERIFY(aside != nullptr && aside->points > 5000);
}

PLANEWRIGHT_TEST(RealRecordingsTest)
#include "real_recordings_test.moc"
