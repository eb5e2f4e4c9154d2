// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does on the Inspect page beside squeezing.
#include "ui/context/workbench.h"
#include "ui/pages/inspect/inspect_automatic.h"
#include "ui/pages/inspect/inspect_page_private.h"
#include "ui/people/authorize.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fitted_label.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/windows/question.h"
#include "ui/windows/window_guard.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int longestReason = 200;
constexpr int dialogWidth = 480;

const RegisteredDialog<VoidDialog> voidDialogRow("void", [](Workbench&, QWidget* over) {
    return new VoidDialog(1, over);
});
} // namespace

VoidDialog::VoidDialog(qint64 number, QWidget* parent)
    : Dialog(parent), m_reason(new QLineEdit(this)), m_accept(makeButton(tr("Void it"), {}, "primary", this))
{
    setObjectName("voidDialog");
    const QString title = tr("Void inspection %1").arg(number);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    QLabel* words = makeLabel(tr("It stays on record with the reason, and counts neither in the yield nor in "
                                 "the batch. This cannot be undone."),
                              "second", this);
    words->setWordWrap(true);
    QPushButton* twice = makeButton(tr("Squeezed twice"), {}, "", this);
    twice->setObjectName("voidTwice");
    QPushButton* empty = makeButton(tr("Nothing in the jaws"), {}, "", this);
    empty->setObjectName("voidEmpty");
    m_reason->setObjectName("voidReason");
    m_reason->setMaxLength(longestReason);
    m_reason->setPlaceholderText(tr("or why else"));
    m_reason->setAccessibleName(tr("Why it does not count"));
    m_accept->setObjectName("voidAccept");
    m_accept->setEnabled(false);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    for (QPushButton* button : {twice, empty, cancel, m_accept})
        button->setAutoDefault(false); // a scanner's Enter voids nothing
    auto* reasons = new QHBoxLayout;
    reasons->setSpacing(8);
    reasons->addWidget(twice, 1);
    reasons->addWidget(empty, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_accept);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(title, "heading", this));
    column->addWidget(words);
    column->addLayout(reasons);
    column->addWidget(m_reason);
    column->addStretch(1);
    column->addLayout(buttons);
    connect(twice, &QPushButton::clicked, this, [this, twice] { give(twice->text()); });
    connect(empty, &QPushButton::clicked, this, [this, empty] { give(empty->text()); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, [this] { give(m_reason->text()); });
    connect(m_reason, &QLineEdit::textChanged, this,
            [this](const QString& text) { m_accept->setEnabled(!text.trimmed().isEmpty()); });
    resize(dialogWidth, layout()->totalHeightForWidth(dialogWidth));
    m_reason->setFocus();
}

void VoidDialog::give(const QString& reason)
{
    emit answered(reason.trimmed());
    accept();
}

bool InspectPage::attended() const
{
    return isVisible() && !window()->isMinimized() && !WindowGuard::asking();
}

void InspectPage::followAutomatic()
{
    // In front, so that the countdown is seen and a key reaches this page.
    const bool ready = d->active && attended() && isActiveWindow() && !QApplication::activePopupWidget() &&
                       d->squeeze->isEnabled() && !batchIsOver();
    d->automatic->follow(ready);
}

void InspectPage::takeButton()
{
    const bool busy =
        workbench().squeezing() || workbench().inspection().state() != InspectSession::State::Ready;
    if (!attended() || busy) // one press, one squeeze: a press during it is not kept
        return;
    if (d->squeeze->isEnabled())
        return squeeze();
    d->notice = buttonHint();
    refresh();
}

bool InspectPage::batchIsOver() const
{
    const std::optional<BatchRecord>& batch = workbench().inspection().batch();
    return batch && batch->ended && batch->id == d->wholeBatch && batch->id != d->decidedBatch;
}

/// It squeezes nothing by itself: who answers has the hands elsewhere than at the part.
void InspectPage::askToGoOn()
{
    const BatchRecord& batch = *workbench().inspection().batch();
    auto* question = new Question(
        tr("Batch %1 has ended. Go on without a batch?").arg(batch.name),
        tr("Further parts then belong to no batch. To count them, begin the next batch at the right."),
        tr("Go on without a batch"), tr("Not now"), this);
    question->setObjectName("outsideBatchDialog");
    question->yes()->setObjectName("outsideBatchAccept");
    connect(question, &QDialog::accepted, this, [this, id = batch.id] {
        d->decidedBatch = id;
        refresh();
    });
    question->open();
}

