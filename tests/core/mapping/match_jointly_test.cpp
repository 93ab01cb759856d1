// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/match_jointly.h"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>
#include <QtTest>

#include "tests/core/mapping/known_planes.h"
#include "tests/core/mapping/simulated_floor.h"
#include "tests/test_program.h"

namespace planewright {

class MatchJointlyTest : public QObject {
    Q_OBJECT

private slots:
    void ofAllSetsItFindsTheLargestAndOfTheseTheLikeliest();
    void movedFurnitureDoesNotPullTheWalls();
    void aPlaneThatMayBeEitherOfTwoHasARival();
    void twoPlanesOfAStopAreNotBothOnePlaneOfTheMap();
    void whatAnotherPlaneOfTheStopMayBeIsContested();
    void partsOfOnePlaneCountOnce();
    void theWorkIsBounded();
};

namespace {

/// A stop's plane at the origin with planes of the map at these offsets along its normal.
MatchChoices choicesAt(const Eigen::Vector3d& normal, std::initializer_list<double> offsets, double sigma = 3e-3)
{
    const UncertainPlane seen = planeKnownTo(normal, 2.0, 1e-3, sigma);
    MatchChoices choices;
    choices.jacobian = poseJacobian(seen, {});
    for (const double offset : offsets)
        choices.candidates.push_back({choices.candidates.size(), {0.0, 0.0, offset}, 2.0 * seen.covariance});
    return choices;
}

/// Each candidate another plane of the map.
std::vector<MatchChoices> allOfTheirOwn(std::vector<MatchChoices> planes)
{
    std::size_t known = 0;
    for (MatchChoices& plane : planes) {
        for (MatchCandidate& candidate : plane.candidates)
            candidate.known = known++;
    }
    return planes;
}

Matrix6d wideCovariance()
{
    Vector6d variances;
    variances << Eigen::Vector3d::Constant(square(0.02)), Eigen::Vector3d::Constant(square(0.1));
    return variances.asDiagonal();
}

/// χ² of a set of pairs by its joint covariance, all at once.
double jointChiSquare(std::span<const MatchChoices> planes, const std::vector<int>& chosen, const Matrix6d& covariance)
{
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (chosen[i] >= 0)
            used.push_back(i);
    }
    const auto size = static_cast<Eigen::Index>(3 * used.size());
    Eigen::VectorXd apart(size);
    Eigen::MatrixXd jacobian(size, 6);
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t n = 0; n < used.size(); ++n) {
        const auto at = static_cast<Eigen::Index>(3 * n);
        const MatchCandidate& candidate = planes[used[n]].candidates[static_cast<std::size_t>(chosen[used[n]])];
        apart.segment<3>(at) = candidate.apart;
        jacobian.middleRows<3>(at) = planes[used[n]].jacobian;
        spread.block<3, 3>(at, at) = candidate.noise;
    }
    spread += jacobian * covariance * jacobian.transpose();
    return size == 0 ? 0.0 : apart.dot(spread.llt().solve(apart));
}

}  // namespace

/// Against all sets, on 60 small random problems: as many pairs as the largest set whose joint χ² is within the limit,
/// or at most one less, since the search tests pairs one by one as well; and the same χ² for its own set.
void MatchJointlyTest::ofAllSetsItFindsTheLargestAndOfTheseTheLikeliest()
{
    Random random(11);
    int same = 0;
    constexpr int kProblems = 60;
    for (int problem = 0; problem < kProblems; ++problem) {
        const Vector6d error = drawn(wideCovariance(), random);
        std::vector<MatchChoices> planes;
        for (int i = 0; i < 5; ++i) {
            const Eigen::Vector3d normal =
                Eigen::Vector3d::Unit(i % 3) * (i < 3 ? 1.0 : -1.0) + 0.1 * Eigen::Vector3d::Unit((i + 1) % 3);
            MatchChoices& plane = planes.emplace_back(choicesAt(normal, {0.0, 0.0}));
            plane.candidates[0].apart = plane.jacobian * error + drawn(plane.candidates[0].noise, random);
            plane.candidates[1].apart = plane.candidates[0].apart;
            plane.candidates[1].apart.z() += random.uniform(-0.3, 0.3);
            if (random.uniform() < 0.5)
                std::swap(plane.candidates[0], plane.candidates[1]);
        }
        planes = allOfTheirOwn(std::move(planes));

        const JointMatch found = matchJointly(planes, wideCovariance());

        int most = 0;
        double least = 0.0;
        std::vector<int> best;
        std::vector<int> chosen(planes.size(), -1);
        for (int code = 0; code < 243; ++code) {
            int pairs = 0;
            for (std::size_t i = 0, rest = static_cast<std::size_t>(code); i < planes.size(); ++i, rest /= 3) {
                chosen[i] = static_cast<int>(rest % 3) - 1;
                pairs += chosen[i] >= 0 ? 1 : 0;
            }
            const double chi = jointChiSquare(planes, chosen, wideCovariance());
            if (chi <= chiSquareLimit(3 * pairs) && (pairs > most || (pairs == most && chi < least))) {
                most = pairs;
                least = chi;
                best = chosen;
            }
        }
        QVERIFY(!found.cutShort);
        QVERIFY(found.pairs >= most - 1 && found.pairs <= most);
        std::vector<int> own(planes.size(), -1);
        for (std::size_t i = 0; i < planes.size(); ++i) {
            if (found.chosen[i])
                own[i] = static_cast<int>(*found.chosen[i]);
        }
        QVERIFY(std::abs(found.chiSquare - jointChiSquare(planes, own, wideCovariance())) < 1e-6);
        same += own == best ? 1 : 0;
    }
    QVERIFY(same >= kProblems - 3);
}

