// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/outline_filler.h"

#include <QtTest>

#include "tests/ui/made_map.h"

namespace planewright {

class OutlineFillerTest : public QObject {
    Q_OBJECT

private slots:
    void outlinesComeAfterTheMap();
    void aPlaneKeepsItsEarlierOutlineUntilTheNewOneIsThere();
    void anOutlineIsWorkedOutOnceForARevision();
    void outlinesOfTheMapAreLeftAlone();
    void noMapPassesThrough();
};

namespace {

/// Two segments of a metre, 0.1 m apart: the strip between them has 0.1 m².
MadeMap strip(std::uint64_t revision)
{
    MadeMap made;
    made.slice(1).slice(1);
    made.plane(made.wall(5, {{0, 0}, {1, 0}}, revision));
    return made;
}

struct Listener {
    explicit Listener(OutlineFiller& filler)
    {
        QObject::connect(&filler, &OutlineFiller::filled, &filler, [this](const auto& map) { maps.push_back(map); });
    }
    const ShownPlane& plane() const { return maps.back()->planes.front(); }

    std::vector<std::shared_ptr<const ShownMap>> maps;
};

}  // namespace

void OutlineFillerTest::outlinesComeAfterTheMap()
{
    OutlineFiller filler;
    const Listener listener(filler);

    filler.setMap(strip(1).get());

    QCOMPARE(listener.maps.size(), std::size_t(1));
    QVERIFY(!listener.plane().outline);
    QTRY_VERIFY(!filler.isBusy());
    QVERIFY(listener.plane().outline);
    QVERIFY(std::abs(listener.plane().outline->outline.area - 0.1) < 1e-9);
}

void OutlineFillerTest::aPlaneKeepsItsEarlierOutlineUntilTheNewOneIsThere()
{
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip(1).get());
    QTRY_VERIFY(!filler.isBusy());

    filler.setMap(strip(2).get());

    QCOMPARE(listener.plane().outline->revision, std::uint64_t(1));
    QTRY_VERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline->revision, std::uint64_t(2));
}

void OutlineFillerTest::anOutlineIsWorkedOutOnceForARevision()
{
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip(1).get());
    QTRY_VERIFY(!filler.isBusy());
    const auto first = listener.plane().outline;

    filler.setMap(strip(1).get());

    QVERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline, first);
}

void OutlineFillerTest::outlinesOfTheMapAreLeftAlone()
{
    OutlineFiller filler;
    const Listener listener(filler);

    filler.setMap(strip(1).outlined(7.0, 3.5, 2.0).get());

    QVERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline->outline.area, 7.0);
}

void OutlineFillerTest::noMapPassesThrough()
{
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip(1).get());

    filler.setMap(nullptr);

    QVERIFY(!listener.maps.back());
    QVERIFY(!filler.isBusy());
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::OutlineFillerTest)
#include "outline_filler_test.moc"
