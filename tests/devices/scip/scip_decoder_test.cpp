// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_decoder.h"

#include <QtTest>

#include "devices/scip/scip_encoding.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

class ScipDecoderTest : public QObject {
    Q_OBJECT

private slots:
    void repliesOfRealSessionsAreRead_data();
    void repliesOfRealSessionsAreRead();
    void identityOfARealUtm30lxIsIntact();
    void limitsOfARealUtm30lxAreIntact();
    void conditionOfARealUtm30lxIsIntact();
    void aSumThatLeavesOutWhatComesAfterTheArrowIsRightForIiOnly();
    void aLineThatIsWronglySummedIsMarked();
    void theTimeOfARealSessionIsRead();
    void theFirstPairsOfARealScanAreRead();
    void aLatestScanHasItsStampBehindStatus00();
    void exactlyTwoQuitsAreFoundBetweenRubbish();
    void aReplyInAScanComesOutAndTheScanDoesNot();
    void aReplyWhoseEmptyLineIsLostIsFollowedByTheNext();
    void aScanWhoseEmptyLineIsLostIsStillWhole();
    void statusesInAStreamAreReplies();
    void piecesDoNotMatter();
    void furtherEchoesAreSortedToTheirBeams();
    void furtherEchoesHaveIntensities();
    void moreThanThreeEchoesAreNone();
    void clustersHaveFewerValues();
    void shortRangesHaveTwoCharacters();
    void anotherNumberOfValuesIsRefused();
    void aLineBeyondTheBoundIsDroppedAndTheNextReplyIsFound();
    void aMessageWithoutEndIsDroppedAtTheBound();
    void whatIsForgottenDoesNotComeBack();
    void damageIsCountedByKind_data();
    void damageIsCountedByKind();
};

void ScipDecoderTest::repliesOfRealSessionsAreRead_data()
{
    QTest::addColumn<QString>("bytes");
    QTest::addColumn<QString>("echo");
    QTest::addColumn<QString>("status");
    const auto row = [](const char* bytes, const char* echo, const char* status) {
        QTest::addRow("%s %s", echo, status) << QString{bytes} << QString{echo} << QString{status};
    };
    row("BM\n02R\n\n", "BM", "02");
    row("CR00\n04T\n\n", "CR00", "04");
    row("ME0000108001101\n00P\n\n", "ME0000108001101", "00");
    row("TM0\n00P\n\n", "TM0", "00");
    row("TM2\n00P\n\n", "TM2", "00");
    row("QT\n00P\n\n", "QT", "00");
    row("QT\n0Ee\n\n", "QT", "0E");
    row("QT\nE\n\n", "QT", "E");
    row("SCIP2.0\n0\n\n", "SCIP2.0", "0");
    row("VV;a1\n0Ll\n\n", "VV;a1", "0L");
}

void ScipDecoderTest::repliesOfRealSessionsAreRead()
{
    QFETCH(QString, bytes);
    QFETCH(QString, echo);
    QFETCH(QString, status);

    const auto events = decode(bytes.toStdString());

    QCOMPARE(events.size(), std::size_t(1));
    const auto reply = only<ScipReply>(events).at(0);
    QCOMPARE(reply.echo, echo.toStdString());
    QCOMPARE(reply.status, status.toStdString());
    QVERIFY(reply.lines.empty());
}

namespace {

void compareIntactLines(const std::string& bytes, const std::vector<std::string>& lines)
{
    const auto events = decode(bytes);
    QCOMPARE(events.size(), std::size_t(1));
    const auto reply = only<ScipReply>(events).at(0);
    QCOMPARE(reply.status, std::string{"00"});
    QCOMPARE(reply.lines.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        QCOMPARE(reply.lines[i].text, lines[i]);
        QVERIFY(reply.lines[i].isIntact);
    }
}

}  // namespace

void ScipDecoderTest::identityOfARealUtm30lxIsIntact()
{
    compareIntactLines(
        "VV\n00P\nVEND:Hokuyo Automatic Co.,Ltd.;[\nPROD:SOKUIKI Sensor TOP-URG UTM-30LX;P\n"
        "FIRM:P.1.05(17/Apr./2009);M\nPROT:SCIP 2.0;N\nSERI:00903971;:\n\n",
        {"VEND:Hokuyo Automatic Co.,Ltd.", "PROD:SOKUIKI Sensor TOP-URG UTM-30LX", "FIRM:P.1.05(17/Apr./2009)",
         "PROT:SCIP 2.0", "SERI:00903971"});
}

