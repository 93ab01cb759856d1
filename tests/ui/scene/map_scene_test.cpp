// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/map_scene.h"

#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "tests/ui/scene/shown_room.h"
#include "ui/scene/scene_pick.h"

namespace planewright {

class MapSceneTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyEchoIsAPoint();
    void pointsOfHiddenPlanesAreLeftOut();
    void whatDoesNotChangeIsNotMadeAnew();
    void aBudgetThinsThePoints();
    void segmentsBelongToThePlaneThatListsThem();
    void aLineOfSightPicksThePlaneThatItMeetsFirst();
    void hiddenPlanesAreNotPicked();
    void aPointIsPickedWhereItWasMeasured();
    void legendsNameWhatIsShown();
    void aShortLegendNamesTheLargestPlanes();
    void aPieceThatIsChosenIsWhereItsEchoesAre();
    void singleFarEchoesDoNotMakeTheRoomSmall();
    void planesThatAppearLargestAreNamedFirst();

private:
    std::shared_ptr<const ShownMap> corridor_;
};

namespace {

std::size_t echoesOf(const ShownMap& map)
{
    std::size_t echoes = 0;
    for (const auto& slice : map.slices)
        echoes += static_cast<std::size_t>(std::count_if(slice->ranges.begin(), slice->ranges.end(),
                                                         [&](double range) { return map.sensor.hasEcho(range); }));
    return echoes;
}

std::shared_ptr<ShownMap> withHidden(const ShownMap& map, std::size_t plane)
{
    auto changed = std::make_shared<ShownMap>(map);
    changed->planes[plane].hidden = true;
    return changed;
}

/// The plane whose normal is nearest to up and which lies lowest.
std::size_t floorOf(const ShownMap& map)
{
    std::size_t found = 0;
    double lowest = 1e9;
    for (std::size_t i = 0; i < map.planes.size(); ++i) {
        const double z = map.planes[i].outline->outline.centroid.z();
        if (std::abs(map.planes[i].plane->normal.z()) > 0.95 && z < lowest) {
            lowest = z;
            found = i;
        }
    }
    return found;
}

}  // namespace

void MapSceneTest::initTestCase()
{
    corridor_ = shownRoom("corridor");
    QVERIFY(corridor_->planes.size() > 5);
}

void MapSceneTest::everyEchoIsAPoint()
{
    MapScene scene;
    scene.setMap(corridor_);
    scene.update();

    QCOMPARE(scene.points().points(), echoesOf(*corridor_));
}

void MapSceneTest::pointsOfHiddenPlanesAreLeftOut()
{
    MapScene scene;
    const std::size_t floor = floorOf(*corridor_);
    scene.setMap(withHidden(*corridor_, floor));
    scene.update();

    const auto hidden = static_cast<std::size_t>(corridor_->planes[floor].plane->points);
    const std::size_t left = echoesOf(*corridor_) - scene.points().points();
    // A segment's points and what lies between its first and its last beam: a few echoes more at most.
    QVERIFY2(left >= hidden && left < hidden + hidden / 50, qPrintable(QString("%1 %2").arg(left).arg(hidden)));
}

void MapSceneTest::whatDoesNotChangeIsNotMadeAnew()
{
    MapScene scene;
    scene.setMap(corridor_);
    scene.update();
    QCOMPARE(scene.points().rebuiltChunks(), 9);  // 137 slices in chunks of 16

    scene.setMap(corridor_);
    scene.update();
    QCOMPARE(scene.points().rebuiltChunks(), 0);

    SceneSelection selection;
    selection.planes.insert(corridor_->planes.front().plane->id);
    scene.setSelection(selection);
    scene.update();
    QCOMPARE(scene.points().rebuiltChunks(), 0);
}

