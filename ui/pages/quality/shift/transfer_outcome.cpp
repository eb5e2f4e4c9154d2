// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "core/session/shift/transfer_watch.h"
#include "ui/charts/interval_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/shift/drift_charts.h"
#include "ui/pages/quality/shift/shift_words.h"
#include "ui/pages/quality/shift/transfer_steps.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/row_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int outcomeRowHeight = 32, mostOutcomeRows = 12, mostRecords = 200;

using Records = std::vector<AdjustmentRecord>;

} // namespace

TransferOutcome::TransferOutcome(Workbench& workbench, const TransferWatch& watch, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_watch(&watch)
{
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 12);
    QFrame* card = makeCard(content);
    auto* words = new QVBoxLayout(card);
    setSpacing(words, 16, 8);
    m_verdict = makeLabel({}, "title", card);
    m_verdict->setObjectName("transferVerdict");
    m_words = makeLabel({}, "", card);
    m_words->setObjectName("transferWords");
    m_check = makeLabel({}, "", card);
    m_check->setObjectName("transferCheck");
    m_standing = makeLabel({}, "strong", card);
    m_standing->setObjectName("transferStanding");
    for (QLabel* label : {m_verdict, m_words, m_check, m_standing}) {
        label->setWordWrap(true);
        words->addWidget(label);
    }
    column->addWidget(card);
    m_figures = new QWidget(content);
    auto* figures = new QVBoxLayout(m_figures);
    setSpacing(figures, 0, 12);
    QFrame* plotCard = makeCard(m_figures);
    auto* inside = new QVBoxLayout(plotCard);
    setSpacing(inside, 12, 0);
    m_plot = new IntervalPlot(plotCard);
    m_plot->setObjectName("transferPlot");
    inside->addWidget(m_plot);
    figures->addWidget(plotCard);
    figures->addWidget(makeTable(m_figures));
    column->addWidget(m_figures);
    column->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 12);
    outer->addWidget(makeHead());
    outer->addWidget(makeScroll(content, this), 1);
}

QWidget* TransferOutcome::makeHead()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    QPushButton* back = makeButton(tr("All studies"), u"go-previous"_s, "", box);
    back->setObjectName("transferOutcomeBack");
    m_name = new ElidedLabel({}, box);
    setRole(m_name, "strong");
    m_facts = new ElidedLabel({}, box);
    setRole(m_facts, "caption");
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_name);
    words->addWidget(m_facts);
    m_accept = makeButton(tr("Accept the adjustment…"), {}, "primary", box);
    m_accept->setObjectName("transferAccept");
    row->addWidget(back);
    row->addLayout(words, 1);
    row->addWidget(m_accept);
    connect(back, &QPushButton::clicked, this, &TransferOutcome::left);
    connect(m_accept, &QPushButton::clicked, this, &TransferOutcome::askAccept);
    return box;
}

QWidget* TransferOutcome::makeTable(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 2, 0);
    m_table = new QTableWidget(0, 6, card);
    m_table->setObjectName("transferTable");
    m_table->setAccessibleName(tr("What an adjustment by the other types leaves of each"));
    m_table->setHorizontalHeaderLabels({tr("Type"), tr("Squeezes"), ShiftWords::quantity(2),
                                        ShiftWords::quantity(1), ShiftWords::quantity(0), tr("Fits")});
    setUpRowList(m_table, outcomeRowHeight);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    column->addWidget(m_table);
    return card;
}

void TransferOutcome::begin()
{
    m_own.reset();
    m_before.reset();
    m_isStandingKnown = m_isAsked = false;
    m_figures->hide();
    for (QLabel* label : {m_verdict, m_words, m_check, m_standing})
        label->clear();
    refresh();
}