void ScipDecoderTest::limitsOfARealUtm30lxAreIntact()
{
    compareIntactLines(
        "PP\n00P\nMODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U\nDMIN:23;7\nDMAX:60000;J\nARES:1440;^\nAMIN:0;?\n"
        "AMAX:1080;Z\nAFRT:540;0\nSCAN:2400;U\n\n",
        {"MODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.)", "DMIN:23", "DMAX:60000", "ARES:1440", "AMIN:0", "AMAX:1080",
         "AFRT:540", "SCAN:2400"});
}

void ScipDecoderTest::conditionOfARealUtm30lxIsIntact()
{
    compareIntactLines(
        "II\n00P\nMODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U\nLASR:ON;9\n"
        "SCSP:Initial(2400[rpm])<-Default setting by user;1\nMESM:CLASSIC;^\nSBPS:USB Full Speed;P\nTIME:4991D0;d\n"
        "STAT:Sensor works well.;8\n\n",
        {"MODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.)", "LASR:ON", "SCSP:Initial(2400[rpm])<-Default setting by user",
         "MESM:CLASSIC", "SBPS:USB Full Speed", "TIME:4991D0", "STAT:Sensor works well."});
}

void ScipDecoderTest::aSumThatLeavesOutWhatComesAfterTheArrowIsRightForIiOnly()
{
    const std::string line = "SCSP:Initial(2400[rpm])<-Default setting by user;";
    const std::string sum{plainSum("SCSP:Initial(2400[rpm])")};

    QVERIFY(only<ScipReply>(decode("II\n00P\n" + line + sum + "\n\n")).at(0).lines.at(0).isIntact);
    QVERIFY(!only<ScipReply>(decode("PP\n00P\n" + line + sum + "\n\n")).at(0).lines.at(0).isIntact);
}

void ScipDecoderTest::aLineThatIsWronglySummedIsMarked()
{
    const auto reply = only<ScipReply>(decode("VV\n00P\nPROT:SCIP 2.0;N\nSERI:00903971;0\nmore\n\n")).at(0);

    QCOMPARE(reply.lines.size(), std::size_t(3));
    QVERIFY(reply.lines[0].isIntact);
    QVERIFY(!reply.lines[1].isIntact);
    QCOMPARE(reply.lines[1].text, std::string{"SERI:00903971"});
    QVERIFY(!reply.lines[2].isIntact);
}

void ScipDecoderTest::theTimeOfARealSessionIsRead()
{
    const auto replies = only<ScipReply>(decode("TM1\n00P\n<SfkP\n\nTM1;a1\n00P\n<SflQ\n\n"));

    QCOMPARE(replies.size(), std::size_t(2));
    QCOMPARE(replies[0].lines.at(0).text, std::string{"<Sfk"});
    QVERIFY(replies[0].lines[0].isIntact);
    QCOMPARE(*fromScip(replies[1].lines.at(0).text), *fromScip(replies[0].lines[0].text) + 1);
    QVERIFY(only<ScipReply>(decode("TM1\n00P\n<SfkQ\n\n")).empty());
}

void ScipDecoderTest::theFirstPairsOfARealScanAreRead()
{
    // The first line of data of a real scan, of which a request for ten beams would have taken the first 60 characters.
    const std::string line = "00]0LA00`0Kd00a0L000b0KB00a0Kc00b0K@00h0KR00h0K^00h0Jm00h0KG00g0";
    const std::string sent =
        "ME0000000901101\n00P\n\nME0000000901100\n99b\nBI9YM\n" + withPlainSum(line.substr(0, 60)) + "\n\n";

    const auto events = decode(sent);

    QCOMPARE(events.size(), std::size_t(2));
    const auto frame = only<ScipFrame>(events).at(0);
    QCOMPARE(frame.echo, std::string{"ME0000000901100"});
    QCOMPARE(frame.stamp, 4'821'609U);
    QCOMPARE(frame.ranges.size(), std::size_t(10));
    QVERIFY((std::vector(frame.ranges.begin(), frame.ranges.begin() + 3) == std::vector<std::uint32_t>{45, 48, 49}));
    QVERIFY((std::vector(frame.intensities.begin(), frame.intensities.begin() + 3) ==
             std::vector<std::uint32_t>{1809, 1780, 1792}));
}

