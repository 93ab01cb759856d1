// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_search.h"

#include <cmath>

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// What a search among segments gave; all of them are candidates and seeds, in the order given.
struct Searched {
    std::vector<SegmentNumber> numbers;
    std::optional<FoundPlane> found;
    std::vector<FailedHypothesis> failures;

    std::vector<SegmentNumber> members() const { return found ? found->members : std::vector<SegmentNumber>{}; }
    std::vector<Test> tests() const { return found ? found->tests : std::vector<Test>{}; }
    std::vector<SegmentNumber> first(std::size_t count) const
    {
        return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)};
    }
};

Searched search(const Segments& segments, const PlaneParameters& parameters, std::size_t seeds = 1000)
{
    SegmentTable table;
    Searched searched;
    searched.numbers = append(table, segments);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < searched.numbers.size(); ++i)
        candidates.push_back({searched.numbers[i], i < seeds});
    searched.found = findPlane(candidates, table, parameters, &searched.failures);
    return searched;
}

/// The named test of the plane found, or of the first hypothesis that failed.
Test searchTest(const Segments& segments, const PlaneParameters& parameters, std::string_view name)
{
    const Searched searched = search(segments, parameters);
    if (searched.found)
        return testOf(searched.tests(), name);
    return searched.failures.empty() ? testOf({}, name) : testOf(searched.failures[0].tests, name);
}

/// True where just this test keeps the segments from being a plane.
bool failsBy(std::string_view name, const Segments& segments, const PlaneParameters& parameters)
{
    const Searched searched = search(segments, parameters);
    return !searched.found && searched.failures.size() == 1 &&
           failed(searched.failures[0].tests) == std::vector<std::string_view>{name};
}

bool isThere(const std::optional<FoundPlane>& found, const Eigen::Vector3d& normal, double distance)
{
    if (!found)
        return false;
    const double side = found->fit.normal.dot(normal) < 0.0 ? -1.0 : 1.0;
    return angleBetween(side * found->fit.normal, normal) < 1e-9 &&
           std::abs(side * found->fit.distance - distance) < 1e-9;
}

const Eigen::Vector3d kAhead = Eigen::Vector3d::UnitY();

}  // namespace

class PlaneSearchTest : public QObject {
    Q_OBJECT

private slots:
    void threeSegmentsOfDifferentSlicesMakeAPlane();
    void twoSlicesMakeNoHypothesisHoweverManySegmentsTheyHave();
    void aHypothesisPassesOverMoreSegmentsOfTheSameSlice();
    void neighboursWithinTheNoiseMakeNoHypothesis();
    void segmentsOnOneLineMakeNoHypothesis();
    void onlySeedsStartHypotheses();
    void segmentsThatAreNoSeedsSupport();
    void theBetterSupportedOfTwoPlanesComesFirst();
    void segmentsBeyondTheInlierDistanceDoNotSupport();
    void noiseWidensTheInlierDistance();
    void farGroupsInOnePlaneDoNotSupportEachOther();
    void groupsHangTogetherFromNeighbourToNeighbour();
    void groupsOnBothSidesOfAPillarSupportEachOther();
    void segmentsAreCounted();
    void slicesAreCounted();
    void slicesAreCountedOnceInWhateverOrderTheCandidatesCome();
    void pointsAreCounted();
    void extentIsTheShorterOne();
    void extentGrowsWithTheRange();
    void normalSigmaIsThatOfALineFitAcrossTheSlices();
    void incidenceIsTheMeanSineOfTheRays();
    void theSlicesOwnPlaneIsNone();
    void segmentsBesideThePlaneContradictIt();
    void onlyFacingSegmentsALittleOffContradict();
    void fittingErrorIsLimited();
    void aFailedHypothesisCoversItsSupport();
    void failuresNeedNotBeAskedFor();
    void nothingIsFoundAmongNothing();
};

