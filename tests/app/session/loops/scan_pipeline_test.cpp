// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/scan_pipeline.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "app/session/loops/pwscan_recorder.h"
#include "core/formats/recording_pwscan.h"
#include "core/params/presets.h"
#include "devices/emulated/simulated_room.h"
#include "tests/app/session/loops/batch.h"
#include "tests/app/session/loops/fakes.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/devices/fake_clock.h"
#include "tests/sanitized.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ScanPipelineTest : public QObject {
    Q_OBJECT

private slots:
    void aLiveScanItsRecordingAndABatchGiveTheSamePlanes();
    void parametersSetMidScanAreRecordedAndGiveTheSamePlanesAgain();
    void aRecorderThatFailsForAWhileLosesNothing();
    void finishingKeepsWhatWasTaken();
    void abandoningEndsItSoonInEveryMoment();
    void pausesAreRecorded();
    void parametersAfterTheLastSliceAreRefused();
    void aSlowDiskLetsTheQueueGrowAndLosesNothing();
    void planesAreFinalSoonAfterTheLastSlice();
};

namespace {

constexpr int kPatience = 60'000;  // under sanitizers on busy machines [ms]

std::shared_ptr<ScanSource> room(const Clock& clock, double speed)
{
    return std::make_shared<SimulatedRoom>(*makeScene("corridor", 3),
                                           SimulatedScanner{smallScan(), *simulationNoise("default"), 3, speed}, clock);
}

/// A pipeline on three threads.
class RunningPipeline {
public:
    enum class Start { Now, Later };
    RunningPipeline(std::shared_ptr<ScanSource> source, std::unique_ptr<SliceRecorder> recorder, const Clock& clock,
                    Start start = Start::Now)
        : pipeline{{std::move(source), std::move(recorder), {{0, precise()}}, false},
                   {{[] {}, [this](const Error& /*error*/) { ++faults; }, [this](ScanOutcome /*outcome*/) { ++ended; }},
                    {[this](const Error& /*error*/) { ++troubles; }, [this] { ++recoveries; },
                     [this](const Result<void>& closed) { ++(closed ? closedWell : closedBadly); }},
                    [this] { ++news; },
                    [this](const Error& /*error*/) { ++faults; }},
                   clock}
    {
        if (start == Start::Now)
            this->start();
    }
    ~RunningPipeline()
    {
        pipeline.abandon();
        join();
    }

    void start()
    {
        for (auto& loop : pipeline.loops())
            threads_.emplace_back(std::move(loop));
    }
    void join() { threads_.clear(); }

    std::atomic<int> faults{0};
    std::atomic<int> ended{0};
    std::atomic<int> troubles{0};
    std::atomic<int> recoveries{0};
    std::atomic<int> closedWell{0};
    std::atomic<int> closedBadly{0};
    std::atomic<int> news{0};
    ScanPipeline pipeline;

private:
    std::vector<std::jthread> threads_;
};

using Milliseconds = std::chrono::duration<double, std::milli>;

/// Scans a recording in real time, 40 slices a second: the time from its last slice to the final planes; empty where
/// there are none within a minute.
std::optional<Milliseconds> timeUntilFinal(const Recording& recording)
{
    const auto begin = steadyClock().now();
    const auto end = static_cast<int>(recording.slices.size()) - 1;
    std::atomic<std::chrono::nanoseconds> last{0ns};
    auto source = std::make_shared<ScriptedSource>(recording);
    source->onNext = [&](int call) -> Result<void> {
        const auto due = begin + call * 25ms;
        std::this_thread::sleep_for(std::max(0ns, due - steadyClock().now()));
        if (call == end)
            last = steadyClock().now();
        return {};
    };
    const QTemporaryDir folder;
    RunningPipeline run{source,
                        std::make_unique<PwscanRecorder>(folder.filePath("scan.pwscan").toStdString(),
                                                         PwscanRecorder::Target::NewFile, "Scripted scanner"),
                        steadyClock()};

    std::shared_ptr<const Snapshot> newest;
    const auto isFinal = [&] { return newest && newest->report.step == -1; };
    const auto patience = steadyClock().now() + 60s;
    while (!isFinal() && steadyClock().now() < patience) {
        if (const auto steps = run.pipeline.take(); !steps.empty())
            newest = steps.back().snapshot;
        std::this_thread::sleep_for(100us);
    }
    if (!isFinal() || newest->planes.size() < 4)
        return std::nullopt;
    return steadyClock().now() - last.load();
}

}  // namespace