/// Three walls say that the pose is right, a cupboard alone that it is 8 cm off; the cupboard is seen best.
void MatchJointlyTest::movedFurnitureDoesNotPullTheWalls()
{
    const std::vector<MatchChoices> planes =
        allOfTheirOwn({choicesAt(Eigen::Vector3d::UnitX(), {0.08}, 1e-3), choicesAt(Eigen::Vector3d::UnitX(), {0.0}),
                       choicesAt(-Eigen::Vector3d::UnitX(), {0.0}), choicesAt(Eigen::Vector3d::UnitY(), {0.0})});

    const JointMatch found = matchJointly(planes, wideCovariance());

    QCOMPARE(found.pairs, 3);
    QVERIFY(!found.chosen[0]);
    QVERIFY(found.error.norm() < 1e-6);
}

void MatchJointlyTest::aPlaneThatMayBeEitherOfTwoHasARival()
{
    const std::vector<MatchChoices> planes =
        allOfTheirOwn({choicesAt(Eigen::Vector3d::UnitX(), {0.0}), choicesAt(-Eigen::Vector3d::UnitX(), {0.0}),
                       choicesAt(Eigen::Vector3d::UnitX(), {0.003, -0.004, 0.2})});

    const JointMatch found = matchJointly(planes, wideCovariance());

    QCOMPARE(found.pairs, 3);
    QCOMPARE(*found.chosen[2], std::size_t(0));
    QCOMPARE(found.rivals[2], std::vector<std::size_t>{1});
    QVERIFY(found.rivals[0].empty());
}

/// Both would fit, but the stop saw them side by side as two.
void MatchJointlyTest::twoPlanesOfAStopAreNotBothOnePlaneOfTheMap()
{
    std::vector<MatchChoices> planes{
        choicesAt(Eigen::Vector3d::UnitX(), {0.0}), choicesAt(-Eigen::Vector3d::UnitX(), {0.0}),
        choicesAt(Eigen::Vector3d::UnitX(), {0.001}), choicesAt(Eigen::Vector3d::UnitX(), {0.006})};
    planes[1].candidates[0].known = 1;
    planes[2].candidates[0].known = 2;
    planes[3].candidates[0].known = 2;

    const JointMatch both = matchJointly(planes, wideCovariance());
    QVERIFY(both.chosen[2] && both.chosen[3]);
    planes[2].others = {3};
    planes[3].others = {2};
    const JointMatch found = matchJointly(planes, wideCovariance());

    QVERIFY(found.chosen[2] && !found.chosen[3]);
    QCOMPARE(both.pairs, 3);
    QCOMPARE(found.pairs, 3);
}

/// Nothing but odometry tells which of two planes of the stop is the one that the map has.
void MatchJointlyTest::whatAnotherPlaneOfTheStopMayBeIsContested()
{
    std::vector<MatchChoices> planes{choicesAt(Eigen::Vector3d::UnitX(), {0.0}),
                                     choicesAt(Eigen::Vector3d::UnitX(), {0.08}),
                                     choicesAt(Eigen::Vector3d::UnitY(), {0.0})};
    planes[2].candidates[0].known = 1;
    planes[0].others = {1};
    planes[1].others = {0};

    const JointMatch found = matchJointly(planes, wideCovariance());

    QVERIFY(found.chosen[0] && !found.chosen[1]);
    QVERIFY(found.isContested[0]);
    QVERIFY(!found.isContested[2]);
    // Half a metre is more than odometry allows.
    planes[1].candidates[0].apart.z() = 0.5;
    QVERIFY(!matchJointly(planes, wideCovariance()).isContested[0]);
}

/// Two small parts lie 8 cm behind a wall, and one place of the stop has them on the wall, another the wall itself.
void MatchJointlyTest::partsOfOnePlaneCountOnce()
{
    std::vector<MatchChoices> planes{
        choicesAt(Eigen::Vector3d::UnitX(), {0.04}), choicesAt(Eigen::Vector3d::UnitX(), {-0.04}),
        choicesAt(Eigen::Vector3d::UnitX(), {-0.04}), choicesAt(Eigen::Vector3d::UnitY(), {0.0})};
    planes[3].candidates[0].known = 1;
    planes[0].others = {1, 2};
    planes[1].others = planes[2].others = {0};

    const JointMatch found = matchJointly(planes, wideCovariance());

    QCOMPARE(found.pairs, 2);
    const std::size_t wall = found.chosen[0] ? 0 : 1;
    QVERIFY(found.chosen[wall] && found.isContested[wall]);
}

/// Twenty planes of which each may be any of eight, none of them together: it stops, and says so.
void MatchJointlyTest::theWorkIsBounded()
{
    std::vector<MatchChoices> planes;
    for (int i = 0; i < 20; ++i)
        planes.push_back(
            choicesAt(Eigen::Vector3d::Unit(i % 3), {0.01, 0.02, 0.03, 0.04, -0.01, -0.02, -0.03, -0.04}, 0.02));

    const JointMatch found = matchJointly(planes, wideCovariance());

    QVERIFY(found.cutShort);
    QVERIFY(found.pairs > 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MatchJointlyTest)
#include "match_jointly_test.moc"
