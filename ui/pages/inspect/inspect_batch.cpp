// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/inspect_batch.h"

#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/yield_text.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/fitted_label.h"
#include "ui/windows/question.h"
#include "ui/windows/scan_reader.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace gripscope {

namespace {
constexpr int usualTarget = 100;
}

namespace {
const RegisteredDialog<BatchDialog> batchDialogRow("batch", [](Workbench&, QWidget* over) {
    return new BatchDialog({}, over);
});
} // namespace

BatchDialog::BatchDialog(const QString& expectedType, QWidget* parent)
    : Dialog(parent), m_expectedType(expectedType), m_name(new QLineEdit(this)), m_target(new QSpinBox(this)),
      m_accept(makeButton(tr("Begin the batch"), {}, "primary", this))
{
    setObjectName("batchDialog");
    setWindowTitle(tr("Begin a batch"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_name->setObjectName("batchNameField");
    m_name->setMaxLength(longestBatchName);
    m_name->setAccessibleName(tr("Name or number of the batch"));
    m_target->setObjectName("batchTargetField");
    m_target->setRange(1, static_cast<int>(largestBatch));
    m_target->setValue(usualTarget);
    m_target->setAccessibleName(tr("Parts wanted"));
    QLabel* counts = makeLabel(
        expectedType.isEmpty()
            ? tr("Each part that is one of the enrolled types counts, since no type is expected. Other parts "
                 "and measurements that are not valid do not count. The batch ends by itself.")
            : tr("Parts that are %1 count. Other parts and measurements that are not valid do not count. The "
                 "batch ends by itself.")
                  .arg(expectedType),
        "second", this);
    counts->setWordWrap(true);
    m_accept->setObjectName("batchAccept");
    m_accept->setAutoDefault(false); // a scanned number ends with Enter, and begins nothing yet
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_accept);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 8);
    column->addWidget(makeLabel(tr("Begin a batch"), "heading", this));
    column->addWidget(makeLabel(tr("Name or number"), "caption", this));
    column->addWidget(m_name);
    column->addWidget(makeLabel(expectedType.isEmpty() ? tr("Parts wanted, of a known type")
                                                       : tr("Parts wanted, as expected"),
                                "caption", this));
    column->addWidget(m_target);
    column->addSpacing(8);
    column->addWidget(counts);
    column->addSpacing(8);
    column->addLayout(buttons);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_name, &QLineEdit::textChanged, this, &BatchDialog::refresh);
    connect(m_name, &QLineEdit::returnPressed, this, [this] {
        m_sinceName.start();
        m_target->setFocus();
        m_target->selectAll();
    });
    resize(440, sizeHint().height());
    m_name->setFocus();
    refresh();
}

NewBatch BatchDialog::batch() const
{
    return {m_name->text().trimmed(), m_target->value(), m_expectedType, {}};
}

void BatchDialog::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && m_target->hasFocus())
        return takeEnter();
    Dialog::keyPressEvent(event);
}

/// In the number of parts it begins the batch, but not the second Enter with which some scanners end the
/// name.
void BatchDialog::takeEnter()
{
    if (m_sinceName.isValid() && m_sinceName.elapsed() <= ScanReader::longestGap_ms)
        return;
    if (m_accept->isEnabled())
        accept();
}

void BatchDialog::refresh()
{
    m_accept->setEnabled(!batch().name.isEmpty());
}