void TransferOutcome::loadStanding()
{
    m_isAsked = true;
    m_workbench->background().ask<Records>(
        this, [](Library& library) { return library.adjustments(mostRecords); },
        [this, study = m_workbench->study().study()->record](const Expected<Records>& records) {
            if (!records)
                return m_workbench->messages().report(records.error().describe());
            m_isStandingKnown = true;
            for (const AdjustmentRecord& record : *records) {
                if (record.adjustment.studyId == study.id && (!m_own || record.inForce))
                    m_own = record;
                if (record.inForce && record.adjustment.gripperSerial == study.study.gripperSerial)
                    m_before = record;
            }
            refresh();
        });
}

void TransferOutcome::refresh()
{
    const StudySession& session = m_workbench->study();
    if (!session.study() || session.study()->plan.design.kind != StudyKind::Transfer)
        return;
    const StudyRecord& record = session.study()->record;
    m_name->setFullText(record.study.name);
    m_facts->setParts({timeText(record.ended.value_or(record.begun)), record.study.operatorName,
                       tr("gripper %1").arg(record.study.gripperSerial)},
                      u" · "_s);
    if (!m_isAsked && record.state == StudyState::Finished)
        loadStanding();
    if (record.state == StudyState::Abandoned) {
        m_verdict->setText(tr("This was given up: %1").arg(record.endReason));
        m_accept->hide();
        return;
    }
    const std::optional<TransferLook>& look = m_watch->look();
    if (m_watch->error())
        m_verdict->setText(m_watch->error()->describe());
    else if (!look || m_watch->busy())
        m_verdict->setText(tr("Being worked out…"));
    else
        showLook(*look);
    const QString why = obstacle();
    m_accept->setVisible(!m_own || !m_own->inForce);
    m_accept->setEnabled(why.isEmpty());
    m_accept->setToolTip(why);
}

QString TransferOutcome::obstacle() const
{
    const std::optional<TransferLook>& look = m_watch->look();
    if (!m_isStandingKnown || !look || m_watch->busy())
        return tr("Being worked out…");
    if (!look->report.error)
        return tr("The squeezes give no adjustment.");
    if (const QStringList odd = look->misfits(); !odd.isEmpty())
        return tr("%1 does not fit: one adjustment would be wrong for it.").arg(odd.join(u", "_s));
    return look->acceptable() ? QString() : tr("There are fewer than three squeezes of a type.");
}

void TransferOutcome::showLook(const TransferLook& look)
{
    const TransferReport& report = look.report;
    const bool isOdd = !look.misfits().isEmpty();
    m_verdict->setText(!report.error   ? tr("The squeezes give no adjustment")
                       : isOdd         ? tr("One adjustment does not explain all types")
                       : report.adjust ? tr("An adjustment helps: types serve here with it")
                                       : tr("The two grippers find the same as far as can be told"));
    m_words->setText(keptTogether(described(report.words).join(u' ')));
    m_check->setText(keptTogether(
        look.residuals.empty() || !report.error
            ? described(look.advice).join(u' ')
            : tr("Residual check: that the types differ so much by chance has a probability of %1. %2")
                  .arg(formatProbability(report.error->agreement), described(look.advice).join(u' '))));
    if (m_own)
        m_standing->setText(
            m_own->inForce
                ? tr("In force since %1, accepted by %2. Every inspection on gripper %3 is adjusted by it.")
                      .arg(timeText(m_own->accepted),
                           m_own->adjustment.operatorName.isEmpty() ? tr("somebody not named")
                                                                    : m_own->adjustment.operatorName,
                           m_own->adjustment.gripperSerial)
                : tr("It was accepted %1 and is no longer in force.").arg(timeText(m_own->accepted)));
    else if (m_before)
        m_standing->setText(
            tr("Another adjustment of this gripper is in force since %1: this one would replace it.")
                .arg(timeText(m_before->accepted)));
    m_standing->setVisible(!m_standing->text().isEmpty());
    m_figures->setVisible(!report.types.empty());
    m_plot->setChart(DriftCharts::adjustment(look, [this] {
        QMap<QString, int> places;
        for (const TypeRecord& type : m_workbench->inspection().types())
            places.insert(type.name, type.place);
        return places;
    }()));
    showTable(look);
}

