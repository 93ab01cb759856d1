// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser_faults.h"

#include <algorithm>
#include <map>

#include <QtTest>

#include "tests/devices/emulated/laser_rig.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// What an emulated laser's bytes look like where it has a fault. Scans of 81 beams, the fault at the tenth.
class EmulatedLaserFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindIsKnownAndSaid();
    void unknownKindsAreRefusedWithThoseThatThereAre();
    void damagedScansAreDamagedAndNoOthers_data();
    void damagedScansAreDamagedAndNoOthers();
    void manySeedsDamageManyPlaces();
    void aCutScanIsACut();
    void aDuplicateIsTheSameScanTwice();
    void anInterleavedReplyIsInTheMiddleOfAScan();
    void aDelayedScanHoldsThoseBehindIt();
    void theLinkIsPulledOutInTheMiddleOfAScan();
    void aLinkThatNeverWasIsNotConnected();
    void silenceEndsWhenScansAreAskedForAnew();
    void aTimeThatStandsStillGoesOnAfterQuit();
    void aClockSetToZeroStampsZero();
    void theClockBeginsAgainAfterTheTurnsOfItsStep();
    void aCoveredWindowGivesCodesOnly();
    void aLaserThatStartsIsSilentForThreeSeconds();
    void aFaultOfTheHardwareStays();
    void whatIsThereAtConnectIsThere();
    void limitsThatHaveChangedAreToldAndKept();
    void anotherModelIsTold();
    void aFaultGivenTwiceStrikesTwice();
    void theSameSeedGivesTheSameBytes();
};

namespace {

constexpr std::size_t kBeams = 81;
const std::string kRequest = "MD0500058000000";

/// What comes in a second: turns begin at 11 ms, 36 ms, ..., and end for step 580 after 10.07 ms: 40 of them.
std::string streamWith(std::vector<FaultAt> faults, std::uint64_t seed = 1, std::chrono::milliseconds time = 1s)
{
    EmulatedLaserOptions options = laserOptions("UTM-30LX", std::move(faults));
    options.seed = seed;
    LaserRig rig{options};
    rig.ask(kRequest);
    return rig.hear(time);
}

std::vector<std::uint32_t> stampsIn(const std::string& bytes)
{
    std::vector<std::uint32_t> stamps;
    for (const ScipFrame& frame : only<ScipFrame>(decode(bytes)))
        stamps.push_back(frame.stamp);
    return stamps;
}

}  // namespace

void EmulatedLaserFaultsTest::everyKindIsKnownAndSaid()
{
    for (const char* const kind : {"laser-unplug", "laser-cut", "laser-corrupt", "laser-interleave", "laser-prestream",
                                   "laser-time-mode", "laser-scip1", "laser-boot", "laser-malfunction", "laser-silent",
                                   "laser-stuck-time", "laser-wrap", "laser-reset", "laser-count", "laser-blind",
                                   "laser-garbage", "laser-duplicate", "laser-delay", "laser-byte-loss"})
        QVERIFY2(checkLaserFault({kind, 3}).has_value(), kind);
    QCOMPARE(laserFaultKinds().size(), std::size_t(21));
    for (const LaserFaultKind& kind : laserFaultKinds())
        QVERIFY(kind.sentence.size() > 10);
}

void EmulatedLaserFaultsTest::unknownKindsAreRefusedWithThoseThatThereAre()
{
    const auto made = EmulatedLaser::make(viewOfWall(), level, laserOptions("UTM-30LX", {{"laser-fire", 3}}));

    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::Usage);
    QVERIFY(made.error().message.find("'laser-fire'") != std::string::npos);
    for (const LaserFaultKind& kind : laserFaultKinds())
        QVERIFY(made.error().message.find(kind.name) != std::string::npos);
    QCOMPARE(checkLaserFault({"laser-cut", -1}).error().code, ErrorCode::Usage);
}

