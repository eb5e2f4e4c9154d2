// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lag_dialog.h"

#include "core/session/lag_session.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
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
    QLabel *squeezes = nullptr, *outcome = nullptr;
    QProgressBar* progress = nullptr;
    QPushButton *act = nullptr, *close = nullptr;

    bool claimed = false; ///< this dialog told the window that a squeeze is under way
    void claim(bool on)
    {
        if (claimed != on)
            workbench.setTrialRunning(on);
        claimed = on;
    }
    [[nodiscard]] bool busy() const
    {
        return session.state() == LagSession::State::Squeezing ||
               session.state() == LagSession::State::Judging || session.state() == LagSession::State::Storing;
    }
    [[nodiscard]] bool usable() const
    {
        return session.state() == LagSession::State::Measured &&
               session.result().status == LagStatus::Measured;
    }
};

LagDialog::LagDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), d(std::make_unique<Private>(workbench))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("lagDialog");
    setWindowTitle(tr("Lag between the channels"));
    build();
    connect(&workbench, &Workbench::ticked, this, [this] {
        if (d->session.poll() || d->busy())
            refresh();
    });
    connect(&workbench, &Workbench::connectionChanged, this, &LagDialog::refresh);
    connect(&workbench, &Workbench::stopped, this, [this] {
        d->session.cancel();
        refresh(); // the window must not think that the squeeze goes on
    });
    refresh();
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
    d->progress = new QProgressBar(this);
    d->progress->setTextVisible(false);
    d->progress->setAccessibleName(tr("Squeezes"));
    column->addWidget(d->progress);
    d->squeezes = makeLabel({}, "second", this);
    d->squeezes->setWordWrap(true);
    column->addWidget(d->squeezes);
    d->outcome = makeLabel({}, "strong", this);
    d->outcome->setObjectName("lagOutcome");
    d->outcome->setWordWrap(true);
    column->addWidget(d->outcome);
    column->addStretch(1);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    d->close = makeButton(tr("Close"), {}, "", this);
    d->act = makeButton({}, {}, "primary", this);
    d->act->setObjectName("lagAct");
    d->act->setDefault(true);
    row->addWidget(d->close);
    row->addWidget(d->act);
    column->addLayout(row);
    connect(d->close, &QPushButton::clicked, this, &QDialog::reject);
    connect(d->act, &QPushButton::clicked, this, &LagDialog::act);
    resize(520, 340);
}

void LagDialog::act()
{
    Expected<void> answer;
    if (d->busy()) {
        d->session.cancel();
    } else if (!d->workbench.connection().armed()) {
        d->workbench.arm();
    } else if (d->usable()) {
        answer = d->session.accept();
    } else if (d->workbench.squeezing()) {
        d->workbench.report(tr("Another squeeze is under way. Wait for its end, then try again."));
    } else {
        d->session.setOperator(d->workbench.operatorName());
        answer = d->session.start(d->recipe);
        d->claim(answer.has_value());
    }
    if (!answer)
        d->workbench.report(answer.error().describe());
    refresh();
}

QString LagDialog::outcome() const
{
    using State = LagSession::State;
    ConnectSession& connection = d->workbench.connection();
    switch (d->session.state()) {
    case State::Measured:
        return d->usable() ? tr("The position is sampled %1 (95 %) later than the force.")
                                 .arg(lagText(d->session.result()))
                           : d->session.result().message;
    case State::Stored:
        return tr("In use: %1. It is kept for gripper %2, and its uncertainty goes into every error bar.")
            .arg(lagText(d->session.result()), connection.identity().serial);
    case State::Failed:
        return d->session.error()->describe();
    default:
        break;
    }
    if (connection.state() != ConnectSession::State::Connected)
        return tr("No gripper is connected. Close this, and choose one at the top.");
    if (!connection.identity().commandable)
        return tr("This gripper only streams, so that it cannot be measured from here.");
    return connection.armed() ? QString() : tr("Hands clear, then arm.");
}

void LagDialog::refresh()
{
    const ConnectSession& connection = d->workbench.connection();
    const bool ready =
        connection.state() == ConnectSession::State::Connected && connection.identity().commandable;
    if (!d->busy())
        d->claim(false);
    d->progress->setValue(static_cast<int>(100 * d->session.progress()));
    QStringList found;
    for (const LagEstimate& squeeze : d->session.squeezes())
        found << lagText(squeeze);
    d->squeezes->setText(found.join(u"   ·   "_s));
    d->outcome->setText(outcome());
    const QString text = d->busy()             ? tr("Cancel")
                         : !connection.armed() ? tr("Arm")
                         : d->usable()         ? tr("Use this lag")
                         : d->session.state() == LagSession::State::Idle
                             ? tr("Squeeze %1 times").arg(LagSession::usualSqueezes)
                             : tr("Measure again");
    d->act->setText(text);
    d->act->setEnabled(ready && d->session.state() != LagSession::State::Storing);
}

void LagDialog::done(int result)
{
    d->session.cancel();
    d->claim(false);
    QDialog::done(result);
}

} // namespace gripscope
