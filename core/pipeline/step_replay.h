// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters_from.h"
#include "core/pipeline/plane_extractor.h"
#include "core/types/error.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// What the report of the forced last pass has for its step.
inline constexpr int kLastPass = -1;

/// Takes a scan back to any of its steps and tells how it went: phase by phase, with every decision.
///
/// An extraction holds more than its snapshots show, so a step is reached by extracting the slices before it once more;
/// the same slices and parameters give the same planes, bit for bit. It stays where it is, and the next step forward
/// costs no more than that step. It may grow while the scan runs. It is no thread's but its user's.
class StepReplay {
public:
    /// Of an extraction that began with these parameters.
    StepReplay(const SensorModel& sensor, const Parameters& parameters);

    /// The next slice of the scan as it was extracted, corrected by `sensor.*`; its step exceeds those before.
    void add(std::shared_ptr<const ScanSlice> slice);

    /// Parameters in force from a step on, which is later than those before; after the last slice they are in force for
    /// the forced last pass. Those of a step that was told before are replaced.
    void change(const ParametersFrom& change);

    std::size_t slices() const { return slices_.size(); }

    /// How a step went, or the forced last pass (kLastPass) after the slices that there are. Usage error for a step
    /// that the scan does not have.
    Result<std::shared_ptr<const PhasedStep>> at(int step);

    /// Why two planes are not one, or a segment is not in a plane, after a step: as PlaneExtractor::whyNot().
    Result<WhyNot> whyNot(int step, const Operand& a, const Operand& b);

    /// Visits every step of the scan in order, with all decisions in its report; the forced last pass too, if wanted.
    void visit(bool lastPass, const std::function<void(const Snapshot&)>& visitor) const;

private:
    Result<std::size_t> placeOf(int step) const;
    void goTo(std::size_t place);

    /// An extraction and how far it has come.
    struct Course {
        explicit Course(const SensorModel& sensor, const Parameters& parameters, bool explain)
            : extractor(std::make_unique<PlaneExtractor>(sensor, parameters, ExtractionOptions{{}, explain}))
        {
        }
        void changeUpTo(int step, const std::vector<ParametersFrom>& all);

        std::unique_ptr<PlaneExtractor> extractor;
        std::size_t next = 0;  ///< place of the slice that is worked in next; one past the last: the last pass is done
        std::size_t changes = 0;  ///< parameters that are in force or were
    };

    SensorModel sensor_;
    Parameters parameters_;
    std::vector<ParametersFrom> changes_;
    std::vector<std::shared_ptr<const ScanSlice>> slices_;
    std::optional<Course> course_;
    std::shared_ptr<const PhasedStep> newest_;  // what the course did last
};

}  // namespace planewright
