// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_models.h"

#include "ui/models/comparison_table_model.h"
#include "ui/models/fact.h"
#include "ui/models/validation_words.h"
#include "ui/pages/fit_page_facts.h"
#include "ui/pages/fit_page_table.h"
#include "ui/pages/fit_page_validation.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

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
    m_table->setStyleSheet(QStringLiteral("QTableView::item { padding: 0 5px; }"));
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
    QString sentence = comparison.sentence;
    if (sentence.isEmpty())
        sentence = tr("No other model was compared with this one.");
    m_sentence->setText(asSentence(sentence));
    m_table->setVisible(compared);
    m_note->setVisible(compared);
    fitPanelTable(m_table);
}

} // namespace gripscope
