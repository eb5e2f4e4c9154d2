// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/windows/question.h"

#include <QCheckBox>
#include <QFile>
#include <QListWidget>
#include <QMenu>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::PeopleWindow;

namespace {

/// Fills in the form that asks for a change of a type, if there is one, and accepts it.
void acceptForm(const PeopleWindow& f, const QString& name)
{
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<TypeChangeForm*>(), gripscope::test::longEnough_ms);
    auto* form = f.window->findChild<TypeChangeForm*>();
    if (auto* field = form->findChild<QLineEdit*>(u"nameField"_s))
        field->setText(name);
    if (auto* squeezes = form->findChild<QListWidget*>(u"squeezesField"_s))
        squeezes->item(0)->setCheckState(Qt::Checked);
    form->findChild<QLineEdit*>(u"reasonField"_s)->setText(u"asked for"_s);
    f.click(form->findChild<QPushButton*>(u"changeAccept"_s));
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<TypeChangeForm*>(), gripscope::test::longEnough_ms);
}

qint64 version(const PeopleWindow& f)
{
    return f.answer<qint64>([](Library& library) { return library.version(); });
}

void resumeEnrollment(const PeopleWindow& f, const QString& type)
{
    f.window->showPage(u"enroll"_s);
    auto* field = f.find<QLineEdit>("typeName");
    QTest::keyClicks(field, type);
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Recipe);
    f.click(f.find<QPushButton>("recipeNext"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Squeeze,
                              gripscope::test::longEnough_ms);
}

/// A gripper on whose force sensor weights are hung one after the other.
QString weights(const QTemporaryDir& folder)
{
    QFile script(folder.filePath(u"weights.txt"_s));
    if (!script.open(QIODevice::WriteOnly))
        qFatal("no script");
    script.write("0 load 0\n8 load 10\n16 load 20\n");
    return u"virtual:?script="_s + script.fileName();
}

bool forceIs(const PeopleWindow& f, double load_N)
{
    const LiveHistory& history = f.bench->live().history();
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 0.2, 4);
    return !stretches.empty() && !stretches.back().empty() &&
           std::abs(stretches.back().back().y - load_N) < 1 &&
           std::abs(stretches.front().front().y - load_N) < 1;
}

} // namespace

