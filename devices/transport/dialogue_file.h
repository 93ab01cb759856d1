// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types/error.h"

namespace planewright {

/// Something that happened on a link.
struct DialogueEvent {
    enum class Kind {
        ToDevice,    ///< the host wrote bytes
        FromDevice,  ///< bytes arrived
        Lost,        ///< the link was lost; the bytes are the reason as text. Nothing comes after it
    };
    Kind kind = Kind::ToDevice;
    std::chrono::nanoseconds at{0};  ///< since the dialogue began; never less than that of the event before
    std::vector<std::uint8_t> bytes;
};

/// A dialogue with a device, byte by byte, as a file that people can read, cut and write themselves:
///
///     planewright-dialogue 1
///     # 192.168.0.10:10940
///     0 > QT\n
///     1840.25 < QT\n00P\n\n
///     73000000 ! closed the connection; check its power
///
/// The first line is the format with its version, lines with '#' are remarks, every other line is an event: its time
/// [µs, up to three decimals], '>' to the device, '<' from it or '!' lost, and what was said. Printable ASCII stands
/// for itself, but for the backslash, which is \\, and the space, which is \x20, since editors lose it at line ends;
/// line feeds are \n, carriage returns \r, and every other byte is \x and two digits; the reason of a loss keeps its
/// spaces. What came together may stand in several lines of the same time.
inline constexpr const char* kDialogueFirstLine = "planewright-dialogue 1";

/// No line is longer: four characters a byte, and the time.
inline constexpr std::size_t kMostDialogueBytes = 1024;
inline constexpr std::size_t kLongestDialogueLine = kMostDialogueBytes * 4 + 64;

/// Bytes as they stand in a dialogue.
std::string dialogueText(std::span<const std::uint8_t> bytes);

/// The same between quotes, as much as a line of text bears.
std::string quotedDialogue(std::span<const std::uint8_t> bytes);

/// What to do where a dialogue does not fit what is said now; ends a sentence.
inline constexpr const char* kRecordAnew = "; the program is not the one that was recorded: record the dialogue anew";

/// The lines of an event, each with its line feed: more than one where there are more than kMostDialogueBytes.
std::string dialogueLines(const DialogueEvent& event);

/// Reads a dialogue event by event, in memory that the file has no say in.
class DialogueReader {
public:
    /// Reads the first line. Errors (Unreadable), naming the file: not there, no plain file, no dialogue, a version
    /// that is not known.
    static Result<DialogueReader> open(const std::string& path);

    /// The next event; empty at the end. A last line without its end was cut off in the writing, and is left out.
    ///
    /// Errors (Unreadable), naming file and line: no event, a line that is too long, time that runs backwards,
    /// something after the link was lost.
    Result<std::optional<DialogueEvent>> next();

    /// Number of the line that was read last; the first is 1.
    int line() const { return line_; }
    /// "dialogue.txt:17", where the line that was read last is.
    std::string place() const { return path_ + ":" + std::to_string(line_); }

private:
    explicit DialogueReader(std::string path) : path_(std::move(path)) {}
    /// False at the end.
    Result<bool> readLine();
    tl::unexpected<Error> refuse(const std::string& why) const;

    std::string path_;
    std::ifstream file_;
    std::string text_;  ///< of the line that was read last
    int line_ = 0;
    std::chrono::nanoseconds last_{0};
    bool isLost_ = false;
};

}  // namespace planewright
