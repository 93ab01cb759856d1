// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/apply_edits.h"

#include <QTest>

#include "core/params/presets.h"
#include "core/types/angle.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"

using namespace planewright;

class ApplyEditsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void withoutEditsPlanesAreSharedAndHaveAClass();
    void namesAndClassesAreWhatWasSaidLast();
    void hiddenPlanesAreThereAndDeletedOnesAreNot();
    void aMergeIsOnePlaneOfAllSegments();
    void aMergeKeepsNameClassAndHiddenOfTheFirst();
    void aMergeOfCoplanarHalvesIsThePlane();
    void aSplitGivesItsPartsNewIds();
    void idsAreNeverUsedAgain();
    void editsOfWhatEditsMadeAreApplied();
    void editsOfPlanesThatAreNotThereAreProblems();
    void lockedPlanesAreLeftAlone();
    void aSplitOfOnePlaneIsAProblem();
    void editsThatNameTooFewOrTooManyPlanesAreProblems();
    void segmentsOfAnEditedSnapshotFollow();

private:
    EditedPlanes apply(const std::vector<Edit>& edits) const { return apply(edits, *snapshot_); }
    EditedPlanes apply(const std::vector<Edit>& edits, const Snapshot& snapshot) const
    {
        return applyEdits(snapshot, edits, room_.scan.recording.description, parameters_);
    }
    PlaneId id(std::size_t place) const { return snapshot_->planes[place]->id; }
    /// A snapshot in which the planes at two places are one, with the id of the first.
    Snapshot withTwoAsOne(std::size_t a, std::size_t b) const;
    std::size_t placeAcross(std::size_t place) const;

    SimulatedRoom room_;
    Parameters parameters_;
    std::shared_ptr<const Snapshot> snapshot_;
};

namespace {

const EditedPlane& planeOf(const EditedPlanes& edited, PlaneId id)
{
    const auto found = std::find_if(edited.planes.begin(), edited.planes.end(),
                                    [id](const EditedPlane& plane) { return plane.plane->id == id; });
    if (found == edited.planes.end())
        qFatal("there is no plane %d", id);
    return *found;
}

bool holds(const EditedPlanes& edited, PlaneId id)
{
    return std::any_of(edited.planes.begin(), edited.planes.end(),
                       [id](const EditedPlane& plane) { return plane.plane->id == id; });
}

}  // namespace

void ApplyEditsTest::initTestCase()
{
    room_ = scanOf("twelve", "default", 5);
    planewright::apply(methodPresets().front(), parameters_);
    snapshot_ = extracted(room_.scan.recording, parameters_);
    QVERIFY(snapshot_->planes.size() >= 10);
}

Snapshot ApplyEditsTest::withTwoAsOne(std::size_t a, std::size_t b) const
{
    Snapshot snapshot = *snapshot_;
    Plane wrong = *snapshot.planes[a];
    const Plane& other = *snapshot.planes[b];
    wrong.segments.insert(wrong.segments.end(), other.segments.begin(), other.segments.end());
    std::sort(wrong.segments.begin(), wrong.segments.end());
    snapshot.planes[a] = std::make_shared<const Plane>(wrong);
    snapshot.planes.erase(snapshot.planes.begin() + static_cast<std::ptrdiff_t>(b));
    return snapshot;
}

/// A plane at right angles to another, of many segments.
std::size_t ApplyEditsTest::placeAcross(std::size_t place) const
{
    for (std::size_t i = place + 1; i < snapshot_->planes.size(); ++i) {
        if (std::abs(snapshot_->planes[i]->normal.dot(snapshot_->planes[place]->normal)) < 0.1 &&
            snapshot_->planes[i]->segments.size() > 30)
            return i;
    }
    qFatal("the room has no such plane");
}