/// What asks for a supervisor is not done for an operator, and is done after a supervisor's consent.
class SupervisedActionsTest : public QObject {
    Q_OBJECT
    /// The dialog has come up; cancelled first, and then allowed.
    static void refuseThenAllow(const PeopleWindow& f, const std::function<void()>& act,
                                const QString& action)
    {
        const qint64 before = version(f);
        act();
        QTRY_VERIFY_WITH_TIMEOUT(f.dialog(), gripscope::test::longEnough_ms);
        f.dialog()->reject();
        QTRY_VERIFY(!f.dialog());
        QCOMPARE(version(f), before);
        act();
        f.authorise();
        QTRY_COMPARE_WITH_TIMEOUT(f.newestEntry().action, action, gripscope::test::longEnough_ms);
        QCOMPARE(f.newestEntry().person, u"Sam"_s);
        QVERIFY(f.newestEntry().details.contains(u"\"operator\":\"Olli\""_s));
    }

private slots:
    void changesOfTypes_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<bool>("retired");
        QTest::addColumn<QString>("action");
        QTest::newRow("rename") << u"renameButton"_s << false << u"type.rename"_s;
        QTest::newRow("merge") << u"mergeButton"_s << false << u"type.merge"_s;
        QTest::newRow("split") << u"splitButton"_s << false << u"type.split"_s;
        QTest::newRow("retire") << u"retireButton"_s << false << u"type.retire"_s;
        QTest::newRow("put back") << u"putBackButton"_s << true << u"type.reinstate"_s;
        QTest::newRow("approve") << u"approveTypeButton"_s << true << u"type.approve"_s;
        QTest::newRow("undo") << u"undoButton"_s << false << u"type.restore"_s;
    }
    void changesOfTypes()
    {
        QFETCH(QString, button);
        QFETCH(bool, retired);
        QFETCH(QString, action);
        PeopleWindow f;
        if (retired) // and, to be approved, in use again
            f.answer<void>([&action](Library& library) -> Expected<void> {
                const auto sam = library.people().named(u"Sam"_s);
                library.actAs(
                    {{},
                     {},
                     *library.people().authorise(sam->id, Secret(u"2468135790"_s), Permission::ChangeTypes)});
                const QString id = (*library.findType(u"A"_s))->id;
                auto done = library.retireType(id, {{}, u"test"_s});
                return done && action == u"type.approve"_s ? library.reinstateType(id, {{}, u"test"_s})
                                                           : done;
            });
        f.signInOlli();
        auto* dialog = new EnrolledTypesDialog(*f.bench, f.window.get());
        dialog->open();
        auto* types = f.find<QTableWidget>("typesTable");
        QTRY_COMPARE_WITH_TIMEOUT(types->rowCount(), 4, gripscope::test::longEnough_ms);
        refuseThenAllow(
            f,
            [&] {
                types->selectRow(action == u"type.reinstate"_s ? 3 : 0);
                // The page of the tab may be hidden: pressed all the same.
                QMetaObject::invokeMethod(f.find<QPushButton>(qPrintable(button)), "click");
                if (action == u"type.approve"_s)
                    f.sayWhy();
                else
                    acceptForm(f, u"Cola"_s);
            },
            action);
    }
    void droppingASqueeze()
    {
        PeopleWindow f;
        f.signInOlli();
        resumeEnrollment(f, u"A"_s);
        f.find<QTableView>("squeezeTable")->selectRow(0);
        QTRY_VERIFY(f.find<QPushButton>("dropButton")->isEnabled());
        refuseThenAllow(
            f,
            [&f] {
                f.click(f.find<QPushButton>("dropButton"));
                QTRY_VERIFY(f.window->findChild<TextQuestion*>(u"dropDialog"_s));
                auto* dialog = f.window->findChild<TextQuestion*>(u"dropDialog"_s);
                dialog->field()->setText(u"slipped"_s);
                dialog->accept();
                QTRY_VERIFY(!f.window->findChild<TextQuestion*>(u"dropDialog"_s));
            },
            u"type.drop"_s);
        QCOMPARE(f.newestEntry().reason, u"slipped"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 9, gripscope::test::longEnough_ms);
    }
    void approvingAtTheEndOfAnEnrollment()
    {
        PeopleWindow f;
        f.signInOlli();
        resumeEnrollment(f, u"B"_s);
        QTRY_VERIFY(f.find<QPushButton>("reviewButton")->isEnabled());
        f.click(f.find<QPushButton>("reviewButton"));
        QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Review);
        refuseThenAllow(
            f,
            [&f] {
                f.click(f.find<QPushButton>("approveButton"));
                f.sayWhy(u"reviewed with quality"_s);
            },
            u"type.approve"_s);
        QCOMPARE(f.newestEntry().reason, u"reviewed with quality"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Approved,
                                  gripscope::test::longEnough_ms);
    }
    void keepingSessions()
    {
        PeopleWindow f;
        f.signInOlli();
        const bool before = f.bench->keepsSessions();
        refuseThenAllow(
            f,
            [&f] {
                f.click(f.find<QWidget>("deviceChip"));
                auto* keep = f.window->findChild<QAction*>(u"keepSessions"_s);
                QVERIFY(keep);
                keep->trigger();
                static_cast<QMenu*>(keep->parent())->close();
            },
            u"setting.changed"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->keepsSessions(), !before, gripscope::test::longEnough_ms);
    }
    void acceptingACalibration()
    {
        const QTemporaryDir folder;
        PeopleWindow f(weights(folder));
        f.signInOlli();
        f.window->showPage(u"calibrate"_s);
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, 10, 20"_s);
        QTest::keyClicks(f.find<QLineEdit>("calibrationReference"), u"Weights M1"_s);
        f.find<QSpinBox>("calibrationRuns")->setValue(1);
        for (auto* box : f.page(u"calibrate"_s)->findChildren<QCheckBox*>())
            box->setChecked(false); // up only
        QTRY_VERIFY(f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.click(f.find<QPushButton>("calibrationBegin"));
        auto* points = f.find<QTableView>("calibrationPoints");
        for (const double load_N : {0.0, 10.0, 20.0}) {
            QTRY_VERIFY_WITH_TIMEOUT(forceIs(f, load_N), gripscope::test::longEnough_ms);
            QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
            QTRY_VERIFY_WITH_TIMEOUT(!points->model()->index(int(load_N / 10), 3).data().toString().isEmpty(),
                                     gripscope::test::longEnough_ms);
        }
        QTRY_VERIFY(f.find<QPushButton>("calibrationAccept")->isVisible());
        refuseThenAllow(
            f,
            [&f] {
                f.click(f.find<QPushButton>("calibrationAccept"));
                f.sayWhy(u"yearly"_s);
            },
            u"calibration.accepted"_s);
        QCOMPARE(f.newestEntry().reason, u"yearly"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().calibration().record(SensorChannel::Force),
                                 gripscope::test::longEnough_ms);
    }
};

GRIPSCOPE_TEST(SupervisedActionsTest)
#include "supervised_actions_test.moc"
