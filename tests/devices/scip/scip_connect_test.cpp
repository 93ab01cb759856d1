// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_connect.h"

#include <map>
#include <random>

#include <QtTest>

#include "devices/emulated/emulated_laser_scan.h"
#include "tests/devices/scip/laser_bench.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// What the driver makes of answers that a good laser does not give.
class ScipConnectTest : public QObject {
    Q_OBJECT

private slots:
    void nothingThatAnswersIsNoDevice();
    void somethingElseThatAnswersIsNoLaser();
    void aStreamOfRubbishIsNoLaser();
    void aLaserThatKnowsOnlyScip1IsTooOld();
    void aLostQuitIsSentAgain();
    void aLaserThatIsNotReadyIsAskedAgain();
    void aLaserThatNeverComesToRestIsGivenUp();
    void aWrongSumThatStaysTheSameIsTheLasersOwn();
    void aWrongSumThatDoesNotStayIsTheLines();
    void aReplyThatIsNeverIntactIsNoDevice();
    void limitsThatAreMissingAreNoDevice();
    void wordsThatNobodyKnowsAreAWarning();
    void timeModeThatIsRefusedIsDoneWithout();
    void timeModeThatIsNotYetPossibleIsWaitedFor();
    void timeModeIsLeftWhereTheTimeIsNotTold();
    void firmwareWithAWrongClockIsNotAsked();
    void aLaserThatDoesNotSwitchOnIsToldWithItsCode();
    void aFaultAtSwitchOnIsResetAndStartedAnewOnce();
    void aRefusedScanIsToldWithItsCode();
    void aStopThatIsNotAnsweredIsALoss();
    void aStopThatIsLostIsSentAgain();
    void repliesWithoutEndDoNotHoldUpNext();
    void aLaserIsConnectedAgainAfterAnError();
};

namespace {

/// Answers of a good laser, by request; a test changes some. Requests with a tag are answered as without.
class Answers {
public:
    Answers()
    {
        texts_["QT"] = laserReply("QT", "00");
        texts_["VV"] =
            laserReply("VV", "00",
                       {laserField("VEND", "Hokuyo Automatic Co.,Ltd."), laserField("PROD", "UST-20LX"),
                        laserField("FIRM", "2.0"), laserField("PROT", "SCIP 2.2"), laserField("SERI", "H1")});
        texts_["PP"] = laserReply("PP", "00",
                                  {laserField("MODL", "UST-20LX"), laserField("DMIN", "20"),
                                   laserField("DMAX", "60000"), laserField("ARES", "1440"), laserField("AMIN", "0"),
                                   laserField("AMAX", "1080"), laserField("AFRT", "540"), laserField("SCAN", "2400")});
        texts_["II"] = laserReply("II", "00", {laserField("STAT", "Stable 000 no error.")});
        for (const char* const request : {"BM", "TM0", "TM2", "RS", "MD0000108000000", "MD0500058000000"})
            texts_[request] = laserReply(request, "00");
    }

    std::string& operator[](const std::string& request) { return texts_[request]; }

    std::string operator()(const std::string& request)
    {
        ++asked_[request];
        if (request.starts_with("TM1;"))
            return texts_.contains("TM1") ? texts_["TM1"] : laserReply(request, "00", {withPlainSum("0000")});
        const auto text = texts_.find(request);
        return text == texts_.end() ? std::string{} : text->second;
    }

    int asked(const std::string& request) { return asked_[request]; }

private:
    std::map<std::string, std::string> texts_;
    std::map<std::string, int> asked_;
};

std::shared_ptr<AnsweringDevice> scripted(std::function<std::string(const std::string&)> answer)
{
    return std::make_shared<AnsweringDevice>(std::move(answer));
}

void compareNoDevice(const Result<void>& result, const std::string& words, ErrorCode code = ErrorCode::NoDevice)
{
    QVERIFY(!result);
    QCOMPARE(result.error().code, code);
    QVERIFY(result.error().message.starts_with("usb 1-4: "));
    QVERIFY2(result.error().message.find(words) != std::string::npos, result.error().message.c_str());
}

}  // namespace

void ScipConnectTest::nothingThatAnswersIsNoDevice()
{
    LaserBench bench{scripted([](const std::string&) { return std::string{}; })};

    compareNoDevice(bench.connect(), "12 V supply");

    QVERIFY(bench.clock.now() >= 20s && bench.clock.now() < 25s);
    QVERIFY(bench.progress.size() > 20);
    QCOMPARE(bench.progress.back(), std::string{"usb 1-4: waiting for the laser to start, up to 1 s more"});
}

void ScipConnectTest::somethingElseThatAnswersIsNoLaser()
{
    LaserBench bench{scripted([](const std::string& request) { return request + "\r\nERROR\r\n> "; })};

    compareNoDevice(bench.connect(), "no laser that speaks SCIP");
    QVERIFY(bench.clock.now() < 25s);
}