void MapSceneTest::aBudgetThinsThePoints()
{
    MapScene scene;
    scene.setMap(corridor_);
    scene.update();
    const std::vector<vtkActor*> all = scene.points().parts();

    scene.setPointBudget(20'000);
    for (vtkActor* actor : all)
        QVERIFY(!actor->GetVisibility());

    scene.setPointBudget(0);
    for (vtkActor* actor : all)
        QVERIFY(actor->GetVisibility());
}

void MapSceneTest::segmentsBelongToThePlaneThatListsThem()
{
    const SegmentOwners owners(*corridor_);
    std::size_t owned = 0;
    std::size_t listed = 0;
    for (std::size_t slice = 0; slice < owners.slices(); ++slice)
        owned += static_cast<std::size_t>(std::count_if(owners.planesOf(slice).begin(), owners.planesOf(slice).end(),
                                                        [](int plane) { return plane >= 0; }));
    for (const ShownPlane& plane : corridor_->planes)
        listed += plane.plane->segments.size();

    QCOMPARE(owned, listed);
}

void MapSceneTest::aLineOfSightPicksThePlaneThatItMeetsFirst()
{
    MapScene scene;
    scene.setMap(corridor_);
    const ShownPlane& floor = corridor_->planes[floorOf(*corridor_)];

    // From the scanner steeply down: nothing is between it and the floor.
    const auto picked = pick(scene, {{0.0, 0.5, 0.0}, Eigen::Vector3d{0.0, 0.3, -1.0}.normalized()}, 1e-6);

    QVERIFY(picked);
    QCOMPARE(picked->plane, floor.plane->id);
    QVERIFY(std::abs(floor.plane->normal.dot(picked->place) - floor.plane->distance) < 1e-3);
}

void MapSceneTest::hiddenPlanesAreNotPicked()
{
    MapScene scene;
    const std::size_t floor = floorOf(*corridor_);
    scene.setMap(withHidden(*corridor_, floor));

    const auto picked = pick(scene, {{0.0, 0.5, 0.0}, Eigen::Vector3d{0.0, 0.3, -1.0}.normalized()}, 1e-6);

    QVERIFY(!picked || picked->plane != corridor_->planes[floor].plane->id);
}

void MapSceneTest::aPointIsPickedWhereItWasMeasured()
{
    MapScene scene;
    scene.setMap(corridor_);
    const ScanSlice& slice = *corridor_->slices[40];
    const std::size_t beam = 300;
    const Eigen::Vector3d point = toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tilt, corridor_->sensor);
    const Eigen::Vector3d eye = Eigen::Vector3d::Zero();

    const auto picked = pickPoint(scene, {eye, (point - eye).normalized()}, 1e-6);

    QVERIFY(picked && picked->isPoint);
    QVERIFY(picked->place.isApprox(point, 1e-9));
}

void MapSceneTest::legendsNameWhatIsShown()
{
    MapScene scene;
    scene.setMap(corridor_);

    QCOMPARE(scene.legend(100).size(), corridor_->planes.size() + 1);
    QCOMPARE(scene.legend(4).size(), std::size_t(4));
    QCOMPARE(scene.legend(4).back().text, "and " + std::to_string(corridor_->planes.size() - 2) + " more");

    LayerSettings byStep;
    byStep.colourBy = ColourBy::Step;
    scene.setLayers(byStep);
    QCOMPARE(scene.legend(100).front().text, std::string("step 137"));
    QCOMPARE(scene.legend(100).back().text, std::string("step 1"));
}

void MapSceneTest::aShortLegendNamesTheLargestPlanes()
{
    // Planes by their area, the largest first, worked out beside the legend.
    auto planes = corridor_->planes;
    std::sort(planes.begin(), planes.end(),
              [](const auto& a, const auto& b) { return a.outline->outline.area > b.outline->outline.area; });
    QVERIFY(planes.size() > 3);
    auto turned = std::make_shared<ShownMap>(*corridor_);
    std::reverse(turned->planes.begin(), turned->planes.end());
    MapScene scene;
    scene.setMap(turned);

    const std::vector<LegendEntry> legend = scene.legend(3);

    QCOMPARE(legend.size(), std::size_t(3));
    std::set<std::string> named{legend[0].text.substr(0, 3), legend[1].text.substr(0, 3)};
    for (const std::size_t largest : {std::size_t(0), std::size_t(1)}) {
        const QString label = QStringLiteral("P%1").arg(planes[largest].plane->id, 2, 10, QLatin1Char('0'));
        QVERIFY2(named.contains(label.toStdString()), qPrintable(label));
    }
}