void ScipDecoderTest::aLatestScanHasItsStampBehindStatus00()
{
    const auto frame = only<ScipFrame>(decode("GD0044004501\n00P\nJUGnD\n" + withPlainSum("0C10C2") + "\n\n")).at(0);

    QCOMPARE(frame.stamp, *fromScip("JUGn"));
    QVERIFY((frame.ranges == std::vector<std::uint32_t>{*fromScip("0C1"), *fromScip("0C2")}));
}

void ScipDecoderTest::exactlyTwoQuitsAreFoundBetweenRubbish()
{
    const auto events = decode("QT\n00P\n\nFOO\nBAR\nQT\n\nQT\n\nQT\n00P\n\n\n\n");

    const auto replies = only<ScipReply>(events);
    QCOMPARE(replies.size(), std::size_t(2));
    for (const ScipReply& reply : replies)
        QCOMPARE(reply.echo, std::string{"QT"});
    const auto damages = only<ScipDamage>(events);
    QCOMPARE(damages.size(), std::size_t(2));
    QCOMPARE(damages[0].kind, ScipDamageKind::UnknownEcho);
    QCOMPARE(damages[0].bytes, std::string{"FOO\nBAR\nQT\n"});
    QCOMPARE(damages[1].kind, ScipDamageKind::Status);
}

void ScipDecoderTest::aReplyInAScanComesOutAndTheScanDoesNot()
{
    const std::vector<std::uint32_t> ranges(100, 4321);
    const std::string scan = plainScan("MD0000009900000", 1000, ranges);
    const std::string reply = "II\n00P\nLASR:ON;9\n\n";
    for (std::size_t at = scan.find('\n') + 1; at < scan.size(); ++at) {
        ScipDecoder decoder;

        const auto events = decoder.push(bytesOf(scan.substr(0, at) + reply + scan.substr(at)));
        const auto after = decoder.push(bytesOf(scan));

        if (at < scan.size() - 1)  // before that, the scan is whole but for its empty line
            QVERIFY(only<ScipFrame>(events).empty());
        const bool isLineBegin = scan[at - 1] == '\n';
        QCOMPARE(only<ScipReply>(events).size(), std::size_t(isLineBegin ? 1 : 0));
        QCOMPARE(only<ScipFrame>(after).size(), std::size_t(1));
        QVERIFY(only<ScipFrame>(after)[0].ranges == ranges);
    }
}

void ScipDecoderTest::aReplyWhoseEmptyLineIsLostIsFollowedByTheNext()
{
    const auto replies = only<ScipReply>(decode("QT\n00P\nVV\n00P\nPROT:SCIP 2.0;N\nBM\n02R\n\n"));

    QCOMPARE(replies.size(), std::size_t(3));
    QCOMPARE(replies[0].echo, std::string{"QT"});
    QCOMPARE(replies[1].echo, std::string{"VV"});
    QCOMPARE(replies[1].lines.size(), std::size_t(1));
    QCOMPARE(replies[2].status, std::string{"02"});
}

void ScipDecoderTest::aScanWhoseEmptyLineIsLostIsStillWhole()
{
    std::string scan = plainScan("MD0000000300000", 1000, {11, 12, 13, 14});
    scan.pop_back();

    const auto frames = only<ScipFrame>(decode(scan + plainScan("MD0000000300000", 1025, {21, 22, 23, 24})));

    QCOMPARE(frames.size(), std::size_t(2));
    QVERIFY((frames[0].ranges == std::vector<std::uint32_t>{11, 12, 13, 14}));
    QVERIFY((frames[1].ranges == std::vector<std::uint32_t>{21, 22, 23, 24}));
}

void ScipDecoderTest::statusesInAStreamAreReplies()
{
    const auto replies =
        only<ScipReply>(decode("MD0000108000000\n21S\n\nMD0000108000000\n98a\n\nMD0000108000000\n70W\n\n"));

    QCOMPARE(replies.size(), std::size_t(3));
    QCOMPARE(replies[0].status, std::string{"21"});
    QCOMPARE(replies[1].status, std::string{"98"});
    QCOMPARE(replies[2].status, std::string{"70"});
}