void TransferOutcome::showTable(const TransferLook& look)
{
    m_table->setRowCount(int(look.report.types.size()) + (look.report.error ? 1 : 0));
    const auto fill = [this](int row, const QStringList& cells) {
        for (int column = 0; column < cells.size(); ++column) {
            auto* cell = new QTableWidgetItem(cells[column]);
            cell->setToolTip(cells[column]);
            m_table->setItem(row, column, cell);
        }
    };
    const auto intervals = [](const LogVector& log, const LogMatrix& covariance) {
        QStringList cells;
        for (const Eigen::Index i : {2, 1, 0})
            cells << (i < log.size() ? ShiftWords::percentInterval(log(i), std::sqrt(covariance(i, i)))
                                     : u"–"_s);
        return cells;
    };
    int row = 0;
    for (const TypeShift& type : look.report.types) {
        const auto left = std::ranges::find(look.residuals, type.type, &TransferResidual::type);
        const bool isHeld = left != look.residuals.end();
        fill(row++,
             QStringList{type.type, formatCount(type.squeezes)} +
                 (isHeld ? intervals(left->log, left->covariance) : intervals(type.log, type.covariance)) +
                 QStringList{!isHeld      ? tr("no other type")
                             : left->fits ? tr("yes (%1)").arg(formatProbability(left->pValue))
                                          : tr("no (%1)").arg(formatProbability(left->pValue))});
    }
    if (look.report.error)
        fill(row, QStringList{tr("The adjustment"), formatCount(look.squeezes)} +
                      intervals(look.report.error->value, look.report.error->covariance) +
                      QStringList{formatProbability(look.report.error->agreement)});
    fitHeightToRows(m_table, mostOutcomeRows);
    m_table->setFixedHeight(m_table->maximumHeight());
}

void TransferOutcome::askAccept()
{
    const std::optional<KeptStudy>& study = m_workbench->study().study();
    if (!study || !obstacle().isEmpty())
        return;
    askWhy(this, tr("Adjust gripper %1").arg(study->record.study.gripperSerial),
           [this](const QString& reason) {
               authorize(*m_workbench, this, Permission::AdjustGrippers, [this, reason] { accept(reason); });
           });
}

void TransferOutcome::accept(const QString& reason)
{
    const std::optional<KeptStudy>& study = m_workbench->study().study();
    const std::optional<TransferLook>& look = m_watch->look();
    if (!study || !look || !look->acceptable())
        return;
    NewAdjustment adjustment;
    adjustment.gripperSerial = study->record.study.gripperSerial;
    adjustment.gripperName = m_workbench->connection().identity().serial == adjustment.gripperSerial
                                 ? m_workbench->connection().identity().name
                                 : QString();
    for (const TypeShift& type : look->report.types)
        adjustment.types << type.type;
    adjustment.squeezes = look->squeezes;
    adjustment.error = *look->report.error;
    adjustment.studyId = study->record.id;
    adjustment.operatorName = m_workbench->operatorName();
    adjustment.reason = reason;
    m_workbench->background().ask<AdjustmentRecord>(
        this,
        [adjustment](Library& library) -> Expected<AdjustmentRecord> {
            NewAdjustment known = adjustment;
            ASSIGN_OR_RETURN(const auto grippers, library.grippersOfTypes());
            for (const QString& type : known.types)
                known.enrolledOn += grippers.value(type);
            known.enrolledOn.removeAll(QString());
            known.enrolledOn.removeDuplicates();
            return library.acceptAdjustment(known);
        },
        [this](const Expected<AdjustmentRecord>& stored) {
            if (!stored)
                return m_workbench->messages().report(stored.error().describe());
            m_own = *stored;
            m_before = *stored;
            m_workbench->messages().tell(
                tr("Gripper %1 is adjusted to the types from now on.").arg(stored->adjustment.gripperSerial));
            m_workbench->tellLibraryChanged();
            refresh();
            emit accepted();
        });
}

void TransferOutcome::focusFirst()
{
    if (m_accept->isVisible() && m_accept->isEnabled())
        m_accept->setFocus();
    else
        setFocus();
}

} // namespace gripscope
