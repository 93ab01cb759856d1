// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/svg_picture.h"

#include <QXmlStreamReader>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SvgPictureTest : public QObject {
    Q_OBJECT

private slots:
    void linesAndTextsAreElements();
    void aClipStandsAroundWhatItCuts();
};

void SvgPictureTest::linesAndTextsAreElements()
{
    const QByteArray svg = svgOf({200, 100}, [](QPainter& painter) {
        painter.setPen(QPen(QColor(255, 0, 0), 2.0));
        painter.drawPolyline(QPolygonF{{QPointF(1, 2), QPointF(30, 40)}});
        painter.setPen(Qt::black);
        painter.drawText(QPointF(10, 20), QStringLiteral("a < b"));
    });

    QVERIFY(svg.contains("viewBox=\"0 0 200 100\""));
    QVERIFY2(svg.contains("d=\"M1 2L30 40\" fill=\"none\" stroke=\"#ff0000\""), svg.constData());
    QVERIFY(svg.contains(">a &lt; b</text>"));
    QXmlStreamReader reader(svg);
    while (!reader.atEnd())
        reader.readNext();
    QVERIFY(!reader.hasError());
}

void SvgPictureTest::aClipStandsAroundWhatItCuts()
{
    const QByteArray svg = svgOf({200, 100}, [](QPainter& painter) {
        painter.translate(10, 0);
        painter.setClipRect(QRect(0, 0, 50, 60));
        painter.fillRect(QRectF(0, 0, 100, 100), Qt::blue);
        painter.setClipping(false);
        painter.fillRect(QRectF(0, 0, 5, 5), Qt::green);
    });

    // The clip is told in the picture's own frame.
    QVERIFY2(svg.contains("<path d=\"M10 0L60 0L60 60L10 60L10 0\"/></clipPath>"), svg.constData());
    QCOMPARE(svg.count("clip-path=\"url(#clip1)\""), 1);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::SvgPictureTest)
#include "svg_picture_test.moc"
