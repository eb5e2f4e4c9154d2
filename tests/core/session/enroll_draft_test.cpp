// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/child_process.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/session/enrollment_run.h"
#include "tests/core/session/session_recordings.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using Step = EnrollSession::Step;
using Activity = EnrollSession::Activity;
using Decision = EnrollSqueeze::Decision;
using Kind = EnrollSession::Act::Kind;

namespace {

PartPicture aPicture()
{
    return {{}, u"png"_s, 2, 2, QByteArray("a picture")};
}

/// One program run whose enrolment is kept.
struct Run : EnrollmentRun {
    explicit Run(const QString& file) : EnrollmentRun(file)
    {
        enrollment.keepDrafts(true);
        enrollment.setOperator(u"Ada"_s);
    }
    bool add(std::uint64_t seed)
    {
        return enrollment.addRecording(squeezeOf(canA, seed), u"file.csv"_s) && waitFor(Activity::Deciding);
    }
    bool accept() { return enrollment.accept() && waitFor(Activity::Waiting) && !enrollment.lastError(); }
    bool undo(Activity then) { return enrollment.undo() && waitFor(then) && !enrollment.lastError(); }
    bool redo(Activity then) { return enrollment.redo() && waitFor(then) && !enrollment.lastError(); }
    bool resume(const QString& name)
    {
        return enrollment.resumeDraft(name) &&
               pollUntil([this] { enrollment.poll(); },
                         [this] {
                             return enrollment.activity() == Activity::Waiting ||
                                    enrollment.activity() == Activity::Deciding;
                         }) &&
               !enrollment.lastError();
    }
    std::vector<EnrollmentDraft> drafts()
    {
        return ask<std::vector<EnrollmentDraft>>([](Library& l) { return l.drafts(); });
    }
};

/// A process that enrols up to `goal` and is then killed without warning, at the moment it said so.
bool killedAfter(const QString& file, const std::function<bool(Run&)>& goal)
{
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0)
        return false;
    const pid_t process = startChild([&] {
        Run run(file);
        if (!goal(run))
            _exit(1);
        if (write(ends[1], "x", 1) == 1)
            pause();
    });
    close(ends[1]);
    char byte = 0;
    const bool reached = read(ends[0], &byte, 1) == 1;
    close(ends[0]);
    ::kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
    return reached;
}

} // namespace

