// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/message_text.h"

namespace planewright {

/// Collects what is wrong with a file: texts up to a limit, and a count beyond it.
class ProblemList {
public:
    ProblemList(std::string fileName, std::size_t most) : fileName_(std::move(fileName)), most_(most) {}

    /// Adds a problem at a line and column, both from 1; 0 for none.
    void add(std::string_view what, std::size_t line, std::size_t column = 0, std::string_view name = {})
    {
        if (texts_.size() < most_)
            texts_.push_back(placeInFile(fileName_, line, column, name) + std::string{what});
        else
            ++more_;
    }

    /// Adds a problem whose text says its file and place already.
    void addText(std::string text)
    {
        if (texts_.size() < most_)
            texts_.push_back(std::move(text));
        else
            ++more_;
    }

    /// True where reading on is of no use: the caller asked for this many problems and no count.
    bool endsReading() const { return most_ == 1 && !texts_.empty(); }

    bool empty() const { return texts_.empty(); }
    std::size_t more() const { return more_; }
    const std::string& fileName() const { return fileName_; }
    const std::vector<std::string>& texts() const { return texts_; }

private:
    std::string fileName_;
    std::size_t most_;
    std::size_t more_ = 0;
    std::vector<std::string> texts_;
};

}  // namespace planewright
