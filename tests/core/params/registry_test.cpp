// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/registry.h"

#include <clocale>
#include <limits>
#include <set>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class RegistryTest : public QObject {
    Q_OBJECT

private slots:
    void everyKeyIsNamedOnceAfterItsPart();
    void everyRowSaysWhatItIs();
    void everyPrintedDefaultReadsBackAsItself();
    void bothEndsOfEveryRangeAreAllowedAndNothingBeyond();
    void anAngleIsGivenInDegreesAndKeptInRadians();
    void limitsOfAnglesAreShownAsTheyWereWritten();
    void aChoiceIsGivenByItsWord();
    void aValueThatIsNoAllowedNumberIsRefused_data();
    void aValueThatIsNoAllowedNumberIsRefused();
    void aRefusedValueLeavesTheParameterAsItWas();
    void aRefusalNamesTheKeyTheValueAndWhatIsAllowed_data();
    void aRefusalNamesTheKeyTheValueAndWhatIsAllowed();
    void negativeZeroIsZero();
    void anUnknownKeyIsRefusedWithTheNearestKnownOne();
    void anUnknownKeyFarFromAllIsRefusedWithoutAGuess();
    void anAssignmentIsSplitAtItsFirstEqualsSign();
    void noLocaleChangesWhatIsReadOrPrinted();
    void parametersOfMapsAreApartFromThoseOfExtractions();
};

