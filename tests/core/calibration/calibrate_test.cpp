// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/calibrate.h"

#include <cmath>

#include <QtTest>

#include "core/evaluation/compare_planes.h"
#include "core/geometry/correct_recording.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scene_builder.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// Everything at full volume, by hand.
bool atFullVolume()
{
    return qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG");
}

/// What a scanner with these errors reports: the corrections undo them. Its sweeps have no end pitch.
Recording reported(Recording recording, const SensorParameters& corrections)
{
    for (ScanSlice& slice : recording.slices)
        slice.tiltEnd.reset();
    SensorParameters errors;
    errors.pitchZero = -corrections.pitchZero;
    errors.rangeOffset = -corrections.rangeOffset;
    errors.leverArmCorrection = -corrections.leverArmCorrection;
    errors.pitchDelay = -corrections.pitchDelay;
    correctRecording(recording, errors);
    return recording;
}

Recording scanOf(const Scene& scene, std::uint64_t seed, const AcquisitionSettings& settings = {})
{
    return simulate(scene, settings, *simulationNoise("default"), seed).recording;
}

/// The head nods up and, half a step beside, down again.
Recording scanBothWays(const Scene& scene, std::uint64_t seed)
{
    AcquisitionSettings up;
    AcquisitionSettings down;
    down.firstTilt = up.firstTilt + (up.slices - 0.5) * up.tiltStep;
    down.tiltStep = -up.tiltStep;
    Recording recording = scanOf(scene, seed, up);
    for (ScanSlice& slice : scanOf(scene, seed + 1000, down).slices) {
        slice.step += up.slices;
        recording.slices.push_back(slice);
    }
    return recording;
}

const CalibratedError& errorOf(const Calibration& calibration, ScannerError error)
{
    return calibration.errors[static_cast<std::size_t>(error)];
}

/// Within four standard deviations, and these are small.
bool isFound(const CalibratedError& error, double truth, double largestSigma)
{
    return error.observed && error.sigma < largestSigma && std::abs(error.value - truth) < 4.0 * error.sigma;
}

Result<Calibration> calibrated(const Recording& recording, const CalibrationSettings& settings = {})
{
    return calibrate(std::span{&recording, 1}, precise(), settings);
}

/// The room that a scanner in it sees which looks at one wall ahead.
Scene oneWall()
{
    SceneBuilder room("one wall");
    room.wall("wall", {{-2.0, 4.0}, {2.0, 4.0}, -1.0, 2.0});
    return room.build({});
}

}  // namespace

class CalibrateTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheErrorsOfAScanner_data();
    void findsTheErrorsOfAScanner();
    void aDelayIsFoundWhereTheHeadNodsBothWays();
    void aDelayIsNotToldFromTheZeroWhereItNodsOneWay();
    void errorsAreAsLargeAsTheirUncertaintiesSay();
    void scansOfOneScannerAreEstimatedTogether();
    void oneWallTellsLittle();
    void aLeaningScannerHasNoZero();
    void correctionsMakePlanesRight();
    void goesOnFromWhatIsInForce();
    void withoutPlanesItSaysWhatToDo();
    void isTheSameEveryTime();
};

void CalibrateTest::findsTheErrorsOfAScanner_data()
{
    QTest::addColumn<double>("zero");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("arm");
    QTest::addColumn<double>("turn");
    QTest::newRow("all") << -2.2 << 0.03 << -0.02 << 1.0;
    QTest::newRow("none") << 0.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("pitch zero") << 2.2 << 0.0 << 0.0 << 0.0;
    QTest::newRow("ranges too short") << 0.0 << 0.03 << 0.0 << 0.0;
    QTest::newRow("ranges too long") << 0.0 << -0.03 << 0.0 << 0.0;
    QTest::newRow("lever arm too short") << 0.0 << 0.0 << 0.02 << 0.0;
    QTest::newRow("lever arm too long") << 0.0 << 0.0 << -0.02 << 0.0;
    QTest::newRow("nods on by a step") << 0.0 << 0.0 << 0.0 << 1.0;
}

