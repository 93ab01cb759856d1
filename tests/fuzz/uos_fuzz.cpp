// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "core/formats/cloud_uos.h"
#include "tests/fuzz/cloud_fuzz.h"

/// A scan of 3DTK by strangers, or its pose where the first byte is a P.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace planewright;
    if (size == 0)
        return 0;
    std::istringstream in(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
    if (data[0] == 'P') {
        const auto pose = readPoseUos(in, "a.pose");
        require(!pose || (pose->translation.allFinite() && std::abs(pose->rotation.norm() - 1.0) < 1e-9));
        return 0;
    }
    checkCloud(readCloudUos(in, "a.3d"));
    return 0;
}
