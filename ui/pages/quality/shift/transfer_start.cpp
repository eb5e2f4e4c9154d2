// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "core/library/records/study_record.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/shift/transfer_steps.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int mostAdjustments = 50, usualTrials = 5, mostTrials = 20, mostCountedStudies = 1000;

void clearBoxes(QVBoxLayout* rows)
{
    while (QLayoutItem* item = rows->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

QString serialsInWords(QStringList serials)
{
    for (QString& serial : serials)
        if (serial.isEmpty())
            serial = TransferStart::tr("a gripper not named");
    return serials.join(u", "_s);
}

} // namespace

TransferStart::TransferStart(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 16);
    column->addWidget(makeChoice(content));
    m_adjustmentCard = makeCard(content);
    auto* inside = new QVBoxLayout(m_adjustmentCard);
    setSpacing(inside, 16, 8);
    inside->addWidget(makeLabel(tr("Adjustments"), "heading", m_adjustmentCard));
    m_adjustments = new QVBoxLayout;
    m_adjustments->setSpacing(8);
    inside->addLayout(m_adjustments);
    column->addWidget(m_adjustmentCard);
    column->addStretch(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* back = makeButton(tr("All studies"), u"go-previous"_s, "", this);
    back->setObjectName("transferBack");
    m_hint = makeLabel({}, "second", this);
    m_hint->setObjectName("transferHint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_begin = makeButton(tr("Begin"), {}, "primary", this);
    m_begin->setObjectName("transferBegin");
    row->addWidget(back);
    row->addWidget(m_hint, 1);
    row->addWidget(m_begin);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 12);
    outer->addWidget(makeScroll(content, this), 1);
    outer->addLayout(row);
    connect(back, &QPushButton::clicked, this, &TransferStart::left);
    connect(m_begin, &QPushButton::clicked, this, [this] { emit submitted(request()); });
    connect(m_trials, &QSpinBox::valueChanged, this, &TransferStart::refresh);
    m_adjustmentCard->hide();
}

QWidget* TransferStart::makeChoice(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(tr("Types on another gripper"), "heading", card));
    auto* answer =
        makeLabel(tr("Types were enrolled on one gripper and are to be recognised by another. Squeeze "
                     "parts of some of them here: how the two grippers differ follows from that, and "
                     "every later inspection on this gripper is adjusted by it."),
                  "second", card);
    answer->setWordWrap(true);
    m_situation = makeLabel({}, "strong", card);
    m_situation->setObjectName("transferSituation");
    m_situation->setWordWrap(true);
    m_typeBox = new QWidget(card);
    m_typeBox->setObjectName("transferTypes");
    m_types = new QVBoxLayout(m_typeBox);
    setSpacing(m_types, 0, 4);
    m_trials = new QSpinBox(card);
    m_trials->setObjectName("transferTrials");
    m_trials->setRange(2, mostTrials);
    m_trials->setValue(usualTrials);
    m_trials->setMaximumWidth(120);
    auto* caption = makeLabel(tr("Squeezes of each type"), "", card);
    caption->setBuddy(m_trials);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(caption);
    row->addWidget(m_trials);
    row->addStretch(1);
    column->addWidget(answer);
    column->addWidget(m_situation);
    column->addWidget(makeLabel(tr("Which types do you have parts of here?"), "", card));
    column->addWidget(m_typeBox);
    column->addLayout(row);
    return card;
}

Expected<TransferStart::Standing> TransferStart::read(Library& library)
{
    Standing standing;
    ASSIGN_OR_RETURN(standing.grippers, library.grippersOfTypes());
    ASSIGN_OR_RETURN(standing.adjustments, library.adjustments(mostAdjustments));
    ASSIGN_OR_RETURN(standing.inForce, library.adjustmentsInForce());
    ASSIGN_OR_RETURN(const std::vector<StudyRecord> studies, library.studies(mostCountedStudies));
    standing.studies = std::ranges::count_if(
        studies, [](const StudyRecord& study) { return study.study.kind == toString(StudyKind::Transfer); });
    return standing;
}

