// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "ui/common/beam_run.h"
#include "ui/common/slice_sketch.h"

namespace planewright {

enum class SliceColumn { What, Beams, Bearing, Points, Length, Why };
inline constexpr int kSliceColumns = 6;

/// What a row of a slice's table is about.
enum class SlicePart { Piece, Break, Split, Join };

/// What the segmentation of a slice did, as a table in bearing order: pieces kept and discarded, breakpoints, split
/// points and joins, with the numbers that made them.
class SliceModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// A row: a part of the trace by its kind and its number there.
    struct Row {
        SlicePart part = SlicePart::Piece;
        std::size_t number = 0;
        int beam = 0;  ///< the first
    };

    explicit SliceModel(QObject* parent = nullptr);

    /// Null for none.
    void setSketch(std::shared_ptr<const SliceSketch> sketch);
    const std::shared_ptr<const SliceSketch>& sketch() const { return sketch_; }

    const Row& rowAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
    std::optional<int> rowOf(SlicePart part, std::size_t number) const;
    /// The segment of a row; nothing where it is none.
    std::optional<SegmentId> segmentAt(int row) const;
    std::optional<int> rowOf(const SegmentId& segment) const;
    /// The piece of a row, where it was discarded; nothing of other rows.
    std::optional<BeamRun> discardedAt(int row) const;
    std::optional<int> rowOf(const BeamRun& discarded) const;
    /// All that a row says, in one line.
    QString sentence(int row) const;
    /// Step, pitch and counts, in one line; empty without a slice.
    QString summary() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString textOf(const Row& row, SliceColumn column) const;
    QString pieceText(const TracedPiece& piece, std::size_t number, SliceColumn column) const;
    QString breakText(const TracedBreak& gap, SliceColumn column) const;
    QString splitText(const TracedSplit& split, SliceColumn column) const;
    QString joinText(const TracedJoin& join, SliceColumn column) const;
    QString bearings(int first, int last) const;

    std::shared_ptr<const SliceSketch> sketch_;
    std::vector<Row> rows_;
};

}  // namespace planewright
