// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "tests/benchmarks/opponents/opponent.h"

namespace planewright {

/// All opponents with the parameters that tune_opponents found best: those of the paper first.
std::vector<std::unique_ptr<Opponent>> makeOpponents();

}  // namespace planewright
