// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/type_limits_dialog.h"

#include "core/quality/conformity/limit_risks.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

const RegisteredDialog<TypeLimitsDialog> typeLimitsDialogRow("type limits",
                                                             [](Workbench& bench, QWidget* over) {
                                                                 return new TypeLimitsDialog(bench, {}, over);
                                                             });

/// Small risks keep their first digits: 0.004 % is not 0.0 %.
QString riskText(double share)
{
    if (share < 1e-6)
        return TypeLimitsDialog::tr("below %1").arg(formatPercent(0.0001, 4));
    return formatPercent(100 * share, share < 1e-4 ? 4 : share < 1e-2 ? 2 : 1);
}

QString risksOf(std::size_t place, const std::optional<QuantityRisks>& risks)
{
    const QString quantity = ReferenceWords::quantity(place);
    if (!risks)
        return TypeLimitsDialog::tr("%1: too few squeezes whose uncertainty is known").arg(quantity);
    QString text = TypeLimitsDialog::tr("%1, by %2 squeezes: consumer's risk %3, producer's risk %4")
                       .arg(quantity)
                       .arg(risks->squeezes)
                       .arg(riskText(risks->risks.consumers), riskText(risks->risks.producers));
    return text;
}

} // namespace

TypeLimitsDialog::TypeLimitsDialog(Workbench& workbench, const QString& type, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_type(new QComboBox(this)), m_rule(new QComboBox(this)),
      m_fields(new LimitFields(this)), m_risk(new QDoubleSpinBox(this)),
      m_risks(makeLabel({}, "caption", this)), m_problem(makeLabel({}, "error", this)),
      m_reason(new QLineEdit(this)), m_keep(makeButton(tr("Keep"), {}, "primary", this))
{
    setObjectName("typeLimitsDialog");
    setManualPage(u"types"_s);
    setWindowTitle(tr("Tolerance limits"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    m_soon.setSingleShot(true);
    m_soon.setInterval(200ms); // while somebody types
    connect(&m_soon, &QTimer::timeout, this, &TypeLimitsDialog::askRisks);
    connect(m_type, &QComboBox::currentIndexChanged, this, &TypeLimitsDialog::showType);
    connect(m_rule, &QComboBox::currentIndexChanged, this, &TypeLimitsDialog::refresh);
    connect(m_fields, &LimitFields::changed, this, &TypeLimitsDialog::refresh);
    connect(m_risk, &QDoubleSpinBox::valueChanged, this, &TypeLimitsDialog::refresh);
    connect(m_reason, &QLineEdit::textChanged, this, &TypeLimitsDialog::refresh);
    connect(m_keep, &QPushButton::clicked, this, &TypeLimitsDialog::keep);
    resize(560, sizeHint().height());
    load(type);
}

void TypeLimitsDialog::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(windowTitle(), "heading", this));
    QLabel* words = makeLabel(tr("Parts that are recognised as this type are then also said to conform, not "
                                 "to conform, or to be too near the limit for their squeeze."),
                              "", this);
    words->setWordWrap(true);
    column->addWidget(words);
    m_type->setObjectName("limitsType");
    m_type->setAccessibleName(tr("Type"));
    column->addWidget(m_type);
    column->addWidget(m_fields);
    m_rule->setObjectName("limitsRule");
    m_rule->setAccessibleName(tr("Rule of decision"));
    m_rule->addItem(tr("Proven with 95 % (ISO 14253-1)"), int(ConformityRule::Iso14253));
    m_rule->addItem(tr("Proven up to a consumer's risk of"), int(ConformityRule::ConsumersRisk));
    m_rule->addItem(tr("By the value alone"), int(ConformityRule::Simple));
    m_risk->setObjectName("limitsRisk");
    m_risk->setAccessibleName(tr("Consumer's risk"));
    m_risk->setRange(0.01, 49.99);
    m_risk->setSuffix(tr(" %"));
    m_risk->setValue(5);
    auto* rule = new QHBoxLayout;
    rule->addWidget(m_rule, 1);
    rule->addWidget(m_risk);
    column->addLayout(rule);
    m_risks->setObjectName("limitsRisks");
    m_risks->setWordWrap(true);
    column->addWidget(m_risks);
    m_reason->setObjectName("limitsReason");
    m_reason->setMaxLength(200);
    m_reason->setAccessibleName(tr("Why"));
    column->addWidget(makeLabel(tr("Why? The reason is kept with the change."), "caption", this));
    column->addWidget(m_reason);
    m_problem->setObjectName("limitsProblem");
    m_problem->setWordWrap(true);
    m_problem->hide();
    column->addWidget(m_problem);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    m_keep->setObjectName("limitsKeep");
    m_keep->setDefault(true);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_keep);
    column->addStretch(1);
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

void TypeLimitsDialog::load(const QString& type)
{
    refresh();
    m_workbench->background().ask<std::vector<TypeRecord>>(
        this, [](Library& library) { return library.types(); },
        [this, type](Expected<std::vector<TypeRecord>> types) {
            if (types)
                showTypes(*std::move(types), type);
            else
                tellProblem(types.error().describe());
        });
}

void TypeLimitsDialog::showTypes(std::vector<TypeRecord> types, const QString& first)
{
    m_listed = std::move(types);
    {
        const QSignalBlocker quiet(m_type);
        m_type->clear();
        for (const TypeRecord& one : m_listed)
            m_type->addItem(one.name);
        m_type->setCurrentIndex(std::max(0, m_type->findText(first)));
    }
    showType();
}

const TypeRecord* TypeLimitsDialog::type() const
{
    const int at = m_type->currentIndex();
    return at >= 0 && at < int(m_listed.size()) ? &m_listed[std::size_t(at)] : nullptr;
}

void TypeLimitsDialog::showType()
{
    const TypeRecord* shown = type();
    m_measured.clear();
    if (!shown)
        return refresh();
    {
        const QSignalBlocker quietRule(m_rule), quietRisk(m_risk);
        m_rule->setCurrentIndex(std::max(0, m_rule->findData(int(shown->limits.rule))));
        m_risk->setValue(100 * shown->limits.risk);
    }
    m_fields->showType(*shown);
    refresh();
    m_workbench->background().ask<std::vector<MeasuredValues>>(
        this, [asked = *shown](Library& library) { return library.measuredSqueezes(asked); },
        [this, id = shown->id](Expected<std::vector<MeasuredValues>> measured) {
            if (!type() || type()->id != id || !measured)
                return;
            m_measured = *std::move(measured);
            refresh();
        });
}

std::optional<PartLimits> TypeLimitsDialog::wanted(QString& problem) const
{
    std::optional<PartLimits> limits = m_fields->limits();
    if (!limits) {
        problem = tr("A limit is not a number.");
        return {};
    }
    limits->rule = ConformityRule(m_rule->currentData().toInt());
    // What nobody changed stays as it was, to the last digit.
    const double shown = type() ? 100 * type()->limits.risk : 5;
    limits->risk =
        type() && std::abs(m_risk->value() - shown) < 0.005 ? type()->limits.risk : m_risk->value() / 100;
    if (limits->isEmpty())
        return PartLimits{};
    if (const std::optional<Error> refused = limits->validate()) {
        problem = refused->describe();
        return {};
    }
    return limits;
}

/// No room is kept for what is not said: the window is to fit a small screen.
void TypeLimitsDialog::tellProblem(const QString& problem)
{
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void TypeLimitsDialog::refresh()
{
    m_risk->setVisible(m_rule->currentData().toInt() == int(ConformityRule::ConsumersRisk));
    QString problem;
    const std::optional<PartLimits> limits = wanted(problem);
    tellProblem(problem);
    const bool changes = limits && type() && !(*limits == type()->limits);
    m_keep->setEnabled(changes && !m_reason->text().trimmed().isEmpty());
    if (!limits || limits->isEmpty())
        m_risks->setText(tr("Without a limit nothing is said of parts beyond their type."));
    m_soon.start();
}

void TypeLimitsDialog::askRisks()
{
    QString problem;
    const std::optional<PartLimits> limits = wanted(problem);
    if (!limits || limits->isEmpty())
        return;
    m_workbench->background().compute<LimitRisks>(
        this,
        [limits = *limits, measured = m_measured] {
            return limitRisks(limits, measured).value_or(LimitRisks());
        },
        [this, limits = *limits, asked = ++m_asked](const LimitRisks& risks) {
            if (asked == m_asked)
                showRisks(limits, risks);
        });
}

void TypeLimitsDialog::showRisks(const PartLimits& limits, const LimitRisks& risks)
{
    QStringList lines;
    for (std::size_t i = 0; i < risks.size(); ++i)
        if (limits.quantities[i])
            lines << risksOf(i, risks[i]);
    m_risks->setText(lines.join(u'\n'));
    m_risks->setToolTip(
        tr("Consumer's risk: of all parts, those accepted that do not conform. Producer's risk: "
           "those that conform and are not accepted, too near a limit among them (JCGM 106)."));
}

void TypeLimitsDialog::keep()
{
    QString problem;
    const std::optional<PartLimits> limits = wanted(problem);
    if (!limits || !type())
        return;
    const ChangeNote note{m_workbench->operatorName(), m_reason->text().trimmed()};
    authorize(*m_workbench, this, Permission::ChangeTypes, [this, limits, note, id = type()->id] {
        m_workbench->background().ask<TypeRecord>(
            this, [limits, note, id](Library& library) { return library.setTypeLimits(id, *limits, note); },
            [this](const Expected<TypeRecord>& done) {
                if (!done) {
                    tellProblem(done.error().describe());
                    return;
                }
                m_workbench->tellLibraryChanged();
                accept();
            });
    });
}

} // namespace gripscope
