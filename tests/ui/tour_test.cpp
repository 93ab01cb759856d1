// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/tour.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class TourTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void callOutsComeOneAfterTheOther();
    void escapeEndsThem();
    void whatCannotBeSeenIsPassedOver();
    void callOutsLieBesideWhatTheyPointAt();

private:
    std::unique_ptr<QWidget> window_;
    QWidget* left_ = nullptr;
    QWidget* right_ = nullptr;
    Tour* tour_ = nullptr;
};

void TourTest::init()
{
    window_ = std::make_unique<QWidget>();
    window_->resize(800, 600);
    left_ = new QWidget(window_.get());
    left_->setGeometry(0, 0, 200, 600);
    right_ = new QWidget(window_.get());
    right_->setGeometry(600, 100, 200, 200);
    tour_ = new Tour(window_.get());
    window_->show();
    tour_->start({{left_, "left"}, {right_, "right"}});
}

void TourTest::callOutsComeOneAfterTheOther()
{
    QCOMPARE(tour_->findChild<QLabel*>("tourText")->text(), QString("left"));

    tour_->findChild<QPushButton*>("tourNext")->click();
    QCOMPARE(tour_->findChild<QLabel*>("tourText")->text(), QString("right"));
    tour_->findChild<QPushButton*>("tourNext")->click();

    QVERIFY(!tour_->isVisible());
    QCOMPARE(tour_->stop(), std::size_t(2));
}

void TourTest::escapeEndsThem()
{
    QTest::keyClick(tour_->findChild<QPushButton*>("tourNext"), Qt::Key_Escape);

    QVERIFY(!tour_->isVisible());
    QVERIFY(!window_->findChild<QFrame*>("tourRing")->isVisible());
}

void TourTest::whatCannotBeSeenIsPassedOver()
{
    tour_->end();
    left_->hide();

    tour_->start({{left_, "left"}, {right_, "right"}});

    QCOMPARE(tour_->stop(), std::size_t(1));
}

void TourTest::callOutsLieBesideWhatTheyPointAt()
{
    QVERIFY(window_->rect().contains(tour_->geometry()));
    QVERIFY(!tour_->geometry().intersects(left_->geometry()));

    tour_->findChild<QPushButton*>("tourNext")->click();

    QVERIFY(window_->rect().contains(tour_->geometry()));
    QVERIFY(!tour_->geometry().intersects(right_->geometry()));
    QCOMPARE(window_->findChild<QFrame*>("tourRing")->geometry(), right_->geometry());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::TourTest)
#include "tour_test.moc"
