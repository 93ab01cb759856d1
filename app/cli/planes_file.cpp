// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/planes_file.h"

#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "core/formats/planes_csv.h"
#include "core/formats/planes_json.h"

namespace planewright {

Result<std::vector<PlaneRecord>> readPlanesFile(const std::string& path)
{
    const auto suffix = suffixOf(path, {".csv", ".csv.gz", ".json"}, "a planes file");
    if (!suffix)
        return tl::unexpected{suffix.error()};
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return *suffix == ".json" ? readPlanesJson(**input, path) : readPlanesCsv(**input, path);
}

}  // namespace planewright