void PlaneSearchTest::threeSegmentsOfDifferentSlicesMakeAPlane()
{
    const Eigen::Vector3d normal = Eigen::Vector3d(0.3, 0.8, -0.4).normalized();
    const auto tangents = tangentsOf(normal);
    const Sheet sheet{2.5 * normal, 1.5 * tangents.col(0), 0.1 * tangents.col(1), 3, 4};

    const Searched searched = search(sheet.segments(), lenient().planes);

    QVERIFY(isThere(searched.found, normal, 2.5));
    QVERIFY(searched.members() == searched.numbers);
    QVERIFY(allPass(searched.tests()));
    QVERIFY(searched.failures.empty());
}

void PlaneSearchTest::twoSlicesMakeNoHypothesisHoweverManySegmentsTheyHave()
{
    Segments segments;
    for (const double x : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0}) {
        for (const int step : {0, 1})
            segments.push_back(segmentBetween(step, {x, 4.0, 0.1 * step}, {x + 0.9, 4.0, 0.1 * step}));
    }

    const Searched searched = search(segments, lenient().planes);

    QVERIFY(!searched.found);
    QVERIFY(searched.failures.empty());
}

void PlaneSearchTest::aHypothesisPassesOverMoreSegmentsOfTheSameSlice()
{
    // The seed's two nearest neighbours are of one slice and span a slope with it; with the slice after it is a wall.
    PlaneParameters parameters = lenient().planes;
    parameters.inlierDistance = 0.01;
    const Segments segments{
        segmentBetween(0, {-1.0, 4.0, 0.0}, {1.0, 4.0, 0.0}),
        segmentBetween(1, {-1.0, 4.0, 0.1}, {1.0, 4.0, 0.1}),
        segmentBetween(1, {-1.0, 4.11, 0.0}, {1.0, 4.11, 0.0}),
        segmentBetween(2, {-1.0, 4.0, 0.2}, {1.0, 4.0, 0.2}),
    };

    const Searched searched = search(segments, parameters, 1);

    QVERIFY(isThere(searched.found, kAhead, 4.0));
    QVERIFY((searched.members() ==
             std::vector<SegmentNumber>{searched.numbers[0], searched.numbers[1], searched.numbers[3]}));
}

void PlaneSearchTest::neighboursWithinTheNoiseMakeNoHypothesis()
{
    // An end point of 10 mm in each of three directions strays by 17.3 mm: two standard deviations are 34.6 mm. Rows
    // 10 mm apart leave no other within that.
    Sheet sheet = wall(4);
    sheet.up = {0.0, 0.0, 0.01};
    PlaneParameters parameters = lenient().planes;
    parameters.baselineSigmas = 2.0;
    const Searched blurred = search(sheet.segments(), parameters);
    parameters.baselineSigmas = 0.5;
    const Searched sharp = search(sheet.segments(), parameters);

    QVERIFY(!blurred.found);
    QVERIFY(blurred.failures.empty());
    QVERIFY(isThere(sharp.found, kAhead, 4.0));
}

void PlaneSearchTest::segmentsOnOneLineMakeNoHypothesis()
{
    const Sheet line{{-3.0, 4.0, 0.3}, {0.9, 0.0, 0.0}, {1.0, 0.0, 0.0}, 5, 0};

    const Searched searched = search(line.segments(), lenient().planes);

    QVERIFY(!searched.found);
    QVERIFY(searched.failures.empty());
}

void PlaneSearchTest::onlySeedsStartHypotheses()
{
    const Searched none = search(wall(6).segments(), lenient().planes, 0);
    const Searched one = search(wall(6).segments(), lenient().planes, 1);

    QVERIFY(!none.found);
    QVERIFY(none.failures.empty());
    QVERIFY(one.found.has_value());
}

void PlaneSearchTest::segmentsThatAreNoSeedsSupport()
{
    const Searched searched = search(wall(6).segments(), lenient().planes, 1);

    QVERIFY(isThere(searched.found, kAhead, 4.0));
    QVERIFY(searched.members() == searched.numbers);
}

