// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_painting.h"

#include <QImage>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_history.h"
#include "ui/common/scan_charts.h"
#include "ui/theme/theme.h"

namespace planewright {

/// A chart's numbers and where they are in its picture.
class ChartPaintingTest : public QObject {
    Q_OBJECT

private slots:
    void theFrameIsWhereTheCurveIs();
    void aLimitThatIsFarAwayDoesNotFlattenTheRest();
    void limitsThatAreNearToEachOtherAreBothNamed();
    void aChartWithoutNumbersHasAxes();
    void nothingIsDrawnWhereThereIsNoRoom();

private:
    PlotFrame paint(const Chart& chart, QSize size);

    QImage image_;
};

PlotFrame ChartPaintingTest::paint(const Chart& chart, QSize size)
{
    image_ = QImage(size, QImage::Format_RGB32);
    QPainter painter(&image_);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    return paintChart(painter, QSizeF(size), chart, {applicationPalette(Theme::Light), font});
}

void ChartPaintingTest::theFrameIsWhereTheCurveIs()
{
    MadeHistory made;
    for (int i = 0; i < 21; ++i)
        made.step(i == 10 ? 100 : 40, 0, 0, 0.0);
    const Chart chart = scanCharts(made.get(), 4.0)[0];

    const PlotFrame frame = paint(chart, {400, 200});

    // The curve's colour at the peak and at the level beside it, and not between them.
    const auto hasColour = [&](double x, double y) {
        const QPoint centre = frame.pixel(x, y).toPoint();
        const QColor wanted = seriesColour(chart.series[0], applicationPalette(Theme::Light));
        for (int dy = -3; dy <= 3; ++dy) {
            for (int dx = -3; dx <= 3; ++dx) {
                const QColor there = image_.pixelColor(centre + QPoint(dx, dy));
                if (std::abs(there.red() - wanted.red()) + std::abs(there.green() - wanted.green()) +
                        std::abs(there.blue() - wanted.blue()) <
                    60)
                    return true;
            }
        }
        return false;
    };
    QCOMPARE(frame.lowX, 1.0);
    QCOMPARE(frame.highX, 21.0);
    QVERIFY(hasColour(11.0, 100.0));
    QVERIFY(hasColour(5.0, 40.0));
    QVERIFY(hasColour(17.0, 40.0));
    QVERIFY(!hasColour(5.0, 80.0));
    QVERIFY(!hasColour(17.0, 10.0));
}

void ChartPaintingTest::aLimitThatIsFarAwayDoesNotFlattenTheRest()
{
    using std::chrono::milliseconds;
    const auto fast = MadeHistory().step(1, 0, 0, 0.0).takes(Phase::Fit, milliseconds(2)).get();
    const auto usual = MadeHistory().step(1, 0, 0, 0.0).takes(Phase::Fit, milliseconds(3)).get();
    const auto slow = MadeHistory().step(1, 0, 0, 0.0).takes(Phase::Fit, milliseconds(12)).get();

    const PlotFrame ofFast = paint(scanCharts(fast, 4.0)[4], {400, 200});
    const PlotFrame ofUsual = paint(scanCharts(usual, 4.0)[4], {400, 200});
    const PlotFrame ofSlow = paint(scanCharts(slow, 4.0)[4], {400, 200});

    QVERIFY(ofFast.highY > 2.0 && ofFast.highY < 3.0);
    QVERIFY(ofUsual.highY > 10.0 && ofUsual.highY < 12.0);
    QVERIFY(ofSlow.highY > 25.0 && ofSlow.highY < 30.0);
}

void ChartPaintingTest::limitsThatAreNearToEachOtherAreBothNamed()
{
    using std::chrono::milliseconds;
    const auto verySlow =
        MadeHistory().step(1, 0, 0, 0.0).step(1, 0, 0, 0.0).takes(Phase::Fit, milliseconds(300)).get();
    Chart both = scanCharts(verySlow, 4.0)[4];
    Chart one = both;
    one.series.pop_back();
    QCOMPARE(one.series.back().name, std::string("10 ms"));

    // What the line at 25 ms adds to the picture takes nothing of the name of that at 10 ms.
    const PlotFrame frame = paint(one, {400, 200});
    const QImage alone = image_;
    paint(both, {400, 200});
    const int top = static_cast<int>(frame.pixelY(10.0)) - 12;
    const int right = static_cast<int>(frame.area.right()) - 2;
    QVERIFY(frame.pixelY(10.0) - frame.pixelY(25.0) < 12.0);
    int dark = 0;
    int kept = 0;
    for (int y = top; y < top + 10; ++y) {
        for (int x = right - 40; x < right; ++x) {
            if (alone.pixelColor(x, y).lightness() > 90)
                continue;
            ++dark;
            kept += image_.pixelColor(x, y).lightness() <= 130 ? 1 : 0;
        }
    }
    QVERIFY2(dark > 30, qPrintable(QString::number(dark)));
    QCOMPARE(kept, dark);
}

void ChartPaintingTest::aChartWithoutNumbersHasAxes()
{
    for (const Chart& chart : scanCharts({}, 4.0)) {
        const PlotFrame frame = paint(chart, {360, 158});

        QVERIFY2(frame.area.width() > 250.0, chart.id.c_str());
        QVERIFY2(frame.area.height() > 60.0, chart.id.c_str());
    }
}

void ChartPaintingTest::nothingIsDrawnWhereThereIsNoRoom()
{
    const Chart chart = scanCharts(MadeHistory().scan(20).get(), 4.0)[4];

    QVERIFY(paint(chart, {10, 10}).isEmpty());
    QVERIFY(paint(chart, {400, 20}).isEmpty());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ChartPaintingTest)
#include "chart_painting_test.moc"
