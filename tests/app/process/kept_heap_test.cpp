// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/process/kept_heap.h"

#include <memory>
#include <sys/resource.h>

#include <QtTest>

#include "tests/sanitized.h"
#include "tests/test_program.h"

namespace planewright {

class KeptHeapTest : public QObject {
    Q_OBJECT

private slots:
    void freedMemoryIsUsedAgain();
};

namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kBlock = std::size_t{8} << 20;

/// Page faults while a block is made, used and freed.
long faultsOfABlock()
{
    rusage before{};
    rusage after{};
    getrusage(RUSAGE_THREAD, &before);
    {
        const std::unique_ptr<volatile char[]> block(new char[kBlock]);
        for (std::size_t at = 0; at < kBlock; at += kPage)
            block[at] = 1;
    }
    getrusage(RUSAGE_THREAD, &after);
    return after.ru_minflt - before.ru_minflt;
}

}  // namespace

void KeptHeapTest::freedMemoryIsUsedAgain()
{
    if (kIsSanitized)
        QSKIP("a sanitizer brings a heap of its own");
    keepFreedMemory();
    const long first = faultsOfABlock();
    QVERIFY2(first >= long{kBlock / kPage} / 2,
             qPrintable(QString::number(first)));  // a page for each, or some at once
    const long second = faultsOfABlock();
    QVERIFY2(second < 16, qPrintable(QString::number(second)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::KeptHeapTest)
#include "kept_heap_test.moc"
