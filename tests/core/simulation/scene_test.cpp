// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <QtTest/QtTest>

#include "core/simulation/nodding_scanner.h"
#include "core/types/angle.h"
#include "tests/sanitized.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

constexpr std::uint64_t kSeeds = kIsSanitized ? 4 : 20;

std::map<int, int> returnsOf(const Scene& scene, const SimulationNoise& noise, std::uint64_t seed)
{
    std::map<int, int> returns;
    for (const std::vector<int>& labels : simulate(scene, {}, noise, seed).labels)
        for (const int label : labels)
            ++returns[label];
    return returns;
}

int planesSeenBy(const std::map<int, int>& returns, int atLeast)
{
    return static_cast<int>(std::count_if(returns.begin(), returns.end(), [atLeast](const auto& entry) {
        return entry.first >= 0 && entry.second >= atLeast;
    }));
}

const TruePlane& planeNamed(const Scene& scene, const std::string& name)
{
    return *std::find_if(scene.planes.begin(), scene.planes.end(),
                         [&name](const TruePlane& p) { return p.name == name; });
}

std::array<Eigen::Vector3d, 4> cornersOf(const RectangleSurface& r)
{
    return {r.corner, r.corner + r.edgeU, r.corner + r.edgeU + r.edgeV, r.corner + r.edgeV};
}

/// How near two rectangles in nearly parallel planes come in the plane of the first, by their bounding boxes there.
double gapInPlane(const RectangleSurface& a, const RectangleSurface& b)
{
    double gap = 0.0;
    for (const Eigen::Vector3d& axis : {a.edgeU.normalized(), a.edgeV.normalized()}) {
        double first[2]{1e9, -1e9};
        double second[2]{1e9, -1e9};
        for (const Eigen::Vector3d& corner : cornersOf(a)) {
            first[0] = std::min(first[0], axis.dot(corner));
            first[1] = std::max(first[1], axis.dot(corner));
        }
        for (const Eigen::Vector3d& corner : cornersOf(b)) {
            second[0] = std::min(second[0], axis.dot(corner));
            second[1] = std::max(second[1], axis.dot(corner));
        }
        gap = std::max({gap, second[0] - first[1], first[0] - second[1]});
    }
    return gap;
}

bool areExactlyCoplanar(const TruePlane& a, const TruePlane& b)
{
    const double sign = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
    return (a.normal - sign * b.normal).norm() < 1e-12 && std::abs(a.distance - sign * b.distance) < 1e-12;
}

/// Names of two planes that no range noise of a centimetre could keep apart, or nothing.
std::string indistinguishablePair(const Scene& scene)
{
    const double limit = std::cos(degrees(3.0));
    for (const RectangleSurface& a : scene.rectangles) {
        for (const RectangleSurface& b : scene.rectangles) {
            const TruePlane& planeA = scene.planes[static_cast<std::size_t>(a.plane)];
            const TruePlane& planeB = scene.planes[static_cast<std::size_t>(b.plane)];
            if (a.plane == b.plane || std::abs(planeA.normal.dot(planeB.normal)) < limit ||
                areExactlyCoplanar(planeA, planeB) || gapInPlane(a, b) > 0.15)
                continue;
            for (const Eigen::Vector3d& corner : cornersOf(b))
                if (std::abs(planeA.normal.dot(corner) - planeA.distance) < 0.045)
                    return planeA.name + " and " + planeB.name;
        }
    }
    return {};
}

}  // namespace

class SceneTest : public QObject {
    Q_OBJECT

private slots:
    void scenesHaveTheirNumbersOfPlanes_data();
    void scenesHaveTheirNumbersOfPlanes();
    void planesAreCanonicalAndSurfacesLieInThem_data();
    void planesAreCanonicalAndSurfacesLieInThem();
    void neighboursAreFarEnoughApartToTell_data();
    void neighboursAreFarEnoughApartToTell();
    void roomsAreClosed_data();
    void roomsAreClosed();
    void anotherSeedIsAnotherRoom_data();
    void anotherSeedIsAnotherRoom();
    void theCorridorHasItsDimensions();
    void theDoorsOfASideAreRecessedAlike();
    void theCorridorShowsSixPlanesWell();
    void theStairsHaveTwelveStepsOf17By29Centimetres();
    void theHallHasItsDimensions();
    void theTwelveAreThoseOfTable12();
    void theTwelveAreAllSeenByFourHundredReturns();
    void curvedSurfacesAreLabelledAsSuch_data();
    void curvedSurfacesAreLabelledAsSuch();
    void anUnknownNameListsTheKnownOnes();
};

