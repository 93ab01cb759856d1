// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/replayed_dialogue.h"

#include <atomic>
#include <fstream>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ReplayedDialogueTest : public QObject {
    Q_OBJECT

private slots:
    void theDeviceAnswersOnlyWhatItWasAsked();
    void answersComeAsLongAfterAsThen();
    void aHostThatIsLateMakesAllOfItLate();
    void asFastAsPossibleNothingIsWaitedFor();
    void theHostMaySayItInOtherPieces();
    void theHostMaySpeakBeforeAllWasRead();
    void piecesOfOneArrivalHaveItsTime();
    void whereTheHostDiffersIsNamed_data();
    void whereTheHostDiffersIsNamed();
    void aHostThatSaysMoreIsNamed();
    void afterADifferenceAllCallsFail();
    void theRecordedLossIsALoss();
    void afterTheEndTheDeviceIsSilent();
    void whatIsWrongWithTheFileShowsAtOnce();
    void closingWakesTheReader();
    void aStopEndsReading();
    void whatTheHostSaysWakesTheReader();

private:
    std::unique_ptr<ReplayedDialogue> open(const std::string& events, const Clock& clock,
                                           ReplayedDialogue::Pace pace = ReplayedDialogue::Pace::Recorded);

    QTemporaryDir folder_;
    std::string path_ = folder_.filePath("dialogue.txt").toStdString();
};

namespace {

/// One read that waits until a moment: what came, and when.
std::pair<std::string, std::chrono::nanoseconds> readOnce(Transport& link, std::chrono::nanoseconds deadline,
                                                          std::size_t most = 100)
{
    std::vector<std::uint8_t> into(most);
    const auto arrival = link.read(into, deadline, {});
    if (!arrival)
        return {"<" + arrival.error().message + ">", 0ns};
    return {std::string{into.data(), into.data() + arrival->count}, arrival->at};
}

using Read = std::pair<std::string, std::chrono::nanoseconds>;

}  // namespace

std::unique_ptr<ReplayedDialogue> ReplayedDialogueTest::open(const std::string& events, const Clock& clock,
                                                             ReplayedDialogue::Pace pace)
{
    std::ofstream{path_, std::ios::binary} << kDialogueFirstLine << "\n" << events;
    auto dialogue = ReplayedDialogue::open(path_, pace, clock);
    return dialogue ? std::move(*dialogue) : nullptr;
}

void ReplayedDialogueTest::theDeviceAnswersOnlyWhatItWasAsked()
{
    FakeClock clock;
    const auto link = open("0 > QT\\n\n5 < QT\\n00P\\n\\n\n", clock);
    QVERIFY(link);

    QCOMPARE(readOnce(*link, 1s), (Read{"", 1s}));
    QVERIFY(link->write(asBytes("QT\n"), clock.now()));

    QCOMPARE(readOnce(*link, 2s).first, std::string("QT\n00P\n\n"));
    QVERIFY(link->isPlayed());
    QCOMPARE(link->name(), path_);
}

void ReplayedDialogueTest::answersComeAsLongAfterAsThen()
{
    FakeClock clock;
    clock.advance(1h);
    const auto link = open("100 < hello\n1000 > A\n3000 < a\n8000 < b\n", clock);
    QVERIFY(link);

    QCOMPARE(readOnce(*link, 2h), (Read{"hello", 1h + 100us}));
    clock.advance(900us);
    QVERIFY(link->write(asBytes("A"), clock.now()));

    QCOMPARE(readOnce(*link, 1h + 2ms), (Read{"", 1h + 2ms}));
    QCOMPARE(readOnce(*link, 2h), (Read{"a", 1h + 3ms}));
    QCOMPARE(readOnce(*link, 2h), (Read{"b", 1h + 8ms}));
}

void ReplayedDialogueTest::aHostThatIsLateMakesAllOfItLate()
{
    FakeClock clock;
    const auto link = open("0 > A\n3000 < a\n4000 > B\n6000 < b\n", clock);
    QVERIFY(link);

    clock.advance(50ms);
    QVERIFY(link->write(asBytes("A"), clock.now()));
    QCOMPARE(readOnce(*link, 1s), (Read{"a", 53ms}));
    clock.advance(10ms);
    QVERIFY(link->write(asBytes("B"), clock.now()));

    QCOMPARE(readOnce(*link, 1s), (Read{"b", 65ms}));
}