void InspectPage::askToVoid()
{
    const auto& result = workbench().inspection().result();
    if (!result || result->number == 0 || result->voided)
        return;
    auto* dialog = new VoidDialog(result->number, this);
    connect(dialog, &VoidDialog::answered, this, [this, which = result->squeeze](const QString& reason) {
        const auto& now = workbench().inspection().result();
        if (now && now->squeeze == which)
            workbench().inspection().voidLast(reason);
    });
    dialog->open();
}

void InspectPage::takeScan(const QString& text)
{
    if (!workbench().settings().get(setting::partNumbers) || d->expected->knows(text))
        return d->expected->choose(text);
    workbench().inspection().setPartNumber(text.left(longestPartNumber));
    refresh();
    focusSqueeze();
}

int InspectPage::callAfter() const
{
    return static_cast<int>(workbench().settings().get(setting::invalidInARow));
}

void InspectPage::refreshPart()
{
    const bool parts = workbench().settings().get(setting::partNumbers);
    d->part->setVisible(parts);
    d->expected->setMinimumWidth(parts ? 152 : 200);
    if (const QString& part = workbench().inspection().partNumber(); d->part->text().trimmed() != part)
        d->part->setText(part);
    const auto& result = workbench().inspection().result();
    d->voidLast->setEnabled(result && result->number != 0 && !result->voided &&
                            !workbench().inspection().changingBatch());
    d->voidLast->setVisible(!workbench().inspection().types().empty());
    if (result && result->voided && std::exchange(d->toldVoided, result->squeeze) != result->squeeze)
        workbench().tellLibraryChanged(); // the lists show it struck
    refreshBatchEnd();
}

void InspectPage::refreshBatchEnd()
{
    const std::optional<BatchRecord>& batch = workbench().inspection().batch();
    if (batch && batch->ended && batch->whole())
        d->wholeBatch = batch->id;
    d->over->setVisible(batchIsOver());
    if (batchIsOver())
        d->over->setText(batch->whole() ? tr("Batch %1 is complete").arg(batch->name)
                                        : tr("Batch %1 has ended").arg(batch->name));
}

bool InspectPage::isInUse(const QString& type) const
{
    const std::vector<TypeRecord>& all = workbench().inspection().types();
    return std::any_of(all.begin(), all.end(), [&type](const TypeRecord& one) { return one.name == type; });
}

/// It is gone, or waits for its approval; then it is expected again with that.
void InspectPage::forgetExpected()
{
    const QString before = d->expectedNow;
    expect(d->expected->expected());
    const bool waits = isInUse(before) && d->expected->findData(before) < 0;
    if (!waits)
        return;
    workbench().settings().set(setting::expectedType, before);
    d->recalled = false;
}

void InspectPage::recallExpected()
{
    const QString before = workbench().settings().get(setting::expectedType);
    const bool approved = !before.isEmpty() && d->expected->findData(before) > 0;
    d->recalled = approved || !isInUse(before);
    if (approved)
        d->expected->choose(before);
}

void InspectPage::editRates()
{
    const StoredRates now = workbench().rates();
    auto* dialog = new RatesDialog(now.rates, now.earlyEnd, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        changeRates(workbench(), this, {dialog->rates(), dialog->earlyEnd()});
    });
    dialog->open();
}

void InspectPage::prepareTour()
{
    // The batch of the picture, then parts for it.
    d->tour.add(
        [this] {
            d->expected->choose(u"A"_s);
            if (!workbench().inspection().batch()) // where this is the second try
                workbench().inspection().beginBatch({u"4711"_s, 400, u"A"_s, {}});
        },
        [this] { return workbench().inspection().batch().has_value(); });
    addInspections(
        d->tour, workbench(), [this] { d->expected->choose(u"A"_s); }, [this] { squeeze(); });
    d->tour.start(workbench());
}

bool InspectPage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
