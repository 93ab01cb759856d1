// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#if defined(QT_WIDGETS_LIB)
#include <QApplication>
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
#endif
#include <QtTest>

// A program of tests has the tests of one folder, a class for each source; its first argument names the source without
// its ending, what follows is for QtTest. A program of one class needs no name.

namespace planewright {

/// Runs one class of tests: QtTest's arguments; gives the number of functions that failed.
using TestRun = int (*)(int argc, char** argv);

/// Makes a class of tests known to the program; `file` is its source.
struct TestEntry {
    TestEntry(const char* file, TestRun run);
};

#if defined(QT_WIDGETS_LIB)
using TestGuiApplication = QApplication;
#elif defined(QT_GUI_LIB)
using TestGuiApplication = QGuiApplication;
#endif

template <class Test, class Application>
int runTest(int argc, char** argv)
{
    Application application(argc, argv);
    application.setAttribute(Qt::AA_Use96Dpi, true);  // pictures and sizes are the same on every screen
    Test test;
    return QTest::qExec(&test, argc, argv);
}

}  // namespace planewright

#define PLANEWRIGHT_TEST_NAMED(name, ...) \
    static const planewright::TestEntry name{__FILE__, planewright::runTest<__VA_ARGS__>};
#define PLANEWRIGHT_TEST_NUMBERED(number, ...) PLANEWRIGHT_TEST_NAMED(kTestEntry##number, __VA_ARGS__)
#define PLANEWRIGHT_TEST_COUNTED(number, ...) PLANEWRIGHT_TEST_NUMBERED(number, __VA_ARGS__)

/// A class of tests that needs no display.
#define PLANEWRIGHT_TEST(Class) PLANEWRIGHT_TEST_COUNTED(__COUNTER__, Class, QCoreApplication)

/// A class of tests with windows or pictures.
#define PLANEWRIGHT_GUI_TEST(Class) PLANEWRIGHT_TEST_COUNTED(__COUNTER__, Class, planewright::TestGuiApplication)
