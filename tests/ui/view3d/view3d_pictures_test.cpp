// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>

#include <QApplication>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/scene/shown_room.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/opengl/offscreen_window.h"
#include "ui/view3d/scene_picture.h"
#include "ui/view3d/view3d.h"

namespace planewright {

/// Pictures of the 3D view beside references that were looked at.
class View3dPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aBlankPictureIsFound();
    void picturesAreAsTheyWere_data();
    void picturesAreAsTheyWere();
    void theSamePictureComesEveryTime();
    void partsGiveThePictureThatIsDrawnAtOnce();
};

namespace {

constexpr QSize kSize{640, 400};

struct PictureCase {
    std::string scene;
    int step = -1;
    std::function<void(View3d&)> change;
};

QImage pictureOfCase(const PictureCase& what)
{
    View3d view;
    PresenterSettings settings;
    settings.image = true;
    if (const auto presented = view.present(settings); !presented)
        qFatal("%s", presented.error().message.c_str());
    view.resize(kSize);
    if (!what.scene.empty())
        view.setMap(shownRoom(what.scene, what.step));
    view.showNamed(NamedView::Iso);
    if (what.change)
        what.change(view);
    return view.picture(kSize, 1.0);
}

void selectLargest(View3d& view)
{
    const auto& planes = view.scene().map().planes;
    const auto largest = std::max_element(planes.begin(), planes.end(), [](const auto& a, const auto& b) {
        return a.outline->outline.area < b.outline->outline.area;
    });
    SceneSelection selection;
    selection.planes.insert(largest->plane->id);
    view.setSelection(selection);
}

/// The end points of a selected segment far down the corridor from near by, with their uncertainty.
void showUncertainty(View3d& view)
{
    LayerSettings layers;
    layers[Layer::Points].visible = layers[Layer::FittedSegments].visible = false;
    layers[Layer::Uncertainty].visible = true;
    view.setLayers(layers);
    SceneSelection selection;
    const LineSegment& segment = view.scene().map().snapshot->segments.slice(62).front();
    selection.segments.insert(segment.id);
    view.setSelection(selection);
    ViewCamera camera = centredOn(view.camera(), segment.start);
    camera.distance = 0.5;
    camera.elevation = degrees(60.0);
    view.setCamera(camera);
}

void showUnfitted(View3d& view)
{
    LayerSettings layers;
    for (const Layer layer : {Layer::Points, Layer::Planes, Layer::FittedSegments, Layer::Clusters})
        layers[layer].visible = false;
    view.setLayers(layers);
}

const std::vector<std::pair<const char*, PictureCase>>& cases()
{
    static const std::vector<std::pair<const char*, PictureCase>> all{
        {"empty", {"", -1, {}}},
        {"corridor-step-5", {"corridor", 4, {}}},
        {"corridor-step-7", {"corridor", 6, {}}},
        {"corridor-step-35", {"corridor", 34, {}}},
        {"corridor", {"corridor", -1, {}}},
        {"office", {"office", -1, {}}},
        {"hall", {"hall", -1, {}}},
        {"selection", {"corridor", -1, selectLargest}},
        {"unfitted", {"clutter", -1, showUnfitted}},
        {"uncertainty", {"corridor", -1, showUncertainty}},
        {"dark", {"office", -1, [](View3d& view) { view.setTheme(Theme::Dark); }}},
        {"by-height",
         {"stairs", -1,
          [](View3d& view) {
              LayerSettings layers;
              layers.colourBy = ColourBy::Height;
              view.setLayers(layers);
          }}},
    };
    return all;
}

}  // namespace

void View3dPicturesTest::initTestCase()
{
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
}

void View3dPicturesTest::aBlankPictureIsFound()
{
    QImage blank(kSize, QImage::Format_RGB888);
    blank.fill(Qt::lightGray);

    QVERIFY(differenceFromReference(blank, "corridor").contains("blank"));
}

void View3dPicturesTest::picturesAreAsTheyWere_data()
{
    QTest::addColumn<int>("place");
    for (std::size_t i = 0; i < cases().size(); ++i)
        QTest::newRow(cases()[i].first) << static_cast<int>(i);
}

void View3dPicturesTest::picturesAreAsTheyWere()
{
    QFETCH(int, place);
    const auto& [name, what] = cases()[static_cast<std::size_t>(place)];

    const QString difference = differenceFromReference(pictureOfCase(what), name);

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

void View3dPicturesTest::theSamePictureComesEveryTime()
{
    const PictureCase office{"office", -1, {}};

    QCOMPARE(pictureOfCase(office), pictureOfCase(office));
}

void View3dPicturesTest::partsGiveThePictureThatIsDrawnAtOnce()
{
    MapScene scene;
    const auto window = OffscreenWindow::open(OffscreenRenderer::Auto, kSize.width(), kSize.height());
    QVERIFY(window);
    (*window)->AddRenderer(scene.renderer());
    scene.setMap(shownRoom("office"));
    scene.setCamera(namedView(NamedView::Iso, scene.bounds(), 1.6, {}));
    drawScene(scene, **window);
    const QImage atOnce = pictureOf(**window);

    PartwiseDrawing parts(scene, **window);
    parts.begin(30'000);
    int drawn = 1;
    while (!parts.drawNext())
        ++drawn;

    QVERIFY(drawn >= 3);
    QCOMPARE(pictureOf(**window), atOnce);
    (*window)->RemoveRenderer(scene.renderer());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::View3dPicturesTest)
#include "view3d_pictures_test.moc"
