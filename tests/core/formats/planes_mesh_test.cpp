// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_mesh.h"

#include <sstream>

#include <Eigen/Geometry>
#include <QtTest>

#include "ply_parser.h"
#include "sample_planes.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

/// Area of triangles as vectors along their normals, added up.
Eigen::Vector3d areaOf(const Triangles& triangles)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& t : triangles)
        sum += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
    return sum;
}

}  // namespace

class PlanesMeshTest : public QObject {
    Q_OBJECT

private slots:
    void plyHasTheTrianglesOfEveryPlane();
    void plyOfNothingIsAFileToo();
    void objHasAGroupForEveryPlane();
    void aFullDiskIsNotSilent();
};

void PlanesMeshTest::plyHasTheTrianglesOfEveryPlane()
{
    std::ostringstream out;
    const std::vector<PlaneResult> planes{sampleCeiling(), knownPlane(5, "", {1, 0, 0}, 1, 1), sampleWall()};

    QVERIFY(writePlanesPly(out, planes).has_value());
    const PlyFile file = parsePly(out.str());

    QCOMPARE(file.elements.size(), std::size_t(2));
    QCOMPARE(file.bytesLeft, std::size_t(0));
    const auto& vertices = file.elements[0];
    const auto& faces = file.elements[1];
    QCOMPARE(vertices.name, std::string("vertex"));
    QCOMPARE(vertices.properties, (std::vector<std::string>{"double x", "double y", "double z", "int plane_id"}));
    QCOMPARE(faces.name, std::string("face"));
    QCOMPARE(faces.properties, (std::vector<std::string>{"list uchar int vertex_indices", "uchar red", "uchar green",
                                                         "uchar blue", "int plane_id"}));
    std::map<int, Triangles> triangles;
    for (const auto& face : faces.values) {
        QVERIFY(face.contains("vertex_indices.2") && !face.contains("vertex_indices.3"));
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& vertex =
                vertices.values.at(static_cast<std::size_t>(face.at("vertex_indices." + std::to_string(i))));
            QCOMPARE(vertex.at("plane_id"), face.at("plane_id"));
            corners[i] = {vertex.at("x"), vertex.at("y"), vertex.at("z")};
        }
        triangles[static_cast<int>(face.at("plane_id"))].push_back(corners);
    }
    QCOMPARE(triangles.size(), std::size_t(2));
    QVERIFY((areaOf(triangles[3]) - Eigen::Vector3d(0, 0, 11)).norm() < 1e-9);
    QVERIFY((areaOf(triangles[12]) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-9);
    QVERIFY(faces.values.front().at("red") != faces.values.back().at("red"));
}

void PlanesMeshTest::plyOfNothingIsAFileToo()
{
    std::ostringstream out;

    QVERIFY(writePlanesPly(out, {}).has_value());
    const PlyFile file = parsePly(out.str());

    QCOMPARE(file.elements.size(), std::size_t(2));
    QVERIFY(file.elements[0].values.empty());
    QCOMPARE(file.bytesLeft, std::size_t(0));
}

void PlanesMeshTest::objHasAGroupForEveryPlane()
{
    std::ostringstream out;
    QVERIFY(writePlanesObj(out, std::vector<PlaneResult>{sampleCeiling(), sampleWall()}).has_value());

    std::istringstream in(out.str());
    std::vector<Eigen::Vector3d> vertices;
    std::map<std::string, Triangles> groups;
    std::string group, line;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "g")
            words >> group;
        if (word == "v") {
            vertices.emplace_back();
            words >> vertices.back()[0] >> vertices.back()[1] >> vertices.back()[2];
        }
        if (word == "f") {
            std::array<std::size_t, 3> corners{};
            words >> corners[0] >> corners[1] >> corners[2];
            groups[group].push_back(
                {vertices.at(corners[0] - 1), vertices.at(corners[1] - 1), vertices.at(corners[2] - 1)});
        }
    }

    QCOMPARE(groups.size(), std::size_t(2));
    QVERIFY((areaOf(groups["plane_3"]) - Eigen::Vector3d(0, 0, 11)).norm() < 1e-9);
    QVERIFY((areaOf(groups["plane_12"]) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-9);
}

void PlanesMeshTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writePlanesPly(out, {}).error().code, ErrorCode::NotWritten);
    QCOMPARE(writePlanesObj(out, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PlanesMeshTest)
#include "planes_mesh_test.moc"
