// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/normal_interval.h"
#include "core/session/calibrate/measuring_sessions.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/shared/guided_squeezes.h"
#include "ui/shell/connect_menu.h"
#include "ui/widgets/controls.h"

#include <QLabel>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString lagText(const LagEstimate& lag)
{
    if (!lag.hasValue())
        return lag.message.describe();
    return formatNumber(lag.lag_s, normal95 * lag.standardError_s, u"s"_s).text();
}

} // namespace

struct LagDialog::Private {
    explicit Private(Workbench& bench) : workbench(bench), session(bench.connection(), bench.library()) {}

    Workbench& workbench;
    LagSession session;
    Recipe recipe;
    GuidedSqueezes* guide = nullptr;
    [[nodiscard]] bool usable() const { return session.result().status == LagStatus::Measured; }
};

namespace {
const RegisteredDialog<LagDialog> lagDialogRow("lag", [](Workbench& bench, QWidget* over) {
    return new LagDialog(bench, over);
});
} // namespace

LagDialog::LagDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), d(std::make_unique<Private>(workbench))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("lagDialog");
    setManualPage(u"records"_s);
    setWindowTitle(tr("Lag between the channels"));
    build();
}

LagDialog::~LagDialog() = default;

void LagDialog::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    auto* what = makeLabel(
        tr("A gripper samples the position a little later than the force. A lag of 100 µs that nobody knows "
           "of "
           "changes the mass of a can by a tenth. Grip something firm, a spring or a can of any type, and "
           "leave it there: the gripper squeezes it %1 times, with %2 for %3 s.")
            .arg(QString::number(LagSession::usualSqueezes), pushText(d->recipe.bias_N, d->recipe.peak_N),
                 Words::number(d->recipe.seconds)),
        "", this);
    what->setWordWrap(true);
    column->addWidget(what);
    GuidedSqueezes::Script script;
    script.name = u"lag"_s;
    script.begin = [] { return tr("Squeeze %1 times").arg(LagSession::usualSqueezes); };
    script.again = [] { return tr("Measure again"); };
    script.start = [this] { return d->session.start(d->recipe); };
    script.found = [this] { return found(); };
    script.outcome = [this] { return outcome(); };
    script.use = tr("Use this lag");
    script.usable = [this] { return d->usable(); };
    script.accept = [this] { return d->session.accept(); };
    d->guide = new GuidedSqueezes(d->workbench, d->session, std::move(script), this);
    d->guide->button()->setDefault(true);
    auto* close = makeButton(tr("Close"), {}, "", this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    d->guide->addButton(close);
    column->addWidget(d->guide, 1);
    resize(520, 340);
}

QString LagDialog::found() const
{
    QStringList found;
    for (const LagEstimate& squeeze : d->session.squeezes())
        found << lagText(squeeze);
    return found.join(u"   ·   "_s);
}

QString LagDialog::outcome() const
{
    if (d->session.state() == LagSession::State::Stored)
        return tr("In use: %1. It is kept for gripper %2, and its uncertainty goes into every error bar.")
            .arg(lagText(d->session.result()), d->workbench.connection().identity().serial);
    return d->usable() ? tr("The position is sampled %1 (95 %) later than the force.")
                             .arg(lagText(d->session.result()))
                       : d->session.result().message.describe();
}

void LagDialog::done(int result)
{
    d->guide->leave();
    Dialog::done(result);
}

} // namespace gripscope
