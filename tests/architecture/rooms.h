// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace planewright::architecture {

/// A folder of the house with all below it that is no room of its own, and what it may include.
struct Room {
    std::string_view folder;
    std::vector<std::string_view> opensTo;    ///< rooms, or folders of rooms, whose headers it may include
    std::vector<std::string_view> libraries;  ///< beginnings of the headers of other projects that it may include
};

/// Something that only some folders may do.
struct Restriction {
    std::string_view what;                 ///< a standard header; or a word in the code
    std::vector<std::string_view> under;   ///< the rule holds below these folders
    std::vector<std::string_view> except;  ///< but not below these
    std::string_view reason;
};

/// The rooms of the house. The first whose folder is a beginning of a path is its room: inner rooms come first.
std::span<const Room> rooms();

/// Standard headers that do not stand open to everyone.
std::span<const Restriction> restrictedHeaders();

/// Words of code (not in comments or string literals) that do not stand open to everyone.
std::span<const Restriction> restrictedWords();

/// The room that a path belongs to, or null where the house has none there.
const Room* roomOf(std::string_view path);

/// True where a room may include a header of the project, named from the top: its own, or one behind a door.
bool hasDoorTo(const Room& room, std::string_view header);

/// True where a path is a folder or lies below it.
bool liesIn(std::string_view path, std::string_view folder);

/// True for a header of the standard library of C++20 or of C.
bool isStandardHeader(std::string_view header);

}  // namespace planewright::architecture
