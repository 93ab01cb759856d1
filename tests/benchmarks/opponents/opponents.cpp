// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/opponents.h"

#include "tests/benchmarks/opponents/efficient_ransac.h"
#include "tests/benchmarks/opponents/organized_planes.h"
#include "tests/benchmarks/opponents/prosac_normal.h"
#include "tests/benchmarks/opponents/prosac_only.h"
#include "tests/benchmarks/opponents/randomized_hough.h"
#include "tests/benchmarks/opponents/region_growing.h"

namespace planewright {

std::vector<std::unique_ptr<Opponent>> makeOpponents()
{
    std::vector<std::unique_ptr<Opponent>> opponents;
    opponents.push_back(std::make_unique<ProsacOnly>());
    opponents.push_back(std::make_unique<ProsacNormal>());
    opponents.push_back(std::make_unique<RandomizedHough>());
    opponents.push_back(std::make_unique<OrganizedPlanes>());
    opponents.push_back(std::make_unique<EfficientRansac>());
    opponents.push_back(std::make_unique<RegionGrowing>());
    return opponents;
}

}  // namespace planewright