void EmulatedLaserFaultsTest::damagedScansAreDamagedAndNoOthers_data()
{
    QTest::addColumn<QString>("kind");
    for (const char* const kind :
         {"laser-cut", "laser-corrupt", "laser-interleave", "laser-garbage", "laser-byte-loss", "laser-count"})
        QTest::newRow(kind) << QString{kind};
}

void EmulatedLaserFaultsTest::damagedScansAreDamagedAndNoOthers()
{
    QFETCH(QString, kind);
    const auto healthy = stampsIn(streamWith({}));
    QCOMPARE(healthy.size(), std::size_t(40));

    const std::string bytes = streamWith({{kind.toStdString(), 10}});
    const auto found = stampsIn(bytes);

    QVERIFY(!only<ScipDamage>(decode(bytes)).empty());
    QVERIFY(std::includes(healthy.begin(), healthy.end(), found.begin(), found.end()));
    // What is cut or overlaps may take the next scan with it.
    QVERIFY(found.size() == 39 || found.size() == 38);
    QVERIFY(std::equal(healthy.begin(), healthy.begin() + 10, found.begin()));
    QVERIFY(std::equal(healthy.end() - 28, healthy.end(), found.end() - 28));
}

void EmulatedLaserFaultsTest::manySeedsDamageManyPlaces()
{
    const std::string healthy = streamWith({});
    for (const char* const kind :
         {"laser-cut", "laser-corrupt", "laser-interleave", "laser-garbage", "laser-byte-loss"}) {
        std::map<std::size_t, int> places;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const std::string bytes = streamWith({{kind, 10}}, seed);
            const auto first = std::mismatch(bytes.begin(), bytes.end(), healthy.begin(), healthy.end()).first;
            ++places[static_cast<std::size_t>(first - bytes.begin())];
            for (const ScipFrame& frame : only<ScipFrame>(decode(bytes)))
                QCOMPARE(frame.ranges[40], 4000U);
        }
        QVERIFY2(places.size() >= (std::string{kind} == "laser-garbage" ? 1U : 10U), kind);
    }
}

void EmulatedLaserFaultsTest::aCutScanIsACut()
{
    const std::string healthy = streamWith({});
    const std::string cut = streamWith({{"laser-cut", 10}});

    QVERIFY(cut.size() < healthy.size());
    const auto first = std::mismatch(cut.begin(), cut.end(), healthy.begin(), healthy.end()).first;
    const auto rest = static_cast<std::size_t>(cut.end() - first);
    QVERIFY(std::equal(first, cut.end(), healthy.end() - static_cast<std::ptrdiff_t>(rest)));
}

void EmulatedLaserFaultsTest::aDuplicateIsTheSameScanTwice()
{
    const auto stamps = stampsIn(streamWith({{"laser-duplicate", 10}}));

    QCOMPARE(stamps.size(), std::size_t(41));
    QCOMPARE(stamps[10], stamps[11]);
    QCOMPARE(stamps[12], stamps[11] + 25);
}

void EmulatedLaserFaultsTest::anInterleavedReplyIsInTheMiddleOfAScan()
{
    const std::string bytes = streamWith({{"laser-interleave", 10}});

    const std::size_t reply = bytes.find("II\n00P\nMODL:");
    QVERIFY(reply != std::string::npos);
    QVERIFY(bytes.find("STAT:Sensor works well.;8\n\n", reply) != std::string::npos);
    QCOMPARE(stampsIn(bytes).size(), std::size_t(39));
}

void EmulatedLaserFaultsTest::aDelayedScanHoldsThoseBehindIt()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-delay", 10}})};
    rig.ask(kRequest);
    // Turn 10 begins at 11 + 250 ms and ends for step 580 after 10.07 ms.
    QCOMPARE(stampsIn(rig.hear(470ms)).size(), std::size_t(10));

    const auto late = stampsIn(rig.hear(475ms));

    QCOMPARE(late.size(), std::size_t(9));
    QVERIFY(rig.lastAt <= 475ms);
}

