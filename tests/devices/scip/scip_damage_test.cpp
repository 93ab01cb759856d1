// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <random>

#include <QtTest>

#include "devices/scip/scip_decoder.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

/// What the decoder promises of damaged scans: whatever it gives is a scan as it was sent.
///
/// The protocol lets two things through. Of two wrong characters in one line, one pair in 64 has the right sum. And
/// where exactly the bytes of a whole scan, or of several, are lost in the middle of others, head and tail make one
/// scan.
class ScipDamageTest : public QObject {
    Q_OBJECT

private slots:
    void everyOtherByteInEveryPlaceIsMet();
    void everyFlippedBitOfAWholeScanIsMet();
    void aWrongCharacterInEveryLineIsMet();
    void everyLostByteIsMet();
    void lostPiecesAreMet();
    void addedPiecesAreMet();
    void anotherMultiEchoCharacterIsMet();
    void randomBytesGiveNothing();
    void theStreamGoesOnAfterDamage();
};

namespace {

/// Rounds of a test at random: a tenth of them but at full volume.
int rounds(int full)
{
    return qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? full : full / 10;
}

const std::string kSmallEcho = "MD0000004900000";
const std::string kWholeEcho = "MD0000108000000";

std::vector<std::uint32_t> randomRanges(std::size_t count, std::mt19937& random)
{
    std::vector<std::uint32_t> ranges(count);
    for (std::uint32_t& range : ranges)
        range = static_cast<std::uint32_t>(random() % 60'001);
    return ranges;
}

/// Scans one behind the other, their ranges at random.
struct Sent {
    std::string bytes;
    std::vector<std::vector<std::uint32_t>> scans;

    /// True where a scan is one of those that were sent: its stamp names it.
    bool has(const ScipFrame& frame) const { return frame.stamp < scans.size() && frame.ranges == scans[frame.stamp]; }
};

Sent send(const std::string& echo, std::size_t beams, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    Sent sent;
    for (std::size_t scan = 0; scan < count; ++scan) {
        sent.scans.push_back(randomRanges(beams, random));
        sent.bytes += plainScan(echo, static_cast<std::uint32_t>(scan), sent.scans.back());
    }
    return sent;
}

/// The scans that come out of damaged bytes; -1 where one of them is none of those sent.
int trueScansIn(const std::string& bytes, const Sent& sent)
{
    const auto frames = only<ScipFrame>(decode(bytes));
    const bool areTrue =
        std::all_of(frames.begin(), frames.end(), [&](const ScipFrame& frame) { return sent.has(frame); });
    return areTrue ? static_cast<int>(frames.size()) : -1;
}

}  // namespace

void ScipDamageTest::everyOtherByteInEveryPlaceIsMet()
{
    const Sent sent = send(kSmallEcho, 50, 1, 1);
    const std::size_t data = kSmallEcho.size() + 1;
    for (std::size_t at = 0; at < sent.bytes.size(); ++at) {
        for (int value = 0; value < 256; ++value) {
            std::string bytes = sent.bytes;
            if (static_cast<char>(value) == bytes[at])
                continue;
            bytes[at] = static_cast<char>(value);

            const int scans = trueScansIn(bytes + "\n", sent);

            // The echo has no sum, but a wrong one changes no range; the last line feed ends nothing that is not whole.
            const bool maySurvive = at < data || at == sent.bytes.size() - 1;
            QVERIFY2(scans == 0 || (scans == 1 && maySurvive), qPrintable(QString::number(at)));
        }
    }
}

void ScipDamageTest::everyFlippedBitOfAWholeScanIsMet()
{
    const Sent sent = send(kWholeEcho, 1081, 1, 2);
    QCOMPARE(sent.bytes.size(), std::size_t(3372));
    QCOMPARE(trueScansIn(sent.bytes, sent), 1);
    for (std::size_t at = kWholeEcho.size() + 1; at < sent.bytes.size() - 1; ++at) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            std::string bytes = sent.bytes;
            bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << bit));

            QCOMPARE(trueScansIn(bytes + "\n", sent), 0);
        }
    }
}