void MapSceneTest::aPieceThatIsChosenIsWhereItsEchoesAre()
{
    // A level slice at steps 3 and 5 of a laser on its pitch axis: the beam at 90° looks along y.
    auto map = std::make_shared<ShownMap>();
    map->sensor.pitchAxisOffset = 0.0;
    ScanSlice slice;
    slice.tilt = degrees(90.0);
    slice.firstBearing = degrees(88.0);
    slice.bearingStep = degrees(1.0);
    slice.ranges = {2.0, 2.0, 3.0, 0.0, 2.0};
    for (const int step : {3, 5}) {
        slice.step = step;
        map->slices.push_back(std::make_shared<const ScanSlice>(slice));
    }
    map->step = 5;

    const auto points = pointsOf({5, 2, 3}, *map);

    QCOMPARE(points.size(), std::size_t(1));  // the other beam has no echo
    QVERIFY(points[0].isApprox(Eigen::Vector3d(0.0, 3.0, 0.0), 1e-9));
    QVERIFY(pointsOf({4, 2, 3}, *map).empty());
    QCOMPARE(pointsOf({3, -2, 40}, *map).size(), std::size_t(4));
    MapScene scene;
    scene.setMap(map);
    QVERIFY(scene.selectedBounds().isEmpty());
    scene.setSelection({.planes = {}, .segments = {}, .pieces = {{5, 2, 2}}});
    QVERIFY(scene.selectedBounds().min().isApprox(Eigen::Vector3d(0.0, 3.0, 0.0), 1e-9));
}

void MapSceneTest::singleFarEchoesDoNotMakeTheRoomSmall()
{
    MadeMap made;
    for (int step = 0; step < 200; ++step)
        made.slice(1);  // a segment from x = 0 to 1 m, at y = 2 m, from z = 0 to 19.9 m
    auto far = std::make_shared<ShownMap>(*made.get());
    auto snapshot = std::make_shared<Snapshot>(*far->snapshot);
    LineSegment echo;
    echo.id = {200, 0};
    echo.start = {300.0, 2.0, 1.0};
    echo.end = {301.0, 2.0, 1.0};
    snapshot->segments.append(200, std::make_shared<Segments>(Segments{echo}));
    far->snapshot = snapshot;
    MapScene scene;

    scene.setMap(far);

    QCOMPARE(scene.bounds().max().x(), 301.0);
    QCOMPARE(scene.framing().max().x(), 1.0);
    QCOMPARE(scene.framing().min().x(), 0.0);
    // Of 402 ends along z, two a step, four are left out at either end: those of two steps.
    QCOMPARE(scene.framing().max().z(), 19.7);
    QVERIFY(std::abs(scene.framing().min().z() - 0.2) < 1e-12);
}

void MapSceneTest::planesThatAppearLargestAreNamedFirst()
{
    MapScene scene;
    scene.setMap(corridor_);
    const std::size_t floor = floorOf(*corridor_);
    scene.setCamera(namedView(NamedView::Top, scene.bounds(), 1.6, {}));

    const std::vector<SceneLabel> labels = scene.labels();

    QCOMPARE(labels.size(), corridor_->planes.size());
    QVERIFY(std::is_sorted(labels.begin(), labels.end(),
                           [](const SceneLabel& a, const SceneLabel& b) { return a.seen > b.seen; }));
    // From above floor and ceiling are seen in full, walls from their edge; the ceiling is nearer.
    const Eigen::Vector3d eye = scene.camera().eye();
    const ShownPlane& plane = corridor_->planes[floor];
    const Eigen::Vector3d sight = plane.outline->outline.centroid - eye;
    const double expected =
        plane.outline->outline.area * std::abs(plane.plane->normal.dot(sight.normalized())) / sight.squaredNorm();
    const auto named = std::find_if(labels.begin(), labels.end(), [&](const SceneLabel& label) {
        return label.place == plane.outline->outline.centroid;
    });
    QVERIFY(named - labels.begin() < 2);
    QVERIFY(std::abs(named->seen - expected) < 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MapSceneTest)
#include "map_scene_test.moc"
