// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/measuring_sessions.h"
#include "ui/context/workbench.h"
#include "ui/format/fact.h"
#include "ui/format/parameter_text.h"
#include "ui/format/reference_words.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/pages/shared/guided_squeezes.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

ParameterTexts textsOf(const GripperBaseline& baseline, const GripperIdentity& identity)
{
    return parameterTexts(
        {baseline.parameters[0], baseline.parameters[1], baseline.parameters[2]},
        Eigen::Vector3d(baseline.standardErrors[0], baseline.standardErrors[1], baseline.standardErrors[2]),
        identity.forceUnit, identity.positionUnit);
}

std::vector<Fact> factsOf(const GripperBaseline& baseline, const GripperIdentity& identity)
{
    const ParameterTexts texts = textsOf(baseline, identity);
    return {{ReferenceWords::quantity(2), texts.k.text()},
            {ReferenceWords::quantity(1), texts.b.text()},
            {ReferenceWords::quantity(0), texts.m.text()}};
}

} // namespace

struct CalibrateBaseline::Private {
    explicit Private(Workbench& workbench)
        : bench(workbench), session(workbench.connection(), workbench.library())
    {
    }

    Workbench& bench;
    BaselineSession session;
    EnrollRecipeForm* recipe = nullptr;
    GuidedSqueezes* guide = nullptr;
    QGridLayout* inUse = nullptr;
    QLabel* meaning = nullptr;
    QPushButton* remove = nullptr;
};

CalibrateBaseline::CalibrateBaseline(Workbench& workbench, QWidget* parent)
    : QWidget(parent), d(std::make_unique<Private>(workbench))
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeMeasuring(), 1);
    row->addWidget(makeInUse());
    connect(&workbench, &Workbench::connectionChanged, this, &CalibrateBaseline::showInUse);
    connect(d->guide, &GuidedSqueezes::changed, this, &CalibrateBaseline::showInUse);
    showInUse();
}

CalibrateBaseline::~CalibrateBaseline() = default;

QWidget* CalibrateBaseline::makeMeasuring()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 12);
    column->addWidget(makeLabel(tr("The empty gripper"), "heading", card));
    auto* what = makeLabel(
        tr("Fingers and drive have a mass, a damping and a stiffness of their own, which add to the part's. "
           "Take everything out of the gripper and measure it with the force that the parts are squeezed "
           "with: it squeezes nothing, %n times.",
           nullptr, BaselineSession::usualSqueezes),
        "second", card);
    what->setWordWrap(true);
    column->addWidget(what);
    d->recipe = new EnrollRecipeForm(d->bench, EnrollRecipeForm::Gripped::Nothing, card);
    column->addWidget(d->recipe);
    column->addWidget(makeRule(card));

    GuidedSqueezes::Script script;
    script.name = u"baseline"_s;
    script.begin = [] { return tr("Squeeze nothing (Space)"); };
    script.again = [] { return tr("Measure again (Space)"); };
    script.obstacle = [this] {
        return d->recipe->isValid() ? QString() : tr("Change the forces above first.");
    };
    script.start = [this] { return d->session.start(d->recipe->recipe()); };
    script.found = [this] { return found(); };
    script.outcome = [this] { return outcome(); };
    script.use = tr("Take it off from now on");
    script.usable = [this] { return d->session.baseline().has_value(); };
    script.accept = [this] { return d->session.accept(); };
    d->guide = new GuidedSqueezes(d->bench, d->session, std::move(script), card);
    connect(d->recipe, &EnrollRecipeForm::changed, d->guide, &GuidedSqueezes::refresh);
    column->addWidget(d->guide, 1);
    return card;
}

QWidget* CalibrateBaseline::makeInUse()
{
    QFrame* card = makeCard(this);
    card->setFixedWidth(336);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 12);
    column->addWidget(makeLabel(tr("Taken off now"), "heading", card));
    d->inUse = makeFactGrid();
    column->addLayout(d->inUse);
    d->meaning = makeLabel({}, "second", card);
    d->meaning->setObjectName("baselineMeaning");
    d->meaning->setWordWrap(true);
    column->addWidget(d->meaning);
    column->addStretch(1);
    d->remove = makeButton(tr("Take nothing off any more"), u"edit-delete"_s, "", card);
    d->remove->setObjectName("baselineRemove");
    connect(d->remove, &QPushButton::clicked, this, &CalibrateBaseline::remove);
    column->addWidget(d->remove);
    return card;
}

QString CalibrateBaseline::found() const
{
    QStringList found;
    const GripperIdentity identity = d->bench.connection().identity();
    for (const Identification& squeeze : d->session.squeezes())
        found << tr("k %1").arg(parameterTexts(squeeze, identity.forceUnit, identity.positionUnit).k.text());
    return found.join(u"   ·   "_s);
}

QString CalibrateBaseline::outcome() const
{
    if (!d->session.baseline())
        return d->session.problem().isEmpty()
                   ? QString()
                   : tr("Not valid, so nothing changes: %1").arg(asSentence(d->session.problem()));
    const ParameterTexts texts = textsOf(*d->session.baseline(), d->bench.connection().identity());
    const QString numbers = tr("m %1, b %2, k %3 (95 %)").arg(texts.m.text(), texts.b.text(), texts.k.text());
    return d->session.state() == SeriesSession::State::Stored
               ? tr("In use for gripper %1: %2.").arg(d->bench.connection().identity().serial, numbers)
               : tr("The empty gripper: %1.").arg(numbers);
}

void CalibrateBaseline::showInUse()
{
    ConnectSession& connection = d->bench.connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const std::optional<GripperBaseline>& baseline = connection.measuringChain().baseline;
    const bool known = connected && baseline;
    fillFacts(d->inUse, known ? factsOf(*baseline, connection.identity()) : std::vector<Fact>());
    d->meaning->setText(
        known
            ? tr("These are taken off every later squeeze before it is shown, enrolled or judged, and their "
                 "uncertainty goes into its error bars. Types that were enrolled without this include the "
                 "fingers: enroll them again. Measure anew when the fingers are changed.")
            : tr("Nothing. The m, b and k of a part include those of the fingers, in enrolled types and in "
                 "inspections alike, so that they still compare on this gripper."));
    d->remove->setVisible(known);
    d->remove->setEnabled(!d->session.busy());
    d->recipe->setEnabled(!d->session.busy());
}

void CalibrateBaseline::remove()
{
    askWhy(this, d->remove->text(), [this](const QString& reason) {
        authorize(d->bench, this, Permission::AcceptCalibrations, [this, reason] {
            d->session.setOperator(d->bench.operatorName());
            d->session.setReason(reason);
            if (const Expected<void> answer = d->session.remove(); !answer)
                d->bench.messages().report(answer.error().describe());
            d->guide->refresh();
        });
    });
}

void CalibrateBaseline::act()
{
    if (d->guide->button()->isEnabled())
        d->guide->act();
}

bool CalibrateBaseline::underWay() const
{
    return d->session.busy() ||
           (d->session.state() == SeriesSession::State::Measured && d->session.baseline() && isVisible());
}

void CalibrateBaseline::leave()
{
    d->guide->leave();
}

} // namespace gripscope
