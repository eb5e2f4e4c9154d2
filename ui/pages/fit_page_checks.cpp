// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_checks.h"

#include "ui/models/estimate_words.h"
#include "ui/models/fact.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

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
                      : sign == CheckSign::Warning ? tr("suspect")
                                                   : tr("failed"));
    update();
}

void CheckSignLabel::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = m_sign == CheckSign::Pass ? tokens.secondText : tokens.notValid;
    painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    switch (m_sign) {
    case CheckSign::Pass:
        painter.drawPolyline(QPolygonF{QPointF(4, 10.5), QPointF(8.5, 15), QPointF(16, 5.5)});
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
    auto* text = makeLabel(u"<b>%1.</b> %2"_s.arg(name.toHtmlEscaped(), asSentence(message).toHtmlEscaped()));
    text->setWordWrap(true);
    text->setTextFormat(Qt::RichText);
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
                m_rows->addWidget(findingRow(ok               ? CheckSign::Pass
                                             : check.decisive ? CheckSign::Fail
                                                              : CheckSign::Warning,
                                             checkName(check.id), check.message));
    if (!preparation.empty()) {
        auto* head = makeLabel(tr("Before the estimate"), "strong");
        head->setContentsMargins(0, metrics::step, 0, metrics::insideControl);
        m_rows->addWidget(head);
    }
    for (const PreparationStep& step : preparation)
        m_rows->addWidget(findingRow(step.ok ? CheckSign::Pass : CheckSign::Warning, preparationName(step.id),
                                     step.message));
    m_rows->addStretch();
}

} // namespace gripscope
