// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <sstream>
#include <string>

#include "core/formats/cloud_pcd.h"
#include "tests/fuzz/cloud_fuzz.h"

/// A .pcd of strangers, to the recording that is made of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    planewright::checkCloud(planewright::readCloudPcd(in, "a.pcd"));
    return 0;
}
