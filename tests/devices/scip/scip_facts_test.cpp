// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_facts.h"

#include <QtTest>

#include "devices/scip/scip_capabilities.h"
#include "devices/scip/scip_ranges.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ScipFactsTest : public QObject {
    Q_OBJECT

private slots:
    void aRealUtm30lxIsKnownByItsReplies();
    void blanksAroundValuesDoNotCount();
    void impossibleLimitsAreRefused_data();
    void impossibleLimitsAreRefused();
    void theTimeOfIiHasSixHexadecimalDigitsOrFourCharacters();
    void onlyWordsThatTellOfAFaultAreOne_data();
    void onlyWordsThatTellOfAFaultAreOne();
    void whatALaserCanIsKnownByItsNames_data();
    void whatALaserCanIsKnownByItsNames();
    void codesOfTheTwoFamiliesDiffer();
    void rangesAreThoseWithinTheLimits();
};

namespace {

ScipReply replyOf(const std::string& echo, const std::vector<std::string>& lines)
{
    ScipReply reply{echo, "00", {}};
    for (const std::string& line : lines)
        reply.lines.push_back({line, true});
    return reply;
}

std::vector<std::string> limitsOfUtm30lx()
{
    return {"MODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.)",
            "DMIN:23",
            "DMAX:60000",
            "ARES:1440",
            "AMIN:0",
            "AMAX:1080",
            "AFRT:540",
            "SCAN:2400"};
}

LaserIdentity utm30lx(const std::string& firmware)
{
    LaserIdentity identity;
    identity.product = "SOKUIKI Sensor TOP-URG UTM-30LX";
    identity.firmware = firmware;
    identity.protocol = "SCIP 2.0";
    return identity;
}

LaserLimits limitsOf(double rangeMin, double rangeMax)
{
    LaserLimits limits;
    limits.rangeMin = rangeMin;
    limits.rangeMax = rangeMax;
    return limits;
}

}  // namespace

void ScipFactsTest::aRealUtm30lxIsKnownByItsReplies()
{
    const LaserIdentity identity =
        readScipIdentity(replyOf("VV", {"VEND:Hokuyo Automatic Co.,Ltd.", "PROD:SOKUIKI Sensor TOP-URG UTM-30LX",
                                        "FIRM:P.1.05(17/Apr./2009)", "PROT:SCIP 2.0", "SERI:00903971"}));
    QCOMPARE(identity.vendor, std::string{"Hokuyo Automatic Co.,Ltd."});
    QCOMPARE(identity.product, std::string{"SOKUIKI Sensor TOP-URG UTM-30LX"});
    QCOMPARE(identity.firmware, std::string{"P.1.05(17/Apr./2009)"});
    QCOMPARE(identity.protocol, std::string{"SCIP 2.0"});
    QCOMPARE(identity.serial, std::string{"00903971"});

    const auto limits = readScipLimits(replyOf("PP", limitsOfUtm30lx()), "usb 1-4");

    QVERIFY(limits);
    QCOMPARE(limits->rangeMin, 0.023);
    QCOMPARE(limits->rangeMax, 60.0);
    QCOMPARE(limits->stepsPerTurn, 1440);
    QCOMPARE(limits->firstStep, 0);
    QCOMPARE(limits->lastStep, 1080);
    QCOMPARE(limits->frontStep, 540);
    QVERIFY(limits->period == 25ms);
}

void ScipFactsTest::blanksAroundValuesDoNotCount()
{
    const ScipReply reply = replyOf("VV", {"SERI: H0508486 ", "FIRM:", "PROT:  "});

    QCOMPARE(*scipField(reply, "SERI"), std::string{"H0508486"});
    QCOMPARE(*scipField(reply, "FIRM"), std::string{});
    QCOMPARE(*scipField(reply, "PROT"), std::string{});
    QVERIFY(!scipField(reply, "SER"));
}

