// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/charts/chart.h"

namespace planewright {

/// A report of Markdown in a folder of its own, with its figures beside it.
class Report {
public:
    explicit Report(std::string folder) : folder_(std::move(folder)) {}

    void heading(int level, const std::string& text);
    void text(const std::string& paragraph);

    /// A table; every row has as many cells as the header.
    void table(const std::string& caption, const std::vector<std::string>& header,
               const std::vector<std::vector<std::string>>& rows);

    /// Charts below one another in one picture, `name`.png.
    void figure(const std::string& name, const std::string& caption, const std::vector<Chart>& charts, int width = 900);

    /// Writes report.md. False where that or a figure failed.
    bool write() const;

private:
    std::string folder_;
    std::string markdown_;
    bool failed_ = false;
};

/// A number with so many digits behind the point.
std::string fixed(double value, int digits);

}  // namespace planewright
