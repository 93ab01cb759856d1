// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/change_limiter.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ChangeLimiterTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsDueWithoutAChange();
    void aChangeIsToldAtOnceAndOnce();
    void fiveChangesInASecondAreToldAtOnce();
    void theSixthInASecondIsToldHalfASecondLater();
    void aStormIsToldTwiceASecondAndItsEndToo();
    void afterAStormAChangeIsToldAtOnceAgain();
};

void ChangeLimiterTest::nothingIsDueWithoutAChange()
{
    ChangeLimiter limiter;

    QVERIFY(!limiter.due());
    QVERIFY(!limiter.take(1h));
}

void ChangeLimiterTest::aChangeIsToldAtOnceAndOnce()
{
    ChangeLimiter limiter;

    limiter.note(3s);

    QVERIFY(limiter.due() == 3s);
    QVERIFY(limiter.take(3s));
    QVERIFY(!limiter.take(4s));
}

void ChangeLimiterTest::fiveChangesInASecondAreToldAtOnce()
{
    ChangeLimiter limiter;

    for (int i = 0; i < 5; ++i) {
        limiter.note(i * 100ms);
        QVERIFY(limiter.take(i * 100ms));
    }
}

void ChangeLimiterTest::theSixthInASecondIsToldHalfASecondLater()
{
    ChangeLimiter limiter;
    for (int i = 0; i < 5; ++i) {
        limiter.note(i * 100ms);
        limiter.take(i * 100ms);
    }

    limiter.note(500ms);

    QVERIFY(limiter.due() == 1s);
    QVERIFY(!limiter.take(999ms));
    QVERIFY(limiter.take(1s));
}

void ChangeLimiterTest::aStormIsToldTwiceASecondAndItsEndToo()
{
    ChangeLimiter limiter;
    int told = 0;
    for (std::chrono::milliseconds now{0}; now < 10s; now += 10ms) {
        limiter.note(now);
        told += limiter.take(now) ? 1 : 0;
    }

    QVERIFY(told <= 5 + 20);  // the first five at once, then two a second
    QVERIFY(told >= 5 + 15);
    QVERIFY(limiter.due());
    QVERIFY(limiter.take(10s + 500ms));
    QVERIFY(!limiter.due());
}

void ChangeLimiterTest::afterAStormAChangeIsToldAtOnceAgain()
{
    ChangeLimiter limiter;
    for (int i = 0; i < 100; ++i)
        limiter.note(i * 1ms);
    limiter.take(1s);

    limiter.note(5s);

    QVERIFY(limiter.due() == 5s);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ChangeLimiterTest)
#include "change_limiter_test.moc"
