// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "core/formats/trajectory_tum.h"

namespace {

void require(bool holds)
{
    if (!holds)
        std::abort();
}

}  // namespace

/// A trajectory of strangers: what is read has times in order and unit quaternions, and what is written of it is read
/// again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace planewright;
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    const auto poses = readTrajectoryTum(in, "a.txt");
    if (!poses)
        return 0;
    require(!poses->empty());
    for (std::size_t i = 0; i < poses->size(); ++i) {
        require(std::abs((*poses)[i].pose.rotation.norm() - 1.0) < 1e-9 && (*poses)[i].pose.translation.allFinite());
        require(i == 0 || (*poses)[i].time >= (*poses)[i - 1].time);
    }
    std::stringstream written;
    require(writeTrajectoryTum(written, *poses).has_value());
    const auto again = readTrajectoryTum(written, "b.txt");
    require(again && again->size() == poses->size());
    return 0;
}
