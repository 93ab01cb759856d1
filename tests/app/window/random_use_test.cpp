// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <QApplication>
#include <QtTest>

#include "app/window/waiting.h"
#include "tests/app/window/random_user.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

QStringList complaints;

void listen(QtMsgType type, const QMessageLogContext&, const QString& text)
{
    // What the offscreen platform cannot do concerns nobody.
    if (type == QtDebugMsg || type == QtInfoMsg || text.startsWith(QLatin1String("This plugin does not support")))
        return;
    complaints.push_back(text);
}

/// VTK's warnings and errors.
class VtkListener : public vtkOutputWindow {
public:
    static VtkListener* New();
    vtkTypeMacro(VtkListener, vtkOutputWindow);
    void DisplayText(const char* text) override { complaints.push_back(QString::fromUtf8(text)); }
};

vtkStandardNewMacro(VtkListener);

}  // namespace

/// Random use: 200 events, and with PLANEWRIGHT_TEST_LONG set 5,000.
class RandomUseTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingBreaksAndNothingComplains_data();
    void nothingBreaksAndNothingComplains();

private:
    QTemporaryDir folder_;
};

void RandomUseTest::initTestCase()
{
    useFixedLook();
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    vtkOutputWindow::SetInstance(vtkSmartPointer<VtkListener>::New());
}

void RandomUseTest::nothingBreaksAndNothingComplains_data()
{
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<int>("events");
    const bool isLong = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG");
    for (unsigned seed = 1; seed <= (isLong ? 10U : 2U); ++seed)
        QTest::addRow("seed %u", seed) << seed << (isLong ? 500 : 100);
}

void RandomUseTest::nothingBreaksAndNothingComplains()
{
    QFETCH(unsigned, seed);
    QFETCH(int, events);
    auto opened = ShownWindow::open(folder_.filePath(QStringLiteral("settings-%1.ini").arg(seed)));
    QVERIFY2(opened, opened ? "" : opened.error().message.c_str());
    ShownWindow& shown = **opened;
    QVERIFY(shown.scanCorridor());
    complaints.clear();
    const QtMessageHandler before = qInstallMessageHandler(listen);

    {
        RandomUser user(shown, folder_.path(), seed);
        for (int i = 0; i < events && complaints.isEmpty(); ++i)
            user.act();
        if (!complaints.isEmpty()) {
            qInstallMessageHandler(before);
            QFAIL(qPrintable(complaints.join(QLatin1Char('\n')) + "\nafter:\n" + user.deeds().join(QLatin1Char('\n'))));
        }
    }
    // Whatever was opened and edited last: all of it can be taken back, and made again.
    (void)shown.parts.session.stopMotion();
    QVERIFY(waitForRest(shown.parts, kPatience) || shown.parts.fault);
    const std::size_t edits = shown.parts.edits.inForce().size();
    const std::size_t most = shown.parts.undo.entries().size();
    std::size_t undone = 0;
    for (; undone <= most && shown.action("actUndo")->isEnabled(); ++undone)
        shown.action("actUndo")->trigger();
    QVERIFY(shown.parts.edits.inForce().empty());
    QVERIFY(!shown.action("actUndo")->isEnabled());
    for (std::size_t i = 0; i < undone; ++i)
        shown.action("actRedo")->trigger();
    QCOMPARE(shown.parts.edits.inForce().size(), edits);
    opened->reset();
    qInstallMessageHandler(before);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(QLatin1Char('\n'))));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::RandomUseTest)
#include "random_use_test.moc"