void PlaneSearchTest::theBetterSupportedOfTwoPlanesComesFirst()
{
    const Searched searched = search(wall(4, 1.0).segments() + wall(7).segments(), lenient().planes);

    QVERIFY(isThere(searched.found, kAhead, 4.0));
    QCOMPARE(searched.members().size(), std::size_t{7});
}

void PlaneSearchTest::segmentsBeyondTheInlierDistanceDoNotSupport()
{
    // Both ends count: 25 mm supports, 35 mm at one end does not.
    PlaneParameters parameters = lenient().planes;
    parameters.flatness = 0.1;
    const Segments near{segmentBetween(10, {-1.0, 4.025, 1.0}, {1.0, 4.0, 1.0})};
    const Segments far{segmentBetween(10, {-1.0, 4.035, 1.0}, {1.0, 4.0, 1.0})};

    const Searched withNear = search(wall(10).segments() + near, parameters, 1);
    const Searched withFar = search(wall(10).segments() + far, parameters, 1);

    QCOMPARE(withNear.members().size(), std::size_t{11});
    QCOMPARE(withFar.members().size(), std::size_t{10});
}

void PlaneSearchTest::noiseWidensTheInlierDistance()
{
    PlaneParameters parameters = lenient().planes;
    parameters.inlierSigmas = 3.0;
    Look noisy;
    noisy.sigma = 0.03;
    const Segments far{segmentBetween(10, {-1.0, 4.08, 1.0}, {1.0, 4.08, 1.0}, noisy)};

    const Searched searched = search(wall(10).segments() + far, parameters, 1);

    QCOMPARE(searched.members().size(), std::size_t{11});
}