void ScipFactsTest::impossibleLimitsAreRefused_data()
{
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("named");
    const auto row = [](int line, const char* text, const char* named) {
        QTest::newRow(text) << line << QString{text} << QString{named};
    };
    row(0, "MODE:x", "MODL missing");
    row(1, "DMIN:0", "DMIN = '0'");
    row(1, "DMIN:-23", "DMIN = '-23'");
    row(1, "DMIN:2e3", "DMIN = '2e3'");
    row(2, "DMAX:22", "DMAX = '22'");
    row(2, "DMAX:99999999999", "DMAX = '99999999999'");
    row(2, "DMAX:262144", "DMAX = '262144'");
    row(3, "ARES:7", "ARES = '7'");
    row(4, "AMIN:", "AMIN = ''");
    row(5, "AMAX:0", "AMAX = '0'");
    row(5, "AMAX:1441", "AMAX = '1441'");
    row(6, "AFRT:1081", "AFRT = '1081'");
    row(7, "SCAN:0", "SCAN = '0'");
    row(7, "SCAM:2400", "SCAN missing");
}

void ScipFactsTest::impossibleLimitsAreRefused()
{
    QFETCH(int, line);
    QFETCH(QString, text);
    QFETCH(QString, named);
    std::vector<std::string> lines = limitsOfUtm30lx();
    lines[static_cast<std::size_t>(line)] = text.toStdString();

    const auto limits = readScipLimits(replyOf("PP", lines), "usb 1-4");

    QVERIFY(!limits);
    QCOMPARE(limits.error().code, ErrorCode::NoDevice);
    QVERIFY(limits.error().message.starts_with("usb 1-4: "));
    QVERIFY2(limits.error().message.find(named.toStdString()) != std::string::npos, limits.error().message.c_str());
}

void ScipFactsTest::theTimeOfIiHasSixHexadecimalDigitsOrFourCharacters()
{
    const auto clockOf = [](const std::string& time) { return readScipState(replyOf("II", {"TIME:" + time})).clock; };

    QVERIFY(clockOf("4991D0") == 4'821'456U);
    QVERIFY(clockOf("BI9Y") == 4'821'609U);
    QVERIFY(clockOf("002AA9") == 10'921U);
    QVERIFY(!clockOf("4991G0"));
    QVERIFY(!clockOf("12345"));
    QVERIFY(!clockOf(""));
    QVERIFY(!readScipState(replyOf("II", {})).clock);
}

void ScipFactsTest::onlyWordsThatTellOfAFaultAreOne_data()
{
    QTest::addColumn<QString>("condition");
    QTest::addColumn<bool>("isHealthy");
    QTest::addColumn<bool>("isFaulty");
    const auto row = [](const char* condition, bool isHealthy, bool isFaulty) {
        QTest::newRow(condition) << QString{condition} << isHealthy << isFaulty;
    };
    row("Sensor works well.", true, false);
    row("sensor is working normally", true, false);
    row("Stable 000 no error.", true, false);
    row("Trouble!! Error No. =[00->33]", false, true);
    row("Abnormal status", false, true);
    row("Unstable 001", false, false);
    row("", false, false);
}

void ScipFactsTest::onlyWordsThatTellOfAFaultAreOne()
{
    QFETCH(QString, condition);
    QFETCH(bool, isHealthy);
    QFETCH(bool, isFaulty);

    const ScipState state = readScipState(replyOf("II", {"STAT:" + condition.toStdString()}));

    QCOMPARE(state.isHealthy, isHealthy);
    QCOMPARE(state.isFaulty, isFaulty);
    QCOMPARE(state.condition, condition.toStdString());
}

void ScipFactsTest::whatALaserCanIsKnownByItsNames_data()
{
    QTest::addColumn<QString>("product");
    QTest::addColumn<QString>("firmware");
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<int>("widestIntensity");  // degrees, 0: any
    QTest::addColumn<QString>("able");         // T: time mode, S: line speed, C: motor speed, R: reboot, E: multi-echo
    const auto row = [](const char* product, const char* firmware, const char* protocol, int widest, const char* able) {
        QTest::addRow("%s %s", product, firmware) << product << firmware << protocol << widest << able;
    };
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "P.1.05(17/Apr./2009)", "SCIP 2.0", 95, "T");
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "1.16.01(16/Nov./2009)", "SCIP 2.0", 190, "T");
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "1.16.02(19/Jan./2010)", "SCIP 2.0", 95, "");
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "1.18.01(09/Jul./2010)", "SCIP 2.0", 0, "T");
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "1.20.02(16/Jul./2013)", "SCIP 2.0", 0, "T");
    row("SOKUIKI Sensor TOP-URG UTM-30LX", "", "SCIP 2.0", 95, "T");
    row("SOKUIKI Sensor TOP-URG UTM-30LX-EW", "1.1.8", "SCIP 2.2", 0, "TRE");
    row("UST-20LX", "2.23.0000", "SCIP 2.2", 0, "TRE");
    row("SOKUIKI Sensor UXM-30LX-E", "1.0", "SCIP 2.0", 0, "TE");
    row("SOKUIKI Sensor URG-04LX", "3.3.00(16/Apr./2008)", "SCIP 2.0", 0, "TSC");
    row("SOKUIKI Sensor URG-04LX-UG01(Simple-URG)", "3.4.03", "SCIP 2.0", 0, "TC");
    row("Something else", "", "", 0, "");
}

