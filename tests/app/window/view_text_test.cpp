// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/view_text.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ViewTextTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead();
    void textsThatAreNotWholeGiveNothing_data();
    void textsThatAreNotWholeGiveNothing();
};

void ViewTextTest::whatIsWrittenIsRead()
{
    const ViewCamera camera{{1.5, -2.0, 0.25}, 12.5, 0.5, -0.75, 0.8, true};
    LayerSettings layers;
    layers[Layer::Points] = {false, 0.4, 3.5};
    layers.colourBy = ColourBy::Height;
    layers.labels = false;
    const ChosenParts chosen{{3, 7}, {{63, 3}}};

    const auto cameraRead = cameraOf(textOf(camera));
    const auto layersRead = layersOf(textOf(layers));
    const auto chosenRead = chosenOf(textOf(chosen));

    QVERIFY(cameraRead && layersRead && chosenRead);
    QVERIFY(cameraRead->target == camera.target);
    QCOMPARE(cameraRead->distance, 12.5);
    QVERIFY(cameraRead->parallel);
    QVERIFY(*layersRead == layers);
    QVERIFY(chosenRead->planes == chosen.planes);
    QVERIFY(chosenRead->segments == chosen.segments);
}

void ViewTextTest::textsThatAreNotWholeGiveNothing_data()
{
    QTest::addColumn<QString>("text");
    for (const char* text : {"", "{}x", "1 2 3", "nan 0 0 1 0 0 1 0", "0 0 0 -1 0 0 1 0", "0 0 0 1 0 0 9 0", "[]",
                             R"({"layers":[],"colour-by":0,"labels":true})", R"({"planes":[-1]})",
                             R"({"planes":["x"]})", R"({"planes":[],"segments":["1"]})", R"({"segments":["-1.2"]})"})
        QTest::newRow(text) << QString::fromLatin1(text);
}

void ViewTextTest::textsThatAreNotWholeGiveNothing()
{
    QFETCH(QString, text);

    QVERIFY(!cameraOf(text));
    QVERIFY(!layersOf(text));
    QVERIFY(!chosenOf(text));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ViewTextTest)
#include "view_text_test.moc"
