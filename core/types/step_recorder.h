// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "core/types/step_report.h"

namespace planewright {

/// The caller's clock: time since any fixed moment. The algorithms have none of their own.
using StepClock = std::function<std::chrono::nanoseconds()>;

/// Writes the report of a step while the step runs: which phase is on, how long it took, what was decided and why.
class StepRecorder {
public:
    /// Without a clock times stay zero; without `explain` decisions are not kept.
    StepRecorder(StepReport& report, const StepClock& clock, bool explain)
        : report_(report), clock_(clock), explain_(explain)
    {
    }

    /// Ends the phase that was on and begins another.
    void begin(Phase phase)
    {
        end();
        phase_ = phase;
        running_ = true;
        if (clock_)
            began_ = clock_();
    }

    /// Ends the phase that is on.
    void end()
    {
        if (running_ && clock_)
            report_.times[static_cast<std::size_t>(phase_)] += clock_() - began_;
        running_ = false;
    }

    /// True where decisions are kept; the work of describing them can be saved otherwise.
    bool explains() const { return explain_; }

    /// Keeps a decision of the phase that is on.
    void decide(DecisionKind kind, std::vector<Operand> operands, std::vector<Test> tests,
                std::vector<Operand> result = {})
    {
        if (explain_)
            report_.decisions.push_back({phase_, kind, std::move(operands), std::move(tests), std::move(result)});
    }

    StepCounts& counts() { return report_.counts; }

private:
    StepReport& report_;
    const StepClock& clock_;
    bool explain_;
    bool running_ = false;
    Phase phase_ = Phase::Extract;
    std::chrono::nanoseconds began_{0};
};

}  // namespace planewright