namespace {

QString text(std::string_view view)
{
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

}  // namespace

void RegistryTest::everyKeyIsNamedOnceAfterItsPart()
{
    const QRegularExpression form(
        "^(method|noise|sensor|segments|assignment|clusters|planes|likelihood|schedule)\\.[a-z]+(-[a-z]+)*$");
    std::set<std::string_view> keys;
    for (const ParameterRow& row : parameterRows()) {
        QVERIFY2(form.match(text(row.key)).hasMatch(), qPrintable(text(row.key)));
        QVERIFY2(keys.insert(row.key).second, qPrintable(text(row.key)));
    }
    QVERIFY(keys.contains("noise.range-constant"));
    QVERIFY(keys.contains("schedule.remaining-every"));
}

void RegistryTest::everyRowSaysWhatItIs()
{
    for (const ParameterRow& row : parameterRows()) {
        QVERIFY2(row.meaning.size() > 10 && row.meaning.ends_with('.'), qPrintable(text(row.key)));
        QVERIFY2(row.lowest < row.highest, qPrintable(text(row.key)));
        QCOMPARE(row.choices.empty(), row.unit != Unit::Choice && row.unit != Unit::Switch);
        QCOMPARE(row.unitName == "deg", row.unit == Unit::Angle);
        QCOMPARE(row.unitName == "m", row.unit == Unit::Metre);
    }
}

void RegistryTest::everyPrintedDefaultReadsBackAsItself()
{
    const Parameters defaults;
    for (const ParameterRow& row : parameterRows()) {
        const std::string printed = printParameter(defaults, row.key);
        Parameters parameters;

        const auto done = setParameter(parameters, row.key, printed);

        QVERIFY2(done, qPrintable(text(row.key)));
        QCOMPARE(printParameter(parameters, row.key), printed);
    }
}

void RegistryTest::bothEndsOfEveryRangeAreAllowedAndNothingBeyond()
{
    const double infinity = std::numeric_limits<double>::infinity();
    for (const ParameterRow& row : parameterRows()) {
        if (!row.choices.empty())
            continue;
        const auto allows = [&](double value) {
            Parameters parameters;
            return setParameter(parameters, row.key, QByteArray::number(value, 'g', 17).toStdString()).has_value();
        };
        QVERIFY2(allows(row.lowest), qPrintable(text(row.key)));
        QVERIFY2(allows(row.highest), qPrintable(text(row.key)));
        QVERIFY2(!allows(std::nextafter(row.lowest, -infinity)), qPrintable(text(row.key)));
        QVERIFY2(!allows(std::nextafter(row.highest, infinity)), qPrintable(text(row.key)));
    }
}

void RegistryTest::anAngleIsGivenInDegreesAndKeptInRadians()
{
    Parameters parameters;

    QVERIFY(setParameter(parameters, "segments.incidence-limit", "30"));

    QVERIFY(std::abs(parameters.segments.incidenceLimit - std::numbers::pi / 6.0) < 1e-15);
    QCOMPARE(printParameter(parameters, "segments.incidence-limit"), std::string("30"));
}

void RegistryTest::limitsOfAnglesAreShownAsTheyWereWritten()
{
    for (const ParameterRow& row : parameterRows()) {
        if (row.key == "segments.incidence-limit") {
            QVERIFY(row.lowest == 1.0);
            QVERIFY(row.highest == 45.0);
        }
    }
}

void RegistryTest::aChoiceIsGivenByItsWord()
{
    Parameters parameters;

    QVERIFY(setParameter(parameters, "clusters.average", "lwma"));
    QVERIFY(setParameter(parameters, "planes.cost", "foot"));

    QVERIFY(parameters.clusters.average == MovingAverage::LinearlyWeighted);
    QVERIFY(parameters.planes.cost == PlaneCost::Foot);
    QCOMPARE(printParameter(parameters, "clusters.average"), std::string("lwma"));
    QCOMPARE(printParameter(parameters, "planes.cost"), std::string("foot"));
}

void RegistryTest::aValueThatIsNoAllowedNumberIsRefused_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    const QByteArray metres = "segments.split-distance";
    const QByteArray count = "segments.min-points";
    const QByteArray choice = "clusters.average";
    QTest::newRow("empty") << metres << QByteArray();
    QTest::newRow("no number") << metres << QByteArray("far");
    QTest::newRow("nan") << metres << QByteArray("nan");
    QTest::newRow("infinity") << metres << QByteArray("inf");
    QTest::newRow("infinity spelled out") << metres << QByteArray("infinity");
    QTest::newRow("too large for a double") << metres << QByteArray("1e999");
    QTest::newRow("blank before") << metres << QByteArray(" 0.1");
    QTest::newRow("blank after") << metres << QByteArray("0.1 ");
    QTest::newRow("line end after") << metres << QByteArray("0.1\n");
    QTest::newRow("only a blank") << metres << QByteArray(" ");
    QTest::newRow("unit after") << metres << QByteArray("0.1m");
    QTest::newRow("decimal comma") << metres << QByteArray("0,1");
    QTest::newRow("hexadecimal") << metres << QByteArray("0x1");
    QTest::newRow("zero byte after") << metres << QByteArray("0.1\0", 4);
    QTest::newRow("below the range") << metres << QByteArray("-0.001");
    QTest::newRow("above the range") << metres << QByteArray("0.501");
    QTest::newRow("half a point") << count << QByteArray("7.5");
    QTest::newRow("count below") << count << QByteArray("1");
    QTest::newRow("count above every int") << count << QByteArray("1e300");
    QTest::newRow("unknown word") << choice << QByteArray("median");
    QTest::newRow("place of a word") << choice << QByteArray("1");
    QTest::newRow("word in capitals") << choice << QByteArray("EWMA");
    QTest::newRow("no word") << choice << QByteArray();
}

void RegistryTest::aValueThatIsNoAllowedNumberIsRefused()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    Parameters parameters;

    const auto done = setParameter(parameters, key.toStdString(), value.toStdString());

    QVERIFY(!done);
    QVERIFY(done.error().code == ErrorCode::Usage);
}

void RegistryTest::aRefusedValueLeavesTheParameterAsItWas()
{
    Parameters parameters;
    QVERIFY(setParameter(parameters, "segments.min-points", "12"));

    QVERIFY(!setParameter(parameters, "segments.min-points", "13.5"));

    QCOMPARE(parameters.segments.minPoints, 12);
}

void RegistryTest::aRefusalNamesTheKeyTheValueAndWhatIsAllowed_data()
{
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("message");
    QTest::newRow("segments.split-distance")
        << "2"
        << "parameter segments.split-distance: '2' is not allowed; give a number from 0 to 0.5 m";
    QTest::newRow("segments.incidence-limit")
        << "0.5"
        << "parameter segments.incidence-limit: '0.5' is not allowed; give a number from 1 to 45 deg";
    QTest::newRow("segments.min-points")
        << "7.5"
        << "parameter segments.min-points: '7.5' is not allowed; give a whole number from 4 to 1000";
    QTest::newRow("clusters.decay") << "2"
                                    << "parameter clusters.decay: '2' is not allowed; give a number from 0 to 1";
    QTest::newRow("clusters.average") << "mean"
                                      << "parameter clusters.average: 'mean' is not allowed; give sma, lwma or ewma";
    QTest::newRow("planes.cost") << "l2"
                                 << "parameter planes.cost: 'l2' is not allowed; give ml or foot";
}

