// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QUrl>
#include <QtTest>

#include "app/files/recording_file.h"
#include "app/window/exports.h"
#include "app/window/waiting.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// What a depth camera 1.2 m above the floor of a room sees: 4 m to the wall ahead, 3 m to both sides, 1.4 m to the
/// ceiling; x right, y down, z ahead, the camera at `viewpoint`.
QByteArray roomAsPcd(const Eigen::Vector3d& viewpoint = Eigen::Vector3d::Zero())
{
    constexpr int kColumns = 160;
    constexpr int kRows = 120;
    QByteArray text = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                      QByteArray::number(kColumns) + "\nHEIGHT " + QByteArray::number(kRows) + "\nVIEWPOINT";
    for (const double value : viewpoint)
        text += " " + QByteArray::number(value);
    text += " 1 0 0 0\nDATA ascii\n";
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const double x = (column - 79.5) / 80.0;
            const double y = (row - 59.5) / 80.0;
            const double sideways = 3.0 / std::abs(x);
            const double upright = y > 0.0 ? 1.2 / y : 1.4 / -y;
            const double ahead = std::min({4.0, sideways, upright});
            const Eigen::Vector3d point = viewpoint + ahead * Eigen::Vector3d{x, y, 1.0};
            text += QByteArray::number(point.x(), 'f', 6) + " " + QByteArray::number(point.y(), 'f', 6) + " " +
                    QByteArray::number(point.z(), 'f', 6) + "\n";
        }
    }
    return text;
}

}  // namespace

/// Clouds of points in the window.
class ImportWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void init();
    void cleanup();
    void aCloudThatIsDroppedBecomesAScan();
    void aCloudThatIsNoneIsToldAndNothingIsOpened();
    void aCopyOfAnImportOpensWithTheSamePlanes();
    void aCopyOfAnImportKeepsItsPose();

private:
    QString write(const QString& name, const QByteArray& bytes);
    void drop(const QString& file);

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<ShownWindow> shown_;
};

void ImportWindowTest::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    auto shown = ShownWindow::open(folder_->filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
}

void ImportWindowTest::cleanup()
{
    shown_.reset();
    folder_.reset();
}

QString ImportWindowTest::write(const QString& name, const QByteArray& bytes)
{
    QFile file(folder_->filePath(name));
    if (file.open(QIODevice::WriteOnly))
        file.write(bytes);
    return file.fileName();
}

void ImportWindowTest::drop(const QString& file)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    MainWindow& window = *shown_->parts.window;
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent dropped(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &dropped);
}

void ImportWindowTest::aCloudThatIsDroppedBecomesAScan()
{
    drop(write("room.pcd", roomAsPcd()));
    WindowParts& parts = shown_->parts;

    QVERIFY(waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience));
    QVERIFY(waitForRest(parts, kPatience));

    QCOMPARE(parts.session.map()->slices.size(), std::size_t(120));
    // The wall ahead is where it is, in a frame with y ahead.
    const auto& planes = parts.shown->snapshot->planes;
    QVERIFY(std::any_of(planes.begin(), planes.end(), [](const auto& plane) {
        return plane->normal.y() > 0.9999 && std::abs(plane->distance - 4.0) < 0.002;
    }));
    QVERIFY(shown_->action("actImportCloud")->isEnabled());
}

void ImportWindowTest::aCloudThatIsNoneIsToldAndNothingIsOpened()
{
    drop(write("none.pcd", "ply\n"));
    WindowParts& parts = shown_->parts;

    QVERIFY(waitUntil([&] { return parts.window->banner().isVisible(); }, kPatience));

    QVERIFY2(parts.window->banner().text().contains("'ply' is no key of a .pcd header"),
             qPrintable(parts.window->banner().text()));
    QVERIFY(!parts.shown->snapshot);
}

void ImportWindowTest::aCopyOfAnImportOpensWithTheSamePlanes()
{
    drop(write("room.pcd", roomAsPcd()));
    WindowParts& parts = shown_->parts;
    QVERIFY(waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience));
    QVERIFY(waitForRest(parts, kPatience));
    const auto before = parts.shown->snapshot->planes;
    const QString copy = folder_->filePath("copy.pwscan");
    const auto writing = copyOf(parts, copy);
    QVERIFY(writing);
    QVERIFY((*writing)());

    const auto imported = parts.session.map()->snapshot;
    shown_->controllers->scan.open(copy);
    QVERIFY(waitUntil([&] { return parts.session.map()->snapshot && parts.session.map()->snapshot != imported; },
                      kPatience));
    QVERIFY(waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience));
    QVERIFY(waitForRest(parts, kPatience));

    const auto& after = parts.shown->snapshot->planes;
    QCOMPARE(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY(after[i]->normal == before[i]->normal);
        QVERIFY(after[i]->distance == before[i]->distance);
    }
}

void ImportWindowTest::aCopyOfAnImportKeepsItsPose()
{
    const Eigen::Vector3d viewpoint{1.0, 2.0, 3.0};
    drop(write("room.pcd", roomAsPcd(viewpoint)));
    WindowParts& parts = shown_->parts;
    QVERIFY(waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience));
    const QString copy = folder_->filePath("copy.pwscan");

    const auto writing = copyOf(parts, copy);

    QVERIFY(writing);
    QVERIFY((*writing)());
    const auto read = loadRecordingFile(copy.toStdString());
    QVERIFY(read && read->notes);
    QCOMPARE(QString::fromStdString(read->notes->scan.name), QStringLiteral("room.pcd"));
    QVERIFY(read->notes->scan.pose);
    QVERIFY(read->notes->scan.pose->translation == viewpoint);
    // The camera's y is down and its z ahead.
    QVERIFY(read->notes->scan.pose->rotation.isApprox(
        Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitX())), 1e-12));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ImportWindowTest)
#include "import_window_test.moc"