void ScipConnectTest::aStreamOfRubbishIsNoLaser()
{
    std::mt19937 random(1);
    const auto device = scripted([](const std::string&) { return std::string{}; });
    for (auto at = 0ms; at < 60s; at += 5ms) {
        std::string bytes(64, '\0');
        for (char& c : bytes)
            c = static_cast<char>(random() % 256);
        device->say(bytes, at);
    }
    LaserBench bench{device};

    compareNoDevice(bench.connect(), "no laser that speaks SCIP");
    QVERIFY(bench.clock.now() < 30s);
}

void ScipConnectTest::aLaserThatKnowsOnlyScip1IsTooOld()
{
    LaserBench bench{scripted([](const std::string& request) { return request + "\nE\n\n"; })};

    compareNoDevice(bench.connect(), "too old");
    QCOMPARE(bench.timesAsked("SCIP2.0"), std::size_t(1));
}

void ScipConnectTest::aLostQuitIsSentAgain()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "QT" && answers->asked("QT") == 1 ? std::string{} : text;
    })};

    QVERIFY(bench.connect());
    QCOMPARE(bench.timesAsked("QT"), std::size_t(3));
}

void ScipConnectTest::aLaserThatIsNotReadyIsAskedAgain()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "QT" && answers->asked("QT") <= 6 ? laserReply("QT", "10") : text;
    })};

    QVERIFY(bench.connect());
    QVERIFY(bench.clock.now() >= 3s && bench.clock.now() < 6s);
}

void ScipConnectTest::aLaserThatNeverComesToRestIsGivenUp()
{
    for (const char* const status : {"0E", "10", "0L", "77"}) {
        LaserBench bench{scripted([&](const std::string& request) { return laserReply(request, status); })};

        compareNoDevice(bench.connect(), "does not come to rest");
        QVERIFY(bench.asked.size() < 200);
        QVERIFY(bench.timesAsked("RS") <= 1);
    }
}

void ScipConnectTest::aWrongSumThatStaysTheSameIsTheLasersOwn()
{
    Answers answers;
    answers["VV"] = "VV\n00P\nPROD:URG-04LX;X\nPROT:SCIP 2.0;N\nSERI: H0508486;0\nsurplus\n\n";
    LaserBench bench{scripted(answers)};

    QVERIFY(bench.connect());

    QCOMPARE(bench.laser->identity().serial, std::string{"H0508486"});
    QCOMPARE(bench.timesAsked("VV"), std::size_t(2));
}

void ScipConnectTest::aWrongSumThatDoesNotStayIsTheLines()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "PP" && answers->asked("PP") == 1 ? "PP\n00P\nDMAX:66000;J\n\n" : text;
    })};

    QVERIFY(bench.connect());

    QCOMPARE(bench.laser->limits().rangeMax, 60.0);
    QCOMPARE(bench.timesAsked("PP"), std::size_t(2));
}

void ScipConnectTest::aReplyThatIsNeverIntactIsNoDevice()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        if (request != "VV")
            return text;
        return "VV\n00P\nSERI:" + std::to_string(answers->asked("VV")) + ";~\n\n";
    })};

    compareNoDevice(bench.connect(), "does not answer to VV");
}

void ScipConnectTest::limitsThatAreMissingAreNoDevice()
{
    Answers answers;
    answers["PP"] = laserReply("PP", "00", {laserField("MODL", "UST-20LX"), laserField("DMIN", "20")});
    LaserBench bench{scripted(answers)};

    compareNoDevice(bench.connect(), "AMAX missing");
}

void ScipConnectTest::wordsThatNobodyKnowsAreAWarning()
{
    Answers answers;
    answers["II"] = laserReply("II", "00", {laserField("STAT", "Feeling fine")});
    LaserBench bench{scripted(answers)};

    QVERIFY(bench.connect());

    QCOMPARE(bench.laser->health().trouble, std::string{"the laser says of itself 'Feeling fine'"});
}

void ScipConnectTest::timeModeThatIsRefusedIsDoneWithout()
{
    Answers answers;
    answers["TM0"] = laserReply("TM0", "0E");
    LaserBench bench{scripted(answers)};

    QVERIFY(bench.begin());

    QCOMPARE(bench.timesAsked("TM0"), std::size_t(1));
    QCOMPARE(bench.timesAsked("TM1;t0"), std::size_t(0));
}

void ScipConnectTest::timeModeThatIsNotYetPossibleIsWaitedFor()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "TM0" && answers->asked("TM0") < 5 ? laserReply("TM0", "10") : text;
    })};

    QVERIFY(bench.begin());

    QCOMPARE(bench.timesAsked("TM0"), std::size_t(5));
    QCOMPARE(bench.timesAsked("TM2"), std::size_t(1));
    QCOMPARE(bench.progress.size(), std::size_t(4));
}

void ScipConnectTest::timeModeIsLeftWhereTheTimeIsNotTold()
{
    for (const std::string& answer : {std::string{}, laserReply("TM1;t0", "04"), laserReply("TM1;t0", "00"),
                                      std::string{"TM1;t0\n00P\n0000X\n\n"}}) {
        Answers answers;
        answers["TM1"] = answer;
        LaserBench bench{scripted(answers)};

        QVERIFY(bench.begin());

        QCOMPARE(bench.timesAsked("TM1;t0"), std::size_t(1));
        QCOMPARE(bench.timesAsked("TM1;t1"), std::size_t(0));
        QCOMPARE(bench.timesAsked("TM2"), std::size_t(1));
    }
}

