// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_models.h"

#include "ui/models/comparison_table_model.h"
#include "ui/pages/fit_page_table.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent), m_model(new ComparisonTableModel(this)), m_sentence(makeLabel({}, "strong")),
      m_table(makePanelTable(m_model)), m_note(makeLabel({}, "second"))
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
    column->addStretch();
    setComparison({});
}

void ModelPanel::setComparison(const ModelComparison& comparison)
{
    const bool compared = !comparison.ranked.empty();
    m_model->setComparison(comparison);
    QString sentence = comparison.sentence;
    if (sentence.isEmpty())
        sentence = tr("No other model was compared with this one.");
    sentence[0] = sentence[0].toUpper();
    m_sentence->setText(sentence.endsWith(QLatin1Char('.')) ? sentence : sentence + QLatin1Char('.'));
    m_table->setVisible(compared);
    m_note->setVisible(compared);
    fitPanelTable(m_table);
}

} // namespace gripscope