void ScipDamageTest::aWrongCharacterInEveryLineIsMet()
{
    std::mt19937 random(3);
    const Sent sent = send(kWholeEcho, 1081, 1, 3);
    for (int round = 0; round < rounds(5'000); ++round) {
        std::string bytes = sent.bytes;
        int changed = 0;
        for (std::size_t begin = kWholeEcho.size() + 5, end = 0; begin < bytes.size() - 1; begin = end + 1) {
            end = bytes.find('\n', begin);
            char& c = bytes[begin + random() % (end - begin)];
            const char before = c;
            c = static_cast<char>('0' + random() % 64);
            changed += c != before ? 1 : 0;
        }

        QVERIFY(changed > 0);
        QCOMPARE(trueScansIn(bytes, sent), 0);
    }
}

void ScipDamageTest::everyLostByteIsMet()
{
    const Sent sent = send(kWholeEcho, 1081, 3, 4);
    for (std::size_t at = 3372; at < 2 * 3372; ++at) {
        std::string bytes = sent.bytes;
        bytes.erase(at, 1);

        // Without one of its last two line feeds a scan is whole, and the next one's echo tells that it has ended.
        QCOMPARE(trueScansIn(bytes, sent), at >= 2 * 3372 - 2 ? 3 : 2);
    }
}

void ScipDamageTest::lostPiecesAreMet()
{
    std::mt19937 random(5);
    const Sent sent = send(kSmallEcho, 50, 6, 5);
    const std::size_t scan = sent.bytes.size() / 6;
    for (int round = 0; round < rounds(200'000); ++round) {
        const std::size_t length = 1 + random() % (3 * scan);
        if (length % scan == 0)  // head and tail of two scans: what cannot be met
            continue;
        std::string bytes = sent.bytes;
        bytes.erase(random() % (bytes.size() - length), length);

        QVERIFY(trueScansIn(bytes, sent) >= 0);
    }
}

void ScipDamageTest::addedPiecesAreMet()
{
    std::mt19937 random(6);
    const Sent sent = send(kSmallEcho, 50, 2, 6);
    for (int round = 0; round < rounds(200'000); ++round) {
        std::string bytes = sent.bytes;
        std::string added(1 + random() % 300, '\0');
        // Plain characters and line feeds look most like data.
        const bool isPlain = random() % 2 == 0;
        for (char& c : added)
            c = static_cast<char>(isPlain ? (random() % 40 == 0 ? '\n' : static_cast<int>('0' + random() % 64))
                                          : static_cast<int>(random() % 256));
        bytes.insert(random() % bytes.size(), added);

        QVERIFY(trueScansIn(bytes + "\n", sent) >= 0);
    }
}

void ScipDamageTest::anotherMultiEchoCharacterIsMet()
{
    // '&' and 'f' have the same six bits: the sum does not tell them apart, the number of characters does.
    std::string payload;
    for (std::uint32_t beam = 0; beam < 40; ++beam)
        payload += plainNumber(0x36'000 + beam, 3) + (beam % 3 == 0 ? "&" + plainNumber(0x36'DB6, 3) : "");
    const std::string bytes = plainFrame("ND0000003900000", 5, payload);
    QCOMPARE(only<ScipFrame>(decode(bytes)).size(), std::size_t(1));
    for (std::size_t at = 27; at < bytes.size() - 1; ++at) {
        for (int value = 0; value < 256; ++value) {
            std::string wrong = bytes;
            wrong[at] = static_cast<char>(value);

            QCOMPARE(only<ScipFrame>(decode(wrong + "\n")).size(), std::size_t(wrong == bytes ? 1 : 0));
        }
    }
}

void ScipDamageTest::randomBytesGiveNothing()
{
    std::mt19937 random(7);
    ScipDecoder decoder;
    for (int round = 0; round < rounds(5'000); ++round) {
        std::string bytes(1 + random() % 1000, '\0');
        for (char& c : bytes)
            c = static_cast<char>(random() % 256);

        const auto events = decoder.push(bytesOf(bytes));

        QCOMPARE(only<ScipDamage>(events).size(), events.size());
        QVERIFY(decoder.waiting() <= ScipDecoder::kLongestFrame);
    }
    QVERIFY(decoder.damage().total() > 0);
}

void ScipDamageTest::theStreamGoesOnAfterDamage()
{
    std::mt19937 random(8);
    const Sent sent = send(kSmallEcho, 50, 5, 8);
    const std::size_t scan = sent.bytes.size() / 5;
    for (int round = 0; round < rounds(10'000); ++round) {
        std::string bytes = sent.bytes;
        for (int i = 0; i < 20; ++i)
            bytes[scan + random() % (scan - 2)] = static_cast<char>(random() % 256);

        const auto frames = only<ScipFrame>(decode(bytes));

        QVERIFY(frames.size() >= 3);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(frames[frames.size() - 1 - i].ranges == sent.scans[4 - i]);
        QVERIFY(frames.front().ranges == sent.scans.front());
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipDamageTest)
#include "scip_damage_test.moc"
