// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>
#include <string_view>

#include <QString>

#include "core/types/step_report.h"
#include "ui/common/length_style.h"

namespace planewright {

/// What a comparison decides about. The same name means another thing where it does.
enum class TestAbout {
    Any,
    Join,    ///< whether a segment joins a plane
    Known,   ///< the same for a plane that it does not face
    Move,    ///< whether it goes from one plane to another
    Fit,     ///< whether a cluster gives a plane
    Seed,    ///< whether a few segments do
    Keep,    ///< whether a plane remains one
    Split,   ///< whether a plane is taken apart
    Merge,   ///< whether two planes are one, by their segments' end points
    Tracks,  ///< the same by likelihood
    Absorb,  ///< whether a plane covers another
    Piece,   ///< whether neighbouring echoes are a segment
};

/// How people see a number of a comparison.
enum class TestScale {
    Plain,
    Count,
    Metre,
    Angle,
    Variance,     ///< of an angle [rad²], seen as its standard deviation
    Sine,         ///< of an angle, seen as the angle
    SquaredSine,  ///< the same
    Cosine,       ///< as it is, with more digits
    Share,        ///< of 1, seen in percent
    ChiSquare,
    Flag,  ///< 1 is yes and 0 is no
};

/// One condition in the words of the field.
struct TestWords {
    std::string_view name;  ///< as reports have it
    TestAbout about;
    const char* symbol;
    TestScale scale;
    /// Keys of the parameters that set its limit, the most telling first; empty where the method fixes it.
    std::array<std::string_view, 2> parameters;
    const char* meaning;
};

/// All conditions that there are words for.
std::span<const TestWords> allTestWords();

/// The words for a condition: those of what it is about, or those for any; null for a name that is not known.
const TestWords* wordsFor(std::string_view name, TestAbout about);

/// A comparison as people read it.
struct TestText {
    QString symbol;  ///< "D", or the name itself where there are no words for it
    QString value;
    QString comparison;  ///< "<", "≤", ">", "≥"; "=" between yes and no
    QString limit;
    QString unit;  ///< "m", "°", "%", or nothing
    bool isFlag = false;
    bool pass = false;

    /// "D 0.012 < 0.050 m", or "faces it: no"
    QString text() const;
};

/// Numbers that differ have as many digits as it takes to see which is larger.
TestText textOf(const Test& test, TestAbout about, const LengthStyle& lengths = {});

/// What the condition asks, in a sentence, with the parameters that set its limit.
QString meaningOf(const Test& test, TestAbout about);

/// "✔" or "✘"
QString verdictMark(bool pass);

/// What the tests of a decision decide about.
TestAbout aboutOf(const Decision& decision);
/// The same of a way of WhyNot with its tests.
TestAbout aboutOf(std::string_view way, std::span<const Test> tests);

}  // namespace planewright
