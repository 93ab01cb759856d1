// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/ftdi_wire.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class FtdiWireTest : public QObject {
    Q_OBJECT

private slots:
    void divisorsAreThoseOfTheChipsMaker_data();
    void divisorsAreThoseOfTheChipsMaker();
    void everyDivisorGivesTheRateThatItTells();
    void ratesThatAChipLacksAreRefused_data();
    void ratesThatAChipLacksAreRefused();

    void everyPacketLosesItsStatus_data();
    void everyPacketLosesItsStatus();
    void aPacketOfStatusAloneIsEmpty();
    void overrunsAreCountedByPacket();
    void halfAStatusIsNothing();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

/// What a chip makes of a divisor, read the other way round: AN 232B-05's table of eighths.
double rateOf(std::uint32_t code, double clock)
{
    constexpr double kEighths[]{0.0, 0.5, 0.25, 0.125, 0.375, 0.625, 0.75, 0.875};
    const std::uint32_t whole = code & 0x3FFF;
    const double divisor = whole + kEighths[code >> 14 & 7];
    return clock / (code == 0 ? 1.0 : code == 1 ? 1.5 : divisor);
}

}  // namespace

void FtdiWireTest::divisorsAreThoseOfTheChipsMaker_data()
{
    QTest::addColumn<bool>("isFast");
    QTest::addColumn<int>("rate");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("index");
    QTest::newRow("FT232R at 3 M: divisor 1 is 0") << false << 3'000'000 << 0x0000 << 0;
    QTest::newRow("FT232R at 2 M: divisor 1.5 is 1") << false << 2'000'000 << 0x0001 << 0;
    QTest::newRow("FT232R at 1.5 M: 2") << false << 1'500'000 << 0x0002 << 0;
    QTest::newRow("FT232R at 1 M: 3") << false << 1'000'000 << 0x0003 << 0;
    QTest::newRow("FT232R at 500 000: 6") << false << 500'000 << 0x0006 << 0;
    QTest::newRow("FT232R at 117 647: 25.5") << false << 117'647 << 0x4019 << 0;
    QTest::newRow("FT232R at 115 200: 26") << false << 115'200 << 0x001A << 0;
    QTest::newRow("FT232R at 57 600: 52.125") << false << 57'600 << 0xC034 << 0;
    QTest::newRow("FT232R at 57 142: 52.5") << false << 57'142 << 0x4034 << 0;
    QTest::newRow("FT232R at 57 143: 52.5") << false << 57'143 << 0x4034 << 0;
    QTest::newRow("FT232R at 38 400: 78.125") << false << 38'400 << 0xC04E << 0;
    QTest::newRow("FT232R at 9 600: 312.5") << false << 9'600 << 0x4138 << 0;
    QTest::newRow("FT232R at 2 400: 1250") << false << 2'400 << 0x04E2 << 0;
    QTest::newRow("FT232R at 600: 5000") << false << 600 << 0x1388 << 0;
    QTest::newRow("FT232R at 49 896: 60.125") << false << 49'896 << 0xC03C << 0;
    QTest::newRow("FT232R at 80 268: 37.375") << false << 80'268 << 0x0025 << 1;
    QTest::newRow("FT232H at 12 M: divisor 1 is 0") << true << 12'000'000 << 0x0000 << 0x0200;
    QTest::newRow("FT232H at 8 M: divisor 1.5 is 1") << true << 8'000'000 << 0x0001 << 0x0200;
    QTest::newRow("FT232H at 4 M: 3") << true << 4'000'000 << 0x0003 << 0x0200;
    QTest::newRow("FT232H at 1 M: 12") << true << 1'000'000 << 0x000C << 0x0200;
    QTest::newRow("FT232H at 115 200: 104.125") << true << 115'200 << 0xC068 << 0x0200;
    QTest::newRow("FT232H at 57 600: 208.375") << true << 57'600 << 0x00D0 << 0x0300;
    QTest::newRow("FT232H at 57 142: 210") << true << 57'142 << 0x00D2 << 0x0200;
}

void FtdiWireTest::divisorsAreThoseOfTheChipsMaker()
{
    QFETCH(bool, isFast);
    QFETCH(int, rate);
    QFETCH(int, value);
    QFETCH(int, index);

    const auto divisor = ftdiDivisor(isFast ? FtdiChip::Ft232h : FtdiChip::Ft232r, rate);

    QVERIFY(divisor);
    QCOMPARE(int(divisor->value), value);
    QCOMPARE(int(divisor->index), index);
}

