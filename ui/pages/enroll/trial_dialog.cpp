// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/verdict.h"
#include "core/session/enroll/trial_session.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/pages/enroll/enroll_review_panel.h"
#include "ui/pages/shared/guided_squeezes.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

struct TrialDialog::Private {
    Private(Workbench& bench, QString name, Recipe squeezed)
        : workbench(bench), session(bench.connection(), bench.library()), type(std::move(name)),
          recipe(std::move(squeezed))
    {
    }
    Workbench& workbench;
    TrialSession session;
    QString type;
    Recipe recipe;
    GuidedSqueezes* guide = nullptr;
};

namespace {
const RegisteredDialog<TrialDialog> trialDialogRow("trial", [](Workbench& bench, QWidget* over) {
    return new TrialDialog(bench, u"A"_s, {}, over);
});

/// "Trial: it would be A (posterior 0.9998)." and why.
QString trialWords(const Verdict& verdict)
{
    QString words;
    switch (verdict.kind) {
    case VerdictKind::Type:
        words = TrialDialog::tr("Trial: it would be %1 (posterior %2).")
                    .arg(verdict.type,
                         formatProbability(std::min(verdict.posterior.value(verdict.type), 1 - 1e-15)));
        break;
    case VerdictKind::Unknown:
        words = TrialDialog::tr("Trial: it would be unknown.");
        break;
    case VerdictKind::Inconclusive:
        words = TrialDialog::tr("Trial: it would be inconclusive.");
        break;
    case VerdictKind::Invalid:
        words = TrialDialog::tr("Trial: it would not be judged.");
        break;
    }
    return QStringList{words, described(verdict.allReasons()).join(u' ')}.join(u'\n').trimmed();
}

} // namespace

TrialDialog::TrialDialog(Workbench& workbench, const QString& type, const Recipe& recipe, QWidget* parent)
    : Dialog(parent), d(std::make_unique<Private>(workbench, type, recipe))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("trialDialog");
    setManualPage(u"enroll"_s);
    setWindowTitle(titleText(tr("Try %1").arg(type)));
    build();
}

TrialDialog::~TrialDialog() = default;

void TrialDialog::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(tr("What would a part be called?"), "heading", this));
    QLabel* what =
        makeLabel(tr("The part is held against the approved types and %1, at the rates that are set. "
                     "This is a trial: nothing is stored, counted or approved.")
                      .arg(d->type),
                  "", this);
    what->setWordWrap(true);
    column->addWidget(what);
    GuidedSqueezes::Script script;
    script.name = u"trial"_s;
    script.begin = [] { return tr("Squeeze"); };
    script.again = [] { return tr("Squeeze again"); };
    script.start = [this] { return d->session.start(d->type, d->recipe, d->workbench.rates().rates); };
    script.found = [] { return QString(); };
    script.outcome = [this] { return d->session.verdict() ? trialWords(*d->session.verdict()) : QString(); };
    d->guide = new GuidedSqueezes(d->workbench, d->session, std::move(script), this);
    d->guide->button()->setDefault(true);
    auto* close = makeButton(tr("Close"), {}, "", this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    d->guide->addButton(close);
    column->addWidget(d->guide, 1);
    resize(520, 340);
}

void TrialDialog::done(int result)
{
    d->guide->leave();
    Dialog::done(result);
}

} // namespace gripscope