void RegistryTest::aRefusalNamesTheKeyTheValueAndWhatIsAllowed()
{
    QFETCH(QString, value);
    QFETCH(QString, message);
    Parameters parameters;

    const auto done = setParameter(parameters, QTest::currentDataTag(), value.toStdString());

    QVERIFY(!done);
    QCOMPARE(QString::fromStdString(done.error().message), message);
}

void RegistryTest::negativeZeroIsZero()
{
    Parameters parameters;

    QVERIFY(setParameter(parameters, "segments.min-length=-0.0").has_value());

    QCOMPARE(printParameter(parameters, "segments.min-length"), std::string("0"));
}

void RegistryTest::anUnknownKeyIsRefusedWithTheNearestKnownOne()
{
    Parameters parameters;

    const auto done = setParameter(parameters, "segment.min-point", "7");

    QVERIFY(!done);
    QVERIFY(done.error().code == ErrorCode::Usage);
    QCOMPARE(QString::fromStdString(done.error().message),
             QString("there is no parameter 'segment.min-point'; did you mean segments.min-points? "
                     "'planewright-cli params' lists all"));
}

void RegistryTest::anUnknownKeyFarFromAllIsRefusedWithoutAGuess()
{
    Parameters parameters;

    QVERIFY(nearestKey("colour").empty());
    QVERIFY(nearestKey(std::string(100000, 'x')).empty());
    QVERIFY(nearestKey("").empty());
    QCOMPARE(nearestKey("planes.coast"), std::string_view("planes.cost"));
    QCOMPARE(QString::fromStdString(setParameter(parameters, "colour", "7").error().message),
             QString("there is no parameter 'colour'; 'planewright-cli params' lists all"));
}

void RegistryTest::anAssignmentIsSplitAtItsFirstEqualsSign()
{
    Parameters parameters;

    QVERIFY(setParameter(parameters, "segments.min-points=9"));
    QCOMPARE(parameters.segments.minPoints, 9);
    QVERIFY(!setParameter(parameters, "segments.min-points=9=9"));
    QVERIFY(!setParameter(parameters, "=9"));
    QVERIFY(!setParameter(parameters, "segments.min-points="));
    QCOMPARE(QString::fromStdString(setParameter(parameters, "segments.min-points").error().message),
             QString("parameter 'segments.min-points': write key=value"));
}

void RegistryTest::noLocaleChangesWhatIsReadOrPrinted()
{
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr, "install the package locales-all");
    Parameters parameters;

    const bool pointIsRead = setParameter(parameters, "segments.split-distance", "0.125").has_value();
    const std::string printed = printParameter(parameters, "segments.split-distance");
    const bool commaIsRead = setParameter(parameters, "segments.split-distance", "0,125").has_value();
    std::setlocale(LC_ALL, "C");

    QVERIFY(pointIsRead);
    QCOMPARE(printed, std::string("0.125"));
    QVERIFY(!commaIsRead);
}

void RegistryTest::parametersOfMapsAreApartFromThoseOfExtractions()
{
    MappingParameters mapping;
    Parameters extraction;

    for (const ParameterRow& row : mappingRows())
        QVERIFY2(row.key.starts_with(kMappingPart), qPrintable(text(row.key)));
    QVERIFY(setParameter(mapping, "map.search-tilt=90"));
    QCOMPARE(mapping.searchTilt, degrees(90.0));
    QCOMPARE(printParameter(mapping, "map.search-tilt"), std::string("90"));
    QCOMPARE(setParameter(mapping, "map.gapp=1").error().message,
             std::string("there is no parameter 'map.gapp'; did you mean map.gap? 'planewright-cli params' lists all"));
    QCOMPARE(setParameter(extraction, "map.gap=1").error().message,
             std::string("parameter map.gap is one of maps of several stops: 'planewright-cli map' takes it"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RegistryTest)
#include "registry_test.moc"
