// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_dxf.h"

#include <clocale>
#include <dime/Input.h>
#include <dime/Layer.h>
#include <dime/Model.h>
#include <dime/entities/Entity.h>
#include <dime/sections/EntitiesSection.h>
#include <fstream>
#include <map>
#include <sstream>

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/dxf_text.h"
#include "tests/test_program.h"

using namespace planewright;

/// Drawings are read back with dime, a library of their own.
class PlanesDxfTest : public QObject {
    Q_OBJECT

private slots:
    void facesAndRingsAreThoseOfTheOutline();
    void everyClassHasALayer();
    void coordinatesHaveNineDigitsWhateverTheLocale();
    void aPlanIsCutAtItsHeight();
    void theFloorIsTheLargestPlaneOfItsClass();
    void noPlanesGiveAnEmptyDrawing();
    void layerNamesAreThoseThatRelease12Allows();
    void aStreamThatFailsIsNotWritten();

private:
    struct Entity {
        std::string kind;
        std::string layer;
        std::vector<Eigen::Vector3d> vertices;
    };
    static std::vector<Entity> readBack(const std::string& text, std::vector<std::string>* layers = nullptr);
};

namespace {

/// A wall in the plane y = 2 with a door in it, from the floor at -0.9 m on.
PlaneResult wall()
{
    auto plane = std::make_shared<Plane>();
    plane->id = 3;
    plane->normal = Eigen::Vector3d::UnitY();
    plane->distance = 2.0;
    PlaneResult result;
    result.plane = plane;
    result.className = "wall";
    // Counter-clockwise seen from +n, which looks back at the laser from behind the wall.
    result.outline.parts = {{{{-1.0, 2.0, -0.9}, {-1.0, 2.0, 1.6}, {3.0, 2.0, 1.6}, {3.0, 2.0, -0.9}},
                             {{{0.0, 2.0, -0.8}, {1.0, 2.0, -0.8}, {1.0, 2.0, 1.2}, {0.0, 2.0, 1.2}}}}};
    result.outline.area = 10.0 - 2.0;
    return result;
}

PlaneResult level(double height, double size, const char* className)
{
    auto plane = std::make_shared<Plane>();
    plane->id = 5;
    plane->normal = Eigen::Vector3d::UnitZ();
    plane->distance = height;
    PlaneResult result;
    result.plane = plane;
    result.className = className;
    result.outline.parts = {{{{0.0, 0.0, height}, {size, 0.0, height}, {size, size, height}, {0.0, size, height}}, {}}};
    result.outline.area = size * size;
    result.outline.centroid = {size / 2.0, size / 2.0, height};
    return result;
}

std::string drawingOf(const std::vector<PlaneResult>& planes)
{
    std::ostringstream out;
    if (!writePlanesDxf(out, planes))
        return {};
    return out.str();
}

bool holds(const std::vector<Eigen::Vector3d>& vertices, const Eigen::Vector3d& vertex)
{
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const Eigen::Vector3d& v) { return (v - vertex).norm() < 1e-6; });
}

}  // namespace

std::vector<PlanesDxfTest::Entity> PlanesDxfTest::readBack(const std::string& text, std::vector<std::string>* layers)
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.dxf").toStdString();
    std::ofstream(path, std::ios::binary) << text;
    dimeInput input;
    if (!input.setFile(path.c_str()))
        qFatal("dime does not open the file");
    dimeModel model;
    if (!model.read(&input))
        qFatal("dime does not read the drawing");
    for (int i = 0; layers != nullptr && i < model.getNumLayers(); ++i)
        layers->push_back(model.getLayer(i)->getLayerName());
    auto* const section = static_cast<dimeEntitiesSection*>(model.findSection("ENTITIES"));
    std::vector<Entity> entities;
    for (int i = 0; i < section->getNumEntities(); ++i) {
        dimeEntity* const entity = section->getEntity(i);
        dimeArray<dimeVec3f> vertices;
        dimeArray<int> indices;
        dimeVec3f direction;
        dxfdouble thickness = 0.0;
        entity->extractGeometry(vertices, indices, direction, thickness);
        Entity read{entity->getEntityName(), entity->getLayer()->getLayerName(), {}};
        for (int v = 0; v < vertices.count(); ++v)
            read.vertices.emplace_back(vertices[v][0], vertices[v][1], vertices[v][2]);
        entities.push_back(std::move(read));
    }
    return entities;
}

