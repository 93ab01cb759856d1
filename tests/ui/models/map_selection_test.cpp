// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/map_selection.h"

#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"

namespace planewright {

class MapSelectionTest : public QObject {
    Q_OBJECT

private slots:
    void everyChangeIsToldOnce();
    void togglingTwiceChangesNothingInTheEnd();
    void planesAndSegmentsAreChosenApart();
    void allAndInvertPassHiddenPlanesBy();
    void whatTheMapLosesIsNoLongerChosen();
    void thePointerIsOnOnePlane();
};

void MapSelectionTest::everyChangeIsToldOnce()
{
    MapSelection selection;
    QSignalSpy changed(&selection, &MapSelection::changed);

    selection.select({1, 2});
    selection.select({2, 1});
    selection.addPlane(2);
    selection.addPlane(3);

    QCOMPARE(changed.size(), 2);
    QVERIFY(selection.planes() == (std::set<PlaneId>{1, 2, 3}));
}

void MapSelectionTest::togglingTwiceChangesNothingInTheEnd()
{
    MapSelection selection;

    selection.togglePlane(4);
    QVERIFY(selection.planes().contains(4));
    selection.togglePlane(4);
    selection.toggleSegment({0, 1});
    selection.toggleSegment({0, 1});

    QVERIFY(selection.isEmpty());
}

void MapSelectionTest::planesAndSegmentsAreChosenApart()
{
    MapSelection selection;

    selection.select({}, {}, {{3, 40, 47}});
    selection.selectSegments({{3, 1}});
    selection.selectPlanes({7});

    QVERIFY(selection.segments().contains({3, 1}));
    QVERIFY(selection.pieces().contains({3, 40, 47}));
    selection.select({7});
    QVERIFY(selection.pieces().empty());
    selection.clear();
    QVERIFY(selection.isEmpty());
}

void MapSelectionTest::allAndInvertPassHiddenPlanesBy()
{
    MadeMap made;
    made.plane(made.wall(1, {})).plane(made.wall(2, {}));
    made.last().hidden = true;
    made.plane(made.wall(3, {}));
    MapSelection selection;

    selection.selectAll(*made.get());
    QVERIFY(selection.planes() == (std::set<PlaneId>{1, 3}));
    selection.togglePlane(1);
    selection.invert(*made.get());

    QVERIFY(selection.planes() == (std::set<PlaneId>{1}));
}

void MapSelectionTest::whatTheMapLosesIsNoLongerChosen()
{
    MadeMap made;
    made.slice(2).plane(made.wall(1, {})).plane(made.wall(5, {}));
    MapSelection selection;
    selection.select({1, 4, 5}, {{0, 0}, {0, 2}, {9, 0}});
    selection.hover(4);

    selection.keepWhatIsIn(*made.get());

    QVERIFY(selection.planes() == (std::set<PlaneId>{1, 5}));
    QVERIFY(selection.segments() == (std::set<SegmentId>{{0, 0}}));
    QCOMPARE(selection.hovered(), kNoPlane);
}

void MapSelectionTest::thePointerIsOnOnePlane()
{
    MapSelection selection;
    QSignalSpy hovered(&selection, &MapSelection::hoverChanged);

    selection.hover(3);
    selection.hover(3);
    selection.hover(kNoPlane);

    QCOMPARE(hovered.size(), 2);
    QCOMPARE(hovered[0][0].toInt(), 3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MapSelectionTest)
#include "map_selection_test.moc"
