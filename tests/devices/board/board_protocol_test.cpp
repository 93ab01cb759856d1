// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <map>
#include <set>
#include <utility>

#include <QFile>
#include <QRegularExpression>
#include <QtTest>

#include "devices/board/board_message.h"
#include "devices/board/frame_parser.h"
#include "tests/test_program.h"

namespace planewright {

/// resources/manual/board-protocol.md is what a firmware is written from: what it says must be what the code does.
class BoardProtocolTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstVectorsHoldLiterally_data();
    void theFirstVectorsHoldLiterally();
    void everyExampleOfTheDocumentIsReadAndWrittenAgain();
    void everyMessageHasAnExample();
    void theTablesOfTheDocumentAreTheFieldsOfTheMessages();
    void theNumbersOfStatesNaksAndFaultsAreTheDocuments();
};

namespace {

using namespace board;

QStringList documentLines()
{
    QFile file(PLANEWRIGHT_SOURCE_DIR "/resources/manual/board-protocol.md");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("resources/manual/board-protocol.md cannot be read");
    return QString::fromUtf8(file.readAll()).split('\n');
}

std::vector<std::uint8_t> fromHex(const QString& text)
{
    const QByteArray bytes = QByteArray::fromHex(text.toLatin1());
    return {bytes.begin(), bytes.end()};
}

struct Example {
    QString text;
    QString hex;
};

/// The blocks of the document that begin with a message and go on with its bytes.
std::vector<Example> examples()
{
    static const QRegularExpression kMessage{"^[A-Z_]+( reply)? seq=[0-9A-F]{4}( |$)"};
    static const QRegularExpression kBytes{"^([0-9A-F]{2} ?)+$"};
    std::vector<Example> all;
    const QStringList lines = documentLines();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (!kMessage.match(lines[i]).hasMatch())
            continue;
        Example example{lines[i], {}};
        while (i + 1 < lines.size() && kBytes.match(lines[i + 1]).hasMatch())
            example.hex += (example.hex.isEmpty() ? "" : " ") + lines[++i];
        all.push_back(example);
    }
    return all;
}

/// "offset name type" of every field of a message.
struct FieldLister {
    QStringList& fields;
    std::size_t offset = 0;

    template <class T>
    void operator()(std::string_view name, const T&)
    {
        fields << QString("%1 %2 %3").arg(offset).arg(name.data(), QString::fromStdString(fieldType<T>()));
        offset += sizeof(T);
    }
};

struct Layout {
    QString name;
    QStringList fields;
    bool operator==(const Layout&) const = default;
};

template <std::size_t... I>
std::map<int, Layout> layoutsOfTheCode(std::index_sequence<I...>)
{
    std::map<int, Layout> layouts;
    const auto list = [&]<class T>(const T& message) {
        Layout& layout = layouts[T::kType];
        layout.name = QString::fromLatin1(T::kName.data());
        FieldLister lister{layout.fields};
        T::fields(message, lister);
    };
    (list(std::variant_alternative_t<I, Message>{}), ...);
    return layouts;
}

std::map<int, Layout> layoutsOfTheCode()
{
    return layoutsOfTheCode(std::make_index_sequence<std::variant_size_v<Message>>{});
}

std::map<int, Layout> layoutsOfTheDocument()
{
    static const QRegularExpression kHeading{"^### ([0-9A-F]{2}) (.+)$"};
    static const QRegularExpression kRow{"^\\| (\\d+) \\| (\\w+) \\| ([ui]\\d+|u8\\[8\\]) \\|"};
    static const QRegularExpression kSameAs{"Payload as in ([0-9A-F]{2})"};
    std::map<int, Layout> layouts;
    std::map<int, int> same;
    int type = -1;
    for (const QString& line : documentLines()) {
        if (const auto heading = kHeading.match(line); heading.hasMatch()) {
            type = heading.captured(1).toInt(nullptr, 16);
            layouts[type].name = heading.captured(2);
        } else if (line.startsWith("## ")) {
            type = -1;
        }
        if (const auto row = kRow.match(line); type >= 0 && row.hasMatch())
            layouts[type].fields << QString("%1 %2 %3").arg(row.captured(1), row.captured(2), row.captured(3));
        if (const auto other = kSameAs.match(line); type >= 0 && other.hasMatch())
            same[type] = other.captured(1).toInt(nullptr, 16);
    }
    for (const auto& [to, from] : same)
        layouts[to].fields = layouts[from].fields;
    return layouts;
}

