// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/charts_panel.h"

#include <algorithm>

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSaveFile>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/charts/svg_picture.h"

namespace planewright {

namespace {

constexpr int kLeastWidth = 300;   // of a chart beside others [px]
constexpr int kLeastHeight = 150;  // of a chart below others [px]
constexpr double kPictureScale = 2.0;

}  // namespace

ChartsPanel::ChartsPanel(QWidget* parent)
    : QWidget(parent),
      chooser_(new QComboBox),
      copy_(new QAction(tr("Copy data"), this)),
      pages_(new QStackedWidget),
      scroll_(new QScrollArea),
      board_(new QWidget),
      grid_(new QGridLayout(board_)),
      table_(new QTableView),
      model_(new ChartTableModel(this))
{
    setObjectName(QStringLiteral("chartsPanel"));
    setAccessibleName(tr("Charts"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 0);
    layout->setSpacing(2);
    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(pages_, 1);

    chooser_->setObjectName(QStringLiteral("chartChooser"));
    chooser_->setAccessibleName(tr("Charts to show"));
    chooser_->setToolTip(tr("One chart large, or all of them"));
    chooser_->addItem(tr("All charts"));
    chooser_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    chooser_->setMinimumWidth(120);
    top->addWidget(chooser_);
    tableButton_ = addButton("chartTable", tr("Table"), tr("The same numbers as a table"));
    tableButton_->setCheckable(true);
    top->addWidget(tableButton_);
    copy_->setObjectName(QStringLiteral("actCopyChart"));
    copy_->setToolTip(tr("Copy the numbers as text with tabs (%1)")
                          .arg(QKeySequence(QKeySequence::Copy).toString(QKeySequence::NativeText)));
    QToolButton* copyButton = addButton("copyChart", copy_->text(), copy_->toolTip());
    connect(copyButton, &QToolButton::clicked, copy_, &QAction::trigger);
    top->addWidget(copyButton);
    QToolButton* save = addButton("saveChart", tr("Save picture…"), tr("Write what is shown to a PNG or SVG file"));
    top->addWidget(save);
    top->addStretch(1);

    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(4);
    scroll_->setObjectName(QStringLiteral("chartScroll"));
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setFocusPolicy(Qt::NoFocus);
    scroll_->setWidgetResizable(true);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setWidget(board_);
    scroll_->viewport()->installEventFilter(this);
    pages_->addWidget(scroll_);
    table_->setObjectName(QStringLiteral("chartNumbers"));
    table_->setAccessibleName(tr("Numbers of the charts"));
    table_->setModel(model_);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setResizeContentsPrecision(20);
    table_->setTabKeyNavigation(false);
    table_->installEventFilter(this);
    pages_->addWidget(table_);

    connect(chooser_, &QComboBox::currentIndexChanged, this, [this] {
        arrange();
        fillTable();
    });
    connect(tableButton_, &QToolButton::toggled, this, [this](bool shown) {
        fillTable();
        pages_->setCurrentWidget(shown ? static_cast<QWidget*>(table_) : scroll_);
    });
    connect(copy_, &QAction::triggered, this, [this] { QGuiApplication::clipboard()->setText(dataText()); });
    connect(save, &QToolButton::clicked, this, &ChartsPanel::saveRequested);
    connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
        const std::vector<Chart> charts = shownCharts();
        const std::vector<int>& places = charts.front().places;
        if (static_cast<std::size_t>(index.row()) < places.size())
            emit placeChosen(places[static_cast<std::size_t>(index.row())]);
    });
}

QToolButton* ChartsPanel::addButton(const char* name, const QString& text, const QString& tip)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    button->setMinimumHeight(28);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

void ChartsPanel::makeViews(const std::vector<Chart>& charts)
{
    for (const Chart& chart : charts) {
        auto* view = new ChartView;
        const auto number = static_cast<int>(views_.size());
        views_.push_back(view);
        chooser_->addItem(QString::fromStdString(chart.title));
        connect(view, &ChartView::placeChosen, this, &ChartsPanel::placeChosen);
        connect(view, &ChartView::enlargeRequested, this, [this, number] { choose(chosen() < 0 ? number : -1); });
    }
}

void ChartsPanel::setCharts(const std::vector<Chart>& charts)
{
    if (views_.empty())
        makeViews(charts);
    for (std::size_t i = 0; i < views_.size() && i < charts.size(); ++i)
        views_[i]->setChart(charts[i]);
    arrange();
    if (showsTable())
        fillTable();
}

