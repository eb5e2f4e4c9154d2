// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/format/recipe_words.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/widgets/message_bar.h"
#include "ui/windows/file_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <set>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;

namespace {

/// At the recipe of a new type.
void beginType(WindowFixture& f, const QString& name)
{
    f.window->showPage(u"enroll"_s);
    auto* field = f.find<QLineEdit>("typeName");
    field->clear();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Recipe);
}

/// On the Enroll page: the empty gripper's has a recipe too.
template <typename T>
T* onPage(const WindowFixture& f, const char* name = nullptr)
{
    T* widget = f.page(u"enroll"_s)->findChild<T*>(QString::fromLatin1(name));
    if (!widget)
        qFatal("the Enroll page has no %s", name ? name : T::staticMetaObject.className());
    return widget;
}

void choose(QComboBox& kinds, ExcitationKind kind)
{
    kinds.setFocus();
    const int wanted = kinds.findData(static_cast<int>(kind));
    QVERIFY(wanted >= 0);
    QTest::keyClick(&kinds, Qt::Key_Home);
    for (int i = 0; i < wanted; ++i)
        QTest::keyClick(&kinds, Qt::Key_Down);
    QCOMPARE(kinds.currentIndex(), wanted);
}

/// The heights on which the force stands in the picture.
std::set<int> levelsOf(ForcePicture& picture)
{
    const QImage image = picture.grab().toImage();
    const QRgb force = Theme::instance().tokens().force.rgb();
    std::set<int> levels;
    for (int y = 0; y < image.height(); ++y) {
        int run = 0;
        for (int x = 0; x < image.width(); ++x)
            run += image.pixelColor(x, y).rgb() == force ? 1 : 0;
        if (run > image.width() / 10)
            levels.insert(y);
    }
    return levels;
}

} // namespace

