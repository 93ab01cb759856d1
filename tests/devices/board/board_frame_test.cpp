// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <random>

#include <QtTest>

#include "devices/board/board_message.h"
#include "devices/board/cobs.h"
#include "devices/board/frame_parser.h"
#include "tests/test_program.h"

namespace planewright {

class BoardFrameTest : public QObject {
    Q_OBJECT

private slots:
    void theChecksumIsTheOneWithTheKnownCheckValue();
    void cobsTakesEveryZeroOut_data();
    void cobsTakesEveryZeroOut();
    void cobsComesBackAsItWas();
    void whatNoCobsGivesIsRefused();
    void theLongestFrameHas72BytesAndAZero();
    void framesComeWholeHoweverTheBytesAreCut();
    void garbageCostsOneFrame();
    void everySingleDamagedBitIsFound();
    void whatIsTooLongIsThrownAwayUpToTheNextZero();
    void lengthAndVersionAreLookedAt();
    void nothingBetweenTwoZeroesIsNothing();
    void lostEventsAreCounted();
    void eventsThatComeTwiceAreGivenOnce();
    void numbersOfEventsGoRoundAndBeginAnewWithHello();
    void messagesOfOtherTypesAndLengthsAreNone();
};

namespace {

using namespace board;
using Bytes = std::vector<std::uint8_t>;

/// A frame whose header is written by hand.
Bytes wire(Bytes raw)
{
    const std::uint16_t crc = crc16(raw);
    raw.push_back(static_cast<std::uint8_t>(crc & 0xFF));
    raw.push_back(static_cast<std::uint8_t>(crc >> 8));
    Bytes bytes = encodeCobs(raw);
    bytes.push_back(0);
    return bytes;
}

Bytes position(int seq, int pos)
{
    return encodeFrame(
        toFrame(static_cast<std::uint16_t>(seq), PositionEvent{1000, static_cast<std::uint16_t>(pos), 0}));
}

Bytes operator+(Bytes a, const Bytes& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

}  // namespace

void BoardFrameTest::theChecksumIsTheOneWithTheKnownCheckValue()
{
    const Bytes check{'1', '2', '3', '4', '5', '6', '7', '8', '9'};

    QCOMPARE(int(crc16(check)), 0x29B1);
    QCOMPARE(int(crc16({})), 0xFFFF);
}

void BoardFrameTest::cobsTakesEveryZeroOut_data()
{
    QTest::addColumn<Bytes>("plain");
    QTest::addColumn<Bytes>("stuffed");
    QTest::newRow("nothing") << Bytes{} << Bytes{0x01};
    QTest::newRow("a zero") << Bytes{0} << Bytes{0x01, 0x01};
    QTest::newRow("two zeroes") << Bytes{0, 0} << Bytes{0x01, 0x01, 0x01};
    QTest::newRow("zero between") << Bytes{0x11, 0x22, 0, 0x33} << Bytes{0x03, 0x11, 0x22, 0x02, 0x33};
    QTest::newRow("zeroes at the end") << Bytes{0x11, 0, 0, 0} << Bytes{0x02, 0x11, 0x01, 0x01, 0x01};
    QTest::newRow("254 without") << Bytes(254, 7) << Bytes{0xFF} + Bytes(254, 7);
    QTest::newRow("255 without") << Bytes(255, 7) << Bytes{0xFF} + Bytes(254, 7) + Bytes{0x02, 7};
    QTest::newRow("254 and a zero") << Bytes(254, 7) + Bytes{0} << Bytes{0xFF} + Bytes(254, 7) + Bytes{0x01, 0x01};
}

void BoardFrameTest::cobsTakesEveryZeroOut()
{
    QFETCH(Bytes, plain);
    QFETCH(Bytes, stuffed);

    QCOMPARE(encodeCobs(plain), stuffed);
    QCOMPARE(decodeCobs(stuffed).value(), plain);
}

void BoardFrameTest::cobsComesBackAsItWas()
{
    std::mt19937 random{7};
    for (int run = 0; run < 2000; ++run) {
        Bytes plain(random() % 600);
        const auto zeroEvery = 1 + random() % 300;
        for (std::uint8_t& byte : plain)
            byte = random() % zeroEvery == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(1 + random() % 255);

        const Bytes stuffed = encodeCobs(plain);

        QVERIFY(std::find(stuffed.begin(), stuffed.end(), 0) == stuffed.end());
        QCOMPARE(decodeCobs(stuffed).value(), plain);
    }
}

void BoardFrameTest::whatNoCobsGivesIsRefused()
{
    QVERIFY(!decodeCobs({}));
    QVERIFY(!decodeCobs(Bytes{0x00}));
    QVERIFY(!decodeCobs(Bytes{0x03, 0x11}));
    QVERIFY(!decodeCobs(Bytes{0x02, 0x00}));
    QVERIFY(!decodeCobs(Bytes{0x02, 0x11, 0x05, 0x01}));
}

void BoardFrameTest::theLongestFrameHas72BytesAndAZero()
{
    const Frame longest{1, 0x33, Bytes(kMaxPayload, 0xAA)};

    const Bytes bytes = encodeFrame(longest);

    QCOMPARE(bytes.size(), std::size_t(73));
    QCOMPARE(FrameParser{}.push(bytes), std::vector<Frame>{longest});
}

void BoardFrameTest::framesComeWholeHoweverTheBytesAreCut()
{
    Bytes stream;
    std::vector<Frame> sent;
    for (int i = 0; i < 40; ++i) {
        sent.push_back(toFrame(static_cast<std::uint16_t>(1 + i), Heartbeat{static_cast<std::uint64_t>(i) << 30}));
        stream = stream + encodeFrame(sent.back());
    }
    std::mt19937 random{3};
    for (int run = 0; run < 50; ++run) {
        FrameParser parser;
        std::vector<Frame> came;
        std::span<const std::uint8_t> rest{stream};
        while (!rest.empty()) {
            const std::size_t count = std::min<std::size_t>(1 + random() % 50, rest.size());
            for (Frame& frame : parser.push(rest.first(count)))
                came.push_back(std::move(frame));
            rest = rest.subspan(count);
        }

        QCOMPARE(came, sent);
        QCOMPARE(parser.counters().damaged(), std::uint64_t(0));
    }
}

void BoardFrameTest::garbageCostsOneFrame()
{
    const Bytes hello = encodeFrame(toFrame(1, Hello{}));
    const Bytes stop = encodeFrame(toFrame(2, Stop{}));
    std::mt19937 random{5};
    for (int run = 0; run < 500; ++run) {
        Bytes garbage(1 + random() % 200);
        for (std::uint8_t& byte : garbage)
            byte = static_cast<std::uint8_t>(1 + random() % 255);
        FrameParser parser;

        const std::vector<Frame> frames = parser.push(garbage + hello + stop);

        QCOMPARE(frames, std::vector<Frame>{toFrame(2, Stop{})});
        QCOMPARE(parser.counters().damaged(), std::uint64_t(1));
    }
}

void BoardFrameTest::everySingleDamagedBitIsFound()
{
    const Bytes good = encodeFrame(toFrame(0x8001, SliceEvent{17, 5'000'000, 540, -3, State::Unarmed, 0}));
    const Bytes after = encodeFrame(toFrame(0x8002, PositionEvent{5'000'000, 540, 0}));
    for (std::size_t byte = 0; byte < good.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            Bytes damaged = good;
            damaged[byte] ^= static_cast<std::uint8_t>(1 << bit);
            FrameParser parser;

            const std::vector<Frame> frames = parser.push(damaged + after + after);

            QVERIFY(parser.counters().damaged() >= 1);
            for (const Frame& frame : frames)
                QCOMPARE(int(frame.type), int(PositionEvent::kType));
        }
    }
}

void BoardFrameTest::whatIsTooLongIsThrownAwayUpToTheNextZero()
{
    FrameParser parser;
    const Bytes endless(1'000'000, 0x55);
    const Bytes end{0};

    QVERIFY(parser.push(endless).empty());
    QVERIFY(parser.push(end).empty());
    QCOMPARE(parser.counters().length, std::uint64_t(1));
    QCOMPARE(parser.counters().lostBytes, std::uint64_t(1'000'000));

    QCOMPARE(parser.push(encodeFrame(toFrame(1, Hello{}))).size(), std::size_t(1));
}

void BoardFrameTest::lengthAndVersionAreLookedAt()
{
    FrameParser parser;

    QVERIFY(parser.push(wire({1, 1, 1, 0, 0x01})).empty());     // says one byte, has none
    QVERIFY(parser.push(wire({1, 0, 1, 0, 0x2C, 1})).empty());  // says none, has one
    QVERIFY(parser.push(wire({1, 0, 1})).empty());              // shorter than a header
    QVERIFY(parser.push(wire(Bytes{1, 65, 1, 0, 1} + Bytes(65, 1))).empty());
    QCOMPARE(parser.counters().length, std::uint64_t(4));
    QVERIFY(parser.push(wire({2, 0, 1, 0, 0x01})).empty());
    QCOMPARE(parser.counters().version, std::uint64_t(1));
    QCOMPARE(parser.push(wire({1, 0, 1, 0, 0x01})).size(), std::size_t(1));
    QCOMPARE(parser.counters().crc + parser.counters().cobs, std::uint64_t(0));
}

void BoardFrameTest::nothingBetweenTwoZeroesIsNothing()
{
    FrameParser parser;

    const std::vector<Frame> frames = parser.push(Bytes(10, 0) + encodeFrame(toFrame(1, Hello{})) + Bytes(10, 0));

    QCOMPARE(frames.size(), std::size_t(1));
    QCOMPARE(parser.counters().damaged(), std::uint64_t(0));
}

void BoardFrameTest::lostEventsAreCounted()
{
    FrameParser parser;

    parser.push(position(0x8005, 1));
    QCOMPARE(parser.counters().lostEvents, std::uint64_t(0));
    parser.push(position(0x8006, 1) + position(0x800A, 1));
    QCOMPARE(parser.counters().lostEvents, std::uint64_t(3));
    parser.push(encodeFrame(toFrame(7, StopReply{})) + position(0x800B, 1));

    QCOMPARE(parser.counters().lostEvents, std::uint64_t(3));
    QCOMPARE(parser.counters().frames, std::uint64_t(5));
}

void BoardFrameTest::eventsThatComeTwiceAreGivenOnce()
{
    FrameParser parser;

    const auto frames = parser.push(position(0x8001, 1) + position(0x8001, 1) + position(0x8002, 2));

    QCOMPARE(frames.size(), std::size_t(2));
    QCOMPARE(parser.counters().repeatedEvents, std::uint64_t(1));
    QCOMPARE(parser.counters().lostEvents, std::uint64_t(0));
}

void BoardFrameTest::numbersOfEventsGoRoundAndBeginAnewWithHello()
{
    FrameParser parser;

    parser.push(position(0xFFFE, 1) + position(0xFFFF, 1) + position(0x8000, 1) + position(0x8001, 1));
    QCOMPARE(parser.counters().lostEvents, std::uint64_t(0));
    const auto restarted = parser.push(encodeFrame(toFrame(1, HelloReply{})) + position(0x8000, 1));
    QCOMPARE(restarted.size(), std::size_t(2));
    QCOMPARE(parser.counters().lostEvents, std::uint64_t(0));
    const auto withALoss = parser.push(encodeFrame(toFrame(1, HelloReply{})) + position(0x8002, 1));
    QCOMPARE(withALoss.size(), std::size_t(2));

    QCOMPARE(parser.counters().lostEvents, std::uint64_t(2));
    QCOMPARE(parser.counters().repeatedEvents, std::uint64_t(0));
}

void BoardFrameTest::messagesOfOtherTypesAndLengthsAreNone()
{
    const auto unknown = toMessage({1, 0x30, {}});
    const auto tooLong = toMessage({1, Hello::kType, {1}});
    const auto tooShort = toMessage({1, Move::kType, Bytes(5, 0)});

    QCOMPARE(unknown.error(), NakCode::UnknownType);
    QCOMPARE(tooLong.error(), NakCode::Length);
    QCOMPARE(tooShort.error(), NakCode::Length);
    QCOMPARE(payloadLength(Move::kType).value(), std::size_t(6));
    QVERIFY(!payloadLength(0x30));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardFrameTest)
#include "board_frame_test.moc"
