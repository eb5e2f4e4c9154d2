// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/shared/type_limits_dialog.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;

namespace {

/// The window with the editor of limits open from the Types page.
struct OpenLimits {
    WindowFixture f{true, {}};
    OpenLimits() { open(); }
    void open()
    {
        f.window->showPage(u"types"_s);
        f.click(f.find<QPushButton>("typeLimitsButton"));
        if (!QTest::qWaitFor([this] { return dialog() && type()->count() == 4; }, longEnough_ms))
            qFatal("the types were not listed");
    }
    TypeLimitsDialog* dialog() const { return f.window->findChild<TypeLimitsDialog*>(); }
    template <typename Widget>
    Widget* in(const char* name) const
    {
        return dialog()->findChild<Widget*>(QString::fromLatin1(name));
    }
    QComboBox* type() const { return in<QComboBox>("limitsType"); }
    QPushButton* keep() const { return in<QPushButton>("limitsKeep"); }
    /// By key, as a person does: the field is clicked, emptied and typed into.
    void typeInto(const char* name, const QString& text) const
    {
        auto* field = in<QLineEdit>(name);
        QTest::mouseClick(field, Qt::LeftButton);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
    }
    std::optional<TypeRecord> stored() const
    {
        const auto found =
            f.bench->library()
                .run<std::optional<TypeRecord>>([](Library& library) { return library.findType(u"A"_s); })
                .get();
        return found ? *found : std::nullopt;
    }
};

} // namespace

/// Tolerance limits are typed, shown with their risks, kept with a reason, and taken away again.
class TypeLimitsDialogTest : public QObject {
    Q_OBJECT
private slots:
    void limitsAreTypedAndKept()
    {
        OpenLimits d;
        QVERIFY(!d.keep()->isEnabled());
        QVERIFY(d.in<QLabel>("limitsRisks")->text().contains(u"nothing is said"_s));
        d.typeInto("lowerStiffness", u"9"_s);
        d.typeInto("upperStiffness", u"11.5"_s);
        QVERIFY(!d.keep()->isEnabled()); // not without a reason
        QTRY_VERIFY_WITH_TIMEOUT(!d.in<QLabel>("limitsRisks")->text().contains(u"nothing is said"_s),
                                 longEnough_ms);
        d.typeInto("limitsReason", u"drawing 4711"_s);
        QVERIFY(d.keep()->isEnabled());
        d.f.click(d.keep());
        QTRY_VERIFY_WITH_TIMEOUT(!d.dialog(), longEnough_ms);
        const PartLimits limits = d.stored()->limits;
        QVERIFY(limits.rule == ConformityRule::Iso14253);
        QCOMPARE(limits.quantities[2]->lower.value(), 9000.0); // typed in kN/m, kept in N/m
        QCOMPARE(limits.quantities[2]->upper.value(), 11500.0);
        QVERIFY(!limits.quantities[0] && !limits.quantities[1]);
        // They are shown again, and taken away by emptying them.
        d.open();
        QTRY_COMPARE_WITH_TIMEOUT(d.in<QLineEdit>("upperStiffness")->text(), u"11.5"_s, longEnough_ms);
        d.typeInto("limitsReason", u"no longer asked for"_s);
        QVERIFY(!d.keep()->isEnabled()); // nothing was changed
        d.typeInto("lowerStiffness", {});
        d.typeInto("upperStiffness", {});
        d.f.click(d.keep());
        QTRY_VERIFY_WITH_TIMEOUT(!d.dialog(), longEnough_ms);
        QVERIFY(d.stored()->limits.isEmpty());
    }
    void whatMakesNoSenseIsSaid()
    {
        OpenLimits d;
        d.typeInto("limitsReason", u"drawing"_s);
        d.typeInto("lowerMass", u"abc"_s);
        QVERIFY(d.in<QLabel>("limitsProblem")->text().contains(u"not a number"_s));
        QVERIFY(!d.keep()->isEnabled());
        d.typeInto("lowerMass", u"50"_s);
        d.typeInto("upperMass", u"40"_s);
        QVERIFY(!d.in<QLabel>("limitsProblem")->text().isEmpty());
        QVERIFY(!d.keep()->isEnabled());
        d.typeInto("upperMass", u"60"_s);
        QVERIFY(d.in<QLabel>("limitsProblem")->text().isEmpty());
        QVERIFY(d.keep()->isEnabled());
        QTest::keyClick(d.dialog(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!d.dialog(), longEnough_ms);
        QVERIFY(d.stored()->limits.isEmpty());
    }
    void aRiskIsAskedForWhereItDecides()
    {
        OpenLimits d;
        auto* rule = d.in<QComboBox>("limitsRule");
        QVERIFY(!d.in<QDoubleSpinBox>("limitsRisk")->isVisible());
        rule->setFocus();
        QTest::keyClick(rule, Qt::Key_Down);
        QVERIFY(d.in<QDoubleSpinBox>("limitsRisk")->isVisible());
        d.typeInto("upperStiffness", u"11"_s);
        auto* risk = d.in<QDoubleSpinBox>("limitsRisk");
        risk->selectAll();
        QTest::keyClicks(risk, u"1"_s);
        QTest::keyClick(risk, Qt::Key_Tab);
        d.typeInto("limitsReason", u"drawing"_s);
        d.f.click(d.keep());
        QTRY_VERIFY_WITH_TIMEOUT(!d.dialog(), longEnough_ms);
        QVERIFY(d.stored()->limits.rule == ConformityRule::ConsumersRisk);
        QCOMPARE(d.stored()->limits.risk, 0.01);
        QVERIFY(!d.stored()->limits.quantities[2]->lower);
    }
    void theVerdictOnTheInspectPageSaysIt()
    {
        WindowFixture f(true, gripscope::test::unhurriedA);
        PartLimits limits;
        limits.quantities[2] = ToleranceLimits{{}, 9000.0}; // A has 9990 N/m
        const auto set = f.bench->library()
                             .run<TypeRecord>([limits](Library& library) -> Expected<TypeRecord> {
                                 ASSIGN_OR_RETURN(const auto type, library.findType(u"A"_s));
                                 return library.setTypeLimits(type->id, limits, {u"Mai"_s, u"drawing"_s});
                             })
                             .get();
        QVERIFY(set);
        f.bench->tellLibraryChanged();
        f.window->showPage(u"inspect"_s);
        auto* panel = f.find<VerdictPanel>("verdictPanel");
        QVERIFY(f.inRealTime([&f] { (void)f.bench->inspection().squeeze(); },
                             [panel] { return panel->outcome() == InspectionOutcome::DoesNotConform; }));
        QVERIFY(f.bench->inspection().result()->verdict.conformity);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().doesNotConform, 1, longEnough_ms);
        QCOMPARE(panel->accessibleName(), u"A"_s);
        QVERIFY(panel->accessibleDescription().contains(u"does not conform"_s));
    }
};

GRIPSCOPE_TEST(TypeLimitsDialogTest)
#include "type_limits_dialog_test.moc"