void ScanPipelineTest::aLiveScanItsRecordingAndABatchGiveTheSamePlanes()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("scan.pwscan").toStdString();
    RunningPipeline run{room(steadyClock(), 0.0),
                        std::make_unique<PwscanRecorder>(path, PwscanRecorder::Target::NewFile, "corridor"),
                        steadyClock()};

    run.join();

    const std::string planes = planesText(*run.pipeline.take().back().snapshot);
    const auto recording = readRecordingPwscan(path);
    QVERIFY(recording);
    QCOMPARE(recording->notes.scan.state, ScanState::Complete);
    QCOMPARE(recording->notes.scan.plannedSlices.value(), 40);
    const auto stored = readParameterEvents(recording->notes.events, path);
    QVERIFY(stored);
    QCOMPARE(planes, batchPlanes(recording->read.recording, *stored));
    const Recording simulated =
        asRecorded(simulate(*makeScene("corridor", 3), smallScan(), *simulationNoise("default"), 3).recording);
    QCOMPARE(planes, batchPlanes(simulated, {{0, precise()}}));
    QCOMPARE(run.closedWell.load(), 1);
    QVERIFY(run.pipeline.status().recording.bytes > 0);
    QVERIFY(run.pipeline.status().recording.freeBytes.value() > 0);
}

void ScanPipelineTest::parametersSetMidScanAreRecordedAndGiveTheSamePlanesAgain()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("scan.pwscan").toStdString();
    Parameters changed = precise();
    changed.likelihood.enoughPoints = 400;
    const Recording recording =
        simulate(*makeScene("corridor", 3), smallScan(), *simulationNoise("default"), 3).recording;
    auto source = std::make_shared<ScriptedSource>(recording);
    RunningPipeline run{source, std::make_unique<PwscanRecorder>(path, PwscanRecorder::Target::NewFile, "corridor"),
                        steadyClock(), RunningPipeline::Start::Later};
    source->onNext = [&](int call) -> Result<void> {
        if (call == 17)
            run.pipeline.setParameters(changed);
        return {};
    };
    run.start();
    run.join();

    const std::string planes = planesText(*run.pipeline.take().back().snapshot);
    const auto read = readRecordingPwscan(path);
    QVERIFY(read);
    const auto stored = readParameterEvents(read->notes.events, path);
    QVERIFY(stored);
    QCOMPARE(stored->size(), std::size_t(2));
    QCOMPARE((*stored)[1].step, 17);
    QCOMPARE(planes, batchPlanes(read->read.recording, *stored));
    QCOMPARE(planes, batchPlanes(asRecorded(recording), {{0, precise()}, {17, changed}}));
}

void ScanPipelineTest::aRecorderThatFailsForAWhileLosesNothing()
{
    const FakeClock clock;
    auto scan = std::make_shared<RecordedScan>();
    auto source = std::make_shared<ScriptedSource>(emptySlices(300));
    source->onNext = [&](int call) -> Result<void> {
        scan->fails = call >= 100 && call < 200;
        return {};
    };
    RunningPipeline run{source, std::make_unique<FakeRecorder>(scan), clock};

    run.join();

    QCOMPARE(run.pipeline.status().extracted, 300);
    QCOMPARE(scan->slices(), 300);
    QCOMPARE(scan->copy().back(), std::string("close complete"));
    QCOMPARE(run.pipeline.take().size(), std::size_t(301));
}

void ScanPipelineTest::finishingKeepsWhatWasTaken()
{
    auto scan = std::make_shared<RecordedScan>();
    auto source = std::make_shared<ScriptedSource>(emptySlices(20));
    source->endless = true;
    RunningPipeline run{source, std::make_unique<FakeRecorder>(scan), steadyClock()};
    QTRY_COMPARE_WITH_TIMEOUT(run.pipeline.status().extracted, 20, kPatience);

    run.pipeline.finish();
    run.join();

    QCOMPARE(scan->slices(), 20);
    QCOMPARE(run.pipeline.take().back().snapshot->report.step, -1);
    QVERIFY(!scan->isOpen);
    QCOMPARE(source->ends.load(), 1);
}