class RecipeFormTest : public QObject {
    Q_OBJECT
private slots:
    void aNewTypeSeesFrictionUntilSomebodyChoosesOtherwise()
    {
        WindowFixture f(false, unhurriedA);
        beginType(f, u"Cola"_s);
        auto* kinds = onPage<QComboBox>(f, "recipeKind");
        QCOMPARE(kinds->currentData().toInt(), static_cast<int>(ExcitationKind::FourLevel));
        QVERIFY(onPage<QLabel>(f, "recipeSummary")->text().contains(u"friction"_s));
        auto* picture = onPage<ForcePicture>(f);
        QVERIFY(picture->isVisible());
        QVERIFY(levelsOf(*picture).size() >= 4);
    }
    void whatTheSqueezeCanTellIsSaidAndFollowsTheForce()
    {
        WindowFixture f(false, unhurriedA);
        beginType(f, u"Cola"_s);
        auto* told = onPage<ExpectationView>(f);
        QTRY_VERIFY_WITH_TIMEOUT(told->text().contains(u"friction"_s), longEnough_ms);
        const QString four = told->text();
        choose(*onPage<QComboBox>(f, "recipeKind"), ExcitationKind::Prbs);
        QTRY_VERIFY_WITH_TIMEOUT(told->text() != four, longEnough_ms);
        QVERIFY(told->text().contains(u"k\u00A0±"_s));
        // Of nothing between the fingers there is nothing to be expected.
        QVERIFY(f.page(u"calibrate"_s)->findChildren<ExpectationView*>().isEmpty());
    }
    void everyKindIsShownSaidAndSqueezed()
    {
        WindowFixture f(false, unhurriedA);
        QStringList said;
        for (const ExcitationKind kind : RecipeWords::kinds()) {
            beginType(f, u"Type of "_s + RecipeWords::name(kind));
            choose(*onPage<QComboBox>(f, "recipeKind"), kind);
            if (kind == ExcitationKind::Levels) {
                QVERIFY(!onPage<EnrollRecipeForm>(f)->isValid()); // there are none yet
                f.click(onPage<QPushButton>(f, "forceOptimise"));
                QTRY_VERIFY_WITH_TIMEOUT(onPage<EnrollRecipeForm>(f)->isValid(), longEnough_ms);
            }
            said << onPage<QLabel>(f, "recipeSummary")->text();
            f.click(f.find<QPushButton>("recipeNext"));
            QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Squeeze,
                                      longEnough_ms);
            QVERIFY(f.bench->enrollment().recipe().kind == kind);
            if (!f.bench->connection().armed())
                f.bench->arm();
            WindowFixture::clickWhenEnabled(f.find<QPushButton>("enrollSqueezeButton"));
            QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().squeezes().size(), std::size_t(1), longEnough_ms);
            const EnrollSqueeze& squeeze = f.bench->enrollment().squeezes().front();
            QCOMPARE(squeeze.recording.provenance.value(u"excitation"_s), toString(kind));
            QVERIFY2(squeeze.reason.isEmpty(), qPrintable(squeeze.reason));
            f.bench->enrollment().restart();
            QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Name, longEnough_ms);
        }
        QCOMPARE(said.removeDuplicates(), 0);
    }
    void aForceFromAFileIsSqueezedWith()
    {
        WindowFixture f(false, unhurriedA);
        beginType(f, u"Cola"_s);
        auto* row = onPage<ForceLevelsRow>(f);
        QVERIFY(!row->isVisible()); // before anybody chose it
        choose(*onPage<QComboBox>(f, "recipeKind"), ExcitationKind::Levels);
        QVERIFY(row->isVisible());
        f.click(onPage<QPushButton>(f, "forceFromFile"));
        auto* chooser = f.window->findChild<FileDialog*>();
        QVERIFY(chooser && chooser->isVisible());
        chooser->close();

        const QTemporaryDir folder;
        const auto write = [&folder](const QByteArray& text) {
            QFile file(folder.filePath(u"force.csv"_s));
            if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
                qFatal("cannot write");
            return file.fileName();
        };
        // What cannot be read is told, and changes nothing.
        row->open(write("time_s,force\n0,12\n0.25,x\n"));
        const auto* bar = f.window->findChild<MessageBar*>();
        QTRY_VERIFY_WITH_TIMEOUT(!bar->messages().filter(u"force.csv:3:2"_s).isEmpty(), longEnough_ms);
        const auto* form = onPage<EnrollRecipeForm>(f);
        QVERIFY(!form->isValid());
        row->open(write("time_s,force\n0,12\n0.125,18\n0.25,15\n0.375,9\n"));
        QTRY_VERIFY_WITH_TIMEOUT(form->isValid(), longEnough_ms);
        const Recipe recipe = form->recipe();
        QCOMPARE(recipe.bias_N, 13.5);
        QCOMPARE(recipe.peak_N, 4.5);
        QCOMPARE(recipe.bit_s, 0.125);
        QCOMPARE(recipe.seconds, 0.5);
        QVERIFY(onPage<QLabel>(f, "forceLevels")->text().contains(u"4 levels of 125 ms"_s));
        QCOMPARE(levelsOf(*onPage<ForcePicture>(f)).size(), std::size_t(4));
        f.click(f.find<QPushButton>("recipeNext"));
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Squeeze, longEnough_ms);
        QVERIFY(f.bench->enrollment().recipe() == recipe);
        f.bench->arm();
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("enrollSqueezeButton"));
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().squeezes().size(), std::size_t(1), longEnough_ms);
        const std::vector<double>& force = f.bench->enrollment().squeezes().front().recording.force;
        for (const double level : {12.0, 18.0, 15.0, 9.0}) // an eighth of a second each, at 2 kHz
            QCOMPARE(std::ranges::count_if(
                         force, [level](double measured) { return std::abs(measured - level) < 0.2; }),
                     250);
    }
    void whatDoesNotFitIsSaidBeforeAnythingMoves()
    {
        WindowFixture f(false, unhurriedA);
        beginType(f, u"Cola"_s);
        choose(*onPage<QComboBox>(f, "recipeKind"), ExcitationKind::InverseRepeat);
        const auto* form = onPage<EnrollRecipeForm>(f);
        QVERIFY(form->isValid());
        QDoubleSpinBox* seconds = nullptr;
        for (auto* field : form->findChildren<QDoubleSpinBox*>())
            if (field->accessibleName() == u"Length"_s)
                seconds = field;
        QVERIFY(seconds);
        seconds->setValue(0.2); // 40 bits of 5 ms: eight periods of 14 do not fit
        QVERIFY(!form->isValid());
        QVERIFY(onPage<QLabel>(f, "recipeSummary")->text().contains(u"at least 0.56 s"_s));
        QVERIFY(!f.find<QPushButton>("recipeNext")->isEnabled());
        choose(*onPage<QComboBox>(f, "recipeKind"), ExcitationKind::FourLevel);
        QVERIFY(form->isValid());
    }
};

GRIPSCOPE_TEST(RecipeFormTest)
#include "recipe_form_test.moc"
