// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/health_facts.h"

#include <algorithm>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class HealthFactsTest : public QObject {
    Q_OBJECT

private slots:
    void oneLineHasRateLossesLoadAndTemperature();
    void whatIsOutOfOrderStandsOut();
    void faultsAreCountedByTheirCodes();
    void aTroubleOfBothIsToldOnce();
};

namespace {

NoddingHealth wellAndBusy()
{
    NoddingHealth health;
    health.laser.rate = 39.96;
    health.laser.good = 400;
    health.laser.lost = 1;
    health.laser.corrupt = 2;
    health.laser.late = 3;
    health.tilt.rate = 98.04;
    health.tilt.good = 1000;
    health.motor.load = 0.123;
    health.motor.voltage = 14.8;
    health.motor.temperature = 41.4;
    return health;
}

std::string lineOf(const std::vector<HealthFact>& facts)
{
    std::string line;
    for (const HealthFact& fact : facts)
        line += fact.brief.empty() ? "" : (line.empty() ? "" : ", ") + fact.brief;
    return line;
}

bool isTroubled(const std::vector<HealthFact>& facts)
{
    return std::any_of(facts.begin(), facts.end(), [](const HealthFact& fact) { return fact.isTrouble; });
}

}  // namespace

void HealthFactsTest::oneLineHasRateLossesLoadAndTemperature()
{
    const auto facts = factsOf(wellAndBusy());

    QCOMPARE(lineOf(facts), std::string("40.0 scans/s, lost 1, corrupt 2, late 3, load 12 %, 41 °C"));
    QVERIFY(!isTroubled(facts));
}

void HealthFactsTest::whatIsOutOfOrderStandsOut()
{
    NoddingHealth lossy = wellAndBusy();
    lossy.tilt.lost = 11;  // of a thousand: more than one in a hundred
    NoddingHealth hot = wellAndBusy();
    hot.motor.trouble = "the motor is hot";

    QVERIFY(isTroubled(factsOf(lossy)));
    QVERIFY(lineOf(factsOf(lossy)).find("angles lost 11, corrupt 0, late 0") != std::string::npos);
    QVERIFY(isTroubled(factsOf(hot)));
    QVERIFY(lineOf(factsOf(hot)).starts_with("▲ the motor is hot"));
}

void HealthFactsTest::faultsAreCountedByTheirCodes()
{
    NoddingHealth health = wellAndBusy();
    health.laser.faults = {{"laser-sum", 3}};
    health.tilt.faults = {{"servo-silent", 1}, {"servo-unheard-of", 2}};

    const auto facts = factsOf(health);

    const auto valueOf = [&](const std::string& name) {
        const auto fact = std::ranges::find(facts, name, &HealthFact::name);
        return fact == facts.end() ? std::string{"none"} : fact->value;
    };
    QCOMPARE(valueOf("laser-sum"), std::string("3 × a line with a wrong sum"));
    QCOMPARE(valueOf("servo-silent"), std::string("1 × no answer to a question"));
    QCOMPARE(valueOf("servo-unheard-of"), std::string("2 ×"));
    QCOMPARE(lineOf(facts), lineOf(factsOf(wellAndBusy())));
}

void HealthFactsTest::aTroubleOfBothIsToldOnce()
{
    NoddingHealth health = wellAndBusy();
    health.tilt.trouble = health.motor.trouble = "the motor is hot";

    const auto facts = factsOf(health);

    QCOMPARE(std::ranges::count(facts, "the motor is hot", &HealthFact::value), std::ptrdiff_t(1));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::HealthFactsTest)
#include "health_facts_test.moc"
