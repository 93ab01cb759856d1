// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_painting.h"

#include <algorithm>
#include <cmath>
#include <vector>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <QCoreApplication>
#include <QFontInfo>
#include <QFontMetricsF>

#include "ui/charts/chart_ranges.h"
#include "ui/charts/painter_device.h"
#include "ui/common/palette.h"
#include "ui/models/number_text.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

using Style = ChartSeries::Style;

constexpr double kTallChart = 240.0;  // whose axis has room for a title of its own [px]
constexpr int kBesideAxes = 6;        // from the plot to where there is no axis [px]
constexpr double kNamedFrom = 0.07;   // of the steps: where the word "step" ends
constexpr double kPixelsOfTickX = 64.0;
constexpr double kPixelsOfTickY = 30.0;

/// Ticks at round numbers; those before `named` have no number.
void setTicks(vtkAxis& axis, double low, double high, double step, double named)
{
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    for (double i = std::ceil(low / step - 1e-9); i * step <= high * (1.0 + 1e-12); i += 1.0) {
        places->InsertNextValue(i * step);
        labels->InsertNextValue(i * step < named ? std::string{} : numberText(i * step, decimals).toStdString());
    }
    axis.SetCustomTickPositions(places, labels);
}

void setLabels(vtkAxis& axis, const std::vector<std::string>& names)
{
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    for (std::size_t i = 0; i < names.size(); ++i) {
        places->InsertNextValue(static_cast<double>(i));
        labels->InsertNextValue(names[i]);
    }
    axis.SetCustomTickPositions(places, labels);
}

void give(const QColor& colour, vtkTextProperty* text, int size)
{
    text->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    text->SetOpacity(1.0);
    text->SetFontSize(size);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetShadow(0);
}

void setUpAxis(vtkAxis& axis, const ChartLook& look, double low, double high)
{
    const QColor text = look.palette.color(QPalette::Text);
    const QColor grid = look.palette.color(QPalette::Mid);
    const int size = QFontInfo(look.font).pixelSize();
    axis.SetTitle("");
    give(text, axis.GetTitleProperties(), size);
    give(text, axis.GetLabelProperties(), std::max(9, size - 1));
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetRange(low, high);
    axis.GetPen()->SetColor(static_cast<unsigned char>(text.red()), static_cast<unsigned char>(text.green()),
                            static_cast<unsigned char>(text.blue()), 255);
    axis.GetGridPen()->SetColor(static_cast<unsigned char>(grid.red()), static_cast<unsigned char>(grid.green()),
                                static_cast<unsigned char>(grid.blue()), 90);
    axis.GetGridPen()->SetWidth(1.0F);
}

vtkSmartPointer<vtkDoubleArray> column(const char* name, const std::vector<double>& numbers)
{
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), array->Begin());
    return array;
}

/// A step is as wide as the way to its neighbours: the number of a step does not lead over to the next.
void addStairs(vtkChartXY& chart, const ChartSeries& series, std::vector<double>& below, const QColor& colour)
{
    std::vector<double> x;
    std::vector<double> low;
    std::vector<double> high;
    below.resize(std::max(below.size(), series.y.size()));
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const double before = i > 0 ? 0.5 * (series.x[i] - series.x[i - 1]) : 0.5;
        const double after = i + 1 < series.x.size() ? 0.5 * (series.x[i + 1] - series.x[i]) : 0.5;
        for (const double half : {-before, after}) {
            x.push_back(series.x[i] + half);
            low.push_back(below[i]);
            high.push_back(below[i] + series.y[i]);
        }
        below[i] += series.y[i];
    }
    vtkNew<vtkTable> table;
    table->AddColumn(column("x", x));
    table->AddColumn(column("low", low));
    table->AddColumn(column("high", high));
    auto* plot = vtkPlotArea::SafeDownCast(chart.AddPlot(vtkChart::AREA));
    plot->SetInputData(table);
    plot->SetInputArray(0, "x");
    plot->SetInputArray(1, "low");
    plot->SetInputArray(2, "high");
    plot->GetBrush()->SetColor(static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
                               static_cast<unsigned char>(colour.blue()), 255);
    plot->GetPen()->SetLineType(vtkPen::NO_PEN);
}

