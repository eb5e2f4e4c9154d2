// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/estimate_words.h"
#include "ui/format/fact.h"
#include "ui/format/validation_words.h"
#include "ui/models/comparison_table_model.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/pages/fit/fit_page_validation.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

EstimatorPanel::EstimatorPanel(QWidget* parent)
    : QWidget(parent), m_model(new EstimateTableModel(this)), m_table(makePanelTable(m_model)),
      m_note(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    buildTable();
    m_note->setWordWrap(true);
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addStretch();
}

void EstimatorPanel::buildTable()
{
    m_table->setItemDelegate(new EstimateDelegate(this));
    // The delegate writes these below the name and the simulation fit.
    m_table->setColumnHidden(int(EstimateTableModel::Column::Verdict), true);
    m_table->setColumnHidden(int(EstimateTableModel::Column::PredictionFit), true);
    m_table->setAccessibleName(tr("Estimators against each other"));
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (const auto estimator = m_model->estimatorAt(now.row()))
                    emit estimatorChosen(*estimator);
            });
}

void EstimatorPanel::setIdentification(const Identification& identification, const QString& forceUnit,
                                       const QString& positionUnit)
{
    m_model->setIdentification(identification, forceUnit, positionUnit);
    QStringList notes;
    if (identification.budget.parameters || !identification.budget.further.empty())
        notes << tr("The error bars here are those of noise alone; the intervals above count everything that "
                    "is known (see Uncertainty).");
    if (identification.baseline)
        notes << tr("The table holds what was measured; the empty gripper's own m, b and k are taken off the "
                    "numbers above.");
    if (identification.find(Estimator::Arx) || identification.find(Estimator::ArxMeanForce) ||
        identification.find(Estimator::Arx221))
        notes << tr(
            "ARX predicts one step ahead from the last two measured positions. With noise that reads "
            "high even when m, b and k are far off: a good ARX prediction fit says nothing about them.");
    m_note->setText(notes.join(u"\n\n"_s));
    m_note->setVisible(!notes.isEmpty());
    fitPanelTable(m_table);
    m_table->selectRow(m_model->rowOf(identification.recommended));
}

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent), m_model(new ComparisonTableModel(this)), m_sentence(makeLabel({}, "strong")),
      m_table(makePanelTable(m_model)), m_note(makeLabel({}, "second")), m_validation(new ValidationPanel),
      m_periods(new QWidget), m_periodWords(makeLabel({})), m_periodFacts(makeFactGrid())
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_note->setWordWrap(true);
    m_note->setText(
        tr("A lower criterion explains the squeeze better for the parameters it spends. Less than 10 "
           "apart, nothing is decided."));
    m_table->setAccessibleName(tr("Models against each other"));
    m_table->setStyleSheet(QStringLiteral("QTableView::item { padding: 0 2px; }"));
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    column->addWidget(m_sentence);
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addWidget(makeRule());
    column->addWidget(m_validation);
    auto* periods = new QVBoxLayout(m_periods);
    setSpacing(periods, 0, metrics::step);
    m_periodWords->setWordWrap(true);
    m_periodWords->setTextInteractionFlags(Qt::TextSelectableByMouse);
    periods->addWidget(makeRule());
    periods->addWidget(makeLabel(tr("What the periods tell"), "strong"));
    periods->addWidget(m_periodWords);
    periods->addLayout(m_periodFacts);
    column->addWidget(m_periods);
    column->addStretch();
    setIdentification({}, {}, {});
}

void ModelPanel::setIdentification(const Identification& identification, const QString& forceUnit,
                                   const QString& positionUnit)
{
    setComparison(identification.comparison);
    m_validation->setValidation(identification.validation, positionUnit);
    setPeriods(identification.repetition, forceUnit, positionUnit);
}

void ModelPanel::setPeriods(const std::optional<PeriodicDiagnostics>& periods, const QString& forceUnit,
                            const QString& positionUnit)
{
    m_periods->setVisible(periods.has_value());
    m_periodWords->setText(periods ? periodSentence(*periods) : QString());
    fillFacts(m_periodFacts, periods ? periodFacts(*periods, forceUnit, positionUnit) : std::vector<Fact>());
}

void ModelPanel::setComparison(const ModelComparison& comparison)
{
    const bool compared = !comparison.ranked.empty();
    m_model->setComparison(comparison);
    QString sentence = comparison.sentence.describe();
    if (sentence.isEmpty())
        sentence = tr("No other model was compared with this one.");
    m_sentence->setText(asSentence(sentence));
    m_table->setVisible(compared);
    m_note->setVisible(compared);
    fitPanelTable(m_table);
}

