// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace planewright {

/// A number of things whose plural ends with s: "1 slice", "3 slices".
std::string countText(std::integral auto count, std::string_view thing)
{
    return std::to_string(count) + " " + std::string{thing} + (count == 1 ? "" : "s");
}

}  // namespace planewright
