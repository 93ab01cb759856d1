// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/compare_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/models/model_roles.h"

namespace planewright {

class CompareModelTest : public QObject {
    Q_OBJECT

private slots:
    void pairsAndSinglesHaveRows();
    void cellsHaveNumbersToSortBy();
    void withoutASecondMapThereAreNoRows();
    void rowsAreFoundByTheirPlanes();
};

namespace {

/// Planes across y at these distances, each with a segment of ten beams in a slice of its own, in the order given.
std::shared_ptr<const Snapshot> mapWith(const std::vector<std::pair<PlaneId, double>>& planes)
{
    auto map = std::make_shared<Snapshot>();
    int step = 0;
    for (const auto& [id, distance] : planes) {
        LineSegment segment;
        segment.id = {step, 0};
        segment.lastBeam = 9;
        map->segments.append(step, std::make_shared<Segments>(Segments{segment}));
        auto plane = std::make_shared<Plane>();
        plane->id = id;
        plane->normal = Eigen::Vector3d::UnitY();
        plane->distance = distance;
        plane->fittingError = 0.5 * (step + 1);
        plane->segments = {segment.id};
        map->planes.push_back(plane);
        ++step;
    }
    return map;
}

QString cellText(const CompareModel& model, int row, CompareColumn column)
{
    return model.index(row, static_cast<int>(column)).data().toString();
}

}  // namespace

/// P02 at 1 m and P05 at 1.02 m are one plane; P03 and P07 lie half a metre apart.
void CompareModelTest::pairsAndSinglesHaveRows()
{
    CompareModel model;
    const QAbstractItemModelTester tester(&model);

    model.setMaps(mapWith({{2, 1.0}, {3, 2.0}}), mapWith({{5, 1.02}, {7, 2.5}}));

    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(cellText(model, 0, CompareColumn::What), QStringLiteral("both"));
    QCOMPARE(cellText(model, 0, CompareColumn::A), QStringLiteral("P02"));
    QCOMPARE(cellText(model, 0, CompareColumn::B), QStringLiteral("P05"));
    QCOMPARE(cellText(model, 0, CompareColumn::Overlap), QStringLiteral("100"));
    QCOMPARE(cellText(model, 0, CompareColumn::Angle), QStringLiteral("0.000"));
    QCOMPARE(cellText(model, 0, CompareColumn::Distance), QStringLiteral("20.0"));
    QCOMPARE(cellText(model, 1, CompareColumn::What), QStringLiteral("only A"));
    QCOMPARE(cellText(model, 1, CompareColumn::A), QStringLiteral("P03"));
    QCOMPARE(cellText(model, 1, CompareColumn::B), QStringLiteral("(P07)"));
    QCOMPARE(cellText(model, 1, CompareColumn::Distance), QStringLiteral("–"));
    QCOMPARE(cellText(model, 2, CompareColumn::What), QStringLiteral("only B"));
    QCOMPARE(cellText(model, 2, CompareColumn::A), QStringLiteral("(P03)"));
    QCOMPARE(cellText(model, 2, CompareColumn::B), QStringLiteral("P07"));
    QCOMPARE(cellText(model, 2, CompareColumn::SegmentsA), QStringLiteral("–"));
    QCOMPARE(cellText(model, 2, CompareColumn::SegmentsB), QStringLiteral("1"));
}

void CompareModelTest::cellsHaveNumbersToSortBy()
{
    CompareModel model;

    model.setMaps(mapWith({{2, 1.0}, {3, 2.0}}), mapWith({{5, 1.02}, {7, 2.5}}));

    const auto number = [&](int row, CompareColumn column) {
        return model.index(row, static_cast<int>(column)).data(kSortRole);
    };
    QVERIFY(std::abs(number(0, CompareColumn::Distance).toDouble() - 20.0) < 1e-9);
    QCOMPARE(number(0, CompareColumn::ErrorB).toDouble(), 0.5);
    QCOMPARE(number(2, CompareColumn::ErrorB).toDouble(), 1.0);
    QVERIFY(!number(2, CompareColumn::ErrorA).isValid());
}

void CompareModelTest::withoutASecondMapThereAreNoRows()
{
    CompareModel model;
    model.setMaps(mapWith({{2, 1.0}}), mapWith({{5, 1.0}}));
    QCOMPARE(model.rowCount(), 1);

    model.setMaps(mapWith({{2, 1.0}}), nullptr);

    QCOMPARE(model.rowCount(), 0);
    QVERIFY(model.comparison().pairs.empty());
}

void CompareModelTest::rowsAreFoundByTheirPlanes()
{
    CompareModel model;

    model.setMaps(mapWith({{2, 1.0}, {3, 2.0}}), mapWith({{5, 1.02}, {7, 2.5}}));

    QCOMPARE(model.rowOfA(2), 0);
    QCOMPARE(model.rowOfB(7), 2);
    QCOMPARE(model.rowOfA(7), -1);
    QCOMPARE(model.rowOfA(kNoPlane), -1);
    QCOMPARE(model.planeA(2), kNoPlane);
    QCOMPARE(model.planeB(0), 5);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CompareModelTest)
#include "compare_model_test.moc"