void PlanesDxfTest::facesAndRingsAreThoseOfTheOutline()
{
    const auto entities = readBack(drawingOf({wall()}));

    double area = 0.0;
    int rings = 0;
    for (const Entity& entity : entities) {
        QCOMPARE(entity.layer, std::string("wall"));
        QVERIFY(entity.vertices.size() >= 3);
        for (const Eigen::Vector3d& vertex : entity.vertices)
            QVERIFY(std::abs(vertex.y() - 2.0) < 1e-9);
        if (entity.kind == "3DFACE") {
            const Eigen::Vector3d cross = (entity.vertices[1] - entity.vertices[0])
                                              .cross(Eigen::Vector3d(entity.vertices[2] - entity.vertices[0]));
            QVERIFY(cross.y() > 0.0);  // counter-clockwise seen from +n
            area += 0.5 * cross.norm();
        } else {
            QCOMPARE(entity.kind, std::string("POLYLINE"));
            ++rings;
            QVERIFY(holds(entity.vertices, {0.0, 2.0, -0.8}) || holds(entity.vertices, {-1.0, 2.0, -0.9}));
        }
    }
    QCOMPARE(rings, 2);
    QVERIFY(std::abs(area - 8.0) < 1e-6);  // 4 m x 2.5 m without the door of 1 m x 2 m
}

void PlanesDxfTest::everyClassHasALayer()
{
    std::vector<std::string> layers;
    const auto entities = readBack(
        drawingOf({wall(), level(-0.9, 4.0, "floor"), level(0.0, 1.0, "Tür 1"), level(0.0, 1.0, "")}), &layers);

    std::map<std::string, int> faces;
    for (const Entity& entity : entities)
        faces[entity.layer] += entity.kind == "3DFACE" ? 1 : 0;
    QCOMPARE(faces["floor"], 2);
    QCOMPARE(faces["T__r_1"], 2);
    QCOMPARE(faces["other"], 2);
    for (const char* name : {"wall", "floor", "T__r_1", "other"})
        QCOMPARE(std::count(layers.begin(), layers.end(), name), 1);
}

void PlanesDxfTest::coordinatesHaveNineDigitsWhateverTheLocale()
{
    PlaneResult plane = level(1.23456789, 4.0, "floor");
    const char* const before = std::setlocale(LC_ALL, "de_DE.UTF-8");

    const std::string text = drawingOf({plane});

    std::setlocale(LC_ALL, "C.UTF-8");
    QVERIFY2(before != nullptr, "the locale de_DE.UTF-8 is not there");
    QVERIFY(text.find(" 30\n1.23456789\n") != std::string::npos);
    QVERIFY(text.find(',') == std::string::npos);
}

void PlanesDxfTest::aPlanIsCutAtItsHeight()
{
    std::ostringstream out;

    QVERIFY(writeFloorPlanDxf(out, std::vector{wall(), level(-0.9, 4.0, "floor")}, -0.9 + 1.0));

    const auto entities = readBack(out.str());
    QCOMPARE(entities.size(), std::size_t(2));  // left and right of the door
    for (const Entity& entity : entities) {
        QCOMPARE(entity.kind, std::string("LINE"));
        QCOMPARE(entity.layer, std::string("wall"));
        QCOMPARE(entity.vertices.size(), std::size_t(2));
        QCOMPARE(entity.vertices[0].z(), 0.0);
        QCOMPARE(entity.vertices[1].z(), 0.0);
    }
    QVERIFY(holds(entities[0].vertices, {3.0, 2.0, 0.0}) && holds(entities[0].vertices, {1.0, 2.0, 0.0}));
    QVERIFY(holds(entities[1].vertices, {0.0, 2.0, 0.0}) && holds(entities[1].vertices, {-1.0, 2.0, 0.0}));
}

void PlanesDxfTest::theFloorIsTheLargestPlaneOfItsClass()
{
    QCOMPARE(
        *floorHeight(std::vector{level(-0.5, 1.0, "floor"), level(-0.9, 4.0, "floor"), level(1.6, 5.0, "ceiling")}),
        -0.9);
    QVERIFY(!floorHeight(std::vector{wall()}));
    QVERIFY(!floorHeight({}));
}

void PlanesDxfTest::noPlanesGiveAnEmptyDrawing()
{
    QVERIFY(readBack(drawingOf({})).empty());
}

void PlanesDxfTest::layerNamesAreThoseThatRelease12Allows()
{
    QCOMPARE(layerName("wall-2_b$"), std::string("wall-2_b$"));
    QCOMPARE(layerName("a b\n0"), std::string("a_b_0"));
    QCOMPARE(layerName(std::string(40, 'x')), std::string(31, 'x'));
    QCOMPARE(layerName(""), std::string("other"));
}

void PlanesDxfTest::aStreamThatFailsIsNotWritten()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QVERIFY(writePlanesDxf(out, std::vector{wall()}).error().code == ErrorCode::NotWritten);
    QVERIFY(writeFloorPlanDxf(out, std::vector{wall()}, 0.1).error().code == ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PlanesDxfTest)
#include "planes_dxf_test.moc"