CheckSignLabel::CheckSignLabel(CheckSign sign, QWidget* parent) : QWidget(parent), m_sign(sign)
{
    setFixedSize(20, 20);
    setSign(sign);
    connect(&Theme::instance(), &Theme::changed, this, [this] { update(); });
}

void CheckSignLabel::setSign(CheckSign sign)
{
    m_sign = sign;
    setAccessibleName(sign == CheckSign::Pass      ? tr("passed")
                      : sign == CheckSign::Noted   ? tr("noted")
                      : sign == CheckSign::Warning ? tr("suspect")
                                                   : tr("failed"));
    update();
}

void CheckSignLabel::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool quiet = m_sign == CheckSign::Pass || m_sign == CheckSign::Noted;
    const QColor color = quiet ? tokens.secondText : tokens.notValid;
    painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    switch (m_sign) {
    case CheckSign::Pass:
        painter.drawPolyline(QPolygonF{QPointF(4, 10.5), QPointF(8.5, 15), QPointF(16, 5.5)});
        break;
    case CheckSign::Noted:
        painter.drawLine(QPointF(5, 10), QPointF(15, 10));
        break;
    case CheckSign::Warning:
        painter.drawPolygon(QPolygonF{QPointF(10, 3), QPointF(18, 16.5), QPointF(2, 16.5)});
        painter.drawLine(QPointF(10, 8), QPointF(10, 11));
        painter.drawPoint(QPointF(10, 13.8));
        break;
    case CheckSign::Fail:
        painter.drawLine(QPointF(5, 5), QPointF(15, 15));
        painter.drawLine(QPointF(15, 5), QPointF(5, 15));
        break;
    }
}

namespace {

QWidget* findingRow(CheckSign sign, const QString& name, const QString& message)
{
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 4, 0, 4);
    line->setSpacing(metrics::step);
    line->addWidget(new CheckSignLabel(sign), 0, Qt::AlignTop);
    auto* text =
        makeMarkedLabel(u"<b>%1.</b> %2"_s.arg(name.toHtmlEscaped(), asSentence(message).toHtmlEscaped()));
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line->addWidget(text, 1);
    return row;
}

} // namespace

ValidityLine::ValidityLine(QWidget* parent)
    : QWidget(parent), m_sign(new CheckSignLabel(CheckSign::Pass)), m_words(makeLabel({}, "strong"))
{
    auto* line = new QHBoxLayout(this);
    setSpacing(line, 0, metrics::insideControl);
    line->addWidget(m_sign);
    line->addWidget(m_words);
}

void ValidityLine::setVerdict(ValidityVerdict verdict)
{
    switch (verdict) {
    case ValidityVerdict::Valid:
        m_sign->setSign(CheckSign::Pass);
        m_words->setText(tr("Measurement valid"));
        break;
    case ValidityVerdict::Suspect:
        m_sign->setSign(CheckSign::Warning);
        m_words->setText(tr("Measurement suspect"));
        break;
    case ValidityVerdict::Invalid:
        m_sign->setSign(CheckSign::Fail);
        m_words->setText(tr("Measurement not valid"));
        break;
    }
    setAccessibleName(m_words->text());
}

CheckList::CheckList(QWidget* parent) : QWidget(parent), m_rows(new QVBoxLayout(this))
{
    setSpacing(m_rows, 0, 0);
}

void CheckList::setFindings(const Validity& validity, const std::vector<PreparationStep>& preparation)
{
    while (QLayoutItem* item = m_rows->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const bool ok : {false, true})
        for (const ValidityCheck& check : validity.checks)
            if (check.ok == ok)
                m_rows->addWidget(findingRow(ok && check.noted ? CheckSign::Noted
                                             : ok              ? CheckSign::Pass
                                             : check.decisive  ? CheckSign::Fail
                                                               : CheckSign::Warning,
                                             checkName(check.id), check.message.describe()));
    if (!preparation.empty()) {
        auto* head = makeLabel(tr("Before the estimate"), "strong");
        head->setContentsMargins(0, metrics::step, 0, metrics::insideControl);
        m_rows->addWidget(head);
    }
    for (const PreparationStep& step : preparation)
        m_rows->addWidget(findingRow(step.ok ? CheckSign::Pass : CheckSign::Warning, preparationName(step.id),
                                     step.message.describe()));
    m_rows->addStretch();
}

} // namespace gripscope
