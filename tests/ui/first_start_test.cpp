// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"

#include <QLineEdit>
#include <QPushButton>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

constexpr int mostClicksAndKeys = 12;

/// Presses keys and buttons as a newcomer would, and counts them. A key goes to whatever has the focus: what
/// is pressed is what the program itself put forward.
class Newcomer {
public:
    explicit Newcomer(WindowFixture& fixture) : m_fixture(&fixture) {}

    void press(Qt::Key key)
    {
        ++m_count;
        QWidget* focus = m_fixture->window->focusWidget();
        QTest::keyClick(focus ? focus : m_fixture->window.get(), key);
    }
    void click(const char* button)
    {
        ++m_count;
        WindowFixture::click(m_fixture->find<QAbstractButton>(button));
    }
    [[nodiscard]] int count() const { return m_count; }

private:
    WindowFixture* m_fixture;
    int m_count = 0;
};

} // namespace

/// From an empty library and no settings to a verdict, with what the screen offers and no manual.
class FirstStartTest : public QObject {
    Q_OBJECT
private slots:
    void aNewcomerGetsAVerdictInTwelveClicksOrKeys();
    void exampleTypesAreOfferedWhereNothingIsEnrolled();
};

void FirstStartTest::aNewcomerGetsAVerdictInTwelveClicksOrKeys()
{
    WindowFixture f(false, u"virtual:"_s); // to which the program connects by itself
    f.bench->setOperatorName({});
    Newcomer newcomer(f);
    EnrollSession& session = f.bench->enrollment();

    QCOMPARE(f.window->currentPage()->id(), u"live"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->live().history().newestTime_s() > 0.1, gripscope::test::longEnough_ms);

    newcomer.click("rail-enroll");
    QTRY_COMPARE(f.find<QLineEdit>("typeName")->text(), u"Type 1"_s);
    newcomer.press(Qt::Key_Return);
    QTRY_COMPARE(session.step(), EnrollSession::Step::Recipe);
    newcomer.press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(session.step(), EnrollSession::Step::Squeeze, gripscope::test::longEnough_ms);
    QCOMPARE(f.bench->connection().armed(), false);
    newcomer.press(Qt::Key_Space); // on "Arm the gripper", which has the focus
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    // Four squeezes give a type its first gate.
    for (int squeezes = 1; squeezes <= 4; ++squeezes) {
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("enrollSqueezeButton")->hasFocus(),
                                 gripscope::test::longEnough_ms);
        newcomer.press(Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(session.acceptedCount(), squeezes, gripscope::test::longEnough_ms);
    }
    newcomer.click("reviewButton");
    QTRY_COMPARE(session.step(), EnrollSession::Step::Review);
    newcomer.press(Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(session.step(), EnrollSession::Step::Approved, gripscope::test::longEnough_ms);
    newcomer.press(Qt::Key_Space);
    QTRY_COMPARE(f.window->currentPage()->id(), u"inspect"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("squeezeButton")->hasFocus() &&
                                 f.bench->inspection().models().find(u"Type 1"_s),
                             gripscope::test::longEnough_ms);
    newcomer.press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().result() && f.bench->inspection().result()->number != 0,
                             gripscope::test::longEnough_ms);
    // Four squeezes give the type a gate, and the same part again is named as itself.
    const auto& result = *f.bench->inspection().result();
    QVERIFY2(result.verdict.kind == VerdictKind::Type,
             qPrintable(toString(result.verdict.kind) + u' ' + described(result.verdict.reasons).join(u' ')));
    QCOMPARE(result.verdict.type, u"Type 1"_s);
    QVERIFY2(newcomer.count() <= mostClicksAndKeys, qPrintable(QString::number(newcomer.count())));

    // It is in the library: one approved type, four squeezes, one inspection.
    const auto types =
        f.bench->library().run<std::vector<TypeRecord>>([](Library& l) { return l.types(); }).get();
    QVERIFY(types && types->size() == 1 && types->front().approved && types->front().squeezes == 4);
    const auto inspections =
        f.bench->library()
            .run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
            .get();
    QCOMPARE(inspections->size(), std::size_t(1));
    QCOMPARE(inspections->front().nearest, u"Type 1"_s);
}

void FirstStartTest::exampleTypesAreOfferedWhereNothingIsEnrolled()
{
    WindowFixture f(false);
    f.window->showPage(u"inspect"_s);
    auto* load = f.page(u"inspect"_s)->findChild<QPushButton*>(u"loadExampleTypes"_s);
    QVERIFY(load);
    QTRY_VERIFY_WITH_TIMEOUT(load->isVisible(), gripscope::test::longEnough_ms);
    f.click(load);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().types().size(), std::size_t(4),
                              gripscope::test::longEnough_ms);
    QTRY_VERIFY(!load->isVisible());
}

GRIPSCOPE_TEST(FirstStartTest)
#include "first_start_test.moc"