void ScanPipelineTest::abandoningEndsItSoonInEveryMoment()
{
    for (int cycle = 0; cycle < 100; ++cycle) {
        auto scan = std::make_shared<RecordedScan>();
        auto source = std::make_shared<ScriptedSource>(emptySlices(50));
        source->endless = true;
        if (cycle % 3 == 0)
            source->onNext = [](int call) -> Result<void> {
                return call == 20 ? fail(ErrorCode::Internal, "The scanner is silent.") : Result<void>{};
            };
        RunningPipeline run{source, std::make_unique<FakeRecorder>(scan), steadyClock()};
        while (run.pipeline.status().acquired < cycle % 20)
            std::this_thread::yield();

        run.pipeline.abandon();
        run.join();

        QVERIFY(!scan->isOpen);
        QCOMPARE(scan->slices(), run.pipeline.status().acquired);
    }
}

void ScanPipelineTest::pausesAreRecorded()
{
    const FakeClock clock;
    auto scan = std::make_shared<RecordedScan>();
    RunningPipeline run{room(clock, 1.0), std::make_unique<FakeRecorder>(scan), clock, RunningPipeline::Start::Later};

    QVERIFY(run.pipeline.pause());
    QVERIFY(run.pipeline.resume());
    run.start();
    run.join();

    const auto lines = scan->copy();
    QVERIFY(std::find(lines.begin(), lines.end(), "event pause") != lines.end());
    QVERIFY(std::find(lines.begin(), lines.end(), "event resume") != lines.end());
    QCOMPARE(scan->slices(), 40);
}

void ScanPipelineTest::parametersAfterTheLastSliceAreRefused()
{
    RunningPipeline run{std::make_shared<ScriptedSource>(emptySlices(3)), nullptr, steadyClock()};
    run.join();

    QVERIFY(!run.pipeline.setParameters(precise()));
}

/// The scanner waits for nobody: what is not worked in yet waits in memory.
void ScanPipelineTest::aSlowDiskLetsTheQueueGrowAndLosesNothing()
{
    auto scan = std::make_shared<RecordedScan>();
    auto source = std::make_shared<ScriptedSource>(emptySlices(200));
    scan->isSlow = true;
    RunningPipeline run{source, std::make_unique<FakeRecorder>(scan), steadyClock()};

    QTRY_VERIFY_WITH_TIMEOUT(run.pipeline.status().queueDepth >= 64, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(run.pipeline.status().acquired, 200, kPatience);
    scan->isSlow = false;
    run.join();

    QCOMPARE(scan->slices(), 200);
    QCOMPARE(run.pipeline.status().extracted, 200);
    QCOMPARE(run.pipeline.status().lost, 0);
    QCOMPARE(run.pipeline.status().queueDepth, std::size_t(0));
}

/// A scan of Table VIII in real time: what there is to be done after its last slice takes 5 ms on a machine at rest. A
/// busy one may hold up a scan, hardly three.
void ScanPipelineTest::planesAreFinalSoonAfterTheLastSlice()
{
    constexpr auto kBar = 5ms;
    constexpr int kMargin = kIsSanitized ? 100 : 10;
    const AcquisitionSettings settings;
    const Recording recording = simulate(*makeScene("corridor", 7), settings, *simulationNoise("default"), 1).recording;
    QCOMPARE(recording.slices.size(), std::size_t(137));
    QCOMPARE(recording.description.beams, 721);

    Milliseconds soonest = Milliseconds::max();
    for (int scan = 0; scan < 3 && soonest >= kMargin * kBar; ++scan) {
        const std::optional<Milliseconds> after = timeUntilFinal(recording);
        QVERIFY(after.has_value());
        qInfo("the planes were final %.2f ms after the last slice", after->count());
        soonest = std::min(soonest, *after);
    }
    QVERIFY2(soonest < kMargin * kBar, qPrintable(QString::number(soonest.count())));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanPipelineTest)
#include "scan_pipeline_test.moc"