void addPlot(vtkChartXY& chart, const ChartSeries& series, const QColor& colour)
{
    vtkNew<vtkTable> table;
    table->AddColumn(column("x", series.x));
    table->AddColumn(column("y", series.y));
    const bool bars = series.style == Style::Bars;
    const bool points = series.style == Style::Points || series.x.size() == 1;
    vtkPlot* plot = chart.AddPlot(bars ? vtkChart::BAR : points ? vtkChart::POINTS : vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->SetColor(static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
                   static_cast<unsigned char>(colour.blue()), 255);
    plot->SetWidth(bars ? 0.0F : 1.8F);
    if (bars)
        plot->GetPen()->SetLineType(vtkPen::NO_PEN);
    if (auto* marked = vtkPlotPoints::SafeDownCast(plot); marked != nullptr) {
        marked->SetMarkerStyle(points && !bars ? vtkPlotPoints::CIRCLE : vtkPlotPoints::NONE);
        marked->SetMarkerSize(4.0F);
    }
}

/// Title, note and key; gives their height.
double paintHead(QPainter& painter, double width, const Chart& chart, const ChartLook& look)
{
    QFont bold = look.font;
    bold.setBold(true);
    const QFontMetricsF titleMetrics(bold);
    const QFontMetricsF metrics(look.font);
    const double line = titleMetrics.height();
    QString title = QString::fromStdString(chart.title);
    if (!title.endsWith(QString::fromStdString(chart.yTitle), Qt::CaseInsensitive))
        title += QStringLiteral(" [%1]").arg(QString::fromStdString(chart.yTitle));
    const QColor text = look.palette.color(QPalette::Text);
    painter.setFont(bold);
    painter.setPen(text);
    const QString shown = titleMetrics.elidedText(title, Qt::ElideRight, width - 8.0);
    painter.drawText(QPointF(4.0, titleMetrics.ascent() + 2.0), shown);
    const double titleEnd = 4.0 + titleMetrics.horizontalAdvance(shown) + 12.0;
    painter.setFont(look.font);
    const QString note = QString::fromStdString(chart.note);
    double height = line + 4.0;
    if (!note.isEmpty()) {
        const double needed = metrics.horizontalAdvance(note);
        const bool beside = titleEnd + needed <= width - 4.0;
        if (!beside)
            height += metrics.height();
        painter.drawText(QPointF(beside ? width - 4.0 - needed : 4.0, height - 4.0 - metrics.descent()),
                         metrics.elidedText(note, Qt::ElideRight, width - 8.0));
    }
    std::vector<const ChartSeries*> named;
    for (const ChartSeries& one : chart.series) {
        if (one.style != Style::Limit && one.style != Style::Fit)
            named.push_back(&one);
    }
    if (named.size() < 2)
        return height;
    double x = 4.0;
    const double box = 0.7 * metrics.ascent();
    height += metrics.height();
    for (const ChartSeries* one : named) {
        const QString name = QString::fromStdString(one->name);
        const double needed = box + 4.0 + metrics.horizontalAdvance(name) + 10.0;
        if (x + needed > width && x > 4.0) {
            x = 4.0;
            height += metrics.height();
        }
        const double base = height - 4.0 - metrics.descent();
        painter.fillRect(QRectF(x, base - box, box, box), seriesColour(*one, look.palette));
        painter.drawText(QPointF(x + box + 4.0, base), name);
        x += needed;
    }
    return height;
}

/// Limits within the picture are lines, those above it are named at its upper edge.
void paintLimits(QPainter& painter, const PlotFrame& frame, const Chart& chart, const ChartLook& look)
{
    const QFontMetricsF metrics(look.font);
    const QColor text = look.palette.color(QPalette::Text);
    QColor backing = look.palette.color(QPalette::Base);
    backing.setAlpha(200);
    painter.setFont(look.font);
    std::vector<QRectF> written;
    const auto write = [&](const QString& name, double top, bool atLeft) {
        const double width = metrics.horizontalAdvance(name) + 4.0;
        const double left = atLeft ? frame.area.left() + 4.0 : frame.area.right() - width - 2.0;
        QRectF place(left, top, width, metrics.height() - 1.0);
        // Beside the name of a line that is less than a row away.
        for (const QRectF& other : written) {
            if (place.intersects(other))
                place.moveRight(other.left() - 4.0);
        }
        written.push_back(place);
        painter.fillRect(place, backing);
        painter.setPen(text);
        painter.drawText(QPointF(place.left() + 2.0, place.top() + metrics.ascent()), name);
    };
    QStringList above;
    for (const ChartSeries& one : chart.series) {
        if (one.style != Style::Limit)
            continue;
        QString name = QString::fromStdString(one.name);
        if (name.front().isLetter())
            name += QLatin1Char(' ') + QString::number(one.y.front());
        if (one.y.front() > frame.highY) {
            above << name;
            continue;
        }
        const double y = frame.pixelY(one.y.front());
        painter.setPen(QPen(text, 1.2, Qt::DashLine, Qt::FlatCap));
        painter.drawLine(QPointF(frame.area.left(), y), QPointF(frame.area.right(), y));
        // Where the line is too near to the top its name stands below it.
        write(name, y - metrics.height() < frame.area.top() ? y + 1.0 : y - metrics.height(), false);
    }
    if (!above.isEmpty())
        write(QStringLiteral("↑ ") + above.join(QStringLiteral(", ")), frame.area.top() + 1.0, true);
}

}  // namespace