void SceneTest::scenesHaveTheirNumbersOfPlanes_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("corridor") << "corridor" << 6 + 4 * 16 << 6 + 4 * 20;
    QTest::newRow("office") << "office" << 65 << 70;
    QTest::newRow("hall") << "hall" << 35 << 37;
    QTest::newRow("curved") << "curved" << 14 << 14;
    QTest::newRow("stairs") << "stairs" << 30 << 30;
    QTest::newRow("twelve") << "twelve" << 12 << 12;
    QTest::newRow("clutter") << "clutter" << 79 << 99;
    QTest::newRow("empty") << "empty" << 0 << 0;
    QTest::newRow("hostile") << "hostile" << 44 << 44;
}

void SceneTest::scenesHaveTheirNumbersOfPlanes()
{
    QFETCH(QString, name);
    QFETCH(int, least);
    QFETCH(int, most);

    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene(name.toStdString(), seed).value();
        const int planes = static_cast<int>(scene.planes.size());
        QVERIFY2(planes >= least && planes <= most, qPrintable(QString("seed %1: %2").arg(seed).arg(planes)));
        QCOMPARE(scene.name, name.toStdString());
    }
}

void SceneTest::planesAreCanonicalAndSurfacesLieInThem_data()
{
    scenesHaveTheirNumbersOfPlanes_data();
}

void SceneTest::planesAreCanonicalAndSurfacesLieInThem()
{
    QFETCH(QString, name);

    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene(name.toStdString(), seed).value();
        std::set<std::string> names;
        for (std::size_t i = 0; i < scene.planes.size(); ++i) {
            QCOMPARE(scene.planes[i].id, static_cast<int>(i));
            QVERIFY(scene.planes[i].distance >= 0.0);
            QVERIFY(std::abs(scene.planes[i].normal.norm() - 1.0) < 1e-12);
            QVERIFY2(names.insert(scene.planes[i].name).second, scene.planes[i].name.c_str());
        }
        for (const RectangleSurface& r : scene.rectangles) {
            const TruePlane& plane = scene.planes.at(static_cast<std::size_t>(r.plane));
            QVERIFY(std::abs(r.edgeU.dot(r.edgeV)) < 1e-9);
            for (const Eigen::Vector3d& corner : cornersOf(r))
                QVERIFY(std::abs(plane.normal.dot(corner) - plane.distance) < 1e-12);
        }
    }
}

void SceneTest::neighboursAreFarEnoughApartToTell_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view name : sceneNames())
        if (name != "hostile")
            QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
}

void SceneTest::neighboursAreFarEnoughApartToTell()
{
    QFETCH(QString, name);

    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const std::string pair = indistinguishablePair(makeScene(name.toStdString(), seed).value());
        QVERIFY2(pair.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(QString::fromStdString(pair))));
    }
}

void SceneTest::roomsAreClosed_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"corridor", "office", "hall", "curved", "stairs", "clutter"})
        QTest::newRow(name) << name;
}

void SceneTest::roomsAreClosed()
{
    QFETCH(QString, name);
    AcquisitionSettings settings = acquisitionSettings("largest").value();
    settings.slices = 128;
    settings.tiltStep *= 8.0;

    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const SimulatedScan scan = simulate(makeScene(name.toStdString(), seed).value(), settings, {}, 1);
        for (const ScanSlice& slice : scan.recording.slices)
            QCOMPARE(std::count(slice.ranges.begin(), slice.ranges.end(), 0.0), 0);
    }
}

void SceneTest::anotherSeedIsAnotherRoom_data()
{
    QTest::addColumn<QString>("name");
    for (const std::string_view name : sceneNames())
        if (name != "empty")
            QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
}

void SceneTest::anotherSeedIsAnotherRoom()
{
    QFETCH(QString, name);
    AcquisitionSettings settings;
    settings.firstTilt = degrees(80.0);
    settings.slices = 20;

    const SimulatedScan a = simulate(makeScene(name.toStdString(), 1).value(), settings, {}, 1);
    const SimulatedScan again = simulate(makeScene(name.toStdString(), 1).value(), settings, {}, 1);
    const SimulatedScan b = simulate(makeScene(name.toStdString(), 2).value(), settings, {}, 1);

    QCOMPARE(a.labels, again.labels);
    QVERIFY(a.labels != b.labels);
}

void SceneTest::theCorridorHasItsDimensions()
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene("corridor", seed).value();
        // The sensor stands between both of each pair.
        const auto across = [&scene](const char* a, const char* b) {
            return planeNamed(scene, a).distance + planeNamed(scene, b).distance;
        };
        QVERIFY(std::abs(across("left wall", "right wall") - 2.4) < 1e-12);
        QVERIFY(std::abs(across("end wall", "back wall") - 30.0) < 1e-12);
        QVERIFY(std::abs(across("floor", "ceiling") - 2.6) < 1e-12);
        QVERIFY(std::abs(planeNamed(scene, "end wall").distance - 15.0) <= 0.5);
        QVERIFY(planeNamed(scene, "floor").distance >= 0.9 && planeNamed(scene, "floor").distance <= 1.1);
        const Eigen::Vector3d ahead = planeNamed(scene, "end wall").normal;
        QVERIFY(std::abs(std::atan2(ahead.x(), ahead.y())) <= degrees(10.0));
    }
}

