// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/dialogue_file.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <string_view>

#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DialogueFileTest : public QObject {
    Q_OBJECT

private slots:
    void anEventIsALine();
    void timesKeepTheirNanoseconds();
    void theReasonOfALossIsReadable();
    void everyByteComesBackAsItWas();
    void manyBytesTakeSeveralLinesOfTheSameTime();
    void remarksAndEmptyLinesAreLeftOut();
    void aLastLineThatWasCutOffIsLeftOut();
    void whatIsNoDialogueIsRefused_data();
    void whatIsNoDialogueIsRefused();
    void whatIsNoEventIsRefusedWithItsLine_data();
    void whatIsNoEventIsRefusedWithItsLine();
    void whatIsNoPlainFileIsRefused();
    void randomBytesNeverDoHarm();

private:
    std::string write(std::string_view text);

    QTemporaryDir folder_;
};

namespace {

using Kind = DialogueEvent::Kind;

std::vector<std::uint8_t> bytes(std::string_view text)
{
    return {text.begin(), text.end()};
}

/// All events of a file; the error's text where there is one.
Result<std::vector<DialogueEvent>> readAll(const std::string& path)
{
    auto reader = DialogueReader::open(path);
    if (!reader)
        return tl::unexpected<Error>(reader.error());
    std::vector<DialogueEvent> events;
    for (;;) {
        auto event = reader->next();
        if (!event)
            return tl::unexpected<Error>(event.error());
        if (!*event)
            return events;
        events.push_back(std::move(**event));
    }
}

}  // namespace

std::string DialogueFileTest::write(std::string_view text)
{
    std::string path = folder_.filePath("dialogue.txt").toStdString();
    std::ofstream{path, std::ios::binary} << text;
    return path;
}

void DialogueFileTest::anEventIsALine()
{
    QCOMPARE(dialogueLines({Kind::ToDevice, 0us, bytes("QT\n")}), std::string("0 > QT\\n\n"));
    QCOMPARE(dialogueLines({Kind::FromDevice, 1840us, bytes(std::string_view{"a b\\\r\xFF\0", 7})}),
             std::string("1840 < a\\x20b\\\\\\r\\xFF\\x00\n"));
}

void DialogueFileTest::timesKeepTheirNanoseconds()
{
    QCOMPARE(dialogueLines({Kind::ToDevice, 1840250ns, bytes("A")}), std::string("1840.25 > A\n"));
    QCOMPARE(dialogueLines({Kind::ToDevice, 5ns, bytes("A")}), std::string("0.005 > A\n"));
    QCOMPARE(dialogueLines({Kind::ToDevice, 100us, bytes("A")}), std::string("100 > A\n"));

    const auto events = readAll(write("planewright-dialogue 1\n0.005 > A\n1840.25 < B\n1840.3 < C\n1900 < D\n"));

    QVERIFY2(events, events ? "" : events.error().message.c_str());
    QVERIFY(events->at(0).at == 5ns);
    QVERIFY(events->at(1).at == 1840250ns);
    QVERIFY(events->at(2).at == 1840300ns);
    QVERIFY(events->at(3).at == 1900us);
}

void DialogueFileTest::theReasonOfALossIsReadable()
{
    const std::string line = dialogueLines({Kind::Lost, 7us, bytes("/dev/ttyACM0: the device is gone")});

    QCOMPARE(line, std::string("7 ! /dev/ttyACM0: the device is gone\n"));
    const auto events = readAll(write(std::string{kDialogueFirstLine} + "\n" + line));
    QVERIFY(events);
    QCOMPARE(events->at(0).kind, Kind::Lost);
    QCOMPARE(events->at(0).bytes, bytes("/dev/ttyACM0: the device is gone"));
}

void DialogueFileTest::everyByteComesBackAsItWas()
{
    std::vector<std::uint8_t> all(256);
    std::iota(all.begin(), all.end(), std::uint8_t{0});

    const auto events =
        readAll(write(std::string{kDialogueFirstLine} + "\n" + dialogueLines({Kind::FromDevice, 12us, all})));

    QVERIFY2(events, events ? "" : events.error().message.c_str());
    QCOMPARE(events->size(), std::size_t{1});
    QVERIFY(events->at(0).at == 12us);
    QCOMPARE(events->at(0).bytes, all);
}

void DialogueFileTest::manyBytesTakeSeveralLinesOfTheSameTime()
{
    const std::vector<std::uint8_t> many(2 * kMostDialogueBytes + 1, 0);

    const std::string lines = dialogueLines({Kind::FromDevice, 5us, many});
    const auto events = readAll(write(std::string{kDialogueFirstLine} + "\n" + lines));

    QVERIFY2(events, events ? "" : events.error().message.c_str());
    QCOMPARE(events->size(), std::size_t{3});
    QCOMPARE(events->at(0).bytes.size(), kMostDialogueBytes);
    QCOMPARE(events->at(2).bytes.size(), std::size_t{1});
    QVERIFY(events->at(2).at == 5us);
}

void DialogueFileTest::remarksAndEmptyLinesAreLeftOut()
{
    const auto events = readAll(write("planewright-dialogue 1\n# a laser\n\n0 > A\n# again\n0 < B\n"));

    QVERIFY(events);
    QCOMPARE(events->size(), std::size_t{2});
    QCOMPARE(events->at(1).bytes, bytes("B"));
}

