// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/parameter_events.h"

#include <QTest>

#include "core/params/registry.h"
#include "tests/test_program.h"

using namespace planewright;

class ParameterEventsTest : public QObject {
    Q_OBJECT

private slots:
    void everyParameterComesBack();
    void theLastSetOfAStepHolds();
    void otherEventsArePassedOver();
    void anotherExtractionTakesThePlaceOfTheOneBefore();
    void whatIsNoPresetIsAnError();
};

void ParameterEventsTest::everyParameterComesBack()
{
    Parameters changed;
    for (const ParameterRow& row : parameterRows()) {
        if (row.choices.empty())
            QVERIFY(setParameter(changed, row.key, printParameter(changed, row.key)));
        else
            QVERIFY(setParameter(changed, row.key, row.choices.back()));
    }

    const auto read = readParameterEvents({parametersEvent(12, changed)}, "a.pwscan");

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->size(), std::size_t(1));
    QCOMPARE(read->front().step, 12);
    for (const ParameterRow& row : parameterRows())
        QCOMPARE(printParameter(read->front().parameters, row.key), printParameter(changed, row.key));
}

void ParameterEventsTest::theLastSetOfAStepHolds()
{
    Parameters first, second;
    first.planes.minSlices = 8;
    second.planes.minSlices = 9;

    const auto read = readParameterEvents({parametersEvent(3, first), parametersEvent(3, second)}, "a.pwscan");

    QCOMPARE(read->size(), std::size_t(1));
    QCOMPARE(read->front().parameters.planes.minSlices, 9);
}

void ParameterEventsTest::otherEventsArePassedOver()
{
    const auto read = readParameterEvents({{ScanEvent::Kind::Note, 1, std::nullopt, "no JSON"}}, "a.pwscan");

    QVERIFY(read);
    QVERIFY(read->empty());
}

void ParameterEventsTest::anotherExtractionTakesThePlaceOfTheOneBefore()
{
    Parameters again;
    again.planes.minSlices = 9;

    const auto whole =
        readParameterEvents({parametersEvent(0, {}), parametersEvent(3, {}), parametersEvent(0, again)}, "a.pwscan");
    const auto part =
        readParameterEvents({parametersEvent(0, {}), parametersEvent(3, {}), parametersEvent(2, again)}, "a.pwscan");

    QCOMPARE(whole->size(), std::size_t(1));
    QCOMPARE(whole->front().parameters.planes.minSlices, 9);
    QCOMPARE(part->size(), std::size_t(2));
    QCOMPARE(part->back().step, 2);
    QCOMPARE(part->back().parameters.planes.minSlices, 9);
}

void ParameterEventsTest::whatIsNoPresetIsAnError()
{
    const auto read = readParameterEvents({{ScanEvent::Kind::Parameters, 4, std::nullopt, "{"}}, "a.pwscan");

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Unreadable);
    QVERIFY2(read.error().message.starts_with("a.pwscan: the parameters stored for step 4: line 1"),
             read.error().message.c_str());
}

PLANEWRIGHT_TEST(ParameterEventsTest)
#include "parameter_events_test.moc"
