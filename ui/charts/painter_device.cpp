// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/painter_device.h"

#include <algorithm>
#include <vtkBrush.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainterPath>

namespace planewright {

namespace {

constexpr int kManyPoints = 50;

QColor colourOf(const unsigned char* rgba)
{
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

/// VTK's matrices multiply columns, Qt's rows.
QTransform transformOf(vtkMatrix3x3* m)
{
    const auto e = [m](int row, int column) { return m->GetElement(row, column); };
    return {e(0, 0), e(1, 0), e(2, 0), e(0, 1), e(1, 1), e(2, 1), e(0, 2), e(1, 2), e(2, 2)};
}

Qt::PenStyle styleOf(int type)
{
    switch (type) {
        case vtkPen::NO_PEN:
            return Qt::NoPen;
        case vtkPen::DASH_LINE:
            return Qt::DashLine;
        case vtkPen::DOT_LINE:
            return Qt::DotLine;
        case vtkPen::DASH_DOT_LINE:
            return Qt::DashDotLine;
        case vtkPen::DASH_DOT_DOT_LINE:
            return Qt::DashDotDotLine;
        default:
            return Qt::SolidLine;
    }
}

}  // namespace

vtkStandardNewMacro(PainterDevice);

void PainterDevice::setPainter(QPainter* painter, double height)
{
    painter_ = painter;
    height_ = height;
    matrix_ = {};
    matrices_.clear();
}

QPointF PainterDevice::at(const float* point) const
{
    const QPointF mapped = matrix_.map(QPointF(static_cast<double>(point[0]), static_cast<double>(point[1])));
    return {mapped.x(), height_ - mapped.y()};
}

QPolygonF PainterDevice::polygon(const float* points, int n) const
{
    QPolygonF polygon;
    polygon.reserve(n);
    for (int i = 0; i < n; ++i)
        polygon << at(points + 2 * i);
    return polygon;
}

QPen PainterDevice::pen() const
{
    QPen pen(colourOf(Pen->GetColor()), static_cast<double>(Pen->GetWidth()), styleOf(Pen->GetLineType()), Qt::FlatCap,
             Qt::RoundJoin);
    if (Pen->GetOpacity() == 0)
        pen.setStyle(Qt::NoPen);
    return pen;
}

QBrush PainterDevice::brush() const
{
    return QBrush(colourOf(Brush->GetColor()));
}

QFont PainterDevice::font() const
{
    QFont font = font_;
    font.setPixelSize(std::max(1, TextProp->GetFontSize()));
    font.setBold(TextProp->GetBold() != 0);
    return font;
}

void PainterDevice::fill(const QPolygonF& polygon)
{
    if (Brush->GetOpacity() == 0)
        return;
    painter_->setPen(Qt::NoPen);
    painter_->setBrush(brush());
    painter_->drawPolygon(polygon);
}

void PainterDevice::DrawPoly(float* points, int n, unsigned char*, int)
{
    painter_->setPen(pen());
    const QPolygonF line = polygon(points, n);
    // One path of many lines takes a picture of pixels far longer than the lines do.
    const bool hasPixels = painter_->paintEngine()->type() == QPaintEngine::Raster;
    if (!hasPixels || n < kManyPoints || Pen->GetLineType() != vtkPen::SOLID_LINE) {
        painter_->drawPolyline(line);
        return;
    }
    QList<QLineF> lines;
    lines.reserve(n);
    for (int i = 1; i < n; ++i)
        lines << QLineF(line[i - 1], line[i]);
    painter_->drawLines(lines);
}

void PainterDevice::DrawLines(float* points, int n, unsigned char*, int)
{
    painter_->setPen(pen());
    for (int i = 0; i + 1 < n; i += 2)
        painter_->drawLine(at(points + 2 * i), at(points + 2 * i + 2));
}

void PainterDevice::DrawPoints(float* points, int n, unsigned char*, int)
{
    QPen round = pen();
    round.setCapStyle(Qt::RoundCap);
    painter_->setPen(round);
    painter_->drawPoints(polygon(points, n));
}

void PainterDevice::DrawPointSprites(vtkImageData*, float* points, int n, unsigned char* colors, int components)
{
    DrawPoints(points, n, colors, components);
}

void PainterDevice::DrawMarkers(int shape, bool, float* points, int n, unsigned char*, int)
{
    const double radius = 0.5 * static_cast<double>(Pen->GetWidth());
    painter_->setPen(Qt::NoPen);
    painter_->setBrush(colourOf(Pen->GetColor()));
    for (int i = 0; i < n; ++i) {
        const QPointF centre = at(points + 2 * i);
        if (shape == vtkPlotPoints::SQUARE)
            painter_->drawRect(QRectF(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius));
        else
            painter_->drawEllipse(centre, radius, radius);
    }
}

void PainterDevice::DrawQuad(float* points, int n)
{
    fill(polygon(points, n));
}

/// The points go to and fro between the two edges of the strip.
void PainterDevice::DrawQuadStrip(float* points, int n)
{
    QPolygonF outline;
    outline.reserve(n);
    for (int i = 0; i < n; i += 2)
        outline << at(points + 2 * i);
    for (int i = n - 1 - (n % 2); i > 0; i -= 2)
        outline << at(points + 2 * i);
    fill(outline);
}

void PainterDevice::DrawPolygon(float* points, int n)
{
    fill(polygon(points, n));
}

void PainterDevice::DrawColoredPolygon(float* points, int n, unsigned char*, int)
{
    fill(polygon(points, n));
}

void PainterDevice::DrawEllipseWedge(float x, float y, float outRx, float outRy, float, float, float startAngle,
                                     float stopAngle)
{
    if (Brush->GetOpacity() == 0)
        return;
    const float centre[2]{x, y};
    const auto width = static_cast<double>(outRx);
    const auto height = static_cast<double>(outRy);
    const QPointF middle = at(centre);
    painter_->setPen(Qt::NoPen);
    painter_->setBrush(brush());
    painter_->drawPie(QRectF(middle.x() - width, middle.y() - height, 2.0 * width, 2.0 * height),
                      static_cast<int>(startAngle * 16.0F), static_cast<int>((stopAngle - startAngle) * 16.0F));
}

void PainterDevice::DrawEllipticArc(float x, float y, float rX, float rY, float startAngle, float stopAngle)
{
    const float centre[2]{x, y};
    const auto width = static_cast<double>(rX);
    const auto height = static_cast<double>(rY);
    const QPointF middle = at(centre);
    painter_->setPen(pen());
    painter_->setBrush(Qt::NoBrush);
    painter_->drawArc(QRectF(middle.x() - width, middle.y() - height, 2.0 * width, 2.0 * height),
                      static_cast<int>(startAngle * 16.0F), static_cast<int>((stopAngle - startAngle) * 16.0F));
}

QRectF PainterDevice::justified(const QString& text) const
{
    // VTK keeps room for a title that there is not.
    if (text.isEmpty())
        return {};
    const QFontMetricsF metrics(font());
    const double width = metrics.horizontalAdvance(text);
    const double height = metrics.height();
    const int across = TextProp->GetJustification();
    const int along = TextProp->GetVerticalJustification();
    const double left = across == VTK_TEXT_LEFT ? 0.0 : across == VTK_TEXT_RIGHT ? -width : -0.5 * width;
    const double top = along == VTK_TEXT_TOP ? 0.0 : along == VTK_TEXT_BOTTOM ? -height : -0.5 * height;
    return {left, top, width, height};
}

void PainterDevice::DrawString(float* point, const vtkStdString& string)
{
    const QString text = QString::fromStdString(string);
    double colour[3];
    TextProp->GetColor(colour);
    painter_->save();
    painter_->translate(at(point));
    painter_->rotate(-TextProp->GetOrientation());
    painter_->setFont(font());
    painter_->setPen(QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                                      static_cast<float>(colour[2]), static_cast<float>(TextProp->GetOpacity())));
    const QRectF place = justified(text);
    painter_->drawText(QPointF(place.left(), place.top() + QFontMetricsF(font()).ascent()), text);
    painter_->restore();
}

void PainterDevice::ComputeStringBounds(const vtkStdString& string, float bounds[4])
{
    const QRectF place =
        QTransform().rotate(-TextProp->GetOrientation()).mapRect(justified(QString::fromStdString(string)));
    bounds[0] = bounds[1] = 0.0F;
    bounds[2] = static_cast<float>(place.width());
    bounds[3] = static_cast<float>(place.height());
}

void PainterDevice::DrawString(float* point, const vtkUnicodeString& string)
{
    DrawString(point, vtkStdString(string.utf8_str()));
}

void PainterDevice::ComputeStringBounds(const vtkUnicodeString& string, float bounds[4])
{
    ComputeStringBounds(vtkStdString(string.utf8_str()), bounds);
}

void PainterDevice::ComputeJustifiedStringBounds(const char* string, float bounds[4])
{
    const QRectF place = QTransform().rotate(-TextProp->GetOrientation()).mapRect(justified(QString::fromUtf8(string)));
    bounds[0] = static_cast<float>(place.left());
    bounds[1] = static_cast<float>(-place.bottom());
    bounds[2] = static_cast<float>(place.width());
    bounds[3] = static_cast<float>(place.height());
}

void PainterDevice::DrawMathTextString(float* point, const vtkStdString& string)
{
    DrawString(point, string);
}

void PainterDevice::DrawImage(float*, float, vtkImageData*) {}
void PainterDevice::DrawImage(const vtkRectf&, vtkImageData*) {}
void PainterDevice::SetTexture(vtkImageData*, int) {}

void PainterDevice::SetColor4(unsigned char color[4])
{
    Pen->SetColor(color);
    Brush->SetColor(color);
}

void PainterDevice::SetPointSize(float size)
{
    Pen->SetWidth(size);
}

void PainterDevice::SetLineWidth(float width)
{
    Pen->SetWidth(width);
}

void PainterDevice::SetLineType(int type)
{
    Pen->SetLineType(type);
}

void PainterDevice::SetMatrix(vtkMatrix3x3* m)
{
    matrix_ = transformOf(m);
}

void PainterDevice::GetMatrix(vtkMatrix3x3* m)
{
    const double elements[9]{matrix_.m11(), matrix_.m21(), matrix_.m31(), matrix_.m12(), matrix_.m22(),
                             matrix_.m32(), matrix_.m13(), matrix_.m23(), matrix_.m33()};
    for (int i = 0; i < 9; ++i)
        m->SetElement(i / 3, i % 3, elements[i]);
}

/// The new one acts first.
void PainterDevice::MultiplyMatrix(vtkMatrix3x3* m)
{
    matrix_ = transformOf(m) * matrix_;
}

void PainterDevice::PushMatrix()
{
    matrices_.push_back(matrix_);
}

void PainterDevice::PopMatrix()
{
    if (matrices_.empty())
        return;
    matrix_ = matrices_.back();
    matrices_.pop_back();
}

void PainterDevice::SetClipping(int* rect)
{
    clip_ = QRect(rect[0], static_cast<int>(height_) - rect[1] - rect[3], rect[2], rect[3]);
}

void PainterDevice::EnableClipping(bool enable)
{
    if (enable)
        painter_->setClipRect(clip_);
    else
        painter_->setClipping(false);
}

}  // namespace planewright