void TransferStart::load()
{
    m_workbench->background().ask<Standing>(
        this, [](Library& library) { return read(library); },
        [this](Expected<Standing> standing) {
            if (!standing)
                return m_workbench->messages().report(standing.error().describe());
            m_standing = std::move(*standing);
            fillTypes();
            fillAdjustments();
            refresh();
        });
}

QString TransferStart::situation() const
{
    const ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected)
        return u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail);
    QStringList from;
    for (const QStringList& serials : m_standing.grippers)
        for (const QString& serial : serials)
            if (!from.contains(serial))
                from << serial;
    const QString here = connection.identity().serial;
    from.removeAll(here);
    if (from.isEmpty())
        return tr("Connected is gripper %1. No type was enrolled on another.").arg(here);
    return tr("Connected is gripper %1. Types were enrolled on: %2.").arg(here, serialsInWords(from));
}

void TransferStart::fillTypes()
{
    const QStringList before = chosen();
    const bool isFirst = m_boxes.empty();
    m_boxes.clear();
    clearBoxes(m_types);
    m_shownSerial = m_workbench->connection().identity().serial;
    for (const TypeRecord& type : m_workbench->inspection().types()) {
        const QStringList from = m_standing.grippers.value(type.name);
        const bool isOwn = !m_shownSerial.isEmpty() && from.contains(m_shownSerial);
        const QString why = isOwn            ? tr("enrolled on this gripper itself")
                            : !type.approved ? tr("not approved")
                                             : tr("enrolled on %1").arg(serialsInWords(from));
        auto* box = new QCheckBox(withoutKeys(tr("%1 – %2").arg(type.name, why)), m_typeBox);
        box->setObjectName(u"transferType-"_s + type.name);
        box->setProperty("typeName", type.name);
        box->setEnabled(type.approved && !isOwn);
        box->setChecked(box->isEnabled() && (isFirst || before.contains(type.name)));
        connect(box, &QCheckBox::toggled, this, &TransferStart::refresh);
        m_types->addWidget(box);
        m_boxes.push_back(box);
    }
}

QWidget* TransferStart::makeAdjustment(const AdjustmentRecord& record, QWidget* parent)
{
    auto* box = new QWidget(parent);
    const NewAdjustment& own = record.adjustment;
    const QString who = own.operatorName.isEmpty() ? tr("somebody not named") : own.operatorName;
    auto* name = makeLabel(record.inForce     ? tr("Gripper %1: in force").arg(own.gripperSerial)
                           : record.withdrawn ? tr("Gripper %1: withdrawn").arg(own.gripperSerial)
                                              : tr("Gripper %1: replaced").arg(own.gripperSerial),
                           "strong", box);
    auto* about = makeLabel(tr("%1. Accepted %2 by %3, of %4 squeezes of %5: %6")
                                .arg(adjustmentInWords(own.error).describe(), timeText(record.accepted), who,
                                     formatCount(own.squeezes), own.types.join(u", "_s), own.reason),
                            "second", box);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(name);
    words->addWidget(about);
    about->setWordWrap(true);
    if (record.withdrawn) {
        auto* end =
            makeLabel(tr("Withdrawn %1 by %2: %3")
                          .arg(timeText(record.withdrawnAt),
                               record.withdrawnBy.isEmpty() ? tr("somebody not named") : record.withdrawnBy,
                               record.withdrawnReason),
                      "second", box);
        end->setWordWrap(true);
        words->addWidget(end);
    }
    for (const AdjustmentStanding& standing : m_standing.inForce)
        if (standing.record.id == record.id)
            for (const Finding& signal : adjustmentSignals(standing)) {
                auto* told = makeLabel(signal.describe(), "error", box);
                told->setObjectName("adjustmentSignal");
                told->setWordWrap(true);
                words->addWidget(told);
            }
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 16);
    row->addLayout(words, 1);
    if (record.inForce) {
        QPushButton* withdraw = makeButton(tr("Withdraw…"), {}, "", box);
        withdraw->setObjectName("withdrawAdjustment");
        withdraw->setAccessibleName(tr("Withdraw the adjustment of gripper %1").arg(own.gripperSerial));
        connect(withdraw, &QPushButton::clicked, this, [this, record] { askWithdraw(record); });
        row->addWidget(withdraw, 0, Qt::AlignTop);
    }
    return box;
}

