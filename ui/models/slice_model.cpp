// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/slice_model.h"

#include <algorithm>
#include <utility>

#include "ui/models/number_text.h"

namespace planewright {

namespace {

QString beamsText(int first, int last)
{
    return first == last ? QString::number(first) : QStringLiteral("%1–%2").arg(first).arg(last);
}

/// The comparison that did not hold, turned round: "length 0.124 m < 0.200 m".
QString failureText(const Test& test)
{
    if (test.name == "length")
        return SliceModel::tr("length %1 m < %2 m").arg(numberText(test.value, 3), numberText(test.limit, 3));
    if (test.name == "line_distance")
        return SliceModel::tr("%1 m > %2 m").arg(numberText(test.value, 3), numberText(test.limit, 3));
    if (test.name == "line_chi2")
        return SliceModel::tr("χ² %1 > %2").arg(numberText(test.value, 1), numberText(test.limit, 1));
    const QString numbers = QStringLiteral("%1 < %2").arg(numberText(test.value, 0), numberText(test.limit, 0));
    if (test.name == "points_of_run")
        return SliceModel::tr("points of the run %1").arg(numbers);
    if (test.name == "points_of_line")
        return SliceModel::tr("points for a line %1").arg(numbers);
    return SliceModel::tr("points %1").arg(numbers);
}

QString fateText(PieceFate fate)
{
    switch (fate) {
        case PieceFate::TooFewPoints:
            return SliceModel::tr("Too few points");
        case PieceFate::TooShort:
            return SliceModel::tr("Too short");
        case PieceFate::OffTheLines:
            return SliceModel::tr("Off the lines beside it");
        case PieceFate::Segment:
            break;
    }
    return {};
}

}  // namespace

SliceModel::SliceModel(QObject* parent) : QAbstractTableModel(parent) {}

void SliceModel::setSketch(std::shared_ptr<const SliceSketch> sketch)
{
    beginResetModel();
    sketch_ = std::move(sketch);
    rows_.clear();
    if (sketch_ && sketch_->slice) {
        const SliceTrace& trace = sketch_->trace;
        for (std::size_t i = 0; i < trace.pieces.size(); ++i)
            rows_.push_back({SlicePart::Piece, i, trace.pieces[i].firstBeam});
        for (std::size_t i = 0; i < trace.splits.size(); ++i)
            rows_.push_back({SlicePart::Split, i, trace.splits[i].beam});
        for (std::size_t i = 0; i < trace.breaks.size(); ++i)
            rows_.push_back({SlicePart::Break, i, trace.breaks[i].before});
        for (std::size_t i = 0; i < trace.joins.size(); ++i)
            rows_.push_back({SlicePart::Join, i, trace.joins[i].before});
        std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.beam < b.beam; });
    }
    endResetModel();
}

std::optional<int> SliceModel::rowOf(SlicePart part, std::size_t number) const
{
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const Row& row) { return row.part == part && row.number == number; });
    if (found == rows_.end())
        return std::nullopt;
    return static_cast<int>(found - rows_.begin());
}

std::optional<SegmentId> SliceModel::segmentAt(int row) const
{
    const Row& at = rowAt(row);
    if (at.part != SlicePart::Piece || sketch_->trace.pieces[at.number].segment < 0)
        return std::nullopt;
    return sketch_->idOf(sketch_->trace.pieces[at.number]);
}

std::optional<int> SliceModel::rowOf(const SegmentId& segment) const
{
    for (int row = 0; row < rowCount(); ++row) {
        if (segmentAt(row) == segment)
            return row;
    }
    return std::nullopt;
}

std::optional<BeamRun> SliceModel::discardedAt(int row) const
{
    const Row& at = rowAt(row);
    if (at.part != SlicePart::Piece || sketch_->trace.pieces[at.number].segment >= 0)
        return std::nullopt;
    const TracedPiece& piece = sketch_->trace.pieces[at.number];
    return BeamRun{sketch_->slice->step, piece.firstBeam, piece.lastBeam};
}

std::optional<int> SliceModel::rowOf(const BeamRun& discarded) const
{
    for (int row = 0; row < rowCount(); ++row) {
        if (discardedAt(row) == discarded)
            return row;
    }
    return std::nullopt;
}

QString SliceModel::bearings(int first, int last) const
{
    const auto degreesOf = [&](int beam) { return angleText(sketch_->slice->bearing(static_cast<std::size_t>(beam))); };
    return first == last ? degreesOf(first) : QStringLiteral("%1–%2").arg(degreesOf(first), degreesOf(last));
}

QString SliceModel::pieceText(const TracedPiece& piece, std::size_t number, SliceColumn column) const
{
    switch (column) {
        case SliceColumn::What:
            return piece.segment >= 0 ? tr("Segment %1.%2").arg(sketch_->slice->step + 1).arg(piece.segment)
                                      : tr("✘ Discarded");
        case SliceColumn::Beams:
            return beamsText(piece.firstBeam, piece.lastBeam);
        case SliceColumn::Bearing:
            return bearings(piece.firstBeam, piece.lastBeam);
        case SliceColumn::Points:
            return QString::number(piece.points);
        case SliceColumn::Length:
            return numberText(piece.length, 3);
        case SliceColumn::Why:
            break;
    }
    if (piece.segment >= 0) {
        const std::string& owner = sketch_->owners[number];
        return owner.empty() ? tr("in no plane") : tr("in %1").arg(QString::fromStdString(owner));
    }
    QStringList reasons;
    for (const Test& test : piece.tests) {
        if (!test.pass())
            reasons << failureText(test);
    }
    return reasons.isEmpty() ? fateText(piece.fate)
                             : tr("%1: %2").arg(fateText(piece.fate), reasons.join(QStringLiteral(", ")));
}

