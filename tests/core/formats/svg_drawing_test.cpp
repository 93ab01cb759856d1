// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/svg_drawing.h"

#include <QXmlStreamReader>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SvgDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void metresBecomePixelsWithYUp();
    void hostileTextIsOnlyText();
    void labelsDoNotCoverEachOther();
    void labelsStayInThePicture_data();
    void labelsStayInThePicture();
    void longLabelsAreCutShort();
    void gridLinesKeepTheirDistance();
    void aNarrowPictureHoldsItsBar();
};

namespace {

/// Empty where it is well-formed XML.
QString troubleOf(const std::string& svg)
{
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    while (!reader.atEnd())
        reader.readNext();
    return reader.hasError() ? reader.errorString() : QString();
}

}  // namespace

/// 4 m × 2 m into 424 × 250 pixels: margins of 12 leave 400 × 200 above the bar of 26, so that a metre has 100.
void SvgDrawingTest::metresBecomePixelsWithYUp()
{
    SvgDrawing drawing{{-1.0, 0.0}, {3.0, 2.0}, 424.0, 250.0};
    QCOMPARE(drawing.pixelsPerMetre(), 100.0);
    drawing.line("wall", {-1.0, 0.0}, {3.0, 2.0});
    drawing.dot("scanner", {0.0, 1.0}, 4.0);
    drawing.area("floor area", {{{0, 0}, {1, 0}, {1, 1}}, {{0.5, 0.25}, {0.75, 0.25}, {0.75, 0.5}}});

    const std::string svg = std::move(drawing).take("Plan");

    QCOMPARE(troubleOf(svg), QString());
    const auto has = [&](std::string_view part) { return svg.find(part) != std::string::npos; };
    QVERIFY(has("viewBox=\"0 0 424.00 250.00\""));
    QVERIFY(has("<path class=\"wall\" d=\"M12.00 212.00L412.00 12.00\"/>"));
    QVERIFY(has("<circle class=\"scanner\" cx=\"112.00\" cy=\"112.00\" r=\"4.00\"/>"));
    QVERIFY(has("d=\"M112.00 212.00L212.00 212.00L212.00 112.00ZM162.00 187.00L187.00 187.00L187.00 162.00Z\""));
}

void SvgDrawingTest::hostileTextIsOnlyText()
{
    QCOMPARE(markupText("<script>'a' & \"b\"</script>\n\x01"),
             std::string("&lt;script&gt;&#39;a&#39; &amp; &quot;b&quot;&lt;/script&gt; "));
    SvgDrawing drawing{{0, 0}, {1, 1}, 100, 100};
    QVERIFY(drawing.label("\" onload=\"x", {0.5, 0.5}, "</text><script/>"));

    const std::string svg = std::move(drawing).take("<b>");

    QCOMPARE(troubleOf(svg), QString());
    QVERIFY(svg.find("<script") == std::string::npos);
    QVERIFY(svg.find("onload=\"") == std::string::npos);
}

void SvgDrawingTest::labelsDoNotCoverEachOther()
{
    SvgDrawing drawing{{0, 0}, {4, 4}, 424, 450};  // 100 pixels a metre
    QVERIFY(drawing.label("label", {1.0, 1.0}, "P01"));
    QVERIFY(!drawing.label("label", {1.1, 1.05}, "P02"));
    QVERIFY(drawing.label("label", {1.1, 1.5}, "P03"));
    const std::string svg = std::move(drawing).take("");
    QVERIFY(svg.find("P02") == std::string::npos);
}

void SvgDrawingTest::labelsStayInThePicture_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("textX");
    QTest::addColumn<double>("textY");
    // 100 pixels a metre in 424 × 450; ten letters of 7.5 are 75 wide, and a text is 14 high: its base line is 4.2
    // below its middle.
    QTest::newRow("in the middle") << 2.0 << 2.0 << 212.0 << 216.2;
    QTest::newRow("at the left") << 0.0 << 2.0 << 39.5 << 216.2;
    QTest::newRow("at the right") << 4.0 << 2.0 << 384.5 << 216.2;
    QTest::newRow("at the top") << 2.0 << 4.0 << 212.0 << 16.2;
    QTest::newRow("above the top") << 2.0 << 4.2 << 212.0 << 13.2;
    QTest::newRow("at the bottom") << 2.0 << 0.0 << 212.0 << 416.2;
}

void SvgDrawingTest::labelsStayInThePicture()
{
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, textX);
    QFETCH(double, textY);
    SvgDrawing drawing{{0, 0}, {4, 4}, 424, 450};

    QVERIFY(drawing.label("label", {x, y}, "West wäll!"));

    QXmlStreamReader reader(QByteArray::fromStdString(std::move(drawing).take("")));
    while (!reader.atEnd() && reader.name() != QStringLiteral("text"))
        reader.readNext();
    QCOMPARE(reader.attributes().value(QStringLiteral("x")).toDouble(), textX);
    QCOMPARE(reader.attributes().value(QStringLiteral("y")).toDouble(), textY);
}

/// A picture of 1 m × 1 m and 62 pixels holds (62 − 4) / 7.5 letters: seven, the last of them the ellipsis.
void SvgDrawingTest::longLabelsAreCutShort()
{
    SvgDrawing drawing{{0, 0}, {1, 1}, 62, 400};

    QVERIFY(drawing.label("label", {0.5, 0.5}, "Wänd im Süden"));

    const std::string svg = std::move(drawing).take("");
    QVERIFY(svg.find(">Wänd i…</text>") != std::string::npos);
    QVERIFY(svg.find("x=\"31.00\"") != std::string::npos);
}

void SvgDrawingTest::gridLinesKeepTheirDistance()
{
    const auto barOf = [](double size) {
        SvgDrawing drawing{{0, 0}, {size, size}, 424, 450};
        drawing.grid();
        const std::string svg = std::move(drawing).take("");
        const std::size_t end = svg.find(" m</text>");
        return svg.substr(svg.rfind('>', end) + 1, end - svg.rfind('>', end) - 1);
    };
    QCOMPARE(barOf(4.0), std::string("1"));     // 100 px a metre
    QCOMPARE(barOf(25.0), std::string("2"));    // 16
    QCOMPARE(barOf(80.0), std::string("5"));    // 5
    QCOMPARE(barOf(300.0), std::string("20"));  // 1.33
}

/// 0.2 m × 20 m into 640 pixels: 590 are for 20 m, so that the bar of a metre is 29.5 long, where 0.2 m are 5.9.
void SvgDrawingTest::aNarrowPictureHoldsItsBar()
{
    SvgDrawing drawing{{0, 0}, {0.2, 20.0}, 400, 640};
    drawing.grid();

    const std::string svg = std::move(drawing).take("");

    // The text of three letters begins 6 behind the bar and ends 2 before the edge.
    QVERIFY2(svg.find("viewBox=\"0 0 72.00 640.00\"") != std::string::npos, svg.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SvgDrawingTest)
#include "svg_drawing_test.moc"