void ApplyEditsTest::withoutEditsPlanesAreSharedAndHaveAClass()
{
    const EditedPlanes edited = apply({});

    QCOMPARE(edited.planes.size(), snapshot_->planes.size());
    QVERIFY(edited.problems.empty());
    for (std::size_t i = 0; i < edited.planes.size(); ++i) {
        QVERIFY(edited.planes[i].plane == snapshot_->planes[i]);
        QVERIFY(edited.planes[i].name.empty());
        // The twelve planes of the room are its floor, its ceiling and ten walls.
        const double upright = edited.planes[i].plane->normal.z();
        QCOMPARE(edited.planes[i].className, std::string(upright < -0.9  ? "floor"
                                                         : upright > 0.9 ? "ceiling"
                                                                         : "wall"));
    }
}

void ApplyEditsTest::namesAndClassesAreWhatWasSaidLast()
{
    const EditedPlanes edited = apply({{Edit::Kind::Rename, {id(0)}, "first", true},
                                       {Edit::Kind::Rename, {id(0)}, "second", true},
                                       {Edit::Kind::Classify, {id(0), id(1)}, "door", true},
                                       {Edit::Kind::Classify, {id(1)}, "", true}});

    QVERIFY(edited.problems.empty());
    QCOMPARE(planeOf(edited, id(0)).name, std::string("second"));
    QCOMPARE(planeOf(edited, id(0)).className, std::string("door"));
    QCOMPARE(planeOf(edited, id(1)).className, planeOf(apply({}), id(1)).className);
}

void ApplyEditsTest::hiddenPlanesAreThereAndDeletedOnesAreNot()
{
    const EditedPlanes edited = apply({{Edit::Kind::Hide, {id(0), id(1)}, {}, true},
                                       {Edit::Kind::Hide, {id(1)}, {}, false},
                                       {Edit::Kind::Delete, {id(2), id(3)}, {}, true}});

    QCOMPARE(edited.planes.size(), snapshot_->planes.size() - 2);
    QVERIFY(planeOf(edited, id(0)).hidden);
    QVERIFY(!planeOf(edited, id(1)).hidden);
    QVERIFY(!holds(edited, id(2)));
    QVERIFY(!holds(edited, id(3)));
}

void ApplyEditsTest::aMergeIsOnePlaneOfAllSegments()
{
    const Plane& a = *snapshot_->planes[0];
    const Plane& b = *snapshot_->planes[1];

    const EditedPlanes edited = apply({{Edit::Kind::Merge, {b.id, a.id}, {}, true}});

    QVERIFY2(edited.problems.empty(), edited.problems.empty() ? "" : edited.problems[0].c_str());
    QCOMPARE(edited.planes.size(), snapshot_->planes.size() - 1);
    const Plane& merged = *planeOf(edited, kFirstEditedPlane).plane;
    QCOMPARE(merged.segments.size(), a.segments.size() + b.segments.size());
    QVERIFY(std::is_sorted(merged.segments.begin(), merged.segments.end()));
    QCOMPARE(merged.points, a.points + b.points);
    QVERIFY(merged.lineage.kind == Lineage::Kind::Merged);
    QCOMPARE(merged.lineage.parents, (std::vector<PlaneId>{b.id, a.id}));
    QCOMPARE(merged.bornStep, std::min(a.bornStep, b.bornStep));
    QCOMPARE(merged.changedStep, std::max(a.changedStep, b.changedStep));
}

void ApplyEditsTest::aMergeKeepsNameClassAndHiddenOfTheFirst()
{
    const EditedPlanes edited = apply({{Edit::Kind::Rename, {id(0)}, "zero", true},
                                       {Edit::Kind::Rename, {id(1)}, "one", true},
                                       {Edit::Kind::Classify, {id(1)}, "door", true},
                                       {Edit::Kind::Hide, {id(1)}, {}, true},
                                       {Edit::Kind::Merge, {id(1), id(0)}, {}, true}});

    const EditedPlane& merged = planeOf(edited, kFirstEditedPlane);
    QCOMPARE(merged.name, std::string("one"));
    QCOMPARE(merged.className, std::string("door"));
    QVERIFY(merged.hidden);
}

