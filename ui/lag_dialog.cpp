// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lag_dialog.h"

#include "core/session/lag_session.h"
#include "ui/guided_squeezes.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"
#include "ui/workbench.h"

#include <QLabel>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString lagText(const LagEstimate& lag)
{
    constexpr double halfWidth95 = 1.96;
    if (!lag.hasValue())
        return lag.message;
    return formatNumber(lag.lag_s, halfWidth95 * lag.standardError_s, u"s"_s).text();
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

LagDialog::LagDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), d(std::make_unique<Private>(workbench))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("lagDialog");
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
           "leave it there: the gripper squeezes it %1 times, with %2 ± %3 N for %4 s.")
            .arg(LagSession::usualSqueezes)
            .arg(d->recipe.bias_N)
            .arg(d->recipe.peak_N)
            .arg(d->recipe.seconds),
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
                       : d->session.result().message;
}

void LagDialog::done(int result)
{
    d->guide->leave();
    QDialog::done(result);
}

} // namespace gripscope
