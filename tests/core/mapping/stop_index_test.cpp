// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/stop_index.h"

#include <algorithm>

#include <QtTest>

#include "core/simulation/random.h"
#include "tests/test_program.h"

namespace planewright {

class StopIndexTest : public QObject {
    Q_OBJECT

private slots:
    void theNearestAreThoseOfAPlainSearch();
    void aStopThatMovedIsFoundWhereItIs();
};

void StopIndexTest::theNearestAreThoseOfAPlainSearch()
{
    Random random(4);
    StopIndex index(5.0);
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < 300; ++i) {
        const double x = random.uniform(-40.0, 40.0);
        const double y = random.uniform(-40.0, 40.0);
        places.emplace_back(x, y, 1.0);
        index.add(i, places.back());
    }

    for (int question = 0; question < 50; ++question) {
        const double x = random.uniform(-50.0, 50.0);
        const double y = random.uniform(-50.0, 50.0);
        const Eigen::Vector3d here{x, y, 1.0};
        std::vector<std::pair<double, std::size_t>> all;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double distance = (places[i] - here).norm();
            if (distance <= 25.0)
                all.emplace_back(distance, i);
        }
        std::ranges::sort(all);
        all.resize(std::min<std::size_t>(all.size(), 12));
        std::vector<std::size_t> expected;
        for (const auto& [distance, stop] : all)
            expected.push_back(stop);
        QCOMPARE(index.nearest(here, 12, 25.0), expected);
    }
}

void StopIndexTest::aStopThatMovedIsFoundWhereItIs()
{
    StopIndex index(5.0);
    index.add(0, {1.0, 1.0, 0.0});
    index.move(0, {1.0, 1.0, 0.0}, {31.0, 1.0, 0.0});

    QVERIFY(index.nearest({1.0, 1.0, 0.0}, 1, 10.0).empty());
    QCOMPARE(index.nearest({30.0, 1.0, 0.0}, 1, 10.0), std::vector<std::size_t>{0});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StopIndexTest)
#include "stop_index_test.moc"