void ReplayedDialogueTest::asFastAsPossibleNothingIsWaitedFor()
{
    FakeClock clock{FakeClock::Kind::Stands};
    const auto link = open("0 > A\n3000000 < a\n9000000 < b\n", clock, ReplayedDialogue::Pace::AsFastAsPossible);
    QVERIFY(link);
    clock.advance(7ms);

    QVERIFY(link->write(asBytes("A"), clock.now()));

    QCOMPARE(readOnce(*link, 1s), (Read{"a", 7ms}));
    QCOMPARE(readOnce(*link, 1s), (Read{"b", 7ms}));
}

void ReplayedDialogueTest::theHostMaySayItInOtherPieces()
{
    FakeClock clock;
    const auto link = open("0 > AB\n0 > CD\n1000 < x\n2000 > E\n3000 < y\n", clock);
    QVERIFY(link);

    QVERIFY(link->write(asBytes("A"), clock.now()));
    QVERIFY(link->write(asBytes("BC"), clock.now()));
    QCOMPARE(readOnce(*link, 500ms).first, std::string());
    QVERIFY(link->write(asBytes("D"), clock.now()));

    QCOMPARE(readOnce(*link, 1s), (Read{"x", 501ms}));
}

void ReplayedDialogueTest::theHostMaySpeakBeforeAllWasRead()
{
    FakeClock clock;
    const auto link = open("0 > A\n1000 < 1\n2000 < 2\n3000 > B\n4000 < 3\n5000 > C\n6000 < 4\n", clock);
    QVERIFY(link);

    QVERIFY(link->write(asBytes("ABC"), clock.now()));

    QCOMPARE(readOnce(*link, 1s), (Read{"1", 1ms}));
    QCOMPARE(readOnce(*link, 1s), (Read{"2", 2ms}));
    // A millisecond after B and C, which are long over, and never before what came last.
    QCOMPARE(readOnce(*link, 1s), (Read{"3", 2ms}));
    QCOMPARE(readOnce(*link, 1s), (Read{"4", 2ms}));
    QVERIFY(link->isPlayed());
}

void ReplayedDialogueTest::piecesOfOneArrivalHaveItsTime()
{
    FakeClock clock;
    const auto link = open("1000 < abcde\n", clock, ReplayedDialogue::Pace::AsFastAsPossible);
    QVERIFY(link);
    clock.advance(7ms);

    QCOMPARE(readOnce(*link, 1s, 2), (Read{"ab", 7ms}));
    clock.advance(1ms);

    QCOMPARE(readOnce(*link, 1s, 3), (Read{"cde", 7ms}));
}

void ReplayedDialogueTest::whereTheHostDiffersIsNamed_data()
{
    QTest::addColumn<QByteArray>("says");
    QTest::addColumn<QByteArray>("error");
    QTest::newRow("at once") << QByteArray("GD0000\n")
                             << QByteArray(":3: the host said 'MD0000\\n' and now says 'GD0000\\n', from byte 1 on;");
    QTest::newRow("in the middle") << QByteArray("MD0100\n")
                                   << QByteArray(":3: the host said '000\\n' and now says '100\\n', from byte 4 on;");
    QTest::newRow("in the next line") << QByteArray("MD0000\nBM\n")
                                      << QByteArray(":5: the host said 'QT\\n' and now says 'BM\\n', from byte 1 on;");
    QTest::newRow("much") << QByteArray(1000, 'a')
                          << QByteArray("now says 'aaaaaaaaaaaaaaaaaaaaaaaa…', from byte 1 on;");
}

void ReplayedDialogueTest::whereTheHostDiffersIsNamed()
{
    QFETCH(QByteArray, says);
    QFETCH(QByteArray, error);
    FakeClock clock;
    const auto link = open("# a laser\n0 > MD0000\\n\n1 < a\n2 > QT\\n\n", clock);
    QVERIFY(link);

    const auto written = link->write(asBytes(says.toStdString()), clock.now());

    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QVERIFY2(written.error().message.starts_with(path_ + ":"), written.error().message.c_str());
    QVERIFY2(written.error().message.find(error.toStdString()) != std::string::npos, written.error().message.c_str());
    QVERIFY(!link->isPlayed());
}

