// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/labels.h"

#include <sstream>

#include <QtTest>

#include "sample_scan.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

Result<Labels> readLabelsText(const std::string& text)
{
    std::istringstream in(text);
    return readLabels(in, "l.txt");
}

}  // namespace

class LabelsTest : public QObject {
    Q_OBJECT

private slots:
    void beamsOfAPlanesSegmentsHaveItsId();
    void writesALinePerSlice();
    void readsBackWhatWasWritten();
    void refusesWhatAreNoLabels_data();
    void refusesWhatAreNoLabels();
    void refusesMoreSlicesThanARecordingHolds();
    void aFullDiskIsNotSilent();
};

void LabelsTest::beamsOfAPlanesSegmentsHaveItsId()
{
    const Labels labels = labelsOf(sampleSnapshot(), sampleScan());

    // Step 4: beams 0 to 3 are of plane 9, but 1 has no return and 2 is too far. Step 7: 0 and 1 are unfitted.
    QCOMPARE(labels, (Labels{{9, -1, -1, 9, -1}, {-1, -1, 1, 1, 1}}));
}

void LabelsTest::writesALinePerSlice()
{
    std::ostringstream out;

    QVERIFY(writeLabels(out, {{9, -1, 12345}, {-2, 0, 1}}).has_value());

    QCOMPARE(out.str(), std::string("9 -1 12345\n-2 0 1\n"));
}

void LabelsTest::readsBackWhatWasWritten()
{
    QCOMPARE(readLabelsText("9 -1 12345\n-2 0 1\n").value(), (Labels{{9, -1, 12345}, {-2, 0, 1}}));
    QCOMPARE(readLabelsText("2147483647\r\n-1\r\n\r\n").value(), (Labels{{2147483647}, {-1}}));
    QCOMPARE(readLabelsText("1 2").value(), (Labels{{1, 2}}));
}

void LabelsTest::refusesWhatAreNoLabels_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const QString give = " is not a label; give whole numbers from -2, separated by single blanks";
    QTest::newRow("empty") << QByteArray() << "l.txt: the file is empty; give a line of labels for every slice";
    QTest::newRow("text") << QByteArray("1 2\n3 x\n") << "l.txt: line 2, column 2: 'x'" + give;
    QTest::newRow("broken") << QByteArray("1 2.5\n") << "l.txt: line 1, column 2: '2.5'" + give;
    QTest::newRow("below") << QByteArray("1 -3\n") << "l.txt: line 1, column 2: '-3'" + give;
    QTest::newRow("huge") << QByteArray("4294967296\n") << "l.txt: line 1, column 1: '4294967296'" + give;
    QTest::newRow("two blanks") << QByteArray("1  2\n") << "l.txt: line 1, column 2: ''" + give;
    QTest::newRow("commas") << QByteArray("1,2,3\n") << "l.txt: line 1, column 1: '1,2,3'" + give;
    QTest::newRow("other length")
        << QByteArray("1 2 3\n1 2\n")
        << "l.txt: line 2: the line has 2 labels and the first has 3; give one for every beam";
    QTest::newRow("blank line") << QByteArray("1 2\n\n1 2\n")
                                << "l.txt: line 2: there is a blank line between labels; remove it";
    QTest::newRow("damaged gzip") << QByteArray("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x06", 11)
                                  << "l.txt: line 1: the compressed data are damaged here; get the file again";
    QTest::newRow("cut gzip") << QByteArray("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x01\x02\0\xFD\xFF\x31\x0A", 17)
                              << "l.txt: line 2: the compressed file was cut short; get the whole file";
}

void LabelsTest::refusesWhatAreNoLabels()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, message);

    const auto labels = readLabelsText(text.toStdString());

    QVERIFY(!labels.has_value());
    QCOMPARE(labels.error().code, ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(labels.error().message), message);
}

void LabelsTest::refusesMoreSlicesThanARecordingHolds()
{
    std::string text;
    for (int slice = 0; slice < kMaxSlices; ++slice)
        text += "0\n";

    QCOMPARE(readLabelsText(text)->size(), std::size_t(kMaxSlices));
    QCOMPARE(readLabelsText(text + "0\n").error().message,
             std::string("l.txt: line 65537: more labels than a recording has ranges; give the labels of a recording"));
}

void LabelsTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writeLabels(out, {{1}}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(LabelsTest)
#include "labels_test.moc"
