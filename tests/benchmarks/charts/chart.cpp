// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/charts/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "tests/benchmarks/charts/offscreen_window.h"

namespace planewright {

namespace {

/// Colours that differ in lightness as well, after Okabe and Ito (2008).
constexpr std::array<std::array<unsigned char, 3>, 8> kPalette{{{0, 114, 178},
                                                                {213, 94, 0},
                                                                {0, 158, 115},
                                                                {204, 121, 167},
                                                                {86, 180, 233},
                                                                {230, 159, 0},
                                                                {70, 70, 70},
                                                                {150, 110, 60}}};

/// A legend of more series stands beside the plot.
constexpr std::size_t kShortLegend = 6;

void setUpAxis(vtkAxis& axis, const std::string& title, bool logarithmic)
{
    axis.SetTitle(title);
    axis.GetTitleProperties()->SetFontSize(15);
    axis.GetTitleProperties()->SetBold(0);
    axis.GetLabelProperties()->SetFontSize(13);
    axis.SetLogScale(logarithmic);
    axis.GetGridPen()->SetColor(225, 225, 225);
}

/// An axis of powers of ten has a tick at each, with its number.
void setPowersOfTen(vtkAxis& axis, double low, double high)
{
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    for (int decade = static_cast<int>(std::floor(low)); decade <= static_cast<int>(std::ceil(high)); ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, decade);
            if (std::log10(value) < low - 1e-9 || std::log10(value) > high + 1e-9)
                continue;
            places->InsertNextValue(std::log10(value));
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%g", value);
            labels->InsertNextValue(text.data());
        }
    }
    axis.SetCustomTickPositions(places, labels);
    axis.SetLogScale(false);
}

void addSeries(vtkChartXY& chart, const Chart& content, const ChartSeries& series, std::size_t number)
{
    vtkNew<vtkTable> table;
    vtkNew<vtkDoubleArray> x;
    vtkNew<vtkDoubleArray> y;
    x->SetName("x");
    y->SetName(series.name.c_str());
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        x->InsertNextValue(content.logX ? std::log10(series.x[i]) : series.x[i]);
        y->InsertNextValue(content.logY ? std::log10(series.y[i]) : series.y[i]);
    }
    table->AddColumn(x);
    table->AddColumn(y);
    const int type = series.style == ChartSeries::Style::Line     ? vtkChart::LINE
                     : series.style == ChartSeries::Style::Points ? vtkChart::POINTS
                                                                  : vtkChart::BAR;
    vtkPlot* plot = chart.AddPlot(type);
    plot->SetInputData(table, 0, 1);
    const auto& colour =
        kPalette[(series.colour >= 0 ? static_cast<std::size_t>(series.colour) : number) % kPalette.size()];
    plot->SetColor(colour[0], colour[1], colour[2], 255);
    plot->SetWidth(series.style == ChartSeries::Style::Line ? 2.0F : 1.0F);
    if (auto* points = vtkPlotPoints::SafeDownCast(plot); points != nullptr && type == vtkChart::POINTS) {
        points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
        points->SetMarkerSize(7.0F);
    }
}

void setUp(vtkChartXY& chart, const Chart& content)
{
    chart.SetTitle(content.title);
    chart.GetTitleProperties()->SetFontSize(17);
    chart.GetTitleProperties()->SetBold(1);
    chart.SetShowLegend(content.legend && content.series.size() > 1);
    // A long legend stands beside the plot; a short one has room above the curves.
    const bool beside = content.series.size() > kShortLegend;
    chart.GetLegend()->SetInline(!beside);
    chart.GetLegend()->SetHorizontalAlignment(beside ? vtkChartLegend::RIGHT : vtkChartLegend::LEFT);
    chart.GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
    chart.GetLegend()->SetLabelSize(13);
    vtkAxis& bottom = *chart.GetAxis(vtkAxis::BOTTOM);
    vtkAxis& left = *chart.GetAxis(vtkAxis::LEFT);
    setUpAxis(bottom, content.xTitle, false);
    setUpAxis(left, content.yTitle, false);
    double lowX = 1e300, highX = -1e300, lowY = 1e300, highY = -1e300;
    for (std::size_t i = 0; i < content.series.size(); ++i) {
        addSeries(chart, content, content.series[i], i);
        for (const double v : content.series[i].x) {
            lowX = std::min(lowX, content.logX ? std::log10(v) : v);
            highX = std::max(highX, content.logX ? std::log10(v) : v);
        }
        for (const double v : content.series[i].y) {
            lowY = std::min(lowY, content.logY ? std::log10(v) : v);
            highY = std::max(highY, content.logY ? std::log10(v) : v);
        }
    }
    if (lowX > highX)
        return;
    if (!content.logY)
        lowY = std::min(lowY, 0.0);
    const double room = content.legend && content.series.size() > 1 && !beside
                            ? 0.08 + 0.075 * static_cast<double>(content.series.size())
                            : 0.06;
    const double spanX = std::max(highX - lowX, 1e-9);
    const double spanY = std::max(highY - lowY, 1e-9);
    const bool bars = !content.xLabels.empty();
    bottom.SetBehavior(vtkAxis::FIXED);
    bottom.SetRange(bars ? -0.6 : lowX - 0.03 * spanX,
                    bars ? static_cast<double>(content.xLabels.size()) - 0.4 : highX + 0.03 * spanX);
    left.SetBehavior(vtkAxis::FIXED);
    left.SetRange(content.logY ? lowY - 0.05 * spanY : lowY, highY + room * spanY);
    if (content.logX)
        setPowersOfTen(bottom, lowX - 0.03 * spanX, highX + 0.03 * spanX);
    if (content.logY)
        setPowersOfTen(left, lowY - 0.05 * spanY, highY + room * spanY);
    if (bars) {
        vtkNew<vtkDoubleArray> places;
        vtkNew<vtkStringArray> labels;
        for (std::size_t i = 0; i < content.xLabels.size(); ++i) {
            places->InsertNextValue(static_cast<double>(i));
            labels->InsertNextValue(content.xLabels[i]);
        }
        bottom.SetCustomTickPositions(places, labels);
    }
}

}  // namespace

bool writeCharts(const std::vector<Chart>& charts, const std::string& path, int width, int height)
{
    const int total = height * static_cast<int>(charts.size());
    vtkNew<OffscreenWindow> window;
    if (!window->open(width, total))
        return false;
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1.0, 1.0, 1.0);
    window->AddRenderer(renderer);
    vtkNew<vtkContextActor> actor;
    renderer->AddActor(actor);
    actor->GetScene()->SetRenderer(renderer);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        vtkNew<vtkChartXY> chart;
        setUp(*chart, charts[i]);
        chart->SetAutoSize(false);
        const int bottom = total - height * static_cast<int>(i + 1);
        chart->SetSize(
            vtkRectf(0.0F, static_cast<float>(bottom), static_cast<float>(width), static_cast<float>(height)));
        actor->GetScene()->AddItem(chart);
    }
    window->Render();

    vtkNew<vtkUnsignedCharArray> pixels;
    if (window->GetPixelData(0, 0, width - 1, total - 1, 1, pixels.Get(), 0) == 0)
        return false;
    const unsigned char* const bytes = pixels->GetPointer(0);
    if (std::all_of(bytes, bytes + pixels->GetNumberOfValues(), [&](unsigned char b) { return b == *bytes; }))
        return false;
    vtkNew<vtkImageData> image;
    image->SetDimensions(width, total, 1);
    image->GetPointData()->SetScalars(pixels);
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(image);
    writer->Write();
    return writer->GetErrorCode() == 0;
}

}  // namespace planewright
