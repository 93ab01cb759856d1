// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/decision_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QRegularExpression>
#include <QStringList>

#include "core/types/plane_words.h"
#include "ui/models/number_text.h"
#include "ui/models/parameter_model.h"

namespace planewright {

namespace {

/// More conditions than these are told one by one only below their decision.
constexpr std::size_t kTestsInLine = 2;

const PlaneId* planeOf(const Operand& operand)
{
    const auto* plane = std::get_if<PlaneRef>(&operand);
    return plane == nullptr ? nullptr : &plane->id;
}

QString operandTexts(std::span<const Operand> operands, const QString& between)
{
    QStringList texts;
    for (const Operand& operand : operands)
        texts << operandText(operand);
    return texts.join(between);
}

/// "P15 (18 seg)"
QString sizedPlane(const Operand& operand, const Snapshot* after)
{
    QString text = operandText(operand);
    const PlaneId* id = planeOf(operand);
    if (after == nullptr || id == nullptr)
        return text;
    const auto plane = std::find_if(after->planes.begin(), after->planes.end(),
                                    [id](const auto& candidate) { return candidate->id == *id; });
    if (plane != after->planes.end())
        text += QStringLiteral(" (%1 seg)").arg((*plane)->segments.size());
    return text;
}

QString splitHead(const Decision& decision)
{
    const QString first = operandText(decision.operands.front());
    return decision.operands.size() > 1 ? QStringLiteral("%1 without %2").arg(first, operandText(decision.operands[1]))
                                        : QStringLiteral("Split %1").arg(first);
}

QString noFitHead(const Decision& decision)
{
    const Operand& first = decision.operands.front();
    if (planeOf(first) != nullptr)
        return QStringLiteral("%1 given up").arg(operandText(first));
    if (decision.operands.size() > 1)
        return QStringLiteral("%1 around %2: no plane")
            .arg(operandText(first), operandTexts(std::span(decision.operands).subspan(1), QStringLiteral(" + ")));
    return QStringLiteral("%1: no plane").arg(operandText(first));
}

/// By likelihood nothing is told of planes that a segment does not join: it was of this one.
bool leavesPlane(const Decision& decision)
{
    return decision.kind == DecisionKind::Reject && decision.operands.size() > 1 && !decision.tests.empty() &&
           decision.tests.front().name == "join_chi2";
}

QString rejectHead(const Decision& decision)
{
    const QString first = operandText(decision.operands.front());
    if (decision.operands.size() < 2)
        return decision.phase == Phase::Extract ? QStringLiteral("%1 discarded").arg(first)
                                                : QStringLiteral("%1 fits no plane").arg(first);
    return (leavesPlane(decision) ? QStringLiteral("%1 leaves %2") : QStringLiteral("%1 not → %2"))
        .arg(first, operandText(decision.operands[1]));
}

QString assignHead(const Decision& decision)
{
    const QString segment = operandText(decision.operands.front());
    const QString to = operandTexts(decision.result, QStringLiteral(", "));
    return aboutOf(decision) == TestAbout::Move
               ? QStringLiteral("%1: %2 → %3").arg(segment, operandText(decision.operands[1]), to)
               : QStringLiteral("%1 → %2").arg(segment, to);
}

void addTest(const Test& test, TestAbout about, const LengthStyle& lengths, TextLine& line)
{
    line.add(textOf(test, about, lengths).text(), test.pass() ? TextTone::Plain : TextTone::Fail);
    line.add(' ' + verdictMark(test.pass()), test.pass() ? TextTone::Pass : TextTone::Fail);
}

/// Of few conditions and of pairs of planes all are told, of others those that failed.
void addTests(const Decision& decision, const LengthStyle& lengths, TextLine& line)
{
    if (decision.tests.empty())
        return;
    line.add(QStringLiteral(": "));
    const TestAbout about = aboutOf(decision);
    const bool tellsAll = decision.tests.size() <= kTestsInLine || decision.kind == DecisionKind::Merge ||
                          decision.kind == DecisionKind::Near;
    const bool allHold =
        std::all_of(decision.tests.begin(), decision.tests.end(), [](const Test& test) { return test.pass(); });
    if (!tellsAll && allHold) {
        line.add(QStringLiteral("all %1 conditions hold").arg(decision.tests.size()));
        line.add(' ' + verdictMark(true), TextTone::Pass);
        return;
    }
    bool isFirst = true;
    for (const Test& test : decision.tests) {
        if (!tellsAll && test.pass())
            continue;
        if (!std::exchange(isFirst, false))
            line.add(QStringLiteral(", "));
        addTest(test, about, lengths, line);
    }
}

/// "2 merged" with the number in front; nothing for none.
void tell(int number, const char* text, QStringList& words)
{
    if (number > 0)
        words << QStringLiteral("%1 %2").arg(number).arg(QString::fromUtf8(text));
}

struct Tally {
    int assigned = 0;
    int moved = 0;
    int rejected = 0;
    int left = 0;
    int clustered = 0;
    int planes = 0;
    int givenUp = 0;
    int noPlane = 0;
    int thinned = 0;
    int split = 0;
    int merged = 0;
    int near = 0;

