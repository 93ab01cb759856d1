// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>
#include <vtkContextDevice2D.h>

#include <QPainter>

namespace planewright {

/// What VTK draws its charts on, for a painter of Qt: no OpenGL, the program's own font, and pictures that are made of
/// lines and letters where the painter's device keeps them.
///
/// VTK counts y from below, in the painter's own unit. Images and textures are not drawn: charts have none.
class PainterDevice : public vtkContextDevice2D {
public:
    static PainterDevice* New();
    vtkTypeMacro(PainterDevice, vtkContextDevice2D);
    PainterDevice(const PainterDevice&) = delete;
    PainterDevice& operator=(const PainterDevice&) = delete;

    /// Draws with this from now on, in an area as high as this whose top left is the painter's origin.
    void setPainter(QPainter* painter, double height);
    /// Family and other looks of all text; VTK's text properties give size, colour and weight.
    void setFont(const QFont& font) { font_ = font; }

    void DrawPoly(float* points, int n, unsigned char* colors, int components) override;
    void DrawLines(float* points, int n, unsigned char* colors, int components) override;
    void DrawPoints(float* points, int n, unsigned char* colors, int components) override;
    void DrawPointSprites(vtkImageData* sprite, float* points, int n, unsigned char* colors, int components) override;
    void DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors, int components) override;
    void DrawQuad(float* points, int n) override;
    void DrawQuadStrip(float* points, int n) override;
    void DrawPolygon(float* points, int n) override;
    void DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) override;
    void DrawEllipseWedge(float x, float y, float outRx, float outRy, float inRx, float inRy, float startAngle,
                          float stopAngle) override;
    void DrawEllipticArc(float x, float y, float rX, float rY, float startAngle, float stopAngle) override;
    void DrawString(float* point, const vtkStdString& string) override;
    void ComputeStringBounds(const vtkStdString& string, float bounds[4]) override;
    void DrawString(float* point, const vtkUnicodeString& string) override;
    void ComputeStringBounds(const vtkUnicodeString& string, float bounds[4]) override;
    void ComputeJustifiedStringBounds(const char* string, float bounds[4]) override;
    void DrawMathTextString(float* point, const vtkStdString& string) override;
    void DrawImage(float p[2], float scale, vtkImageData* image) override;
    void DrawImage(const vtkRectf& place, vtkImageData* image) override;
    void SetColor4(unsigned char color[4]) override;
    void SetTexture(vtkImageData* image, int properties) override;
    void SetPointSize(float size) override;
    void SetLineWidth(float width) override;
    void SetLineType(int type) override;
    void SetMatrix(vtkMatrix3x3* m) override;
    void GetMatrix(vtkMatrix3x3* m) override;
    void MultiplyMatrix(vtkMatrix3x3* m) override;
    void PushMatrix() override;
    void PopMatrix() override;
    void SetClipping(int* rect) override;
    void EnableClipping(bool enable) override;

protected:
    PainterDevice() = default;
    ~PainterDevice() override = default;

private:
    QPointF at(const float* point) const;
    QPolygonF polygon(const float* points, int n) const;
    QPen pen() const;
    QBrush brush() const;
    QFont font() const;
    void fill(const QPolygonF& polygon);
    /// Of a text whose anchor is (0, 0), y from above.
    QRectF justified(const QString& text) const;

    QPainter* painter_ = nullptr;
    double height_ = 0.0;
    QFont font_;
    QTransform matrix_;
    std::vector<QTransform> matrices_;
    QRect clip_;
};

}  // namespace planewright