void CalibrateTest::findsTheErrorsOfAScanner()
{
    QFETCH(double, zero);
    QFETCH(double, offset);
    QFETCH(double, arm);
    QFETCH(double, turn);
    SensorParameters truth;
    truth.pitchZero = degrees(zero);
    truth.rangeOffset = offset;
    truth.leverArmCorrection = arm;
    AcquisitionSettings settings;
    settings.continuous = turn != 0.0;

    const auto found = calibrated(reported(scanOf(*makeScene("office", 3), 3, settings), truth));

    QVERIFY(found);
    QVERIFY(isFound(errorOf(*found, ScannerError::RangeOffset), offset, 0.001));
    QVERIFY(isFound(errorOf(*found, ScannerError::LeverArm), arm, 0.003));
    QVERIFY(isFound(errorOf(*found, ScannerError::SweepTurn), turn, 0.05));
    QVERIFY(found->pitchZeroObserved);
    QVERIFY(std::abs(found->pitchZero - degrees(zero)) < 3.0 * found->pitchZeroSigma);
    QVERIFY(found->pitchZeroSigma < degrees(0.1));
}

void CalibrateTest::aDelayIsFoundWhereTheHeadNodsBothWays()
{
    SensorParameters truth;
    truth.pitchDelay = -1.0;

    const auto found = calibrated(reported(scanBothWays(*makeScene("office", 2), 2), truth));

    QVERIFY(found);
    QVERIFY(found->nodsBothWays);
    QVERIFY(isFound(errorOf(*found, ScannerError::PitchDelay), -1.0, 0.05));
}

void CalibrateTest::aDelayIsNotToldFromTheZeroWhereItNodsOneWay()
{
    SensorParameters truth;
    truth.pitchDelay = 1.0;
    const AcquisitionSettings settings;

    const auto found = calibrated(reported(scanOf(*makeScene("hall", 2), 2), truth));

    QVERIFY(found);
    QVERIFY(!errorOf(*found, ScannerError::PitchDelay).observed);
    QCOMPARE(found->sensor.pitchDelay, 0.0);
    QVERIFY(std::abs(found->pitchZero - settings.tiltStep) < 3.0 * found->pitchZeroSigma);
}

void CalibrateTest::errorsAreAsLargeAsTheirUncertaintiesSay()
{
    const bool full = atFullVolume();
    const std::uint64_t seeds = full ? 30 : 5;
    CalibrationSettings settings;
    settings.buildingTolerance = 0.0;  // simulated floors are level
    SensorParameters truth;
    truth.rangeOffset = 0.01;
    truth.pitchZero = degrees(1.0);
    double squares[kScannerErrors]{};
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto found = calibrated(reported(scanOf(*makeScene("hall", seed), seed), truth), settings);
        QVERIFY(found);
        const double truths[]{truth.rangeOffset, 0.0, 0.0};
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(found->errors[i].observed);
            squares[i] += std::pow((found->errors[i].value - truths[i]) / found->errors[i].sigma, 2);
        }
        squares[3] += std::pow((found->pitchZero - truth.pitchZero) / found->pitchZeroSigma, 2);
    }

    // Chi-square of so many degrees of freedom: five standard deviations above, and no more than twice too cautious.
    const auto count = static_cast<double>(seeds);
    for (const double sum : squares) {
        QVERIFY2(sum / count < 1.0 + 5.0 * std::sqrt(2.0 / count), qPrintable(QString::number(sum / count)));
        QVERIFY2(!full || sum / count > 0.25, qPrintable(QString::number(sum / count)));
    }
}

void CalibrateTest::scansOfOneScannerAreEstimatedTogether()
{
    SensorParameters truth;
    truth.rangeOffset = -0.02;
    truth.pitchZero = degrees(2.2);
    const std::vector<Recording> scans{reported(scanOf(*makeScene("hall", 4), 4), truth),
                                       reported(scanOf(*makeScene("office", 4), 5), truth)};

    const auto both = calibrate(scans, precise());
    const auto one = calibrated(scans[1]);

    QVERIFY(both && one);
    QCOMPARE(both->scans.size(), std::size_t{2});
    QVERIFY(isFound(errorOf(*both, ScannerError::RangeOffset), -0.02, 0.001));
    QVERIFY(std::abs(both->pitchZero - degrees(2.2)) < 3.0 * both->pitchZeroSigma);
    QVERIFY(errorOf(*both, ScannerError::SweepTurn).sigma < errorOf(*one, ScannerError::SweepTurn).sigma);
}

void CalibrateTest::oneWallTellsLittle()
{
    AcquisitionSettings settings;
    settings.firstTilt = degrees(80.0);
    settings.slices = 18;

    const auto found = calibrated(scanOf(oneWall(), 1, settings));

    QVERIFY(found);
    QVERIFY(!errorOf(*found, ScannerError::LeverArm).observed);
    QVERIFY(!errorOf(*found, ScannerError::PitchDelay).observed);
    QCOMPARE(found->sensor.leverArmCorrection, 0.0);
}

