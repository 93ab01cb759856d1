// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/planes_panel.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QVBoxLayout>

#include "ui/common/error_limit.h"
#include "ui/models/number_text.h"
#include "ui/panels/filter_box.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/plane_delegates.h"

namespace planewright {

namespace {

constexpr int column(PlaneColumn column)
{
    return static_cast<int>(column);
}

const std::vector<int> kDefaultColumns{column(PlaneColumn::Colour), column(PlaneColumn::Id),
                                       column(PlaneColumn::Class),  column(PlaneColumn::Distance),
                                       column(PlaneColumn::Area),   column(PlaneColumn::SegmentCount),
                                       column(PlaneColumn::Error),  column(PlaneColumn::State)};
constexpr std::string_view kMinSegmentsKey = "planes.min-cluster-segments";

/// A text about as wide as is usual in each column.
QStringList samples()
{
    QStringList texts(kPlaneColumns, QStringLiteral("000.0"));
    texts[column(PlaneColumn::Colour)] = QStringLiteral("mmm");  // check mark and colour
    texts[column(PlaneColumn::Id)] = QStringLiteral("P00");
    texts[column(PlaneColumn::Name)] = QStringLiteral("Left wall, rear");
    texts[column(PlaneColumn::Class)] = QStringLiteral("ceiling");
    for (const PlaneColumn normal : {PlaneColumn::Nx, PlaneColumn::Ny, PlaneColumn::Nz})
        texts[column(normal)] = QStringLiteral("-0.0000");
    texts[column(PlaneColumn::Distance)] = QStringLiteral("00.00");
    texts[column(PlaneColumn::SegmentCount)] = QStringLiteral("000");
    texts[column(PlaneColumn::Size)] = QStringLiteral("12.34 × 12.34");
    texts[column(PlaneColumn::Error)] = QStringLiteral("00.00");
    texts[column(PlaneColumn::MadeOf)] = QStringLiteral("P03←P07+P11");
    texts[column(PlaneColumn::State)] = QStringLiteral("merged");
    return texts;
}

struct Totals {
    int planes = 0;
    int segments = 0;
    double area = 0.0;     // [m²]
    bool complete = true;  // all areas are known
};

QString totalsText(const Totals& totals)
{
    return QStringLiteral("%1, %2%3 m², %4")
        .arg(countText(totals.planes, QStringLiteral("plane"), QStringLiteral("planes")),
             totals.complete ? QString{} : QStringLiteral("more than "), numberText(totals.area, 2),
             countText(totals.segments, QStringLiteral("segment"), QStringLiteral("segments")));
}

}  // namespace

PlanesPanel::PlanesPanel(PlanesModel& model, MapSelection& selection, QWidget* parent)
    : QWidget(parent),
      model_(model),
      selection_(selection),
      table_(new FilteredTable(&model, planeFilterKeys(),
                               {.objectName = QStringLiteral("planesTable"),
                                .accessibleName = tr("Planes"),
                                .filterName = tr("Filter planes"),
                                .filterPlaceholder = tr("Filter: class:wall area>2 E<1"),
                                .emptyText = {}},
                               kDefaultColumns, this))
{
    setObjectName(QStringLiteral("planesPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(table_);
    setFocusProxy(table_->view());

    QTableView* view = table_->view();
    view->setItemDelegateForColumn(column(PlaneColumn::Colour), new SwatchDelegate(view));
    view->setItemDelegateForColumn(column(PlaneColumn::Error), new LimitBarDelegate(view));
    view->setItemDelegateForColumn(column(PlaneColumn::Class), new ClassDelegate(view));
    view->setEditTriggers(QAbstractItemView::EditKeyPressed);
    view->setContextMenuPolicy(Qt::CustomContextMenu);
    view->sortByColumn(column(PlaneColumn::Id), Qt::AscendingOrder);
    table_->setWidths(samples());

    connect(table_, &FilteredTable::chosenChanged, this, &PlanesPanel::giveSelection);
    connect(&model_, &PlanesModel::mapChanged, this, &PlanesPanel::sayWhyEmpty);
    connect(table_, &FilteredTable::rowsChanged, this, &PlanesPanel::sumUp);
    connect(table_, &FilteredTable::filtered, this, &PlanesPanel::takeSelection);
    connect(&selection_, &MapSelection::changed, this, &PlanesPanel::takeSelection);
    connect(table_, &FilteredTable::linkActivated, this, [this](const QString& link) {
        if (link == QStringLiteral("unfitted"))
            emit showUnfittedRequested();
        else
            emit parameterRequested(link);
    });
    connect(view, &QWidget::customContextMenuRequested, this, &PlanesPanel::showMenu);
    connect(view, &QAbstractItemView::entered, this, [this](const QModelIndex& index) {
        selection_.hover(model_.planeAt(table_->rows()->mapToSource(index).row()));
    });
    connect(view, &QAbstractItemView::viewportEntered, this, [this] { selection_.hover(kNoPlane); });
    view->viewport()->installEventFilter(this);
    connect(view, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
        emit zoomRequested(model_.planeAt(table_->rows()->mapToSource(index).row()));
    });
    sayWhyEmpty();
    sumUp();
}

void PlanesPanel::setParameters(const Parameters& parameters)
{
    parameters_ = parameters;
    model_.setErrorLimit(errorLimitOf(parameters));
    sayWhyEmpty();
}

void PlanesPanel::beginRename()
{
    QTableView* view = table_->view();
    const QModelIndexList chosen = view->selectionModel()->selectedRows();
    const QModelIndex current = chosen.isEmpty() ? view->currentIndex() : chosen.front();
    if (!current.isValid())
        return;
    table_->setColumnShown(column(PlaneColumn::Name), true);
    const QModelIndex name = current.siblingAtColumn(column(PlaneColumn::Name));
    view->setCurrentIndex(name);
    view->scrollTo(name);
    view->edit(name);
}

void PlanesPanel::focusFilter()
{
    table_->filter()->edit()->setFocus(Qt::ShortcutFocusReason);
    table_->filter()->edit()->selectAll();
}

bool PlanesPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave)
        selection_.hover(kNoPlane);
    return QWidget::eventFilter(watched, event);
}

