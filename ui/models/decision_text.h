// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <QList>
#include <QString>

#include "core/types/snapshot.h"
#include "core/types/step_report.h"
#include "core/types/why_not.h"
#include "ui/models/test_words.h"

namespace planewright {

/// How a part of a line stands out.
enum class TextTone {
    Plain,
    Strong,  ///< the name of what stands below
    Faint,   ///< what matters less
    Pass,
    Fail,  ///< a condition that did not hold, with its number
    Link,
    Mark,  ///< what the 3D view shows
};

struct TextPart {
    QString text;
    TextTone tone = TextTone::Plain;
};

/// A line of words with tones.
struct TextLine {
    QList<TextPart> parts;

    void add(const QString& text, TextTone tone = TextTone::Plain) { parts.push_back({text, tone}); }
    QString plain() const;
};

/// "seg 64.3", "P12", "C5", "beams 47–51": steps count from 1 on the screen.
QString operandText(const Operand& operand);
/// What somebody has typed: "P07" or "7" is a plane, "64.3" or "seg 64.3" a segment; nothing for what is neither.
std::optional<Operand> operandOf(const QString& text);

/// What a decision is told with beside its own numbers.
struct DecisionContext {
    const Snapshot* after = nullptr;  ///< knows how many segments planes have; may be null
    int backToClusters = 0;           ///< segments that a split has set free
    LengthStyle lengths;
};

/// What was decided: "seg 64.3 → P12".
QString decisionHead(const Decision& decision, const DecisionContext& context = {});

/// What a split gave: " → P07 (18 seg), P16 (9 seg), 3 back to clusters"; nothing of other decisions.
QString splitOutcome(const Decision& decision, const DecisionContext& context = {});

/// A decision in one line: what was decided, then what was compared. Of many conditions those that failed, but all of
/// pairs of planes; then what a split gave.
TextLine decisionLine(const Decision& decision, const DecisionContext& context = {});

/// One condition in a line of its own, with the parameter that sets its limit as a link.
TextLine testLine(const Test& test, TestAbout about, const LengthStyle& lengths = {});

/// Segments that were put into clusters right after a split: it has set them free.
int setFreeBySplit(std::span<const Decision> decisions, std::size_t split);

/// "Assign to planes"; of the forced last pass the name of one of its passes.
QString phaseTitle(Phase phase, std::string_view pass);

/// What a phase gave: "9 assigned, 3 to no plane".
QString phaseResult(Phase phase, const StepCounts& counts, std::span<const Decision> decisions);

/// "Assign", "Move to a nearer plane": a way of WhyNot.
QString wayTitle(std::string_view way);

/// The answer to why two planes are not one, or a segment is not in a plane, in a sentence.
QString whyNotAnswer(const WhyNot& answer);

/// "64", or "last pass".
QString stepText(int step);

}  // namespace planewright