void ApplyEditsTest::aMergeOfCoplanarHalvesIsThePlane()
{
    Snapshot halves = *snapshot_;
    const Plane& whole = *snapshot_->planes[0];
    Plane left = whole;
    Plane right = whole;
    left.segments.assign(whole.segments.begin(), whole.segments.begin() + 20);
    right.segments.assign(whole.segments.begin() + 20, whole.segments.end());
    right.id = 500;
    halves.planes[0] = std::make_shared<const Plane>(left);
    halves.planes.push_back(std::make_shared<const Plane>(right));

    const EditedPlanes edited = apply({{Edit::Kind::Merge, {left.id, 500}, {}, true}}, halves);

    const Plane& merged = *planeOf(edited, kFirstEditedPlane).plane;
    QVERIFY(merged.segments == whole.segments);
    QVERIFY((merged.normal - whole.normal).norm() < 0.02 * std::sqrt(whole.covariance(0, 0) + whole.covariance(1, 1)));
    QVERIFY(std::abs(merged.distance - whole.distance) < 0.02 * std::sqrt(whole.covariance(2, 2)));
}

void ApplyEditsTest::aSplitGivesItsPartsNewIds()
{
    const std::size_t across = placeAcross(0);
    const Snapshot wrong = withTwoAsOne(0, across);

    const EditedPlanes edited = apply({{Edit::Kind::Rename, {id(0)}, "both", true},
                                       {Edit::Kind::Hide, {id(0)}, {}, true},
                                       {Edit::Kind::Split, {id(0)}, {}, true}},
                                      wrong);

    QVERIFY2(edited.problems.empty(), edited.problems.empty() ? "" : edited.problems[0].c_str());
    QVERIFY(!holds(edited, id(0)));
    for (const PlaneId part : {kFirstEditedPlane, kFirstEditedPlane + 1}) {
        const EditedPlane& plane = planeOf(edited, part);
        QVERIFY(plane.plane->lineage.kind == Lineage::Kind::Split);
        QCOMPARE(plane.plane->lineage.parents, std::vector<PlaneId>{id(0)});
        QVERIFY(plane.name.empty());
        QVERIFY(plane.hidden);
        QVERIFY(plane.className == "floor" || plane.className == "wall");
    }
    QVERIFY(std::abs(planeOf(edited, kFirstEditedPlane)
                         .plane->normal.dot(planeOf(edited, kFirstEditedPlane + 1).plane->normal)) < 0.1);
}

void ApplyEditsTest::idsAreNeverUsedAgain()
{
    Snapshot far = *snapshot_;
    Plane last = *far.planes.back();
    last.id = kFirstEditedPlane + 7;
    far.planes.back() = std::make_shared<const Plane>(last);

    const EditedPlanes edited = apply({{Edit::Kind::Merge, {id(0), id(1)}, {}, true},
                                       {Edit::Kind::Delete, {kFirstEditedPlane + 8}, {}, true},
                                       {Edit::Kind::Merge, {id(2), id(3)}, {}, true}},
                                      far);

    QVERIFY(edited.problems.empty());
    QVERIFY(!holds(edited, kFirstEditedPlane + 8));
    QVERIFY(holds(edited, kFirstEditedPlane + 9));
}

void ApplyEditsTest::editsOfWhatEditsMadeAreApplied()
{
    const EditedPlanes edited = apply({{Edit::Kind::Merge, {id(0), id(1)}, {}, true},
                                       {Edit::Kind::Merge, {kFirstEditedPlane, id(2)}, {}, true},
                                       {Edit::Kind::Rename, {kFirstEditedPlane + 1}, "all three", true}});

    QVERIFY(edited.problems.empty());
    QCOMPARE(edited.planes.size(), snapshot_->planes.size() - 2);
    QCOMPARE(planeOf(edited, kFirstEditedPlane + 1).name, std::string("all three"));
    QCOMPARE(planeOf(edited, kFirstEditedPlane + 1).plane->points,
             snapshot_->planes[0]->points + snapshot_->planes[1]->points + snapshot_->planes[2]->points);
}