void ReplayedDialogueTest::aHostThatSaysMoreIsNamed()
{
    FakeClock clock;
    const auto link = open("0 > QT\\n\n1 < a\n", clock);
    QVERIFY(link);

    const auto written = link->write(asBytes("QT\nBM\n"), clock.now());

    QVERIFY(!written);
    QVERIFY2(written.error().message.starts_with(path_ + ":3: the dialogue has nothing more from the host, which now "
                                                         "says 'BM\\n'"),
             written.error().message.c_str());
}

void ReplayedDialogueTest::afterADifferenceAllCallsFail()
{
    FakeClock clock;
    const auto link = open("0 < a\n0 > QT\\n\n", clock);
    QVERIFY(link);

    const auto first = link->write(asBytes("BM\n"), clock.now());

    QVERIFY(!first);
    const auto second = link->write(asBytes("QT\n"), clock.now());
    QVERIFY(!second);
    QCOMPARE(second.error().message, first.error().message);
    QCOMPARE(readOnce(*link, 1s).first, "<" + first.error().message + ">");
}

void ReplayedDialogueTest::theRecordedLossIsALoss()
{
    FakeClock clock;
    const auto link = open("0 > A\n5000 < a\n9000 ! /dev/ttyACM0: the device is gone\n", clock);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("A"), clock.now()));
    QCOMPARE(readOnce(*link, 1s), (Read{"a", 5ms}));
    QCOMPARE(readOnce(*link, 8ms), (Read{"", 8ms}));

    const std::string end = readOnce(*link, 1s).first;

    QCOMPARE(end, "<" + path_ + ":4: the link was lost here: /dev/ttyACM0: the device is gone>");
    QVERIFY(clock.now() == 9ms);
    QVERIFY(link->isPlayed());
    QVERIFY(!link->write(asBytes("A"), clock.now()));
}

void ReplayedDialogueTest::afterTheEndTheDeviceIsSilent()
{
    FakeClock clock;
    const auto link = open("0 < a\n", clock);
    QVERIFY(link);
    QCOMPARE(readOnce(*link, 1s).first, std::string("a"));

    QCOMPARE(readOnce(*link, 1s), (Read{"", 1s}));
}

void ReplayedDialogueTest::whatIsWrongWithTheFileShowsAtOnce()
{
    std::ofstream{path_, std::ios::binary} << kDialogueFirstLine << "\n0 < a\n0 < b\nnonsense\n";

    const auto link = ReplayedDialogue::open(path_, ReplayedDialogue::Pace::Recorded, steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::Unreadable);
    QVERIFY2(link.error().message.starts_with(path_ + ":4: "), link.error().message.c_str());
}

void ReplayedDialogueTest::closingWakesTheReader()
{
    const auto link = open("0 > A\n", steadyClock());
    QVERIFY(link);
    std::atomic<bool> lost{false};
    std::jthread reader{[&] { lost = readOnce(*link, steadyClock().now() + 1h).first.starts_with("<"); }};

    link->close();
    link->close();
    reader.join();

    QVERIFY(lost);
    QVERIFY(!link->write(asBytes("A"), steadyClock().now()));
}

void ReplayedDialogueTest::aStopEndsReading()
{
    const auto link = open("0 > A\n", steadyClock());
    QVERIFY(link);
    std::atomic<bool> cameBack{false};
    std::jthread reader{[&](const std::stop_token& stop) {
        std::array<std::uint8_t, 8> into{};
        const auto arrival = link->read(into, steadyClock().now() + 1h, stop);
        cameBack = arrival && arrival->count == 0;
    }};

    reader.request_stop();
    reader.join();

    QVERIFY(cameBack);
}

void ReplayedDialogueTest::whatTheHostSaysWakesTheReader()
{
    const auto link = open("0 > A\n1000 < a\n", steadyClock());
    QVERIFY(link);
    std::string read;
    std::jthread reader{[&] { read = readOnce(*link, steadyClock().now() + kPatience).first; }};

    QVERIFY(link->write(asBytes("A"), steadyClock().now()));
    reader.join();

    QCOMPARE(read, std::string("a"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ReplayedDialogueTest)
#include "replayed_dialogue_test.moc"
