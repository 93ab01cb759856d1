// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <sstream>
#include <string>

#include "core/formats/cloud_ptx.h"
#include "tests/fuzz/cloud_fuzz.h"

/// A .ptx of strangers: what counts its scans and what reads them agree.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace planewright;
    const std::string text(reinterpret_cast<const char*>(data), size);
    std::istringstream counted(text);
    const auto scans = scansOfPtx(counted, "a.ptx");
    for (int scan = 0; scan < 3; ++scan) {
        std::istringstream in(text);
        auto cloud = readCloudPtx(in, "a.ptx", scan);
        require(!scans || !cloud || scan < *scans);
        require(!scans || cloud || scan < *scans || cloud.error().code == ErrorCode::Usage);
        checkCloud(std::move(cloud));
    }
    return 0;
}
