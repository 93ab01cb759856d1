// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/types/snapshot.h"

namespace planewright {

/// Makes the reports of a scan by hand.
class MadeHistory {
public:
    /// The next step with its counts.
    MadeHistory& step(int fitted, int unfitted, int planes, double meanError)
    {
        StepReport& report = add();
        report.step = static_cast<int>(history_.size()) - 1;
        report.counts.fitted = fitted;
        report.counts.unfitted = unfitted;
        report.counts.planes = planes;
        report.counts.meanError = meanError;
        return *this;
    }

    /// Time of a phase of the last step.
    MadeHistory& takes(Phase phase, std::chrono::nanoseconds time)
    {
        history_.back()->report.times[static_cast<std::size_t>(phase)] = time;
        return *this;
    }

    MadeHistory& lastPass()
    {
        add().step = -1;
        return takes(Phase::Finish, std::chrono::milliseconds(40));
    }

    /// A scan as they are: segments come and are fitted every five steps, planes every ten.
    MadeHistory& scan(int steps)
    {
        for (int i = 0; i < steps; ++i) {
            const double wave = std::sin(0.13 * i);
            const int unfitted = 3 + 4 * (i % 5) + static_cast<int>(3.0 * wave);
            step(8 * i - unfitted < 0 ? 0 : 8 * i - unfitted, unfitted, i / 10 + 1, 1.2 + 0.9 * wave);
            const auto micros = [](double value) { return std::chrono::microseconds(static_cast<long>(value)); };
            takes(Phase::Extract, micros(600.0 + 80.0 * wave));
            takes(Phase::Assign, micros(300.0 + 6.0 * i));
            takes(Phase::Cluster, micros(40.0));
            if ((i + 1) % 5 == 0)
                takes(Phase::Fit, micros(2500.0 + 10.0 * i)).takes(Phase::Remaining, micros(350.0));
            if ((i + 1) % 7 == 0)
                takes(Phase::SplitMerge, micros(900.0 + 4.0 * i));
        }
        return *this;
    }

    std::vector<std::shared_ptr<const Snapshot>> get() const { return {history_.begin(), history_.end()}; }

private:
    StepReport& add()
    {
        history_.push_back(std::make_shared<Snapshot>());
        return history_.back()->report;
    }

    std::vector<std::shared_ptr<Snapshot>> history_;
};

}  // namespace planewright