void PlanesPanel::takeSelection()
{
    std::vector<int> rows;
    for (const PlaneId plane : selection_.planes()) {
        if (const auto row = model_.rowOf(plane))
            rows.push_back(*row);
    }
    if (rows != table_->chosenRows()) {
        taking_ = true;
        table_->choose(rows);
        taking_ = false;
    }
    sumUp();
}

void PlanesPanel::giveSelection()
{
    if (taking_)
        return;
    // Planes that a filter hides stay chosen only until something is chosen here.
    std::set<PlaneId> planes;
    for (const int row : table_->chosenRows())
        planes.insert(model_.planeAt(row));
    selection_.selectPlanes(std::move(planes));
}

void PlanesPanel::sayWhyEmpty()
{
    const auto& map = model_.map();
    QString text = tr("No planes yet. The first fit happens at step %1.").arg(parameters_.schedule.fitEvery);
    if (map && map->finished) {
        const int unfitted = map->snapshot ? map->snapshot->report.counts.unfitted : 0;
        // The estimator by likelihood makes planes of segments that face each other, not of clusters.
        const bool ofClusters = parameters_.method.estimator == Estimator::EndPoints;
        text = ofClusters ? tr("No plane had N<sub>c</sub> = %1 segments.").arg(parameters_.planes.minClusterSegments)
                          : tr("No segments gave a plane.");
        text += QLatin1Char(' ') +
                (unfitted == 1 ? tr("1 segment is unfitted.") : tr("%1 segments are unfitted.").arg(unfitted));
        text += tr("<br><br><a href=\"unfitted\">Show unfitted</a>");
        if (ofClusters)
            text += tr(" &nbsp; <a href=\"%1\">Lower N<sub>c</sub>…</a>")
                        .arg(QLatin1String(kMinSegmentsKey.data(), static_cast<qsizetype>(kMinSegmentsKey.size())));
        if (unfitted == 0)
            text = tr("No planes: the scan has no line segments.");
    }
    table_->setEmptyText(text);
}

void PlanesPanel::sumUp()
{
    const auto sum = [this](const std::vector<int>& rows) {
        Totals totals;
        for (const int row : rows) {
            const auto area = model_.areaAt(row);
            ++totals.planes;
            totals.area += area.value_or(0.0);
            totals.complete = totals.complete && area.has_value();
            totals.segments += model_.index(row, column(PlaneColumn::SegmentCount)).data(kSortRole).toInt();
        }
        return totals;
    };
    std::vector<int> seen;
    for (int row = 0; row < table_->rows()->rowCount(); ++row)
        seen.push_back(table_->rows()->mapToSource(table_->rows()->index(row, 0)).row());
    if (seen.empty()) {
        table_->setFooter({});
        return;
    }
    const std::vector<int> chosen = table_->chosenRows();
    QString text = totalsText(sum(seen));
    if (!chosen.empty())
        text += tr("\nSelected: %1").arg(totalsText(sum(chosen)));
    table_->setFooter(text);
}

void PlanesPanel::showMenu(const QPoint& place)
{
    QMenu menu(this);
    for (QAction* action : contextActions_) {
        if (action != nullptr)
            menu.addAction(action);
        else
            menu.addSeparator();
    }
    if (!menu.isEmpty())
        menu.addSeparator();
    menu.addAction(table_->copyAction());
    menu.exec(table_->view()->viewport()->mapToGlobal(place));
}

}  // namespace planewright
