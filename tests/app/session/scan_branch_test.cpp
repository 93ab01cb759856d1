// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_branch.h"

#include <QSignalSpy>
#include <QtTest>

#include "core/params/presets.h"
#include "tests/app/session/loops/batch.h"
#include "tests/app/session/session_fixture.h"
#include "tests/test_program.h"

namespace planewright {

class ScanBranchTest : public QObject {
    Q_OBJECT

private slots:
    void aBranchIsWhatABatchMakes_data();
    void aBranchIsWhatABatchMakes();
    void aBranchMayGoBeforeItsEnd();
};

namespace {

constexpr int kBranchTimeout = 60'000;  // [ms]

std::vector<SharedSlice> slicesOf(const Recording& recording)
{
    std::vector<SharedSlice> slices;
    for (const ScanSlice& slice : recording.slices)
        slices.push_back(std::make_shared<const ScanSlice>(slice));
    return slices;
}

}  // namespace

void ScanBranchTest::aBranchIsWhatABatchMakes_data()
{
    QTest::addColumn<QString>("preset");
    for (const Preset& preset : methodPresets())
        QTest::newRow(std::string(preset.name).c_str()) << QString::fromStdString(std::string(preset.name));
}

void ScanBranchTest::aBranchIsWhatABatchMakes()
{
    QFETCH(QString, preset);
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    const Recording scan = smallCorridor();
    ScanBranch branch(scan.description, slicesOf(scan), parameters, 40);
    QSignalSpy grown(&branch, &ScanBranch::grown);

    QVERIFY(QSignalSpy(&branch, &ScanBranch::ended).wait(kBranchTimeout));

    QVERIFY(branch.isFinished());
    QVERIFY(!branch.problem());
    QCOMPARE(branch.history().steps().size(), scan.slices.size() + 1);
    QCOMPARE(grown.last()[0].toInt(), static_cast<int>(scan.slices.size()) + 1);
    QCOMPARE(planesText(*branch.history().newest()->snapshot), batchPlanes(scan, {{0, parameters}}));
    QVERIFY(branch.history().explained(7));
}

void ScanBranchTest::aBranchMayGoBeforeItsEnd()
{
    const Recording scan = smallCorridor();
    bool hasEnded = false;
    {
        ScanBranch branch(scan.description, slicesOf(scan), Parameters{}, 40);
        connect(&branch, &ScanBranch::ended, this, [&hasEnded] { hasEnded = true; });
    }
    QCoreApplication::processEvents();
    QVERIFY(!hasEnded);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanBranchTest)
#include "scan_branch_test.moc"
