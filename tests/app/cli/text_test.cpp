// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/text.h"

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class TextTest : public QObject {
    Q_OBJECT

private slots:
    void roundedKeepsNineSignificantDigits();
    void tableSetsNumbersToTheRightAndWordsToTheLeft();
};

void TextTest::roundedKeepsNineSignificantDigits()
{
    QCOMPARE(rounded(0.1 + 0.2), 0.3);
    QCOMPARE(rounded(1234.567890123), 1234.56789);
}

void TextTest::tableSetsNumbersToTheRightAndWordsToTheLeft()
{
    const std::string table = tableText({{"id", "name"}, {"7", "wall"}, {"12", "floor"}});

    QCOMPARE(table, std::string("id  name\n 7  wall\n12  floor\n"));
}

PLANEWRIGHT_TEST(TextTest)
#include "text_test.moc"