void SceneTest::theDoorsOfASideAreRecessedAlike()
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene("corridor", seed).value();
        for (const std::string side : {"left", "right"}) {
            const TruePlane& wall = planeNamed(scene, side + " wall");
            const TruePlane& first = planeNamed(scene, side + " door 1");
            const double depth = first.distance - wall.distance;
            QVERIFY(depth >= 0.05 && depth <= 0.10);
            for (int i = 2; i <= 8; ++i)
                QVERIFY(areExactlyCoplanar(first, planeNamed(scene, side + " door " + std::to_string(i))));
        }
    }
}

void SceneTest::theCorridorShowsSixPlanesWell()
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene("corridor", seed).value();
        QVERIFY(planesSeenBy(returnsOf(scene, simulationNoise("default").value(), seed), 400) >= 6);
    }
}

void SceneTest::theStairsHaveTwelveStepsOf17By29Centimetres()
{
    const Scene scene = makeScene("stairs", 3).value();

    const double floor = planeNamed(scene, "floor").distance;
    for (int i = 1; i <= 12; ++i) {
        const TruePlane& tread = planeNamed(scene, i == 12 ? "landing" : "tread " + std::to_string(i));
        QVERIFY(std::abs(tread.normal.z() * tread.distance + floor - 0.17 * i) < 1e-12);
        if (i > 1) {
            const double here = planeNamed(scene, "riser " + std::to_string(i)).distance;
            const double before = planeNamed(scene, "riser " + std::to_string(i - 1)).distance;
            QVERIFY(std::abs(here - before - 0.29) < 1e-12);
        }
    }
}

void SceneTest::theHallHasItsDimensions()
{
    const Scene scene = makeScene("hall", 3).value();

    const auto across = [&scene](const char* a, const char* b) {
        return planeNamed(scene, a).distance + planeNamed(scene, b).distance;
    };
    QVERIFY(std::abs(across("left wall", "right wall") - 20.0) < 1e-12);
    QVERIFY(std::abs(across("end wall", "back wall") - 25.0) < 1e-12);
}

void SceneTest::theTwelveAreThoseOfTable12()
{
    struct Row {
        Eigen::Vector3d normal;
        double distance;
    };
    const std::array<Row, 12> table{{{{-1, 0, 0}, 12.6},
                                     {{-1, 0, 0}, 12.28},
                                     {{0, 1, 0}, 2.58},
                                     {{-1, 0, 0}, 2.11},
                                     {{0, 1, 0}, 3.69},
                                     {{1, 0, 0}, 1.83},
                                     {{0, 1, 0}, 3.37},
                                     {{1, 0, 0}, 6.34},
                                     {{1, 0, 0}, 10.79},
                                     {{1, 0, 0}, 21.28},
                                     {{0, 0, 1}, 2.0},
                                     {{0, 0, -1}, 0.9}}};

    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene("twelve", seed).value();
        QCOMPARE(scene.planes.size(), table.size());
        for (std::size_t i = 0; i < table.size(); ++i) {
            QCOMPARE(scene.planes[i].name, std::to_string(i + 1));
            QVERIFY((scene.planes[i].normal - table[i].normal).norm() < 1e-15);
            QVERIFY(std::abs(scene.planes[i].distance - table[i].distance) < 1e-14);
        }
    }
}

void SceneTest::theTwelveAreAllSeenByFourHundredReturns()
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Scene scene = makeScene("twelve", seed).value();
        QCOMPARE(planesSeenBy(returnsOf(scene, simulationNoise("default").value(), seed), 400), 12);
    }
}

void SceneTest::curvedSurfacesAreLabelledAsSuch_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("least");
    // The curved wall is a side wall and so fills about a quarter of the view.
    QTest::newRow("curved") << "curved" << 15000;
    QTest::newRow("clutter") << "clutter" << 500;
    QTest::newRow("hostile") << "hostile" << 10;
}

void SceneTest::curvedSurfacesAreLabelledAsSuch()
{
    QFETCH(QString, name);
    QFETCH(int, least);

    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Scene scene = makeScene(name.toStdString(), seed).value();
        QVERIFY(returnsOf(scene, {}, seed)[kNotPlanar] >= least);
    }
}

void SceneTest::anUnknownNameListsTheKnownOnes()
{
    const auto result = makeScene("attic", 1);

    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Usage);
    QCOMPARE(QString::fromStdString(result.error().message),
             QString("No scene is called 'attic'. Known: corridor, office, hall, curved, stairs, twelve, clutter, "
                     "empty, hostile."));
}

PLANEWRIGHT_TEST(SceneTest)
#include "scene_test.moc"
