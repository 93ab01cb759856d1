// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QPixmap>
#include <QWidget>

#include "ui/common/palette.h"
#include "ui/models/timeline_column.h"

namespace planewright {

/// The rows of the strip from above.
enum class TimelineLane { Ruler, PointCount, SegmentCount, Fits, SplitMerge, Faults, Edits };
inline constexpr std::size_t kTimelineLanes = 7;

/// What stands before a lane.
QString timelineLaneName(TimelineLane lane);
/// The colours of a lane's marks, 3 : 1 at least against what they stand on.
Rgb timelineColour(TimelineLane lane, Theme theme);
/// Of the edge at which a scan goes on while somebody looks back.
Rgb liveEdgeColour(Theme theme);

/// A scan from its first step to its last, a column each, and the place that is looked at. Where there are more columns
/// than pixels they share them: bars show the largest of theirs, marks lie on each other.
class TimelineStrip : public QWidget {
    Q_OBJECT

public:
    explicit TimelineStrip(QWidget* parent = nullptr);

    /// The places that there are, of so many that there will be at least.
    void setColumns(std::vector<TimelineColumn> columns, int expected);
    const std::vector<TimelineColumn>& columns() const { return columns_; }
    /// Steps that the scan has by its plan, for tips; 0 where nobody knows.
    void setPlanned(int planned) { planned_ = planned; }
    /// −1 for none.
    void setPlace(int place);
    void setLoop(std::optional<std::pair<int, int>> loop);
    void setBookmarks(std::set<int> bookmarks);
    /// What to do next where there are no columns yet.
    void setHint(const QString& hint);
    const QString& hint() const { return hint_; }
    /// Somebody looks back while the scan goes on.
    void setLooksBack(bool looksBack);

    /// Where things are, in pixels of this widget.
    QRectF columnRect(int place) const;
    QRect laneRect(TimelineLane lane) const;
    /// The nearest place that there is; −1 without any.
    int placeAt(double x) const;
    QString tipAt(int place) const;

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

signals:
    void placeChosen(int place);
    /// Empty: what was there is to go.
    void loopChosen(std::optional<std::pair<int, int>> loop);
    void menuRequested(int place, QPoint screen);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static constexpr int kMargin = 4;  ///< beside the columns [px]

    enum class Drag { None, Scrub, Loop };

    struct Places {
        int left = 0;                                ///< of the columns [px]
        std::array<int, kTimelineLanes + 1> tops{};  ///< of the lanes, and where the last ends [px]
    };

    Theme theme() const;
    int count() const;
    int labelWidth() const;
    QFont smallFont() const;
    const Places& places() const;
    void forgetPicture();
    void drawLanes(QPainter& painter) const;
    void drawLabels(QPainter& painter) const;
    void drawRuler(QPainter& painter) const;
    void drawBars(QPainter& painter, TimelineLane lane, int TimelineColumn::*value) const;
    void drawMarks(QPainter& painter) const;
    void drawBookmarks(QPainter& painter) const;
    void drawLoop(QPainter& painter) const;
    void drawLiveEdge(QPainter& painter) const;
    void drawPlayhead(QPainter& painter) const;
    void drawEmpty(QPainter& painter) const;

    std::vector<TimelineColumn> columns_;
    QString hint_;
    int expected_ = 0;
    int planned_ = 0;
    int place_ = -1;
    std::optional<std::pair<int, int>> loop_;
    std::set<int> bookmarks_;
    bool looksBack_ = false;
    int hovered_ = -1;
    Drag drag_ = Drag::None;
    int dragFrom_ = 0;
    mutable std::optional<Places> places_;  ///< nothing where they must be worked out anew
    QPixmap picture_;  ///< of all that stays while somebody looks about; null where it must be drawn anew
};

}  // namespace planewright