void FtdiWireTest::everyDivisorGivesTheRateThatItTells()
{
    for (const int rate : {200, 1200, 4800, 9600, 19'200, 57'142, 117'647, 222'222, 400'000, 1'000'000, 2'250'000}) {
        const auto slow = ftdiDivisor(FtdiChip::Ft232r, rate);
        if (slow) {
            const auto code = static_cast<std::uint32_t>(slow->index << 16 | slow->value);
            QVERIFY(std::abs(rateOf(code, 3.0e6) - slow->rate) < 1e-6 * rate);
            QVERIFY(std::abs(slow->rate - rate) <= 0.02 * rate);
        }
        const auto fast = ftdiDivisor(FtdiChip::Ft232h, rate);
        if (fast) {
            const auto code = static_cast<std::uint32_t>(fast->index << 8 | fast->value);
            QVERIFY((code & 0x20000) != 0);
            QVERIFY(std::abs(rateOf(code & 0x1FFFF, 12.0e6) - fast->rate) < 1e-6 * rate);
            QVERIFY(std::abs(fast->rate - rate) <= 0.02 * rate);
        }
        QVERIFY(slow || fast);
    }
}

void FtdiWireTest::ratesThatAChipLacksAreRefused_data()
{
    QTest::addColumn<bool>("isFast");
    QTest::addColumn<int>("rate");
    QTest::newRow("below zero") << false << -9600;
    QTest::newRow("zero") << false << 0;
    QTest::newRow("FT232R: below its slowest") << false << 150;
    QTest::newRow("FT232R: between 2 M and 3 M") << false << 2'500'000;
    QTest::newRow("FT232R: above its fastest") << false << 4'000'000;
    QTest::newRow("FT232H: below its slowest") << true << 600;
    QTest::newRow("FT232H: above its fastest") << true << 13'000'000;
    QTest::newRow("the largest number") << true << std::numeric_limits<int>::max();
}

void FtdiWireTest::ratesThatAChipLacksAreRefused()
{
    QFETCH(bool, isFast);
    QFETCH(int, rate);

    const auto divisor = ftdiDivisor(isFast ? FtdiChip::Ft232h : FtdiChip::Ft232r, rate);

    QVERIFY(!divisor);
    QCOMPARE(divisor.error().code, ErrorCode::Usage);
}

void FtdiWireTest::everyPacketLosesItsStatus_data()
{
    QTest::addColumn<int>("packetSize");
    QTest::addColumn<int>("payload");
    for (const int packetSize : {8, 64, 512}) {
        for (const int payload :
             {1, packetSize - 3, packetSize - 2, packetSize - 1, 5 * (packetSize - 2), 1000, 16'000})
            QTest::addRow("%d bytes in packets of %d", payload, packetSize) << packetSize << payload;
    }
}

void FtdiWireTest::everyPacketLosesItsStatus()
{
    QFETCH(int, packetSize);
    QFETCH(int, payload);
    Bytes sent(static_cast<std::size_t>(payload));
    std::iota(sent.begin(), sent.end(), std::uint8_t(7));
    Bytes transfer;
    for (std::size_t i = 0; i < sent.size(); ++i) {
        if (i % static_cast<std::size_t>(packetSize - 2) == 0)
            transfer.insert(transfer.end(), {0x01, 0x60});
        transfer.push_back(sent[i]);
    }

    const FtdiPayload stripped = stripFtdiStatus(transfer, static_cast<std::size_t>(packetSize));

    transfer.resize(stripped.count);
    QCOMPARE(transfer, sent);
    QCOMPARE(stripped.overruns, std::size_t(0));
}

void FtdiWireTest::aPacketOfStatusAloneIsEmpty()
{
    Bytes transfer{0x01, 0x60};

    QCOMPARE(stripFtdiStatus(transfer, 64).count, std::size_t(0));
    QCOMPARE(stripFtdiStatus({}, 64).count, std::size_t(0));
}

void FtdiWireTest::overrunsAreCountedByPacket()
{
    // The first packet is full; the third says that bytes were lost, as the first does. Bit 1 of the first byte means
    // nothing.
    Bytes transfer{0x01, 0x62, 1, 2, 3, 4, 5, 6, 0x03, 0x60, 7, 8, 9, 10, 11, 12, 0x01, 0x02};

    const FtdiPayload stripped = stripFtdiStatus(transfer, 8);

    QCOMPARE(stripped.overruns, std::size_t(2));
    QCOMPARE(stripped.count, std::size_t(12));
    QCOMPARE(transfer[11], std::uint8_t(12));
}

void FtdiWireTest::halfAStatusIsNothing()
{
    Bytes transfer{0x01, 0x60, 1, 2, 3, 4, 5, 6, 0x02};

    const FtdiPayload stripped = stripFtdiStatus(transfer, 8);

    QCOMPARE(stripped.count, std::size_t(6));
    QCOMPARE(stripped.overruns, std::size_t(0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FtdiWireTest)
#include "ftdi_wire_test.moc"