void CalibrateTest::aLeaningScannerHasNoZero()
{
    const Scene upright = *makeScene("hall", 1);
    Scene scene = upright;  // a room that leans to one side is what a scanner sees that leans to the other
    const double lean = degrees(3.0);
    const auto leaning = [&](const Eigen::Vector3d& p) {
        return Eigen::Vector3d{std::cos(lean) * p.x() + std::sin(lean) * p.z(), p.y(),
                               -std::sin(lean) * p.x() + std::cos(lean) * p.z()};
    };
    for (RectangleSurface& surface : scene.rectangles) {
        surface.corner = leaning(surface.corner);
        surface.edgeU = leaning(surface.edgeU);
        surface.edgeV = leaning(surface.edgeV);
    }
    const Recording recording = scanOf(scene, 1);
    CalibrationSettings always;
    always.level = LevelUse::Always;
    CalibrationSettings never;
    never.level = LevelUse::Never;

    const auto byItself = calibrated(recording);
    const auto forced = calibrated(recording, always);
    const auto unasked = calibrated(scanOf(upright, 1), never);

    QVERIFY(byItself && forced && unasked);
    QVERIFY(!byItself->pitchZeroObserved);
    QVERIFY(std::abs(byItself->scans[0].roll - lean) < degrees(0.2));
    QVERIFY(forced->pitchZeroObserved);
    QVERIFY(!unasked->pitchZeroObserved);
    QCOMPARE(unasked->sensor.pitchZero, 0.0);
}

void CalibrateTest::correctionsMakePlanesRight()
{
    SensorParameters truth;
    truth.pitchZero = degrees(2.2);
    truth.rangeOffset = 0.03;
    const Scene scene = *makeScene("hall", 6);
    const Recording recording = reported(scanOf(scene, 6), truth);
    std::vector<ComparedPlane> known;
    for (const TruePlane& plane : scene.planes)
        known.push_back({plane.id, plane.normal, plane.distance});
    const auto medianAngle = [&](const SensorParameters& sensor) {
        Recording corrected = recording;
        correctRecording(corrected, sensor);
        PlaneExtractor extractor(sensorOf(corrected.description), precise());
        for (const ScanSlice& slice : corrected.slices)
            extractor.advance(slice);
        std::vector<ComparedPlane> planes;
        const std::shared_ptr<const Snapshot> snapshot = extractor.finish();
        for (const auto& plane : snapshot->planes) {
            if (plane->points > 1000)
                planes.push_back({plane->id, plane->normal, plane->distance});
        }
        return comparePlanes(planes, known, {degrees(6.0), 0.3})->errors.angle.median;
    };

    const auto found = calibrated(recording);

    QVERIFY(found);
    QVERIFY(medianAngle({}) > degrees(1.5));
    QVERIFY(medianAngle(found->sensor) < degrees(0.1));
}

void CalibrateTest::goesOnFromWhatIsInForce()
{
    SensorParameters truth;
    truth.pitchZero = degrees(2.0);
    truth.rangeOffset = 0.03;
    const Recording recording = reported(scanOf(*makeScene("hall", 7), 7), truth);
    Parameters parameters = precise();
    parameters.sensor.pitchZero = degrees(1.9);
    parameters.sensor.rangeOffset = 0.025;
    parameters.sensor.pitchDelay = 0.25;

    const auto found = calibrate(std::span{&recording, 1}, parameters);

    QVERIFY(found);
    QVERIFY(isFound(errorOf(*found, ScannerError::RangeOffset), 0.03, 0.001));
    QCOMPARE(found->sensor.pitchDelay, 0.25);  // not observed: as it was, and a part of the zero
    const double turned = 0.25 * AcquisitionSettings{}.tiltStep;
    QVERIFY(std::abs(found->pitchZero + turned - degrees(2.0)) < 3.0 * found->pitchZeroSigma);
}

void CalibrateTest::withoutPlanesItSaysWhatToDo()
{
    const auto found = calibrated(scanOf(*makeScene("empty", 1), 1));

    QVERIFY(!found);
    QVERIFY(found.error().code == ErrorCode::GateFailed);
    QVERIFY(QString::fromStdString(found.error().message).contains("scan a room with its floor and walls"));
}

void CalibrateTest::isTheSameEveryTime()
{
    const Recording recording = scanOf(*makeScene("office", 8), 8);

    const auto first = calibrated(recording);
    const auto second = calibrated(recording);

    QVERIFY(first && second);
    for (std::size_t i = 0; i < kScannerErrors; ++i)
        QCOMPARE(first->errors[i].value, second->errors[i].value);
    QCOMPARE(first->pitchZero, second->pitchZero);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CalibrateTest)
#include "calibrate_test.moc"