QColor seriesColour(const ChartSeries& series, const QPalette& palette)
{
    const Rgb colour = planeColour(series.colour, PlanePalette::ColourBlind, themeOf(palette));
    return {colour.red, colour.green, colour.blue};
}

PlotFrame paintChart(QPainter& painter, const QSizeF& size, const Chart& chart, const ChartLook& look)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF({}, size), look.palette.color(QPalette::Base));
    const double head = paintHead(painter, size.width(), chart, look);
    const double height = size.height() - head;
    const ChartRanges ranges = rangesOf(chart);
    const QFontMetricsF metrics(look.font);
    PlotFrame frame{{}, ranges.lowX, ranges.highX, 0.0, ranges.highY};
    if (height < 3.0 * metrics.height() || size.width() < 8.0 * metrics.height()) {
        painter.restore();
        return frame;
    }

    vtkNew<vtkContextScene> scene;
    scene->SetGeometry(static_cast<int>(size.width()), static_cast<int>(height));
    vtkNew<vtkChartXY> plots;
    plots->SetAutoSize(false);
    plots->SetSize(vtkRectf(0.0F, 0.0F, static_cast<float>(size.width()), static_cast<float>(height)));
    plots->SetShowLegend(false);
    plots->SetBarWidthFraction(0.7F);
    plots->SetHiddenAxisBorder(kBesideAxes);
    plots->GetBackgroundBrush()->SetOpacity(0);
    vtkAxis& bottom = *plots->GetAxis(vtkAxis::BOTTOM);
    vtkAxis& left = *plots->GetAxis(vtkAxis::LEFT);
    setUpAxis(bottom, look, ranges.lowX, ranges.highX);
    setUpAxis(left, look, 0.0, ranges.highY);
    // In a low chart the steps are named in the row of their numbers.
    const bool hasTitle = !chart.overSteps || size.height() >= kTallChart;
    bottom.SetTitle(hasTitle ? chart.xTitle : "");
    if (chart.xLabels.empty())
        setTicks(bottom, ranges.lowX, ranges.highX,
                 tickStep(ranges.highX - ranges.lowX, size.width() / kPixelsOfTickX, 1.0),
                 hasTitle ? ranges.lowX : ranges.lowX + kNamedFrom * (ranges.highX - ranges.lowX));
    else
        setLabels(bottom, chart.xLabels);
    setTicks(left, 0.0, ranges.highY,
             tickStep(ranges.highY, std::max(2.0, height / kPixelsOfTickY), chart.counts ? 1.0 : 0.0), 0.0);

    std::vector<double> below;
    const Chart drawn = thinned(inPieces(chart), 0.8 * size.width());
    for (const ChartSeries& one : drawn.series) {
        if (one.style == Style::Limit || one.x.empty())
            continue;
        if (one.style == Style::Stacked)
            addStairs(*plots, one, below, seriesColour(one, look.palette));
        else
            addPlot(*plots, one, seriesColour(one, look.palette));
    }
    if (plots->GetNumberOfPlots() == 0) {
        // VTK draws no axes without a plot.
        addPlot(*plots, {"", {ranges.lowX, ranges.highX}, {0.0, 0.0}, Style::Line, 0}, Qt::transparent);
        plots->GetPlot(0)->GetPen()->SetLineType(vtkPen::NO_PEN);
    }
    scene->AddItem(plots);

    vtkNew<PainterDevice> device;
    painter.translate(0.0, head);
    device->setPainter(&painter, height);
    device->setFont(look.font);
    vtkNew<vtkContext2D> context;
    context->Begin(device);
    scene->Paint(context);
    context->End();
    device->setPainter(nullptr, 0.0);
    painter.setClipping(false);
    painter.translate(0.0, -head);

    const vtkVector2f low = bottom.GetPosition1();
    const vtkVector2f right = bottom.GetPosition2();
    const vtkVector2f top = left.GetPosition2();
    frame.area = QRectF(QPointF(static_cast<double>(low.GetX()), head + height - static_cast<double>(top.GetY())),
                        QPointF(static_cast<double>(right.GetX()), head + height - static_cast<double>(low.GetY())));
    paintLimits(painter, frame, chart, look);
    if (!hasTitle) {
        painter.setFont(look.font);
        painter.setPen(look.palette.color(QPalette::Text));
        painter.drawText(QPointF(3.0, frame.area.bottom() + 5.0 + metrics.ascent()),
                         QString::fromStdString(chart.xTitle));
    }
    if (chart.isEmpty()) {
        painter.setFont(look.font);
        painter.setPen(look.palette.color(QPalette::Text));
        painter.drawText(frame.area, Qt::AlignCenter | Qt::TextWordWrap,
                         QCoreApplication::translate("ChartView", "Data appears with the first slice."));
    }
    painter.restore();
    return frame;
}

}  // namespace planewright