void PlaneSearchTest::farGroupsInOnePlaneDoNotSupportEachOther()
{
    Look left;
    Look right;
    right.firstBeam = 600;
    right.lastBeam = 629;
    PlaneParameters parameters = lenient().planes;
    parameters.minSegments = 4;
    const Sheet one{{-3.0, 4.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0};
    const Sheet other{{2.0, 4.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0};
    const Segments groups = one.segments(left) + other.segments(right);

    parameters.mergeGap = 3.9;
    const Searched apart = search(groups, parameters);
    parameters.mergeGap = 4.1;
    const Searched together = search(groups, parameters);

    QVERIFY(!apart.found);
    QCOMPARE(apart.failures.size(), std::size_t{2});
    for (const FailedHypothesis& failure : apart.failures)
        QCOMPARE(testOf(failure.tests, "segments").value, 3.0);
    QCOMPARE(together.members().size(), std::size_t{6});
}

void PlaneSearchTest::groupsHangTogetherFromNeighbourToNeighbour()
{
    // Each segment faces only the next, by a beam; from the first to the last it is 6 m.
    PlaneParameters parameters = lenient().planes;
    parameters.mergeGap = 0.0;
    Segments stairs;
    for (int i = 0; i < 6; ++i) {
        Look look;
        look.firstBeam = 100 + 30 * i;
        look.lastBeam = 130 + 30 * i;
        stairs.push_back(segmentBetween(i, {-3.0 + i, 4.0, 0.1 * i}, {-2.0 + i, 4.0, 0.1 * i}, look));
    }

    const Searched searched = search(stairs, parameters, 1);

    QCOMPARE(searched.members().size(), std::size_t{6});
}

void PlaneSearchTest::groupsOnBothSidesOfAPillarSupportEachOther()
{
    PlaneParameters parameters = lenient().planes;
    parameters.mergeGap = 0.1;
    Look right;
    right.firstBeam = 160;
    right.lastBeam = 189;
    Segments segments = Sheet{{-3.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0}.segments() +
                        Sheet{{1.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0}.segments(right);

    const Searched open = search(segments, parameters);
    for (LineSegment& segment : segments)
        (segment.firstBeam == 160 ? segment.startShadowed : segment.endShadowed) = true;
    const Searched hidden = search(segments, parameters);

    QCOMPARE(open.members().size(), std::size_t{3});
    QCOMPARE(hidden.members().size(), std::size_t{6});
}

void PlaneSearchTest::segmentsAreCounted()
{
    PlaneParameters parameters = lenient().planes;
    parameters.minSegments = 6;

    QVERIFY(search(wall(6).segments(), parameters).found.has_value());
    QVERIFY(failsBy("segments", wall(5).segments(), parameters));
    QCOMPARE(searchTest(wall(5).segments(), parameters, "segments").value, 5.0);
}

void PlaneSearchTest::slicesAreCounted()
{
    // Two segments in each of three slices.
    Segments segments;
    for (const int step : {0, 1, 2}) {
        segments.push_back(segmentBetween(step, {-3.0, 4.0, 0.1 * step}, {-1.0, 4.0, 0.1 * step}));
        segments.push_back(segmentBetween(step, {1.0, 4.0, 0.1 * step}, {3.0, 4.0, 0.1 * step}));
    }
    PlaneParameters parameters = lenient().planes;
    parameters.minSlices = 3;
    QVERIFY(search(segments, parameters).found.has_value());

    parameters.minSlices = 4;
    QVERIFY(failsBy("slices", segments, parameters));
    QCOMPARE(searchTest(segments, parameters, "slices").value, 3.0);
    QCOMPARE(searchTest(segments, parameters, "segments").value, 6.0);
}

void PlaneSearchTest::slicesAreCountedOnceInWhateverOrderTheCandidatesCome()
{
    // A cluster lists the segments left over from a split after those that it had.
    const Sheet left{{-3.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0};
    const Sheet right{{1.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 3, 0};

    const Searched searched = search(left.segments() + right.segments(), lenient().planes);

    QCOMPARE(searched.members().size(), std::size_t{6});
    QCOMPARE(testOf(searched.tests(), "slices").value, 3.0);
}

void PlaneSearchTest::pointsAreCounted()
{
    // Four segments of 30 points.
    PlaneParameters parameters = lenient().planes;
    parameters.minPoints = 120;
    QVERIFY(search(wall(4).segments(), parameters).found.has_value());

    parameters.minPoints = 121;
    QVERIFY(failsBy("points", wall(4).segments(), parameters));
    QCOMPARE(searchTest(wall(4).segments(), parameters, "points").value, 120.0);
}

void PlaneSearchTest::extentIsTheShorterOne()
{
    // 2 m wide and four rows of 0.1 m: 0.3 m high.
    PlaneParameters parameters = lenient().planes;
    parameters.minExtent = 0.29;
    QVERIFY(search(wall(4).segments(), parameters).found.has_value());

    parameters.minExtent = 0.31;
    QVERIFY(failsBy("extent", wall(4).segments(), parameters));
    QVERIFY(std::abs(searchTest(wall(4).segments(), parameters, "extent").value - 0.3) < 1e-9);
}

void PlaneSearchTest::extentGrowsWithTheRange()
{
    // The middles of three rows are 4 m ahead at heights −0.1, 0 and 0.1 m: on average (4 + 2·sqrt(16.01))/3 m away.
    Sheet sheet = wall(3);
    sheet.corner.z() = -0.1;
    // Met at this sine, half of the angle is enough.
    const double range = (4.0 + 2.0 * std::sqrt(16.01)) / 3.0;
    const double incidence = (1.0 + 2.0 * 4.0 / std::sqrt(16.01)) / 3.0;
    PlaneParameters parameters = lenient().planes;
    parameters.minExtentAngle = degrees(5.6);
    QVERIFY(search(sheet.segments(), parameters).found.has_value());
    const double limit = range * std::tan(degrees(5.6)) * (1.0 - 0.5 * incidence);
    QVERIFY(std::abs(searchTest(sheet.segments(), parameters, "extent").limit - limit) < 1e-9);

    parameters.minExtentAngle = degrees(5.8);
    QVERIFY(failsBy("extent", sheet.segments(), parameters));
}

void PlaneSearchTest::normalSigmaIsThatOfALineFitAcrossTheSlices()
{
    // Four rows at heights 0, 0.1, 0.2 and 0.3 m, each with two ends of 10 mm noise and 5 mm flatness: the slope across
    // the rows is known to sqrt((0.01² + 0.005²)/(2·0.05)), that along them better.
    const double sigma = std::sqrt((0.01 * 0.01 + 0.005 * 0.005) / (2.0 * 0.05));
    PlaneParameters parameters = lenient().planes;
    parameters.maxNormalSigma = 1.001 * sigma;
    QVERIFY(search(wall(4).segments(), parameters).found.has_value());
    QVERIFY(std::abs(searchTest(wall(4).segments(), parameters, "normal_sigma").value / sigma - 1.0) < 1e-6);

    parameters.maxNormalSigma = 0.999 * sigma;
    QVERIFY(failsBy("normal_sigma", wall(4).segments(), parameters));
}

void PlaneSearchTest::incidenceIsTheMeanSineOfTheRays()
{
    // Rays to the middles, 4 m ahead at heights 0, 3 and 3·sqrt(7) m: sines 1, 4/5 and 4/sqrt(79).
    Look tall;
    const Segments segments{
        segmentBetween(0, {-1.0, 4.0, 0.0}, {1.0, 4.0, 0.0}, tall),
        segmentBetween(1, {-1.0, 4.0, 3.0}, {1.0, 4.0, 3.0}, tall),
        segmentBetween(2, {-1.0, 4.0, 3.0 * std::sqrt(7.0)}, {1.0, 4.0, 3.0 * std::sqrt(7.0)}, tall)};
    const double mean = (1.0 + 0.8 + 4.0 / std::sqrt(79.0)) / 3.0;
    PlaneParameters parameters = lenient().planes;
    parameters.minIncidence = std::asin(mean) - 1e-6;
    QVERIFY(search(segments, parameters).found.has_value());
    QVERIFY(std::abs(searchTest(segments, parameters, "incidence").value - mean) < 1e-9);

    parameters.minIncidence = std::asin(mean) + 1e-6;
    QVERIFY(failsBy("incidence", segments, parameters));
}

void PlaneSearchTest::theSlicesOwnPlaneIsNone()
{
    // Three slices at hardly different tilts see three lines that a plane through the scanner holds.
    Look look;
    look.viewpoint = {0.0, 0.0, 1.0};
    const Sheet sheet{{-1.0, 4.0, 1.0}, {2.0, 0.0, 0.0}, {0.0, 0.5, 0.0}, 4, 0};
    PlaneParameters parameters = lenient().planes;
    parameters.minIncidence = degrees(3.0);

    QVERIFY(failsBy("incidence", sheet.segments(look), parameters));
    QVERIFY(std::abs(searchTest(sheet.segments(look), parameters, "incidence").value) < 1e-12);
}

void PlaneSearchTest::segmentsBesideThePlaneContradictIt()
{
    // Three rows support a wall; beside each of their slices others stand off by 60 mm, twice the inlier distance.
    const auto standingOff = [](int count) {
        Segments segments;
        for (int i = 0; i < count; ++i)
            segments.push_back(segmentBetween(i % 3, {-1.0, 4.06, 1.0 + 0.1 * i}, {1.0, 4.06, 1.0 + 0.1 * i}));
        return segments;
    };
    const PlaneParameters parameters = lenient().planes;

    const Searched asMany = search(wall(3).segments() + standingOff(3), parameters, 1);
    const Searched oneMore = search(wall(3).segments() + standingOff(4), parameters, 1);

    QVERIFY(isThere(asMany.found, kAhead, 4.0));
    QCOMPARE(testOf(asMany.tests(), "contradictions").value, 3.0);
    QVERIFY(!oneMore.found);
    QVERIFY(failed(oneMore.failures[0].tests) == std::vector<std::string_view>{"contradictions"});
    QCOMPARE(testOf(oneMore.failures[0].tests, "contradictions").value, 4.0);
    QCOMPARE(testOf(oneMore.failures[0].tests, "contradictions").limit, 3.0);
}

void PlaneSearchTest::onlyFacingSegmentsALittleOffContradict()
{
    Look beside;
    beside.firstBeam = 300;
    beside.lastBeam = 329;
    const Segments strangers{
        segmentBetween(1, {-1.0, 4.13, 0.1}, {1.0, 4.13, 0.1}),          // more than four inlier distances off
        segmentBetween(1, {-1.0, 4.06, 0.2}, {1.0, 4.06, 0.2}, beside),  // seen by other beams
        segmentBetween(8, {-1.0, 4.06, 0.8}, {1.0, 4.06, 0.8}),          // six slices after the last
        segmentBetween(1, {-1.0, 4.06, 0.3}, {1.0, 3.0, 0.3}),           // one end far off
        segmentBetween(1 + 6, {-1.0, 3.95, 0.3}, {1.0, 4.0, 0.3}),       // contradicts: five slices after the last
    };

    const Searched searched = search(wall(3).segments() + strangers, lenient().planes, 1);

    QVERIFY(searched.members() == searched.first(3));
    QCOMPARE(testOf(searched.tests(), "contradictions").value, 1.0);
}

void PlaneSearchTest::fittingErrorIsLimited()
{
    // Rows off by +e, −e, −e, +e leave the wall of least squares where it is: E = e²/(σ² + flatness²).
    constexpr double kOff = 0.005;
    const double error = kOff * kOff / (0.002 * 0.002 + 0.001 * 0.001);
    Look sharp;
    sharp.sigma = 0.002;
    Segments segments;
    for (int i = 0; i < 4; ++i) {
        const double y = 4.0 + (i == 0 || i == 3 ? kOff : -kOff);
        segments.push_back(segmentBetween(i, {-1.0, y, 0.1 * i}, {1.0, y, 0.1 * i}, sharp));
    }
    PlaneParameters parameters = lenient().planes;
    parameters.flatness = 0.001;
    parameters.errorLimit = 1.001 * error;
    QVERIFY(isThere(search(segments, parameters).found, kAhead, 4.0));

    parameters.errorLimit = 0.999 * error;
    QVERIFY(failsBy("fitting_error", segments, parameters));
    QVERIFY(std::abs(searchTest(segments, parameters, "fitting_error").value / error - 1.0) < 1e-5);
}

void PlaneSearchTest::aFailedHypothesisCoversItsSupport()
{
    PlaneParameters parameters = lenient().planes;
    parameters.minSegments = 100;

    const Searched searched = search(wall(6).segments() + wall(4, 1.0).segments(), parameters);

    QVERIFY(!searched.found);
    QCOMPARE(searched.failures.size(), std::size_t{2});
    for (const FailedHypothesis& failure : searched.failures)
        QVERIFY(failed(failure.tests) == std::vector<std::string_view>{"segments"});
}

void PlaneSearchTest::failuresNeedNotBeAskedFor()
{
    SegmentTable table;
    append(table, wall(3).segments());
    PlaneParameters parameters = lenient().planes;
    parameters.minSegments = 4;

    QVERIFY(!findPlane({{0, true}, {1, true}, {2, true}}, table, parameters, nullptr));
}

void PlaneSearchTest::nothingIsFoundAmongNothing()
{
    const Searched searched = search({}, lenient().planes);

    QVERIFY(!searched.found);
    QVERIFY(searched.failures.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneSearchTest)
#include "plane_search_test.moc"