    void count(const Decision& decision)
    {
        switch (decision.kind) {
            case DecisionKind::Assign:
                ++(aboutOf(decision) == TestAbout::Move ? moved : assigned);
                break;
            case DecisionKind::Reject:
                ++(leavesPlane(decision) ? left : rejected);
                break;
            case DecisionKind::Cluster:
                ++clustered;
                break;
            case DecisionKind::Fit:
                ++planes;
                break;
            case DecisionKind::NoFit:
                ++(aboutOf(decision) == TestAbout::Keep ? givenUp : noPlane);
                break;
            case DecisionKind::Split:
                ++(decision.operands.size() > 1 ? thinned : split);
                break;
            case DecisionKind::Merge:
                ++merged;
                break;
            case DecisionKind::Near:
                ++near;
                break;
        }
    }
};

}  // namespace

QString TextLine::plain() const
{
    QString text;
    for (const TextPart& part : parts)
        text += part.text;
    return text;
}

QString operandText(const Operand& operand)
{
    if (const auto* segment = std::get_if<SegmentId>(&operand))
        return QStringLiteral("seg ") + QString::fromStdString(segmentLabel(*segment));
    if (const PlaneId* plane = planeOf(operand))
        return QString::fromStdString(planeLabel(*plane));
    if (const auto* piece = std::get_if<PieceRef>(&operand))
        return piece->firstBeam == piece->lastBeam
                   ? QStringLiteral("beam %1").arg(piece->firstBeam)
                   : QStringLiteral("beams %1–%2").arg(piece->firstBeam).arg(piece->lastBeam);
    return QStringLiteral("C%1").arg(std::get<ClusterRef>(operand).id);
}

std::optional<Operand> operandOf(const QString& text)
{
    static const QRegularExpression kPlane(QStringLiteral("^\\s*p?\\s*(\\d{1,9})\\s*$"),
                                           QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression kSegment(QStringLiteral("^\\s*(?:seg(?:ment)?)?\\s*(\\d{1,9})\\.(\\d{1,9})\\s*$"),
                                             QRegularExpression::CaseInsensitiveOption);
    if (const auto plane = kPlane.match(text); plane.hasMatch())
        return PlaneRef{plane.captured(1).toInt()};
    if (const auto segment = kSegment.match(text); segment.hasMatch())
        return SegmentId{segment.captured(1).toInt() - 1, segment.captured(2).toInt()};
    return std::nullopt;
}

QString decisionHead(const Decision& decision, const DecisionContext& context)
{
    if (decision.operands.empty())
        return {};
    switch (decision.kind) {
        case DecisionKind::Assign:
            return assignHead(decision);
        case DecisionKind::Reject:
            return rejectHead(decision);
        case DecisionKind::Cluster: {
            const bool isNew = !decision.tests.empty() && !decision.tests.front().pass();
            return QStringLiteral("%1 → %2%3")
                .arg(operandText(decision.operands.front()), operandTexts(decision.result, QStringLiteral(", ")),
                     isNew ? QStringLiteral(" (new)") : QString());
        }
        case DecisionKind::Fit: {
            QStringList planes;
            for (const Operand& plane : decision.result)
                planes << sizedPlane(plane, context.after);
            return operandTexts(decision.operands, QStringLiteral(" + ")) + QStringLiteral(" → ") + planes.join(", ");
        }
        case DecisionKind::NoFit:
            return noFitHead(decision);
        case DecisionKind::Split:
            return splitHead(decision);
        case DecisionKind::Merge:
            return operandTexts(decision.operands, QStringLiteral(" + ")) + QStringLiteral(" → ") +
                   operandTexts(decision.result, QStringLiteral(", "));
        case DecisionKind::Near:
            break;
    }
    return operandTexts(decision.operands, QStringLiteral(" ~ ")) + QStringLiteral(" stay two");
}

QString splitOutcome(const Decision& decision, const DecisionContext& context)
{
    if (decision.kind != DecisionKind::Split || decision.operands.size() != 1)
        return {};
    QStringList parts;
    for (const Operand& part : decision.result)
        parts << sizedPlane(part, context.after);
    if (parts.isEmpty())
        parts << QStringLiteral("taken apart");
    if (context.backToClusters > 0)
        parts << QStringLiteral("%1 back to clusters").arg(context.backToClusters);
    return QStringLiteral(" → ") + parts.join(QStringLiteral(", "));
}

TextLine decisionLine(const Decision& decision, const DecisionContext& context)
{
    TextLine line;
    line.add(decisionHead(decision, context));
    addTests(decision, context.lengths, line);
    if (const QString outcome = splitOutcome(decision, context); !outcome.isEmpty())
        line.add(outcome);
    return line;
}

TextLine testLine(const Test& test, TestAbout about, const LengthStyle& lengths)
{
    TextLine line;
    addTest(test, about, lengths, line);
    const TestWords* words = wordsFor(test.name, about);
    if (words == nullptr || words->parameters.front().empty())
        return line;
    for (const ParameterRow& row : parameterRows()) {
        if (row.key != words->parameters.front())
            continue;
        line.add(QStringLiteral("  "));
        line.add(parameterLabel(row), TextTone::Link);
    }
    return line;
}

int setFreeBySplit(std::span<const Decision> decisions, std::size_t split)
{
    if (decisions[split].kind != DecisionKind::Split)
        return 0;
    std::size_t next = split + 1;
    while (next < decisions.size() && decisions[next].kind == DecisionKind::Cluster)
        ++next;
    return static_cast<int>(next - split) - 1;
}

QString phaseTitle(Phase phase, std::string_view pass)
{
    static constexpr std::array<const char*, kPhases> kTitles{"Extract segments", "Assign to planes", "Cluster",
                                                              "Fit planes",       "Split and merge",  "Fit remaining",
                                                              "Last pass"};
    static constexpr std::array<std::pair<std::string_view, const char*>, 12> kPasses{
        {{"merge", "Merge"},
         {"split", "Split"},
         {"split_merge", "Split and merge"},
         {"split_contested", "Split what is contested"},
         {"split_parts", "Split parts that lie apart"},
         {"settle_decisive", "Move what another plane foretells"},
         {"thin", "Take out worst segments"},
         {"fit", "Fit planes"},
         {"fit_pairs", "Fit pairs"},
         {"remaining", "Fit remaining"},
         {"drop_unfounded", "Give up unfounded planes"},
         {"reassign", "Move to nearer planes"}}};
    if (pass.empty())
        return QString::fromUtf8(kTitles[static_cast<std::size_t>(phase)]);
    const auto* known =
        std::find_if(kPasses.begin(), kPasses.end(), [pass](const auto& row) { return row.first == pass; });
    if (known != kPasses.end())
        return QString::fromUtf8(known->second);
    return pass == "refine" ? QStringLiteral("Last fit of all planes")
                            : QString::fromUtf8(pass.data(), static_cast<qsizetype>(pass.size())).replace('_', ' ');
}

QString phaseResult(Phase phase, const StepCounts& counts, std::span<const Decision> decisions)
{
    if (phase == Phase::Extract) {
        const QString segments =
            QStringLiteral("%1 in %2")
                .arg(countText(counts.segments, QStringLiteral("segment"), QStringLiteral("segments")),
                     countText(counts.returns, QStringLiteral("return"), QStringLiteral("returns")));
        return decisions.empty() ? segments : segments + QStringLiteral(", %1 discarded").arg(decisions.size());
    }
    Tally tally;
    for (const Decision& decision : decisions)
        tally.count(decision);
    QStringList words;
    tell(tally.assigned, "assigned", words);
    tell(tally.moved, "moved", words);
    tell(tally.rejected, "fit none", words);
    tell(tally.left, "leave their plane", words);
    tell(tally.planes, tally.planes == 1 ? "plane" : "planes", words);
    tell(tally.noPlane, "without plane", words);
    tell(tally.givenUp, "given up", words);
    tell(tally.split, "split", words);
    tell(tally.thinned, "taken out", words);
    tell(tally.merged, "merged", words);
    tell(tally.near, "nearly merged", words);
    tell(tally.clustered, phase == Phase::Cluster ? "to clusters" : "back to clusters", words);
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral(", "));
}

QString wayTitle(std::string_view way)
{
    static constexpr std::array<std::pair<std::string_view, const char*>, 7> kWays{
        {{"merge", "Merge"},
         {"absorb", "The larger takes in the smaller"},
         {"assign", "Assign"},
         {"reassign", "Move to a nearer plane"},
         {"join_facing", "Join a plane that it faces"},
         {"join_known", "Join a plane that is well known"},
         {"move", "Move to a plane that fits better"}}};
    const auto* known = std::find_if(kWays.begin(), kWays.end(), [way](const auto& row) { return row.first == way; });
    return known != kWays.end() ? QString::fromUtf8(known->second)
                                : QString::fromUtf8(way.data(), static_cast<qsizetype>(way.size())).replace('_', ' ');
}

QString whyNotAnswer(const WhyNot& answer)
{
    const bool may =
        std::any_of(answer.ways.begin(), answer.ways.end(), [](const Conditions& way) { return way.pass(); });
    const bool segmentIsFirst = std::holds_alternative<SegmentId>(answer.operands[0]);
    const QString first = operandText(answer.operands[segmentIsFirst ? 0 : 1]);
    const QString second = operandText(answer.operands[segmentIsFirst ? 1 : 0]);
    if (segmentIsFirst || std::holds_alternative<SegmentId>(answer.operands[1])) {
        const QString named = first.left(1).toUpper() + first.mid(1);
        if (answer.together)
            return QStringLiteral("%1 is in %2.").arg(named, second);
        return may ? QStringLiteral("%1 is not in %2 yet: it joins when it is asked next.").arg(named, second)
                   : QStringLiteral("%1 is not in %2: no way has all its conditions.").arg(named, second);
    }
    return may ? QStringLiteral("%1 and %2 are not one yet: they become one when it is due next.").arg(second, first)
               : QStringLiteral("%1 and %2 stay two: no way has all its conditions.").arg(second, first);
}

QString stepText(int step)
{
    return step < 0 ? QStringLiteral("last pass") : QString::number(step + 1);
}

}  // namespace planewright