void ApplyEditsTest::editsOfPlanesThatAreNotThereAreProblems()
{
    const EditedPlanes edited = apply({{Edit::Kind::Rename, {400}, "x", true},
                                       {Edit::Kind::Merge, {id(0), 400}, {}, true},
                                       {Edit::Kind::Delete, {id(1)}, {}, true},
                                       {Edit::Kind::Rename, {id(1)}, "gone", true},
                                       {Edit::Kind::Rename, {id(0)}, "here", true}});

    QCOMPARE(edited.problems.size(), std::size_t(3));
    QCOMPARE(edited.problems[0], std::string("the naming of plane 400 is not applied: there is no plane 400"));
    QCOMPARE(edited.problems[1],
             "the merge of planes " + std::to_string(id(0)) + ", 400 is not applied: there is no plane 400");
    QCOMPARE(planeOf(edited, id(0)).name, std::string("here"));
    QVERIFY(planeOf(edited, id(0)).plane == snapshot_->planes[0]);
}

void ApplyEditsTest::lockedPlanesAreLeftAlone()
{
    const EditedPlanes edited = apply({{Edit::Kind::Lock, {id(0)}, {}, true},
                                       {Edit::Kind::Rename, {id(0)}, "x", true},
                                       {Edit::Kind::Merge, {id(1), id(0)}, {}, true},
                                       {Edit::Kind::Lock, {id(0)}, {}, false},
                                       {Edit::Kind::Rename, {id(0)}, "unlocked", true},
                                       {Edit::Kind::Lock, {id(0)}, {}, true}});

    QCOMPARE(edited.problems.size(), std::size_t(2));
    QVERIFY(edited.problems[0].ends_with("plane " + std::to_string(id(0)) + " is locked"));
    QCOMPARE(planeOf(edited, id(0)).name, std::string("unlocked"));
    QVERIFY(planeOf(edited, id(0)).locked);
    QVERIFY(holds(edited, id(1)));
}

void ApplyEditsTest::aSplitOfOnePlaneIsAProblem()
{
    const EditedPlanes edited = apply({{Edit::Kind::Split, {id(1)}, {}, true}});

    QCOMPARE(edited.problems.size(), std::size_t(1));
    QVERIFY(edited.problems[0].ends_with("no second plane is found in plane " + std::to_string(id(1))));
    QVERIFY(planeOf(edited, id(1)).plane == snapshot_->planes[1]);
}

void ApplyEditsTest::editsThatNameTooFewOrTooManyPlanesAreProblems()
{
    const EditedPlanes edited = apply({{Edit::Kind::Delete, {}, {}, true},
                                       {Edit::Kind::Merge, {id(0)}, {}, true},
                                       {Edit::Kind::Split, {id(0), id(1)}, {}, true}});

    QCOMPARE(edited.problems.size(), std::size_t(3));
    QCOMPARE(edited.planes.size(), snapshot_->planes.size());
}

void ApplyEditsTest::segmentsOfAnEditedSnapshotFollow()
{
    const EditedPlanes edited =
        apply({{Edit::Kind::Merge, {id(0), id(1)}, {}, true}, {Edit::Kind::Delete, {id(2)}, {}, true}});

    const Labels labels = labelsOf(withPlanes(*snapshot_, edited), room_.scan.recording);

    std::map<int, int> beams;
    for (const auto& line : labels) {
        for (const int label : line)
            ++beams[label];
    }
    QVERIFY(beams[kFirstEditedPlane] > 0);
    QCOMPARE(beams[id(0)] + beams[id(1)] + beams[id(2)], 0);
    QVERIFY(beams[id(3)] > 0);
}

PLANEWRIGHT_TEST(ApplyEditsTest)
#include "apply_edits_test.moc"