QString SliceModel::breakText(const TracedBreak& gap, SliceColumn column) const
{
    switch (column) {
        case SliceColumn::What:
            return tr("□ Breakpoint");
        case SliceColumn::Beams:
            return beamsText(gap.before, gap.after);
        case SliceColumn::Bearing:
            return bearings(gap.before, gap.after);
        case SliceColumn::Points:
            return {};
        case SliceColumn::Length:
            return numberText(gap.gap, 3);
        case SliceColumn::Why:
            break;
    }
    if (gap.missing)
        return tr("Beams without echo: %1").arg(gap.after - gap.before - 1);
    return tr("Gap %1 m ≥ %2 m").arg(numberText(gap.gap, 3), numberText(gap.limit, 3));
}

QString SliceModel::splitText(const TracedSplit& split, SliceColumn column) const
{
    switch (column) {
        case SliceColumn::What:
            return tr("◆ Split point");
        case SliceColumn::Beams:
            return beamsText(split.beam, split.beam);
        case SliceColumn::Bearing:
            return bearings(split.beam, split.beam);
        case SliceColumn::Points:
        case SliceColumn::Length:
            return {};
        case SliceColumn::Why:
            break;
    }
    if (split.test.name == "two_lines_gain")
        return tr("Two lines fit better: χ² %1 > %2")
            .arg(numberText(split.test.value, 1), numberText(split.test.limit, 1));
    if (split.test.name == "divisions")
        return tr("Halved after %1 divisions").arg(numberText(split.test.value, 0));
    return tr("From the chord %1 m > %2 m").arg(numberText(split.test.value, 3), numberText(split.test.limit, 3));
}

QString SliceModel::joinText(const TracedJoin& join, SliceColumn column) const
{
    switch (column) {
        case SliceColumn::What:
            return tr("○ Joined");
        case SliceColumn::Beams:
            return beamsText(join.before, join.after);
        case SliceColumn::Bearing:
            return bearings(join.before, join.after);
        case SliceColumn::Points:
        case SliceColumn::Length:
            return {};
        case SliceColumn::Why:
            break;
    }
    return tr("One line fits both sides");
}

QString SliceModel::textOf(const Row& row, SliceColumn column) const
{
    const SliceTrace& trace = sketch_->trace;
    switch (row.part) {
        case SlicePart::Piece:
            return pieceText(trace.pieces[row.number], row.number, column);
        case SlicePart::Break:
            return breakText(trace.breaks[row.number], column);
        case SlicePart::Split:
            return splitText(trace.splits[row.number], column);
        case SlicePart::Join:
            break;
    }
    return joinText(trace.joins[row.number], column);
}

QString SliceModel::sentence(int row) const
{
    const Row& at = rowAt(row);
    QString text = textOf(at, SliceColumn::What) + QStringLiteral(": ") + textOf(at, SliceColumn::Why);
    if (at.part == SlicePart::Piece)
        text += tr(" (%1 points, %2 m)").arg(textOf(at, SliceColumn::Points), textOf(at, SliceColumn::Length));
    return text;
}

QString SliceModel::summary() const
{
    if (!sketch_ || !sketch_->slice)
        return {};
    const auto kept = std::count_if(sketch_->trace.pieces.begin(), sketch_->trace.pieces.end(),
                                    [](const TracedPiece& piece) { return piece.segment >= 0; });
    return tr("Step %1, φ %2°: %3, %4, %5 discarded")
        .arg(sketch_->slice->step + 1)
        .arg(angleText(sketch_->slice->tilt),
             countText(static_cast<qsizetype>(sketch_->trace.runs.size()), tr("run"), tr("runs")),
             countText(kept, tr("segment"), tr("segments")))
        .arg(static_cast<qsizetype>(sketch_->trace.pieces.size()) - kept);
}

int SliceModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SliceModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kSliceColumns;
}

QVariant SliceModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = static_cast<SliceColumn>(index.column());
    if (role == Qt::DisplayRole)
        return textOf(rowAt(index.row()), column);
    if (role == Qt::ToolTipRole)
        return sentence(index.row());
    const bool isNumber = column == SliceColumn::Points || column == SliceColumn::Length;
    if (role == Qt::TextAlignmentRole)
        return QVariant((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

QVariant SliceModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (static_cast<SliceColumn>(section)) {
        case SliceColumn::What:
            return tr("What");
        case SliceColumn::Beams:
            return tr("Beams");
        case SliceColumn::Bearing:
            return tr("Bearing [°]");
        case SliceColumn::Points:
            return tr("Points");
        case SliceColumn::Length:
            return tr("Length [m]");
        case SliceColumn::Why:
            break;
    }
    return tr("Why");
}

}  // namespace planewright