/// The rows "| number | name |" of the table whose first cell is this one.
std::map<int, QString> tableOfTheDocument(const QString& firstCell, int base)
{
    std::map<int, QString> rows;
    bool inside = false;
    for (const QString& line : documentLines()) {
        const QStringList cells = line.split('|');
        if (cells.size() > 2 && cells[1].trimmed() == firstCell)
            inside = true;
        else if (!line.startsWith('|'))
            inside = false;
        bool isNumber = false;
        const int number = cells.size() > 2 ? cells[1].trimmed().toInt(&isNumber, base) : 0;
        if (inside && isNumber && !rows.contains(number))
            rows[number] = cells[2].trimmed();
    }
    return rows;
}

}  // namespace

void BoardProtocolTest::theFirstVectorsHoldLiterally_data()
{
    QTest::addColumn<QString>("hex");
    QTest::addColumn<int>("seq");
    QTest::addColumn<QString>("text");
    QTest::newRow("HELLO") << "02 01 02 01 04 01 4C 9C 00" << 1 << "HELLO seq=0001";
    QTest::newRow("ESTOP") << "02 01 02 03 04 2F 80 37 00" << 3 << "ESTOP seq=0003";
    QTest::newRow("MOVE") << "04 01 06 02 02 20 03 02 64 05 01 08 F1 B2 00" << 2
                          << "MOVE seq=0002 goal=512 speed=100 flags=1 settle_ms=8";
    QTest::newRow("HEARTBEAT") << "04 01 08 04 06 02 15 CD 5B 07 01 01 01 03 10 DC 00" << 4
                               << "HEARTBEAT seq=0004 host_us=123456789";
    QTest::newRow("SLICE") << "07 01 12 01 80 90 11 01 01 04 40 4B 4C 01 01 01 01 05 1C 02 FD FF 01 03 1C 98 00"
                           << 0x8001 << "SLICE seq=8001 slice=17 at_us=5000000 pos=540 moved=-3 state=0 err=0";
}

void BoardProtocolTest::theFirstVectorsHoldLiterally()
{
    QFETCH(QString, hex);
    QFETCH(int, seq);
    QFETCH(QString, text);

    const std::vector<Frame> frames = FrameParser{}.push(fromHex(hex));

    QCOMPARE(frames.size(), std::size_t(1));
    QCOMPARE(int(frames[0].seq), seq);
    QCOMPARE(QString::fromStdString(toText(frames[0])), text);
    QCOMPARE(QString::fromStdString(toHex(encodeFrame(frames[0]))), hex);
}

void BoardProtocolTest::everyExampleOfTheDocumentIsReadAndWrittenAgain()
{
    const std::vector<Example> all = examples();
    QVERIFY(all.size() >= std::variant_size_v<Message>);

    for (const Example& example : all) {
        const std::vector<Frame> frames = FrameParser{}.push(fromHex(example.hex));

        QVERIFY2(frames.size() == 1, qPrintable(example.text));
        QCOMPARE(QString::fromStdString(toText(frames[0])), example.text);
        const auto message = toMessage(frames[0]);
        QVERIFY(message);
        QCOMPARE(QString::fromStdString(toHex(encodeFrame(toFrame(frames[0].seq, *message)))), example.hex);
    }
}

void BoardProtocolTest::everyMessageHasAnExample()
{
    std::set<int> seen;
    for (const Example& example : examples()) {
        for (const Frame& frame : FrameParser{}.push(fromHex(example.hex)))
            seen.insert(frame.type);
    }

    for (const auto& [type, layout] : layoutsOfTheCode())
        QVERIFY2(seen.contains(type), qPrintable(layout.name));
}

void BoardProtocolTest::theTablesOfTheDocumentAreTheFieldsOfTheMessages()
{
    const std::map<int, Layout> document = layoutsOfTheDocument();
    const std::map<int, Layout> code = layoutsOfTheCode();

    QCOMPARE(document.size(), code.size());
    for (const auto& [type, layout] : code) {
        QVERIFY2(document.contains(type), qPrintable(layout.name));
        QCOMPARE(document.at(type).name, layout.name);
        QCOMPARE(document.at(type).fields, layout.fields);
    }
}

void BoardProtocolTest::theNumbersOfStatesNaksAndFaultsAreTheDocuments()
{
    std::map<int, QString> states;
    for (int state = 0; state < kStates; ++state)
        states[state] = QString::fromStdString(toText(static_cast<State>(state)));
    QCOMPARE(tableOfTheDocument("number", 10), states);

    // The codes of NAK and those of faults stand in two tables with the same first cell: 1 to 6, and 1, 2, 10 to 18.
    const std::map<int, QString> codes = tableOfTheDocument("code", 16);
    QCOMPARE(codes.size(), std::size_t(6 + 9));
    for (const auto& [number, text] : codes) {
        if (number >= 0x10)
            QVERIFY2(!toText(static_cast<board::Fault>(number)).starts_with("fault"), qPrintable(text));
    }
    QVERIFY(toText(static_cast<board::Fault>(0x19)).starts_with("fault"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardProtocolTest)
#include "board_protocol_test.moc"