void ScipDecoderTest::piecesDoNotMatter()
{
    const std::string bytes = "\n\nQT\n00P\n\n" +
                              plainScan("MD0000004900000", 77, std::vector<std::uint32_t>(50, 4095)) +
                              "rubbish\n\nVV\n00P\nPROT:SCIP 2.0;N\n\n";
    const std::size_t whole = decode(bytes).size();
    QCOMPARE(whole, std::size_t(4));
    for (std::size_t piece = 1; piece < 20; ++piece) {
        ScipDecoder decoder;
        std::size_t count = 0;
        for (std::size_t at = 0; at < bytes.size(); at += piece)
            count += decoder.push(bytesOf(std::string_view{bytes}.substr(at, piece))).size();

        QCOMPARE(count, whole);
        QCOMPARE(decoder.damage().total(), std::uint64_t(1));
        QCOMPARE(decoder.waiting(), std::size_t(0));
    }
}

void ScipDecoderTest::furtherEchoesAreSortedToTheirBeams()
{
    // 21 beams and one further echo are 64 characters: the second mark is the first character of a line.
    std::string payload = plainNumber(100, 3) + '&' + plainNumber(150, 3);
    for (std::uint32_t beam = 1; beam < 20; ++beam)
        payload += plainNumber(100 + beam, 3);
    QCOMPARE(payload.size(), std::size_t(64));
    payload += '&' + plainNumber(500, 3) + '&' + plainNumber(600, 3) + plainNumber(120, 3);

    const auto frame = only<ScipFrame>(decode(plainFrame("ND0000002000000", 1, payload))).at(0);

    QCOMPARE(frame.ranges.size(), std::size_t(21));
    for (std::uint32_t beam = 0; beam < 21; ++beam)
        QCOMPARE(frame.ranges[beam], 100 + beam);
    QCOMPARE(frame.furtherEchoes.size(), std::size_t(3));
    QCOMPARE(frame.furtherEchoes[0].value, std::size_t(0));
    QCOMPARE(frame.furtherEchoes[0].range, 150U);
    QCOMPARE(frame.furtherEchoes[1].value, std::size_t(19));
    QCOMPARE(frame.furtherEchoes[1].range, 500U);
    QCOMPARE(frame.furtherEchoes[2].value, std::size_t(19));
    QCOMPARE(frame.furtherEchoes[2].range, 600U);
}

void ScipDecoderTest::furtherEchoesHaveIntensities()
{
    const std::string payload = plainNumber(100, 3) + plainNumber(7, 3) + '&' + plainNumber(150, 3) +
                                plainNumber(8, 3) + plainNumber(200, 3) + plainNumber(9, 3);

    const auto frame = only<ScipFrame>(decode(plainFrame("NE0000000100000", 1, payload))).at(0);

    QVERIFY((frame.ranges == std::vector<std::uint32_t>{100, 200}));
    QVERIFY((frame.intensities == std::vector<std::uint32_t>{7, 9}));
    QCOMPARE(frame.furtherEchoes.at(0).intensity, 8U);
}

void ScipDecoderTest::moreThanThreeEchoesAreNone()
{
    const std::string value = plainNumber(100, 3);
    const auto isRead = [&](const std::string& payload) {
        return !only<ScipFrame>(decode(plainFrame("ND0000000100000", 1, payload))).empty();
    };

    QVERIFY(isRead(value + '&' + value + '&' + value + value));
    QVERIFY(!isRead(value + '&' + value + '&' + value + '&' + value + value));
    QVERIFY(!isRead('&' + value + value + value));
    QVERIFY(only<ScipFrame>(decode(plainFrame("MD0000000100000", 1, value + '&' + value + value))).empty());
}

void ScipDecoderTest::clustersHaveFewerValues()
{
    const auto frames = only<ScipFrame>(decode(plainScan("MD0000000603000", 1, {10, 20, 30})));

    QCOMPARE(frames.size(), std::size_t(1));  // beams 0 to 2, 3 to 5, and 6
    QVERIFY(only<ScipFrame>(decode(plainScan("MD0000000503000", 1, {10, 20, 30}))).empty());
}

void ScipDecoderTest::shortRangesHaveTwoCharacters()
{
    const auto frame =
        only<ScipFrame>(decode(plainFrame("MS0000000100000", 1, plainNumber(1234, 2) + plainNumber(4095, 2)))).at(0);

    QVERIFY((frame.ranges == std::vector<std::uint32_t>{1234, 4095}));
}

void ScipDecoderTest::anotherNumberOfValuesIsRefused()
{
    for (const std::size_t count : {0U, 1U, 3U, 4U, 100U, 9999U}) {
        const auto events = decode(plainScan("MD0000000100000", 1, std::vector<std::uint32_t>(count, 100)));

        QVERIFY(only<ScipFrame>(events).empty());
        QCOMPARE(only<ScipDamage>(events).at(0).kind, ScipDamageKind::Count);
    }
    const std::string half = plainNumber(100, 3) + plainNumber(100, 3) + "0";
    QVERIFY(only<ScipFrame>(decode(plainFrame("MD0000000100000", 1, half))).empty());
}