/// Enrolments that are interrupted and gone on with, and what is undone.
class EnrollDraftTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString file() const { return m_folder->filePath(u"library.db"_s); }

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aKillLosesNeitherStepNorSqueeze_data()
    {
        QTest::addColumn<int>("reached");
        QTest::newRow("a squeeze to decide on") << 0;
        QTest::newRow("two accepted") << 1;
        QTest::newRow("in the review") << 2;
    }
    void aKillLosesNeitherStepNorSqueeze()
    {
        QFETCH(int, reached);
        const bool there = killedAfter(file(), [reached](Run& run) {
            run.enrollment.setPart(u"7"_s);
            if (!run.begin(u"Can"_s) || !run.add(1))
                return false;
            if (reached == 0)
                return true;
            if (!run.accept() || !run.add(2) || !run.accept())
                return false;
            if (reached == 1)
                return true;
            if (!run.add(3) || !run.accept() || !run.enrollment.review())
                return false;
            // What the library was told before is stored before what it is asked now.
            return run.drafts().size() == 1;
        });
        QVERIFY(there);
        Run run(file());
        QCOMPARE(run.drafts().size(), std::size_t(1));
        QCOMPARE(run.drafts()[0].squeezes, reached == 0 ? 0 : reached + 1);
        QVERIFY(run.resume(u"Can"_s));
        QCOMPARE(run.enrollment.part(), u"7"_s);
        QCOMPARE(run.enrollment.step(), reached == 2 ? Step::Review : Step::Squeeze);
        QCOMPARE(run.enrollment.acceptedCount(), reached == 0 ? 0 : reached + 1);
        if (reached != 0)
            return;
        QCOMPARE(run.enrollment.activity(), Activity::Deciding);
        QCOMPARE(run.enrollment.squeezes().back().recording, squeezeOf(canA, 1));
        QVERIFY(run.accept());
        QCOMPARE(run.types()[0].squeezes, 1);
        QVERIFY(run.drafts()[0].pendingId.isEmpty()); // and it is not offered twice
    }
    void aKillAtAnyMomentLeavesNoSqueezeTwice()
    {
        // While squeezes are accepted one after another: whatever is there is there once.
        for (int milliseconds = 20; milliseconds <= 220; milliseconds += 40) {
            const QString name = m_folder->filePath(u"killed%1.db"_s.arg(milliseconds));
            const pid_t process = startChild([&] {
                Run run(name);
                if (!run.begin(u"Can"_s))
                    _exit(1);
                for (std::uint64_t seed = 1;; ++seed)
                    if (!run.add(seed) || !run.accept())
                        _exit(1);
            });
            QTest::qSleep(milliseconds);
            ::kill(process, SIGKILL);
            waitpid(process, nullptr, 0);
            Run run(name);
            if (run.drafts().empty())
                continue; // it did not come that far
            QVERIFY(run.resume(u"Can"_s));
            if (run.enrollment.activity() == Activity::Deciding) {
                const Recording pending = run.enrollment.squeezes().back().recording;
                for (std::size_t i = 0; i + 1 < run.enrollment.squeezes().size(); ++i) {
                    const QString id = run.enrollment.squeezes()[i].graspId;
                    QVERIFY(!(run.ask<Recording>([id](Library& l) { return l.recording(id); }) == pending));
                }
            }
        }
    }
    void aDraftBeginsWithItsName()
    {
        {
            Run run(file());
            run.enrollment.setPicture(aPicture());
            QVERIFY(run.enrollment.setName(u"Can"_s));
        }
        Run run(file());
        QCOMPARE(run.drafts().size(), std::size_t(1));
        QVERIFY(run.resume(u"Can"_s));
        QCOMPARE(run.enrollment.step(), Step::Recipe);
        QCOMPARE(run.enrollment.typeName(), u"Can"_s);
        QVERIFY(run.enrollment.picture());
        QCOMPARE(run.enrollment.picture()->bytes, aPicture().bytes);
    }
    void theRecipeAndItsCrushLimitAreGoneOnWith()
    {
        Recipe recipe;
        recipe.maxForce_N = 31.5;
        recipe.maxTravel_m = 0.003;
        {
            Run run(file());
            QVERIFY(run.enrollment.setName(u"Can"_s));
            QVERIFY(run.enrollment.setRecipe(recipe));
            QVERIFY(run.waitFor(Activity::Waiting));
        }
        Run run(file());
        QVERIFY(run.resume(u"Can"_s));
        QCOMPARE(run.enrollment.step(), Step::Squeeze);
        QCOMPARE(run.enrollment.recipe(), recipe);
    }
    void severalAreKeptSideBySideUntilTheyAreApproved()
    {
        Run run(file());
        QVERIFY(run.begin(u"One"_s) && run.add(1) && run.accept());
        run.enrollment.restart();
        QVERIFY(run.begin(u"Two"_s) && run.add(2));
        run.enrollment.restart();
        QCOMPARE(run.drafts().size(), std::size_t(2));
        QVERIFY(run.resume(u"One"_s));
        QCOMPARE(run.enrollment.acceptedCount(), 1);
        QVERIFY(run.add(3) && run.accept() && run.add(4) && run.accept());
        QVERIFY(run.enrollment.review() && run.enrollment.approve());
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.step(), Step::Approved);
        QCOMPARE(run.drafts().size(), std::size_t(1));
        run.enrollment.restart();
        // By its name it is gone on with as well.
        QVERIFY(run.enrollment.setName(u"Two"_s) && run.enrollment.setRecipe({}));
        QVERIFY(run.waitFor(Activity::Deciding));
        QCOMPARE(run.enrollment.squeezes().back().recording, squeezeOf(canA, 2));
    }
    void aNameThatIsChangedBeforeASqueezeLeavesNoDraftBehind()
    {
        Run run(file());
        QVERIFY(run.enrollment.setName(u"Colla"_s));
        QVERIFY(run.enrollment.undo());
        QCOMPARE(run.enrollment.step(), Step::Name);
        QVERIFY(run.enrollment.setName(u"Cola"_s));
        QCOMPARE(run.drafts().size(), std::size_t(1));
        QCOMPARE(run.drafts()[0].name, u"Cola"_s);
    }
    void acceptingIsUndoneAndDoneAgainWithOneStoredSqueeze()
    {
        Run run(file());
        QVERIFY(run.begin(u"Can"_s));
        QVERIFY(run.add(1) && run.accept() && run.add(2) && run.accept());
        QCOMPARE(run.enrollment.undoable()->kind, Kind::Accept);
        QVERIFY(run.undo(Activity::Deciding));
        QCOMPARE(run.types()[0].squeezes, 1);
        QVERIFY(!run.drafts()[0].pendingId.isEmpty());
        QVERIFY(run.redo(Activity::Waiting));
        QCOMPARE(run.types()[0].squeezes, 2);
        QCOMPARE(run.enrollment.acceptedCount(), 2);
        const QString typeId = run.types()[0].id;
        const auto grasps =
            run.ask<std::vector<GraspRecord>>([typeId](Library& l) { return l.grasps(typeId); });
        QCOMPARE(grasps.size(), std::size_t(2)); // counted again, not stored again
    }
    void aRecordingIsStoredOnce()
    {
        {
            Run run(file());
            QVERIFY(run.begin(u"Can"_s));
            QVERIFY(run.add(1) && run.accept() && run.add(2) && run.accept());
            const QString typeId = run.types()[0].id;
            const auto grasps =
                run.ask<std::vector<GraspRecord>>([typeId](Library& l) { return l.grasps(typeId); });
            QCOMPARE(grasps.size(), std::size_t(2));
            for (std::size_t i = 0; i < grasps.size(); ++i) {
                const QString id = grasps[i].id;
                QCOMPARE(run.ask<Recording>([id](Library& l) { return l.recording(id); }),
                         squeezeOf(canA, i + 1));
            }
        }
        RawDatabase raw(file());
        QCOMPARE(raw.count(u"draft_squeezes"_s), 2);
        QCOMPARE(raw.count(u"recordings"_s), 2);
        QCOMPARE(raw.run(u"SELECT SUM(LENGTH(packed)) FROM recordings"_s).toLongLong(), 0);
    }
    void everythingBackToTheNameAndForthAgain()
    {
        Run run(file());
        QVERIFY(run.begin(u"Can"_s));
        QVERIFY(run.add(1) && run.accept() && run.add(2));
        QVERIFY(run.enrollment.reject(u"slipped"_s));
        QVERIFY(run.enrollment.drop(0, u"dented"_s) && run.waitFor(Activity::Waiting));
        const std::vector<std::pair<Kind, Activity>> back{{Kind::Drop, Activity::Waiting},
                                                          {Kind::Reject, Activity::Deciding},
                                                          {Kind::Squeeze, Activity::Waiting},
                                                          {Kind::Accept, Activity::Deciding},
                                                          {Kind::Squeeze, Activity::Waiting}};
        for (const auto& step : back) {
            QCOMPARE(run.enrollment.undoable()->kind, step.first);
            QVERIFY(run.undo(step.second));
        }
        QVERIFY(run.enrollment.squeezes().empty());
        QCOMPARE(run.types()[0].squeezes, 0);
        for (auto step = back.rbegin(); step != back.rend(); ++step) {
            QCOMPARE(run.enrollment.redoable()->kind, step->first);
            QVERIFY(run.redo(step->first == Kind::Squeeze ? Activity::Deciding : Activity::Waiting));
        }
        QVERIFY(!run.enrollment.redoable());
        QCOMPARE(run.enrollment.squeezes().size(), std::size_t(2));
        QCOMPARE(run.enrollment.squeezes()[0].decision, Decision::Rejected);
        QCOMPARE(run.enrollment.squeezes()[0].reason, u"dented"_s);
        QCOMPARE(run.enrollment.squeezes()[1].reason, u"slipped"_s);
        QCOMPARE(run.types()[0].squeezes, 0);
        for (std::size_t i = 0; i < back.size(); ++i)
            QVERIFY(run.undo(back[i].second));
        QCOMPARE(run.enrollment.undoable()->kind, Kind::Recipe);
        QVERIFY(run.enrollment.undo());
        QCOMPARE(run.enrollment.step(), Step::Recipe);
        QVERIFY(run.enrollment.undo());
        QCOMPARE(run.enrollment.step(), Step::Name);
        QVERIFY(!run.enrollment.undo());
    }
    void somethingElseThanRedoEndsIt()
    {
        Run run(file());
        QVERIFY(run.begin(u"Can"_s));
        QVERIFY(run.add(1) && run.accept());
        QVERIFY(run.undo(Activity::Deciding));
        QVERIFY(run.enrollment.reject(u"slipped"_s)); // instead
        QVERIFY(!run.enrollment.redoable());
        QVERIFY(!run.enrollment.redo());
        QCOMPARE(run.types()[0].squeezes, 0);
        // Nothing is undone while a squeeze is worked on.
        QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 2), u"2.csv"_s));
        QVERIFY(!run.enrollment.undo());
    }
    void theTypeGetsThePictureWithItsFirstSqueeze()
    {
        Run run(file());
        run.enrollment.setPicture(aPicture());
        QVERIFY(run.begin(u"Can"_s) && run.add(1) && run.accept());
        const auto pictureOf = [&run] {
            const QString typeId = run.types()[0].id;
            return run.ask<std::optional<PartPicture>>(
                [typeId](Library& l) { return l.typePicture(typeId); });
        };
        QCOMPARE(pictureOf(), run.enrollment.picture());
        run.enrollment.setPicture(std::nullopt);
        QVERIFY(!pictureOf());
        QVERIFY(run.drafts()[0].pictureId.isEmpty());
    }
    void withoutDraftsNothingIsKeptBeforeItIsAccepted()
    {
        Run run(file());
        run.enrollment.keepDrafts(false);
        QVERIFY(run.begin(u"Can"_s) && run.add(1));
        QVERIFY(run.drafts().empty());
    }
    void aSqueezeAboveTheCrushLimitIsRefusedByTheGate()
    {
        Run run(file());
        QVERIFY(run.connection.open());
        Recipe recipe;
        recipe.maxForce_N = 29; // 20 + 10 N are asked for
        QVERIFY(run.enrollment.setName(u"Can"_s));
        QCOMPARE(run.enrollment.setRecipe(recipe).error().code, ErrorCode::LimitExceeded);
        // Past the form and the session: a recipe that is in the library already.
        run.ask<TypeRecord>([recipe](Library& l) { return l.addType(u"Fragile"_s, recipe, u"N"_s, u"m"_s); });
        run.enrollment.restart();
        QVERIFY(run.begin(u"Fragile"_s));
        QCOMPARE(run.enrollment.recipe().maxForce_N, 29.0);
        QCOMPARE(run.enrollment.squeeze().error().code, ErrorCode::LimitExceeded);
        QCOMPARE(run.connection.gripper().started, 0);
        // The gripper is given the lower of the two limits to watch itself.
        run.enrollment.restart();
        QVERIFY(run.begin(u"Strong"_s));
        QVERIFY(run.enrollment.squeeze());
        QCOMPARE(run.connection.gripper().admittedMaxForce_N, Recipe().maxForce_N);
    }
};

GRIPSCOPE_TEST(EnrollDraftTest)
#include "enroll_draft_test.moc"
