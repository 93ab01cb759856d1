// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

constexpr double square(double x)
{
    return x * x;
}

}  // namespace planewright