void ChartsPanel::setPlace(int place)
{
    for (ChartView* view : views_)
        view->setPlace(place);
}

int ChartsPanel::chosen() const
{
    return chooser_->currentIndex() - 1;
}

void ChartsPanel::choose(int chart)
{
    chooser_->setCurrentIndex(chart + 1);
    if (chart >= 0 && static_cast<std::size_t>(chart) < views_.size())
        views_[static_cast<std::size_t>(chart)]->setFocus();
}

bool ChartsPanel::showsTable() const
{
    return tableButton_->isChecked();
}

void ChartsPanel::showTable(bool shown)
{
    tableButton_->setChecked(shown);
}

/// Puts as many charts beside each other as there is room for.
void ChartsPanel::arrange()
{
    const int alone = chosen();
    const int room = std::max(1, scroll_->viewport()->width());
    const int columns =
        alone >= 0 ? 1 : std::clamp(room / kLeastWidth, 1, std::max(1, static_cast<int>(views_.size())));
    const int rows = alone >= 0 ? 1 : (static_cast<int>(views_.size()) + columns - 1) / columns;
    // Whole charts, however many of them are seen at once.
    const int height = std::max(scroll_->viewport()->height(), 1);
    const int seenRows = std::min(rows, std::max(1, height / kLeastHeight));
    const int each = (height - grid_->spacing() * (seenRows - 1)) / seenRows;
    for (ChartView* view : views_)
        view->setMinimumHeight(each);
    if (columns == columns_ && alone == laidOut_)
        return;
    columns_ = columns;
    laidOut_ = alone;
    int next = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        const bool seen = alone < 0 || alone == static_cast<int>(i);
        if (seen) {
            grid_->addWidget(views_[i], next / columns, next % columns);
            ++next;
        } else {
            grid_->removeWidget(views_[i]);
            views_[i]->setParent(board_);
        }
        views_[i]->setVisible(seen);
    }
}

std::vector<Chart> ChartsPanel::shownCharts() const
{
    std::vector<Chart> charts;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (chosen() < 0 || chosen() == static_cast<int>(i))
            charts.push_back(views_[i]->chart());
    }
    return charts;
}

void ChartsPanel::fillTable()
{
    model_->setTable(tableOf(shownCharts()));
}

QString ChartsPanel::dataText() const
{
    return QString::fromStdString(tabSeparated(tableOf(shownCharts())));
}

void ChartsPanel::paintShown(QPainter& painter, const QSize& size) const
{
    const std::vector<Chart> charts = shownCharts();
    const int columns = std::max(1, columns_);
    const int rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
    const QSizeF each(static_cast<double>(size.width()) / columns, static_cast<double>(size.height()) / rows);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        painter.save();
        painter.translate(static_cast<double>(static_cast<int>(i) % columns) * each.width(),
                          static_cast<double>(static_cast<int>(i) / columns) * each.height());
        paintChart(painter, each, charts[i], {palette(), font()});
        painter.restore();
    }
}

bool ChartsPanel::savePicture(const QString& file) const
{
    const QSize size = board_->size();
    if (views_.empty() || size.isEmpty())
        return false;
    if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        const QByteArray svg = svgOf(size, [&](QPainter& painter) {
            painter.fillRect(QRect({}, size), palette().color(QPalette::Base));
            paintShown(painter, size);
        });
        QSaveFile target(file);
        return target.open(QIODevice::WriteOnly) && target.write(svg) == svg.size() && target.commit();
    }
    QImage image(size * kPictureScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kPictureScale);
    image.fill(palette().color(QPalette::Base));
    QPainter painter(&image);
    paintShown(painter, size);
    painter.end();
    QSaveFile target(file);
    return target.open(QIODevice::WriteOnly) && image.save(&target, "PNG") && target.commit();
}

bool ChartsPanel::event(QEvent* event)
{
    // Ctrl+C means the planes' table elsewhere in the window.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool ChartsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == scroll_->viewport() && event->type() == QEvent::Resize)
        arrange();
    if (watched == table_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copy_->trigger();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ChartsPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy))
        copy_->trigger();
    else
        QWidget::keyPressEvent(event);
}

void ChartsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    emit shown();
}

}  // namespace planewright
