// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/servo_faults.h"

#include <algorithm>
#include <array>
#include <string>

namespace planewright {

namespace {

constexpr auto kServoFaults = std::to_array<ServoFaultKind>({
    {ServoFault::Stall, "servo-stall", "Something blocks the shaft; the load rises to all that the servo can."},
    {ServoFault::Frozen, "servo-frozen", "The servo acknowledges every goal and does not move."},
    {ServoFault::Overload, "servo-overload", "The servo reports an overload and turns itself off."},
    {ServoFault::Overheat, "servo-overheat", "The servo is at 82 °C, turns itself off and cools by 1 °C a second."},
    {ServoFault::Voltage, "servo-voltage", "The supply of the servo falls below its limit."},
    {ServoFault::Silent, "servo-silent", "The servo does not answer any more."},
    {ServoFault::Garbled, "servo-garbled", "One bit of every answer is wrong."},
    {ServoFault::WrongId, "servo-wrong-id", "Answers carry the number of another servo."},
    {ServoFault::Two, "servo-two", "A second servo with the same number is on the bus."},
    {ServoFault::Echo, "servo-echo", "The adapter sends back every byte that it is sent."},
    {ServoFault::Wheel, "servo-wheel", "The servo is set to turn without end."},
    {ServoFault::PowerLoss, "servo-power-loss",
     "The servo has no power for a second, forgets its settings, and its shaft sinks."},
    {ServoFault::Slow, "servo-slow", "Answers come 20 to 30 ms late."},
    {ServoFault::WrongAngle, "servo-wrong-angle", "The servo says that it stands 12 degrees from where it does."},
    {ServoFault::Unplug, "servo-unplug", "The cable is pulled out."},
    {ServoFault::AngleBit, "servo-angle-bit", "Every answer says that a goal was beyond the angle limits."},
    {ServoFault::RangeBit, "servo-range-bit", "Every answer says that a value was out of range."},
    {ServoFault::ChecksumBit, "servo-checksum-bit", "Every answer says that the request had a wrong check."},
    {ServoFault::InstructionBit, "servo-instruction-bit", "Every answer says that the instruction is not known."},
    {ServoFault::ByteLoss, "servo-byte-loss", "One byte of 1000 gets lost, in either direction."},
});

}  // namespace

std::span<const ServoFaultKind> servoFaultKinds()
{
    return kServoFaults;
}

Result<std::vector<ServoFaultAt>> readServoFaults(std::span<const FaultAt> faults)
{
    std::vector<ServoFaultAt> read;
    for (const FaultAt& fault : faults) {
        const auto found = std::find_if(kServoFaults.begin(), kServoFaults.end(),
                                        [&](const auto& kind) { return kind.kind == fault.kind; });
        if (found == kServoFaults.end()) {
            std::string known;
            for (const ServoFaultKind& kind : kServoFaults)
                known += (known.empty() ? "" : ", ") + std::string{kind.kind};
            return fail(ErrorCode::Usage, "'" + fault.kind + "' is no fault of a servo; known are " + known);
        }
        if (fault.step < 0)
            return fail(ErrorCode::Usage, fault.kind + ": the step must not be below 0");
        read.push_back({found->fault, fault.step});
    }
    return read;
}

}  // namespace planewright
