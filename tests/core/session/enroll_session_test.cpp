// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/enrollment_run.h"
#include "tests/core/session/session_recordings.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using Step = EnrollSession::Step;
using Activity = EnrollSession::Activity;
using Decision = EnrollSqueeze::Decision;

class EnrollSessionTest : public QObject {
    Q_OBJECT
private:
    struct Run : EnrollmentRun {
        using EnrollmentRun::EnrollmentRun;
        bool addAndAccept(const Recording& recording)
        {
            return enrollment.addRecording(recording, QStringLiteral("file.csv")) &&
                   waitFor(Activity::Deciding) && enrollment.accept() && waitFor(Activity::Waiting) &&
                   !enrollment.lastError();
        }
        /// A squeeze of the gripper itself ends because it is unplugged; one recording was accepted before.
        bool loseTheGripper()
        {
            if (!connection.open() || !begin(QStringLiteral("A")) || !addAndAccept(squeezeOf(canA, 1)))
                return false;
            connection.gripper().lostAfterSamples = 100;
            return enrollment.squeeze() && waitFor(Activity::Waiting);
        }
    };
    std::unique_ptr<QTemporaryDir> m_folder;
    QString file() const { return m_folder->filePath(QStringLiteral("library.db")); }

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aPartThatWasNamedIsKeptWithItsSqueezes()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        run.enrollment.setPart(QStringLiteral(" 7 "));
        QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
        run.enrollment.setPart({});
        QVERIFY(run.addAndAccept(squeezeOf(canA, 2)));
        const auto squeezes =
            run.ask<std::vector<TypeSqueeze>>([](Library& l) { return l.enrolledSqueezes(); });
        QCOMPARE(squeezes[0].part, QStringLiteral("7"));
        QVERIFY(squeezes[1].part.isEmpty());
        QCOMPARE(run.enrollment.squeezes()[0].part, QStringLiteral("7"));
    }
    void aRetiredTypeIsNotGoneOnWith()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
        run.enrollment.restart();
        const QString id = run.types()[0].id;
        QVERIFY(run.library
                    .run<void>([id](Library& l) {
                        return l.retireType(id, {QStringLiteral("Ada"), QStringLiteral("out of production")});
                    })
                    .get());
        QVERIFY(!run.begin(QStringLiteral("A")));
        QVERIFY(run.enrollment.lastError().has_value());
        QCOMPARE(run.enrollment.step(), Step::Recipe);
    }
    void acceptedSqueezesTellTheHoldTogether()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        const auto squeezesSummed = [&run] {
            return run.enrollment.squeezes().back().identification.summedHold.squeezes;
        };
        QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
        QCOMPARE(squeezesSummed(), 1);
        QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 2), QStringLiteral("2.csv")));
        QVERIFY(run.waitFor(Activity::Deciding));
        QCOMPARE(squeezesSummed(), 2);
        QVERIFY(run.enrollment.reject(QStringLiteral("slipped")));
        QVERIFY(run.addAndAccept(squeezeOf(canA, 3)));
        QCOMPARE(squeezesSummed(), 2); // the rejected one does not count
        Recording elsewhere = squeezeOf(canA, 4);
        elsewhere.provenance.insert(QStringLiteral("serial"), QStringLiteral("G-2"));
        QVERIFY(run.addAndAccept(elsewhere));
        QCOMPARE(squeezesSummed(), 1);
    }
    void fromNameToApprovalWithSqueezesFromTheGripper()
    {
        Run run(file());
        QVERIFY(run.connection.open());
        run.enrollment.setOperator(QStringLiteral("Ada"));
        QCOMPARE(run.enrollment.step(), Step::Name);
        QVERIFY(run.enrollment.setName(QStringLiteral("  can A ")));
        QCOMPARE(run.enrollment.step(), Step::Recipe);
        QVERIFY(run.enrollment.setRecipe({}));
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.step(), Step::Squeeze);
        for (int i = 0; i < EnrollSession::leastSqueezes; ++i) {
            QVERIFY(!run.enrollment.review()); // not yet
            QVERIFY(run.enrollment.squeeze());
            QVERIFY(run.waitFor(Activity::Deciding));
            const EnrollSqueeze& squeeze = run.enrollment.squeezes().back();
            QCOMPARE(squeeze.decision, Decision::Pending);
            // The fake gripper has 1 um of noise on a millimetre of travel: a per mille, and far less in k.
            QVERIFY(std::abs(squeeze.identification.best()->parameters->k / 9990 - 1) < 0.01);
            QVERIFY(run.enrollment.accept());
            QVERIFY(run.waitFor(Activity::Waiting));
            QCOMPARE(run.enrollment.acceptedCount(), i + 1);
            QCOMPARE(squeeze.decision, Decision::Accepted);
        }
        QVERIFY(run.enrollment.review());
        QCOMPARE(run.enrollment.step(), Step::Review);
        QVERIFY(run.enrollment.approve());
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.step(), Step::Approved);

        const std::vector<TypeRecord> types = run.types();
        QCOMPARE(types.size(), std::size_t(1));
        QCOMPARE(types[0].name, QStringLiteral("can A"));
        QCOMPARE(types[0].squeezes, 3);
        QVERIFY(types[0].approved);
        QCOMPARE(types[0].forceUnit, QStringLiteral("N"));
        const QString id = run.enrollment.squeezes()[0].graspId;
        const Recording stored = run.ask<Recording>([id](Library& l) { return l.recording(id); });
        QCOMPARE(stored, run.enrollment.squeezes()[0].recording);
        QCOMPARE(stored.provenance.value(QStringLiteral("operator")), QStringLiteral("Ada"));
    }
    void anInvalidMeasurementCanOnlyBeRejected()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        QVERIFY(run.enrollment.addRecording(constantForce(), QStringLiteral("constant.csv")));
        QVERIFY(run.waitFor(Activity::Deciding));
        QVERIFY(!run.enrollment.squeezes().back().reason.isEmpty());
        QCOMPARE(run.enrollment.accept().error().code, ErrorCode::Usage);
        QVERIFY(run.enrollment.reject({}));
        QCOMPARE(run.enrollment.squeezes().back().decision, Decision::Rejected);
        QVERIFY(!run.enrollment.squeezes().back().reason.isEmpty());
        QCOMPARE(run.enrollment.acceptedCount(), 0);
        QVERIFY(run.types().empty()); // a type comes with its first squeeze
    }
    void theSameNameGoesOnWhereItStopped()
    {
        {
            Run run(file());
            QVERIFY(run.begin(QStringLiteral("A")));
            QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
            QVERIFY(run.addAndAccept(squeezeOf(canA, 2)));
        }
        Run run(file());
        Recipe other;
        other.seconds = 0.5;
        QVERIFY(run.enrollment.setName(QStringLiteral("A")));
        QVERIFY(run.enrollment.setRecipe(other));
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.acceptedCount(), 2);
        QCOMPARE(run.enrollment.recipe(), Recipe()); // squeezes of one type share its recipe
        const EnrollSqueeze& first = run.enrollment.squeezes().front();
        QVERIFY(std::abs(first.identification.best()->parameters->m / canA.m - 1) < 0.05);
        QVERIFY(run.addAndAccept(squeezeOf(canA, 3)));
        QCOMPARE(run.types()[0].squeezes, 3);
    }
    void aSqueezeCanBeDroppedLater()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        for (std::uint64_t seed = 1; seed <= 4; ++seed)
            QVERIFY(run.addAndAccept(squeezeOf(canA, seed)));
        QVERIFY(run.enrollment.review());
        QVERIFY(run.enrollment.drop(1, QStringLiteral("slipped")));
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.squeezes()[1].decision, Decision::Rejected);
        QCOMPARE(run.enrollment.squeezes()[1].reason, QStringLiteral("slipped"));
        QCOMPARE(run.enrollment.acceptedCount(), 3);
        QCOMPARE(run.types()[0].squeezes, 3);
        QVERIFY(!run.enrollment.drop(1, QStringLiteral("twice")));
        QVERIFY(!run.enrollment.drop(99, QStringLiteral("none")));
        QVERIFY(!run.enrollment.drop(-1, QStringLiteral("none")));
        QVERIFY(run.enrollment.drop(0, QStringLiteral("another")));
        QVERIFY(run.waitFor(Activity::Waiting));
        QVERIFY(!run.enrollment.approve()); // only two are left
        QVERIFY(run.enrollment.back());
        QCOMPARE(run.enrollment.step(), Step::Squeeze);
    }
    void unitsThatCannotBeComparedAreNotEnrolledTogether()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
        Recording printed = squeezeOf(canA, 2);
        printed.forceUnit = printed.positionUnit = QStringLiteral("1");
        QVERIFY(run.enrollment.addRecording(printed, QStringLiteral("printed.csv")));
        QVERIFY(run.waitFor(Activity::Deciding));
        QCOMPARE(run.enrollment.accept().error().code, ErrorCode::UnitsDiffer);
        QVERIFY(run.enrollment.reject(QStringLiteral("units")));
        Recording millimetres = squeezeOf(canA, 3);
        millimetres.positionUnit = QStringLiteral("mm");
        for (double& x : millimetres.position)
            x *= 1000;
        QVERIFY(run.addAndAccept(millimetres));
        const auto squeezes =
            run.ask<std::vector<TypeSqueeze>>([](Library& l) { return l.enrolledSqueezes(); });
        QCOMPARE(squeezes.size(), std::size_t(2));
        QVERIFY(std::abs(squeezes[1].parameters.k / squeezes[0].parameters.k - 1) < 0.01);
    }
    void aLostGripperLeavesWhatWasStored()
    {
        Run run(file());
        QVERIFY(run.loseTheGripper());
        QCOMPARE(run.enrollment.lastError()->code, ErrorCode::DeviceLost);
        QCOMPARE(run.enrollment.step(), Step::Squeeze);
        QCOMPARE(run.enrollment.squeezes().size(), std::size_t(1));
        QVERIFY(!run.enrollment.squeeze()); // no gripper now
        QVERIFY(run.addAndAccept(squeezeOf(canA, 2)));
    }
    void aGripperThatComesBackGoesOnWithTheEnrolment()
    {
        Run run(file());
        QVERIFY(run.loseTheGripper());
        run.connection.factory.comeback->there = std::make_shared<FakeGripper>();
        QVERIFY(pollUntil([&] { run.connection.session.poll(); },
                          [&] { return run.connection.session.port() != nullptr; }));
        QCOMPARE(run.enrollment.step(), Step::Squeeze);
        QCOMPARE(run.enrollment.acceptedCount(), 1);
        QCOMPARE(run.enrollment.squeeze().error().code, ErrorCode::NotArmed); // a person has to
        QVERIFY(run.connection.session.arm(QStringLiteral("Ada")));
        run.connection.session.poll();
        QVERIFY(run.enrollment.squeeze());
        QVERIFY(run.waitFor(Activity::Deciding));
        QVERIFY(run.enrollment.accept());
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.acceptedCount(), 2);
    }
    void aLibraryThatCannotBeOpenedKeepsTheSessionWhereItWas()
    {
        Run run(m_folder->filePath(QStringLiteral("no/such/folder/library.db")));
        QVERIFY(run.enrollment.setName(QStringLiteral("A")));
        QVERIFY(run.enrollment.setRecipe({}));
        QCOMPARE(run.enrollment.activity(), Activity::Storing);
        QVERIFY(run.waitFor(Activity::Waiting));
        QCOMPARE(run.enrollment.step(), Step::Recipe);
        QCOMPARE(run.enrollment.lastError()->code, ErrorCode::StorageOpen);
    }
    void stepsAndDecisionsOutOfTurnAreRefused()
    {
        Run run(file());
        QVERIFY(!run.enrollment.setName(QStringLiteral("  ")));
        QVERIFY(!run.enrollment.setRecipe({}));
        QVERIFY(!run.enrollment.squeeze());
        QVERIFY(!run.enrollment.accept());
        QVERIFY(!run.enrollment.reject(QStringLiteral("x")));
        QVERIFY(!run.enrollment.review());
        QVERIFY(!run.enrollment.approve());
        QVERIFY(run.enrollment.setName(QStringLiteral("A")));
        QVERIFY(run.enrollment.back());
        QCOMPARE(run.enrollment.step(), Step::Name);
        QVERIFY(run.begin(QStringLiteral("A")));
        QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
        QVERIFY(
            !run.enrollment.addRecording(squeezeOf(canA, 2), QStringLiteral("2.csv"))); // still identifying
        QVERIFY(run.waitFor(Activity::Deciding));
        QVERIFY(!run.enrollment.review()); // decide first
    }
    void recipesThatMakeNoSenseAreRefused_data()
    {
        QTest::addColumn<double>("peak");
        QTest::addColumn<double>("bias");
        QTest::addColumn<double>("seconds");
        QTest::newRow("no peak") << 0.0 << 20.0 << 1.0;
        QTest::newRow("pulls") << 10.0 << -1.0 << 1.0;
        QTest::newRow("no time") << 10.0 << 20.0 << 0.0;
        QTest::newRow("not a number") << 10.0 << qQNaN() << 1.0;
        QTest::newRow("above its own crush limit") << 21.0 << 20.0 << 1.0;
    }
    void recipesThatMakeNoSenseAreRefused()
    {
        QFETCH(double, peak);
        QFETCH(double, bias);
        QFETCH(double, seconds);
        Run run(file());
        QVERIFY(run.enrollment.setName(QStringLiteral("A")));
        Recipe recipe;
        recipe.peak_N = peak;
        recipe.bias_N = bias;
        recipe.seconds = seconds;
        QVERIFY(!run.enrollment.setRecipe(recipe));
        QCOMPARE(run.enrollment.step(), Step::Recipe);
    }
    void aNewTypeIsSqueezedOnFourLevels()
    {
        Run run(file());
        QVERIFY(run.enrollment.recipe().kind == ExcitationKind::FourLevel);
        QVERIFY(run.begin(QStringLiteral("A"))); // by another
        QVERIFY(run.enrollment.recipe().kind == ExcitationKind::Prbs);
        run.enrollment.restart();
        QVERIFY(run.enrollment.recipe().kind == ExcitationKind::FourLevel);
    }
    void startingAnewKeepsWhatIsStored()
    {
        Run run(file());
        QVERIFY(run.begin(QStringLiteral("A")));
        QVERIFY(run.addAndAccept(squeezeOf(canA, 1)));
        QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 2), QStringLiteral("2.csv")));
        run.enrollment.restart(); // while it is being identified
        QCOMPARE(run.enrollment.step(), Step::Name);
        QVERIFY(run.enrollment.squeezes().empty());
        QVERIFY(run.begin(QStringLiteral("C")));
        QVERIFY(run.addAndAccept(squeezeOf(canC, 1)));
        QCOMPARE(run.types().size(), std::size_t(2));
    }
    void goingAwayWhileWorkRunsDoesNoHarm()
    {
        {
            Run run(file());
            QVERIFY(run.begin(QStringLiteral("A")));
            QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
        } // identifying
        {
            Run run(file());
            QVERIFY(run.begin(QStringLiteral("A")));
            QVERIFY(run.enrollment.addRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
            QVERIFY(run.waitFor(Activity::Deciding));
            QVERIFY(run.enrollment.accept());
        } // storing: the library finishes what it was given
        {
            Run run(file());
            QVERIFY(run.connection.open());
            QVERIFY(run.begin(QStringLiteral("A")));
            QCOMPARE(run.enrollment.acceptedCount(), 1);
            QVERIFY(run.enrollment.squeeze());
        } // squeezing
    }
};

GRIPSCOPE_TEST(EnrollSessionTest)
#include "enroll_session_test.moc"