void TransferStart::fillAdjustments()
{
    clearBoxes(m_adjustments);
    for (const AdjustmentRecord& record : m_standing.adjustments)
        m_adjustments->addWidget(makeAdjustment(record, m_adjustmentCard));
    m_adjustmentCard->setVisible(!m_standing.adjustments.empty());
}

void TransferStart::askWithdraw(const AdjustmentRecord& record)
{
    const QString change = tr("Withdraw the adjustment of gripper %1").arg(record.adjustment.gripperSerial);
    askWhy(this, change, [this, record](const QString& reason) {
        authorize(*m_workbench, this, Permission::AdjustGrippers, [this, record, reason] {
            m_workbench->background().ask<void>(
                this,
                [id = record.id, reason, who = m_workbench->operatorName()](Library& library) {
                    return library.withdrawAdjustment(id, reason, who);
                },
                [this](const Expected<void>& done) {
                    if (!done)
                        return m_workbench->messages().report(done.error().describe());
                    m_workbench->messages().tell(tr("The adjustment is withdrawn."));
                    m_workbench->tellLibraryChanged();
                    load();
                });
        });
    });
}

QStringList TransferStart::chosen() const
{
    QStringList types;
    for (const QCheckBox* const box : m_boxes)
        if (box->isChecked())
            types << box->property("typeName").toString();
    return types;
}

StudyRequest TransferStart::request() const
{
    StudyRequest request;
    request.name = tr("Another gripper %1").arg(m_standing.studies + 1);
    request.design.kind = StudyKind::Transfer;
    request.design.parts = chosen();
    request.design.trials = m_trials->value();
    request.design.order = PlanOrder::TrialAfterTrial;
    request.design.blind = false; // the advice on how many are needed rests on what was measured
    request.design.seed = QRandomGenerator::global()->generate();
    // By the gentlest of them where a type should be gone; each has its own (StudySession::setPartRecipes()).
    bool isFirst = true;
    for (const TypeRecord& type : m_workbench->inspection().types())
        if (request.design.parts.contains(type.name) &&
            (std::exchange(isFirst, false) || type.recipe.maxForce_N < request.recipe.maxForce_N))
            request.recipe = type.recipe;
    return request;
}

QString TransferStart::problem() const
{
    const ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected)
        return tr("Connect the gripper that the types are to be recognised by.");
    if (connection.identity().serial.isEmpty())
        return tr("This gripper has no serial number to keep an adjustment under.");
    if (m_boxes.empty())
        return tr("No type is enrolled. Enrol types on the other gripper, in this library, first.");
    const QStringList types = chosen();
    if (types.isEmpty())
        return tr("Choose the types that you have parts of, two or more.");
    const std::optional<Error> wrong = designProblem(request().design);
    return wrong ? wrong->describe() : QString();
}

void TransferStart::refresh()
{
    if (m_workbench->connection().identity().serial != m_shownSerial)
        fillTypes();
    m_situation->setText(situation());
    const QString wrong = problem();
    const QStringList types = chosen();
    const QString count =
        tr("%1 squeezes, in random order.").arg(formatCount(types.size() * m_trials->value()));
    m_hint->setText(!wrong.isEmpty() ? wrong
                    : types.size() == 1
                        ? tr("%1 With a second type it shows whether one adjustment serves all.").arg(count)
                        : count);
    m_begin->setEnabled(wrong.isEmpty());
}

void TransferStart::focusFirst()
{
    for (QCheckBox* const box : m_boxes)
        if (box->isEnabled())
            return box->setFocus();
    m_trials->setFocus();
}

} // namespace gripscope