void ScipFactsTest::whatALaserCanIsKnownByItsNames()
{
    QFETCH(QString, product);
    QFETCH(QString, firmware);
    QFETCH(QString, protocol);
    QFETCH(int, widestIntensity);
    QFETCH(QString, able);
    LaserIdentity identity = utm30lx(firmware.toStdString());
    identity.product = product.toStdString();
    identity.protocol = protocol.toStdString();

    const ScipCapabilities can = scipCapabilities(identity);

    QCOMPARE(can.widestIntensity.has_value(), widestIntensity > 0);
    if (can.widestIntensity)
        QVERIFY(std::abs(*can.widestIntensity - widestIntensity * 3.14159265358979 / 180.0) < 1e-9);
    QCOMPARE(can.timeMode, able.contains('T'));
    QCOMPARE(can.lineSpeed, able.contains('S'));
    QCOMPARE(can.motorSpeed, able.contains('C'));
    QCOMPARE(can.reboot, able.contains('R'));
    QCOMPARE(can.multiEcho, able.contains('E'));
}

void ScipFactsTest::codesOfTheTwoFamiliesDiffer()
{
    const ScipRanges utm{"UTM-30LX(Hokuyo Automatic Co.,Ltd.)", limitsOf(0.023, 60.0)};
    const ScipRanges urg{"URG-04LX(Hokuyo Automatic Co.,Ltd.)", limitsOf(0.02, 5.6)};

    QCOMPARE(utm.kindOf(0), ScipReturn::Undocumented);
    QCOMPARE(utm.kindOf(1), ScipReturn::NoObject);
    QCOMPARE(utm.kindOf(2), ScipReturn::TooNear);
    QCOMPARE(utm.kindOf(3), ScipReturn::Interference);
    QCOMPARE(utm.kindOf(4), ScipReturn::TooNear);
    QCOMPARE(utm.kindOf(5), ScipReturn::Error);
    QCOMPARE(utm.kindOf(6), ScipReturn::Undocumented);
    QCOMPARE(utm.kindOf(22), ScipReturn::Undocumented);
    QCOMPARE(utm.kindOf(65'533), ScipReturn::NoObject);
    QCOMPARE(urg.kindOf(0), ScipReturn::NoObject);
    QCOMPARE(urg.kindOf(1), ScipReturn::Weak);
    QCOMPARE(urg.kindOf(2), ScipReturn::Weak);
    QCOMPARE(urg.kindOf(3), ScipReturn::Undocumented);
    QCOMPARE(urg.kindOf(6), ScipReturn::Error);
    QCOMPARE(urg.kindOf(19), ScipReturn::Error);
    QCOMPARE(urg.kindOf(6000), ScipReturn::NoObject);
}

void ScipFactsTest::rangesAreThoseWithinTheLimits()
{
    const ScipRanges utm{"UTM-30LX", limitsOf(0.023, 60.0)};
    for (const std::uint32_t raw : {0U, 1U, 5U, 22U, 60'001U, 65'533U, 262'143U})
        QVERIFY(!utm.rangeOf(raw));
    for (const std::uint32_t raw : {23U, 1234U, 60'000U})
        QVERIFY(utm.rangeOf(raw) == raw);

    // Its own limit may lie in the middle of its codes.
    const ScipRanges urg{"URG-04LX", limitsOf(0.01, 5.6)};
    QVERIFY(!urg.rangeOf(19));
    QVERIFY(urg.rangeOf(20) == 20U);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipFactsTest)
#include "scip_facts_test.moc"
