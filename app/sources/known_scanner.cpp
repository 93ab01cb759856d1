// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/known_scanner.h"

namespace planewright {

namespace {

/// A unit that was there once: it says what it could do, and does nothing.
class RememberedUnit : public TiltUnit {
public:
    explicit RememberedUnit(const KnownScanner& scanner) : scanner_(scanner) {}

    Result<void> connect(const std::stop_token& /*stop*/) override { return gone(); }
    std::string identity() const override { return "remembered tilt unit"; }
    double resolution() const override { return scanner_.resolution; }
    double lowest() const override { return scanner_.lowest; }
    double highest() const override { return scanner_.highest; }
    double fastest() const override { return scanner_.fastest; }
    double speedStep() const override { return scanner_.speedStep; }
    Result<void> arm(const std::stop_token& /*stop*/) override { return gone(); }
    Result<void> moveTo(double /*pitch*/, double /*speed*/) override { return gone(); }
    double nearestPitch(double pitch) const override { return pitch; }
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds /*deadline*/,
                                             const std::stop_token& /*stop*/) override
    {
        return tl::unexpected{gone().error()};
    }
    Result<void> hold() override { return gone(); }
    LinkHealth health() const override { return {}; }
    MotorState motor() const override { return {}; }

private:
    static Result<void> gone() { return fail(ErrorCode::NoDevice, "no tilt unit is connected; connect it first"); }

    const KnownScanner& scanner_;
};

}  // namespace

void note(const TiltUnit& unit, KnownScanner& scanner)
{
    scanner.lowest = unit.lowest();
    scanner.highest = unit.highest();
    scanner.fastest = unit.fastest();
    scanner.resolution = unit.resolution();
    scanner.speedStep = unit.speedStep();
}

Result<FittedPlan> fitPlanTo(const KnownScanner& scanner, const ScanPlan& plan)
{
    return fitPlan(plan, scanner.laser, RememberedUnit(scanner));
}

}  // namespace planewright
