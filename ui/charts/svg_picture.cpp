// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/svg_picture.h"

#include <QFontInfo>
#include <QPaintDevice>
#include <QPaintEngine>

namespace planewright {

namespace {

QString svgNumber(double value)
{
    return QString::number(value, 'g', 7);
}

QString matrixText(const QTransform& m)
{
    return QStringLiteral("matrix(%1 %2 %3 %4 %5 %6)")
        .arg(svgNumber(m.m11()), svgNumber(m.m12()), svgNumber(m.m21()), svgNumber(m.m22()), svgNumber(m.dx()),
             svgNumber(m.dy()));
}

QString pathText(const QPainterPath& path)
{
    QString text;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element element = path.elementAt(i);
        // A curve is one letter, and the two elements after it are its numbers.
        text += element.type == QPainterPath::MoveToElement    ? QStringLiteral("M")
                : element.type == QPainterPath::LineToElement  ? QStringLiteral("L")
                : element.type == QPainterPath::CurveToElement ? QStringLiteral("C")
                                                               : QStringLiteral(" ");
        text += svgNumber(element.x) + QLatin1Char(' ') + svgNumber(element.y);
    }
    return text;
}

/// Writes what a painter does as elements of SVG.
class SvgEngine : public QPaintEngine {
public:
    SvgEngine()
        : QPaintEngine(PrimitiveTransform | PainterPaths | AlphaBlend | ConstantOpacity | Antialiasing | BrushStroke)
    {
    }

    const QString& elements() const { return elements_; }

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }

    void updateState(const QPaintEngineState& now) override
    {
        const DirtyFlags dirty = now.state();
        if (dirty & DirtyPen)
            pen_ = now.pen();
        if (dirty & DirtyBrush)
            brush_ = now.brush();
        if (dirty & DirtyTransform)
            matrix_ = now.transform();
        if (dirty & (DirtyClipEnabled | DirtyClipPath | DirtyClipRegion)) {
            clips_ = now.painter()->hasClipping();
            if (clips_)
                elements_ += QStringLiteral("<clipPath id=\"clip%1\"><path d=\"%2\"/></clipPath>\n")
                                 .arg(++clip_)
                                 .arg(pathText(now.painter()->transform().map(now.painter()->clipPath())));
        }
    }

    void drawPath(const QPainterPath& path) override
    {
        if (pen_.style() == Qt::NoPen && brush_.style() == Qt::NoBrush)
            return;
        add(QStringLiteral("<path d=\"%1\"%2%3 transform=\"%4\"/>")
                .arg(pathText(path), fillText(), strokeText(), matrixText(matrix_)));
    }

    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override
    {
        QPainterPath path(points[0]);
        for (int i = 1; i < count; ++i)
            path.lineTo(points[i]);
        const QBrush brush = brush_;
        if (mode == PolylineMode)
            brush_ = Qt::NoBrush;
        else
            path.closeSubpath();
        drawPath(path);
        brush_ = brush;
    }

    void drawTextItem(const QPointF& place, const QTextItem& item) override
    {
        const QFontInfo font(item.font());
        add(QStringLiteral("<text x=\"%1\" y=\"%2\" transform=\"%3\" font-family=\"%4\" font-size=\"%5\" "
                           "font-weight=\"%6\" fill=\"%7\">%8</text>")
                .arg(svgNumber(place.x()), svgNumber(place.y()), matrixText(matrix_), font.family().toHtmlEscaped(),
                     svgNumber(font.pixelSize()), QString::number(item.font().weight()), pen_.color().name(),
                     item.text().toHtmlEscaped()));
    }

    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}

private:
    /// A clip is told in the picture's own frame, and so stands around the element, which has another.
    void add(const QString& element)
    {
        elements_ += clips_ ? QStringLiteral("<g clip-path=\"url(#clip%1)\">%2</g>\n").arg(clip_).arg(element)
                            : element + QLatin1Char('\n');
    }

    QString fillText() const
    {
        if (brush_.style() == Qt::NoBrush)
            return QStringLiteral(" fill=\"none\"");
        return QStringLiteral(" fill=\"%1\" fill-opacity=\"%2\"")
            .arg(brush_.color().name(), svgNumber(brush_.color().alphaF()));
    }

    QString strokeText() const
    {
        if (pen_.style() == Qt::NoPen)
            return {};
        QString text = QStringLiteral(" stroke=\"%1\" stroke-opacity=\"%2\" stroke-width=\"%3\"")
                           .arg(pen_.color().name(), svgNumber(pen_.color().alphaF()),
                                svgNumber(pen_.widthF() > 0.0 ? pen_.widthF() : 1.0));
        QStringList dashes;
        for (const qreal dash : pen_.dashPattern())
            dashes << svgNumber(dash * pen_.widthF());
        if (pen_.style() != Qt::SolidLine && !dashes.isEmpty())
            text += QStringLiteral(" stroke-dasharray=\"%1\"").arg(dashes.join(QLatin1Char(',')));
        if (pen_.capStyle() == Qt::RoundCap)
            text += QStringLiteral(" stroke-linecap=\"round\"");
        return text;
    }

    QString elements_;
    QPen pen_;
    QBrush brush_;
    QTransform matrix_;
    bool clips_ = false;
    int clip_ = 0;
};

class SvgDevice : public QPaintDevice {
public:
    explicit SvgDevice(const QSize& size) : size_(size) {}

    QPaintEngine* paintEngine() const override { return &engine_; }
    const QString& elements() const { return engine_.elements(); }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        constexpr int kDotsPerInch = 96;
        switch (metric) {
            case PdmWidth:
                return size_.width();
            case PdmHeight:
                return size_.height();
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return kDotsPerInch;
            default:
                return QPaintDevice::metric(metric);
        }
    }

private:
    QSize size_;
    mutable SvgEngine engine_;
};

}  // namespace

QByteArray svgOf(const QSize& size, const std::function<void(QPainter&)>& paint)
{
    SvgDevice device(size);
    QPainter painter(&device);
    paint(painter);
    painter.end();
    const QString picture = QStringLiteral(
                                "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" "
                                "viewBox=\"0 0 %1 %2\">\n%3</svg>\n")
                                .arg(size.width())
                                .arg(size.height())
                                .arg(device.elements());
    return picture.toUtf8();
}

}  // namespace planewright