void EmulatedLaserFaultsTest::theLinkIsPulledOutInTheMiddleOfAScan()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-unplug", 10}})};
    rig.ask(kRequest);
    QVERIFY(rig.laser->isConnected(271ms));

    const std::string bytes = rig.hear(2s);

    QVERIFY(!rig.laser->isConnected(2s));
    QCOMPARE(stampsIn(bytes).size(), std::size_t(10));
    QVERIFY(!bytes.ends_with("\n\n"));
    QVERIFY(rig.hear(3s).empty());
}

void EmulatedLaserFaultsTest::aLinkThatNeverWasIsNotConnected()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-unplug", 0}})};

    QVERIFY(!rig.laser->isConnected(0ms));
}

void EmulatedLaserFaultsTest::silenceEndsWhenScansAreAskedForAnew()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-silent", 10}})};
    rig.ask(kRequest);
    QCOMPARE(stampsIn(rig.hear(1s)).size(), std::size_t(10));
    QCOMPARE(rig.ask("QT"), std::string{"QT\n00P\n\n"});

    rig.ask(kRequest);

    QCOMPARE(stampsIn(rig.hear(2s)).size(), std::size_t(40));
}

void EmulatedLaserFaultsTest::aTimeThatStandsStillGoesOnAfterQuit()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-stuck-time", 10}})};
    rig.ask(kRequest);
    const auto stamps = stampsIn(rig.hear(1s));
    QVERIFY(stamps[9] + 25 == stamps[10]);
    QVERIFY(std::all_of(stamps.begin() + 10, stamps.end(), [&](std::uint32_t stamp) { return stamp == stamps[10]; }));
    rig.ask("QT");

    rig.ask(kRequest);

    const auto after = stampsIn(rig.hear(2s));
    QVERIFY(after[0] > stamps[10] + 500);
    QVERIFY(after[1] == after[0] + 25);
}