void DialogueFileTest::aLastLineThatWasCutOffIsLeftOut()
{
    const auto events = readAll(write("planewright-dialogue 1\n0 > QT\\n\n1840 < QT\\n00P"));

    QVERIFY(events);
    QCOMPARE(events->size(), std::size_t{1});
}

void DialogueFileTest::whatIsNoDialogueIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("empty") << QByteArray("") << QByteArray("no recorded dialogue");
    QTest::newRow("first line cut off") << QByteArray("planewright-dialogue 1") << QByteArray("no recorded dialogue");
    QTest::newRow("another format") << QByteArray("# format = nodding-laser-csv 1\n")
                                    << QByteArray("first line must be 'planewright-dialogue 1'");
    QTest::newRow("newer") << QByteArray("planewright-dialogue 2\n") << QByteArray("version '2'");
    QTest::newRow("no line end") << QByteArray(1 << 20, 'a') << QByteArray("longer than any line");
}

void DialogueFileTest::whatIsNoDialogueIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);
    const std::string path = write(text.toStdString());

    const auto events = readAll(path);

    QVERIFY(!events);
    QCOMPARE(events.error().code, ErrorCode::Unreadable);
    QVERIFY2(events.error().message.starts_with(path + ":"), events.error().message.c_str());
    QVERIFY2(events.error().message.find(says.toStdString()) != std::string::npos, events.error().message.c_str());
}

void DialogueFileTest::whatIsNoEventIsRefusedWithItsLine_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* line, const char* says) {
        QTest::newRow(line) << QByteArray(line) << QByteArray(says);
    };
    row("soon > QT", "no time");
    row("-1 > QT", "no time");
    row("1. > QT", "no time");
    row(".5 > QT", "no time");
    row("1.5000 > QT", "no time");
    row("1.-5 > QT", "no time");
    row("1.5.5 > QT", "no time");
    row("+1 > QT", "no time");
    row("99999999999999999999 > QT", "no time");
    row("31536000000000.001 > QT", "no time");
    row("12", "'>', '<' or '!'");
    row("12 = QT", "'>', '<' or '!'");
    row("12 >> QT", "'>', '<' or '!'");
    row("12  > QT", "'>', '<' or '!'");
    row("12>QT", "no time");
    row("12 >", "no bytes");
    row("12 < ", "no bytes");
    row("12 > a\\", "printable ASCII");
    row("12 > a\\x", "printable ASCII");
    row("12 > a\\x1", "printable ASCII");
    row("12 > a\\xG1", "printable ASCII");
    row("12 > a\\x-1", "printable ASCII");
    row("12 > a\\t", "printable ASCII");
    row("12 > \xC3\xBC", "printable ASCII");
    row("12 > QT\r", "printable ASCII");
    row("9 > QT", "time runs backwards");
    row("12 ! gone\n12 > QT", "after the link was lost");
}

void DialogueFileTest::whatIsNoEventIsRefusedWithItsLine()
{
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, says);
    const std::string path = write("planewright-dialogue 1\n10 > A\n" + line.toStdString() + "\n");

    const auto events = readAll(path);

    QVERIFY(!events);
    QCOMPARE(events.error().code, ErrorCode::Unreadable);
    const int number = line.contains('\n') ? 4 : 3;
    QVERIFY2(events.error().message.starts_with(path + ":" + std::to_string(number) + ": "),
             events.error().message.c_str());
    QVERIFY2(events.error().message.find(says.toStdString()) != std::string::npos, events.error().message.c_str());
}

void DialogueFileTest::whatIsNoPlainFileIsRefused()
{
    for (const std::string& path : {folder_.filePath("nowhere").toStdString(), folder_.path().toStdString(),
                                    std::string{"/dev/zero"}, std::string{}}) {
        const auto reader = DialogueReader::open(path);

        QVERIFY(!reader);
        QCOMPARE(reader.error().code, ErrorCode::Unreadable);
        QVERIFY(reader.error().message.starts_with(path + ": "));
    }
}

void DialogueFileTest::randomBytesNeverDoHarm()
{
    // What a dialogue is made of, in any order: most lines are refused, some are read, none may crash or take memory.
    constexpr std::string_view kParts = "0123456789 <>!#\\xnrAF\n\r\xFF";
    std::uint32_t state = 2024;
    const auto draw = [&state] { return (state = state * 1664525U + 1013904223U) >> 8; };
    int refused = 0;
    for (int run = 0; run < 300; ++run) {
        std::string text = "planewright-dialogue 1\n";
        for (std::uint32_t i = draw() % 200; i > 0; --i)
            text += kParts[draw() % kParts.size()];
        const auto events = readAll(write(text));
        refused += events ? 0 : 1;
        for (const DialogueEvent& event : events.value_or(std::vector<DialogueEvent>{}))
            QVERIFY(event.at >= 0us && (event.kind == Kind::Lost || !event.bytes.empty()));
    }
    QVERIFY(refused > 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DialogueFileTest)
#include "dialogue_file_test.moc"