void ScipDecoderTest::aLineBeyondTheBoundIsDroppedAndTheNextReplyIsFound()
{
    ScipDecoder decoder;
    const std::string noise(1'000'000, 'x');

    decoder.push(bytesOf(noise));
    QVERIFY(decoder.waiting() <= ScipDecoder::kLongestLine);
    const auto events = decoder.push(bytesOf("\nQT\n00P\n\n"));

    QCOMPARE(only<ScipReply>(events).size(), std::size_t(1));
    QCOMPARE(decoder.damage().of(ScipDamageKind::LineTooLong), std::uint64_t(1));
    QCOMPARE(only<ScipDamage>(events).at(0).bytes, std::string(128, 'x') + '\n');
    QCOMPARE(only<ScipReply>(decode("VV\n00P\n" + std::string(129, 'x') + "\n\n")).size(), std::size_t(0));
}

void ScipDecoderTest::aMessageWithoutEndIsDroppedAtTheBound()
{
    ScipDecoder decoder;
    for (int i = 0; i < 100'000; ++i) {
        decoder.push(bytesOf("never an end\n"));
        QVERIFY(decoder.waiting() <= ScipDecoder::kLongestFrame);
    }

    QVERIFY(decoder.damage().of(ScipDamageKind::FrameTooLong) >= 1'300'000 / ScipDecoder::kLongestFrame);
    QCOMPARE(only<ScipReply>(decoder.push(bytesOf("\nQT\n00P\n\n"))).size(), std::size_t(1));
}

void ScipDecoderTest::whatIsForgottenDoesNotComeBack()
{
    ScipDecoder decoder;
    decoder.push(bytesOf("VV\n00P\nPROT:SC"));

    decoder.forget();

    QCOMPARE(decoder.waiting(), std::size_t(0));
    const auto events = decoder.push(bytesOf("QT\n00P\n\n"));
    QCOMPARE(events.size(), std::size_t(1));
    QCOMPARE(only<ScipReply>(events).at(0).echo, std::string{"QT"});
}

void ScipDecoderTest::damageIsCountedByKind_data()
{
    QTest::addColumn<QString>("bytes");
    QTest::addColumn<int>("kind");
    int number = 0;
    const auto row = [&](const char* bytes, ScipDamageKind kind) {
        QTest::addRow("%d", ++number) << QString{bytes} << static_cast<int>(kind);
    };
    row("XY\n00P\n\n", ScipDamageKind::UnknownEcho);
    row("QT\n00Q\n\n", ScipDamageKind::Status);
    row("QT\n00\n\n", ScipDamageKind::Status);
    row("QT\n\n", ScipDamageKind::Status);
    row("QT\nE\nE\n\n", ScipDamageKind::Status);
    row("QT\n00P\nmore\n\n", ScipDamageKind::Count);
    row("TM1\n00P\n<SfkP\n<SfkP\n\n", ScipDamageKind::Count);
    row("TM1\n00P\n<SfkX\n\n", ScipDamageKind::Sum);
    row("MD0000000000000\n99b\n\n", ScipDamageKind::Count);
    row("MD0000000000000\n99b\n00000\n00000\n\n", ScipDamageKind::Count);
    row("MD0000000000000\n99b\n00001\n0000\n\n", ScipDamageKind::Sum);
    row("MD0000000000000\n99b\n000\n0000\n\n", ScipDamageKind::LineLength);
    row("MD0000000000000\n99b\n00000\n0\n\n", ScipDamageKind::LineLength);
    row("MD0000000000000\n99b\n000~n\n0000\n\n", ScipDamageKind::Sum);
}

void ScipDecoderTest::damageIsCountedByKind()
{
    QFETCH(QString, bytes);
    QFETCH(int, kind);
    ScipDecoder decoder;

    const auto events = decoder.push(bytesOf(bytes.toStdString()));

    QCOMPARE(events.size(), std::size_t(1));
    QCOMPARE(static_cast<int>(only<ScipDamage>(events).at(0).kind), kind);
    QCOMPARE(decoder.damage().counts[static_cast<std::size_t>(kind)], std::uint64_t(1));
    QCOMPARE(decoder.damage().total(), std::uint64_t(1));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipDecoderTest)
#include "scip_decoder_test.moc"