void EmulatedLaserFaultsTest::aClockSetToZeroStampsZero()
{
    const auto stamps = stampsIn(streamWith({{"laser-reset", 10}}));

    QCOMPARE(stamps[9], 60'011U + 225U);
    QCOMPARE(stamps[10], 0U);
    QCOMPARE(stamps[11], 25U);
}

void EmulatedLaserFaultsTest::theClockBeginsAgainAfterTheTurnsOfItsStep()
{
    const auto stamps = stampsIn(streamWith({{"laser-wrap", 40}}, 1, 5s));

    // 3 s and 40 turns after the first word, that is at 4 s; turns begin at 11 ms, 36 ms and so on.
    const auto wrapped =
        std::find_if(stamps.begin(), stamps.end(), [](std::uint32_t stamp) { return stamp < 100'000; });
    QVERIFY(wrapped != stamps.begin() && wrapped != stamps.end());
    QCOMPARE(*wrapped, 11U);
    QCOMPARE(*std::prev(wrapped), 0x1000000U - 14U);
}

void EmulatedLaserFaultsTest::aCoveredWindowGivesCodesOnly()
{
    const auto frames = only<ScipFrame>(decode(streamWith({{"laser-blind", 10}})));

    QVERIFY((frames[9].ranges != std::vector<std::uint32_t>(kBeams, 4)));
    QVERIFY((frames[10].ranges == std::vector<std::uint32_t>(kBeams, 4)));
    QVERIFY((frames.back().ranges == std::vector<std::uint32_t>(kBeams, 4)));
}

void EmulatedLaserFaultsTest::aLaserThatStartsIsSilentForThreeSeconds()
{
    LaserRig starting{laserOptions("UTM-30LX", {{"laser-boot", 0}})};
    QCOMPARE(starting.ask("VV"), std::string{});
    starting.now = 3s;
    QVERIFY(starting.ask("VV").starts_with("VV\n00P\n"));

    LaserRig rig{laserOptions("UTM-30LX", {{"laser-boot", 10}})};
    rig.ask(kRequest);
    QCOMPARE(stampsIn(rig.hear(2s)).size(), std::size_t(10));
    QCOMPARE(rig.ask("QT"), std::string{});
    rig.now = 4s;
    QCOMPARE(rig.ask("QT"), std::string{"QT\n00P\n\n"});
}

void EmulatedLaserFaultsTest::aFaultOfTheHardwareStays()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-malfunction", 10}})};
    rig.ask(kRequest);
    const std::string bytes = rig.hear(1s);
    QCOMPARE(stampsIn(bytes).size(), std::size_t(10));
    QVERIFY(bytes.ends_with("\n\n" + kRequest + "\n70W\n\n"));

    rig.ask("RS");

    QCOMPARE(rig.ask("BM"), std::string{"BM\n01Q\n\n"});
    LaserRig fromTheBeginning{laserOptions("UTM-30LX", {{"laser-malfunction", 0}})};
    QCOMPARE(fromTheBeginning.ask("BM"), std::string{"BM\n01Q\n\n"});
}

void EmulatedLaserFaultsTest::whatIsThereAtConnectIsThere()
{
    LaserRig streaming{laserOptions("UTM-30LX", {{"laser-prestream", 0}})};
    streaming.hear(0ms);
    QCOMPARE(only<ScipFrame>(decode(streaming.hear(1s))).size(), std::size_t(39));
    LaserRig inTimeMode{laserOptions("UTM-30LX", {{"laser-time-mode", 7}})};
    QCOMPARE(inTimeMode.ask("QT"), std::string{"QT\n0Ee\n\n"});
    LaserRig old{laserOptions("URG-04LX", {{"laser-scip1", 0}})};
    QCOMPARE(old.ask("VV"), std::string{"VV\nE\n\n"});
}

void EmulatedLaserFaultsTest::limitsThatHaveChangedAreToldAndKept()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-limits", 3}})};
    QVERIFY(rig.ask("PP").find("AMIN:0;") != std::string::npos);
    rig.ask("MD0000108000000");
    rig.hear(rig.now + 200ms);
    rig.ask("QT");

    const std::string limits = rig.ask("PP");

    // Ten degrees are 40 of 1440 steps.
    QVERIFY2(limits.find("AMIN:40;") != std::string::npos, limits.c_str());
    QVERIFY2(limits.find("AMAX:1040;") != std::string::npos, limits.c_str());
    QVERIFY(rig.ask("MD0039104000000").find("\n04") != std::string::npos);
    QVERIFY(rig.ask("MD0040104000000").find("\n00P") != std::string::npos);
}

void EmulatedLaserFaultsTest::anotherModelIsTold()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-model", 3}})};
    const std::string serial = rig.ask("VV");
    rig.ask("MD0000108000000");
    rig.hear(rig.now + 200ms);
    rig.ask("QT");

    QVERIFY(rig.ask("PP").find("MODL:UTM-30LX-EW(") != std::string::npos);
    const std::string identity = rig.ask("VV");
    QVERIFY(identity.find("TOP-URG UTM-30LX-EW;") != std::string::npos);
    QCOMPARE(identity.substr(identity.find("SERI:")), serial.substr(serial.find("SERI:")));
}

void EmulatedLaserFaultsTest::aFaultGivenTwiceStrikesTwice()
{
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-silent", 10}, {"laser-silent", 10}})};
    rig.ask(kRequest);
    QCOMPARE(stampsIn(rig.hear(1s)).size(), std::size_t(10));
    rig.ask(kRequest);
    QVERIFY(stampsIn(rig.hear(2s)).empty());

    rig.ask(kRequest);

    QVERIFY(!stampsIn(rig.hear(3s)).empty());
}

void EmulatedLaserFaultsTest::theSameSeedGivesTheSameBytes()
{
    const std::vector<FaultAt> faults{{"laser-garbage", 5}, {"laser-cut", 7}, {"laser-corrupt", 9}, {"laser-cut", 7}};

    QVERIFY(streamWith(faults, 3) == streamWith(faults, 3));
    QVERIFY(streamWith(faults, 3) != streamWith(faults, 4));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedLaserFaultsTest)
#include "emulated_laser_faults_test.moc"