void ScipConnectTest::firmwareWithAWrongClockIsNotAsked()
{
    Answers answers;
    answers["VV"] = laserReply("VV", "00",
                               {laserField("PROD", "SOKUIKI Sensor TOP-URG UTM-30LX"),
                                laserField("FIRM", "1.16.02(19/Jan./2010)"), laserField("PROT", "SCIP 2.0")});
    std::string& limits = answers["PP"];
    limits.replace(limits.find("MODL:UST-20LX"), 15, laserField("MODL", "UTM-30LX"));
    LaserBench bench{scripted(answers)};

    QVERIFY(bench.begin());

    QCOMPARE(bench.timesAsked("TM0"), std::size_t(0));
}

void ScipConnectTest::aLaserThatDoesNotSwitchOnIsToldWithItsCode()
{
    Answers answers;
    answers["BM"] = laserReply("BM", "0E");
    LaserBench bench{scripted(answers)};

    compareNoDevice(bench.begin(), "status 0E");
    Answers never;
    never["BM"] = laserReply("BM", "10");
    LaserBench waiting{scripted(never)};
    compareNoDevice(waiting.begin(), "has not become ready within 20 s");
}

void ScipConnectTest::aFaultAtSwitchOnIsResetAndStartedAnewOnce()
{
    Answers answers;
    answers["BM"] = laserReply("BM", "01");
    LaserBench bench{scripted(answers)};

    compareNoDevice(bench.begin(), "status 01: the laser cannot be switched on", ErrorCode::NeedsOperator);

    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(2));  // twice is once: a model that has it
    QCOMPARE(bench.timesAsked("BM"), std::size_t(3));
}

void ScipConnectTest::aRefusedScanIsToldWithItsCode()
{
    Answers answers;
    answers["MD0500058000000"] = laserReply("MD0500058000000", "05");
    LaserBench bench{scripted(answers)};

    compareNoDevice(bench.begin(), "status 05");
    answers["MD0500058000000"] = laserReply("MD0500058000000", "70");
    LaserBench faulty{scripted(answers)};
    compareNoDevice(faulty.begin(), "status 70", ErrorCode::NeedsOperator);
    QCOMPARE(faulty.timesAsked("RS"), std::size_t(1));
}

void ScipConnectTest::aStopThatIsNotAnsweredIsALoss()
{
    auto answers = std::make_shared<Answers>();
    LaserBench bench{scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "QT" && answers->asked("QT") > 2 ? std::string{} : text;
    })};
    QVERIFY(bench.begin());

    const auto stopped = bench.laser->stop();

    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::DeviceLost);
    QCOMPARE(bench.timesAsked("QT"), std::size_t(4));
}

void ScipConnectTest::aStopThatIsLostIsSentAgain()
{
    auto answers = std::make_shared<Answers>();
    const auto device = scripted([answers](const std::string& request) {
        const std::string text = (*answers)(request);
        return request == "QT" && answers->asked("QT") == 3 ? std::string{} : text;
    });
    LaserBench bench{device};
    QVERIFY(bench.begin());
    const auto from = bench.clock.now();
    for (auto at = from; at < from + 10s; at += 25ms)
        device->say(plainScan("MD0500058000000", 1, std::vector<std::uint32_t>(81, 100)), at);
    QVERIFY(bench.next());

    QVERIFY(bench.laser->stop());

    QCOMPARE(bench.timesAsked("QT"), std::size_t(4));
    QVERIFY(bench.clock.now() - from < 200ms);  // three scans were enough to tell
}

void ScipConnectTest::repliesWithoutEndDoNotHoldUpNext()
{
    const auto device = scripted(Answers{});
    LaserBench bench{device};
    QVERIFY(bench.begin());
    const auto from = bench.clock.now();
    for (auto at = from; at < from + 20s; at += 1ms)
        device->say(laserReply("VV", "00") + "QT\n00P\n\n", at);

    const auto scan = bench.laser->next(from + 100ms, {});
    QVERIFY(scan);
    QVERIFY(!*scan);
    QVERIFY(bench.clock.now() < from + 110ms);
    const auto lost = bench.laser->next(from + 60s, {});

    QVERIFY(!lost);  // and such chatter is no scan
    QCOMPARE(lost.error().code, ErrorCode::DeviceLost);
}

void ScipConnectTest::aLaserIsConnectedAgainAfterAnError()
{
    auto answers = std::make_shared<Answers>();
    (*answers)["PP"] = laserReply("PP", "00", {laserField("MODL", "UST-20LX")});
    LaserBench bench{scripted([answers](const std::string& request) { return (*answers)(request); })};
    QVERIFY(!bench.connect());

    (*answers)["PP"] = Answers{}["PP"];

    QVERIFY(bench.begin());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipConnectTest)
#include "scip_connect_test.moc"
