// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/count_text.h"

#include <cstdint>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class CountTextTest : public QObject {
    Q_OBJECT

private slots:
    void oneThingIsInTheSingular();
};

void CountTextTest::oneThingIsInTheSingular()
{
    QCOMPARE(countText(1, "slice"), std::string("1 slice"));
    QCOMPARE(countText(std::uint64_t{1}, "event"), std::string("1 event"));
    QCOMPARE(countText(0, "slice"), std::string("0 slices"));
    QCOMPARE(countText(std::int64_t{21}, "slice"), std::string("21 slices"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CountTextTest)
#include "count_text_test.moc"
