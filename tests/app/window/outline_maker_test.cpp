// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/outline_maker.h"

#include <atomic>

#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/scene/shown_room.h"

namespace planewright {

class OutlineMakerTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void outlinesAreThoseOfThePlanes();
    void aPlaneThatGrewShowsWhatItWasUntilItIsDone();
    void whatIsNoLongerWantedIsForgotten();

private:
    std::vector<std::shared_ptr<const Plane>> planes() const;

    std::shared_ptr<const ShownMap> corridor_;
};

void OutlineMakerTest::initTestCase()
{
    corridor_ = shownRoom("corridor");
}

std::vector<std::shared_ptr<const Plane>> OutlineMakerTest::planes() const
{
    return corridor_->snapshot->planes;
}

void OutlineMakerTest::outlinesAreThoseOfThePlanes()
{
    std::atomic<int> told = 0;
    OutlineMaker maker([&] { ++told; });
    QVERIFY(maker.outlineOf(*planes().front()) == nullptr);

    maker.want(planes(), corridor_->snapshot);

    QTRY_VERIFY(!maker.isBusy());
    QVERIFY(told > 0);
    for (const auto& plane : planes()) {
        const auto outline = maker.outlineOf(*plane);
        QVERIFY(outline != nullptr);
        QCOMPARE(outline->revision, plane->revision);
        QCOMPARE(outline->outline.area, filledOutlineOf(*plane, corridor_->snapshot->segments)->outline.area);
    }
}

void OutlineMakerTest::aPlaneThatGrewShowsWhatItWasUntilItIsDone()
{
    OutlineMaker maker([] {});
    maker.want(planes(), corridor_->snapshot);
    QTRY_VERIFY(!maker.isBusy());
    auto grown = std::make_shared<Plane>(*planes().front());
    grown->revision += 1;

    const auto before = maker.outlineOf(*grown);
    maker.want({grown}, corridor_->snapshot);

    QVERIFY(before != nullptr);
    QCOMPARE(before->revision, planes().front()->revision);
    QTRY_COMPARE(maker.outlineOf(*grown)->revision, grown->revision);
}

void OutlineMakerTest::whatIsNoLongerWantedIsForgotten()
{
    OutlineMaker maker([] {});
    maker.want(planes(), corridor_->snapshot);
    QTRY_VERIFY(!maker.isBusy());

    maker.want({planes()[1]}, corridor_->snapshot);

    QVERIFY(maker.outlineOf(*planes()[0]) == nullptr);
    QVERIFY(maker.outlineOf(*planes()[1]) != nullptr);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::OutlineMakerTest)
#include "outline_maker_test.moc"