InspectBatch::InspectBatch(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_progress(new QWidget(this))
{
    m_name = new ElidedLabel({}, m_progress);
    m_name->setObjectName("batchName");
    setRole(m_name, "strong");
    m_count = new FittedLabel(48, m_progress);
    m_count->setObjectName("batchCount");
    m_bar = new QProgressBar(m_progress);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress of the batch"));
    m_yield = makeLabel({}, "caption", m_progress);
    m_yield->setObjectName("batchYield");
    m_yield->setWordWrap(true);
    m_end = makeButton(tr("End…"), {}, "quiet", m_progress);
    m_end->setObjectName("endBatchButton");
    m_end->setAccessibleName(tr("End the batch"));
    m_end->setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(m_end, &QPushButton::clicked, this, &InspectBatch::askToEnd);
    m_begin = makeButton(tr("Begin a batch…"), {}, "", this);
    m_begin->setObjectName("beginBatchButton");
    m_begin->setFocusPolicy(Qt::TabFocus);
    connect(m_begin, &QPushButton::clicked, this, &InspectBatch::askToBegin);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_name);
    words->addWidget(m_count);
    auto* row = new QHBoxLayout;
    row->addLayout(words, 1);
    row->addWidget(m_end);
    auto* progress = new QVBoxLayout(m_progress);
    setSpacing(progress, 0, 4);
    progress->addLayout(row);
    progress->addWidget(m_bar);
    progress->addWidget(m_yield);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 8);
    column->setSpacing(8);
    column->addWidget(m_progress);
    column->addWidget(m_begin);
    connect(&workbench, &Workbench::inspectionChanged, this, &InspectBatch::refresh);
    refresh();
}

void InspectBatch::setCountHeight(int pixels)
{
    m_count->setFixedHeight(pixels);
}

void InspectBatch::refresh()
{
    const std::optional<BatchRecord>& batch = m_workbench->inspection().batch();
    const bool running = batch && !batch->ended;
    m_progress->setVisible(batch.has_value());
    m_end->setVisible(running);
    m_end->setEnabled(!m_workbench->inspection().changingBatch());
    m_begin->setVisible(!running);
    m_begin->setEnabled(m_workbench->inspection().state() != InspectSession::State::Loading &&
                        !m_workbench->inspection().changingBatch());
    if (batch)
        show(*batch);
    notice(batch);
}

void InspectBatch::show(const BatchRecord& batch)
{
    m_name->setFullText(batch.whole() ? tr("Batch %1 is complete").arg(batch.name)
                        : batch.ended ? tr("Batch %1 was ended").arg(batch.name)
                                      : tr("Batch %1").arg(batch.name));
    m_count->setText(tr("%1 of %2").arg(formatCount(batch.counts.asExpected), formatCount(batch.target)));
    m_bar->setRange(0, static_cast<int>(batch.target));
    m_bar->setValue(static_cast<int>(std::min(batch.counts.asExpected, batch.target)));
    m_yield->setText(yieldText(batch.counts));
    m_yield->setToolTip(yieldExplained(batch.counts));
    m_yield->setVisible(!m_yield->text().isEmpty());
}

void InspectBatch::notice(const std::optional<BatchRecord>& batch)
{
    const QString id = batch ? batch->id : QString();
    const bool ended = batch && batch->ended;
    if (id != m_known) {
        m_known = id;
        m_ended = ended;
        if (batch && !ended)
            emit expects(batch->expectedType);
    }
    if (ended == m_ended)
        return;
    m_ended = ended;
    if (ended && batch->whole())
        emit whole();
}

void InspectBatch::askToBegin()
{
    auto* dialog = new BatchDialog(m_expected, this);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { m_workbench->inspection().beginBatch(dialog->batch()); });
    dialog->open();
}

void InspectBatch::askToEnd()
{
    const std::optional<BatchRecord>& batch = m_workbench->inspection().batch();
    if (!batch)
        return;
    auto* question =
        new Question(tr("End batch %1 at %2 of %3?")
                         .arg(batch->name, formatCount(batch->counts.asExpected), formatCount(batch->target)),
                     tr("What was inspected is kept. A batch that was ended cannot go on."), tr("End it"),
                     tr("Go on inspecting"), this);
    question->setObjectName("endBatchDialog");
    question->yes()->setObjectName("endBatchAccept");
    connect(question, &QDialog::accepted, this, [this] { m_workbench->inspection().endBatch(); });
    question->open();
}

} // namespace gripscope
