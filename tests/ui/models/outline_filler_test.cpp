// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/outline_filler.h"

#include <QThread>
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
    void anotherScanHasOutlinesOfItsOwn();
    void itMayWorkInAThreadOfItsOwn();
};

namespace {

/// Two segments of a metre, 0.1 m apart: the strip between them has 0.1 m².
class Strip {
public:
    Strip() { made_.slice(1).slice(1); }

    MadeMap& of(std::uint64_t revision)
    {
        made_.withoutPlanes();
        return made_.plane(made_.wall(5, {{0, 0}, {1, 0}}, revision));
    }

private:
    MadeMap made_;
};

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
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);

    filler.setMap(strip.of(1).get());

    QCOMPARE(listener.maps.size(), std::size_t(1));
    QVERIFY(!listener.plane().outline);
    QTRY_VERIFY(!filler.isBusy());
    QVERIFY(listener.plane().outline);
    QVERIFY(std::abs(listener.plane().outline->outline.area - 0.1) < 1e-9);
}

void OutlineFillerTest::aPlaneKeepsItsEarlierOutlineUntilTheNewOneIsThere()
{
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip.of(1).get());
    QTRY_VERIFY(!filler.isBusy());

    filler.setMap(strip.of(2).get());

    QCOMPARE(listener.plane().outline->revision, std::uint64_t(1));
    QTRY_VERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline->revision, std::uint64_t(2));
}

void OutlineFillerTest::anOutlineIsWorkedOutOnceForARevision()
{
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip.of(1).get());
    QTRY_VERIFY(!filler.isBusy());
    const auto first = listener.plane().outline;

    filler.setMap(strip.of(1).get());

    QVERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline, first);
}

void OutlineFillerTest::outlinesOfTheMapAreLeftAlone()
{
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);

    filler.setMap(strip.of(1).outlined(7.0, 3.5, 2.0).get());

    QVERIFY(!filler.isBusy());
    QCOMPARE(listener.plane().outline->outline.area, 7.0);
}

void OutlineFillerTest::noMapPassesThrough()
{
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip.of(1).get());

    filler.setMap(nullptr);

    QVERIFY(!listener.maps.back());
    QVERIFY(!filler.isBusy());
}

void OutlineFillerTest::anotherScanHasOutlinesOfItsOwn()
{
    Strip strip;
    OutlineFiller filler;
    const Listener listener(filler);
    filler.setMap(strip.of(1).get());
    QTRY_VERIFY(!filler.isBusy());

    MadeMap wide;
    wide.slice(2).slice(2);
    filler.setMap(wide.plane(wide.wall(5, {{0, 0}, {0, 1}, {1, 0}, {1, 1}})).get());

    QVERIFY(!listener.plane().outline);
    QTRY_VERIFY(!filler.isBusy());
    QVERIFY(std::abs(listener.plane().outline->outline.area - 0.2) < 1e-9);
}

void OutlineFillerTest::itMayWorkInAThreadOfItsOwn()
{
    Strip strip;
    QThread thread;
    auto* filler = new OutlineFiller;
    filler->moveToThread(&thread);
    connect(&thread, &QThread::finished, filler, &QObject::deleteLater);
    std::shared_ptr<const ShownMap> newest;
    connect(filler, &OutlineFiller::filled, this, [&](const auto& map) { newest = map; });
    thread.start();

    QMetaObject::invokeMethod(filler, [filler, map = strip.of(1).get()] { filler->setMap(map); });

    QTRY_VERIFY(newest && newest->planes.front().outline);
    thread.quit();
    QVERIFY(thread.wait());
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::OutlineFillerTest)
#include "outline_filler_test.moc"
