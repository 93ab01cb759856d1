// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <string_view>
#include <utility>

#include "core/types/step_report.h"

namespace planewright {

/// The caller's clock: time since any fixed moment. The algorithms have none of their own.
using StepClock = std::function<std::chrono::nanoseconds()>;

/// Hears that a phase of a step has ended, or one pass of it: its name, empty for a phase of one pass.
using PhaseListener = std::function<void(Phase, std::string_view)>;

/// Writes the report of a step while the step runs: which phase is on, how long it took, what was decided and why.
class StepRecorder {
public:
    /// Without a clock times stay zero; without `explain` decisions are not kept. A listener hears of every phase that
    /// ends and must outlive the recorder.
    StepRecorder(StepReport& report, const StepClock& clock, bool explain, const PhaseListener* listener = nullptr)
        : report_(report), clock_(clock), explain_(explain), listener_(listener)
    {
    }

    /// Ends the phase that was on and begins another, or another pass of the same: a literal names it.
    void begin(Phase phase, std::string_view pass = {})
    {
        end();
        phase_ = phase;
        pass_ = pass;
        running_ = true;
        if (clock_)
            began_ = clock_();
    }

    /// Ends the phase that is on.
    void end()
    {
        if (!running_)
            return;
        if (clock_)
            report_.times[static_cast<std::size_t>(phase_)] += clock_() - began_;
        running_ = false;
        if (listener_ != nullptr)
            (*listener_)(phase_, pass_);
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
    const PhaseListener* listener_;
    bool running_ = false;
    Phase phase_ = Phase::Extract;
    std::string_view pass_;
    std::chrono::nanoseconds began_{0};
};

}  // namespace planewright
