// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/process/process_capability_panel.h"

#include "ui/charts/histogram_plot.h"
#include "ui/pages/quality/process/process_names.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QTabBar>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<std::size_t, 3> capabilityTabOrder{2, 0, 1}; // k first

QString fieldText(const std::optional<double>& value, double factor)
{
    return value ? QLocale().toString(*value * factor, 'g', 6) : QString();
}

} // namespace

ProcessCapabilityPanel::ProcessCapabilityPanel(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    column->addWidget(makeLabel(tr("Capability"), "heading", this));
    m_tabs = new QTabBar(this);
    m_tabs->setObjectName("processTabs");
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_tabs->setAccessibleName(tr("Quantity"));
    for (const QString& name : {u"k"_s, u"m"_s, u"b"_s})
        m_tabs->addTab(name);
    column->addWidget(m_tabs);
    column->addWidget(makeLimits());
    m_histogram = new HistogramPlot(this);
    m_histogram->setObjectName("processHistogram");
    column->addWidget(m_histogram);
    m_numbersBox = new QWidget(this);
    m_numbersBox->setObjectName("processNumbers");
    m_numbers = new QGridLayout(m_numbersBox);
    m_numbers->setContentsMargins(0, 0, 0, 0);
    m_numbers->setHorizontalSpacing(12);
    m_numbers->setVerticalSpacing(2);
    column->addWidget(m_numbersBox);
    m_words = makeLabel({}, "second", this);
    m_words->setObjectName("processCapability");
    m_words->setWordWrap(true);
    column->addWidget(m_words);
    column->addStretch(1);
    connect(m_tabs, &QTabBar::currentChanged, this, [this] { refresh(); });
    refresh();
}

QWidget* ProcessCapabilityPanel::makeLimits()
{
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    const auto field = [&](int row, const QString& name, const char* objectName, QLabel*& unit) {
        auto* edit = new QLineEdit(box);
        edit->setObjectName(QLatin1StringView(objectName));
        edit->setPlaceholderText(tr("none"));
        edit->setAccessibleName(name);
        unit = makeLabel({}, "caption", box);
        grid->addWidget(makeLabel(name, "caption", box), row, 0);
        grid->addWidget(edit, row, 1);
        grid->addWidget(unit, row, 2);
        connect(edit, &QLineEdit::editingFinished, this, &ProcessCapabilityPanel::takeTyped);
        return edit;
    };
    m_lower = field(0, tr("Lower limit"), "processLower", m_lowerUnit);
    m_upper = field(1, tr("Upper limit"), "processUpper", m_upperUnit);
    grid->setColumnStretch(1, 1);
    m_source = makeLabel({}, "caption", box);
    m_source->setObjectName("processLimitSource");
    m_problem = makeLabel({}, "error", box);
    m_problem->setObjectName("processLimitProblem");
    for (QLabel* label : {m_source, m_problem})
        label->setWordWrap(true);
    grid->addWidget(m_source, 2, 0, 1, 3);
    grid->addWidget(m_problem, 3, 0, 1, 3);
    return box;
}

std::size_t ProcessCapabilityPanel::quantity() const
{
    return capabilityTabOrder[std::size_t(std::max(0, m_tabs->currentIndex()))];
}

void ProcessCapabilityPanel::choose(std::size_t quantity)
{
    for (std::size_t i = 0; i < capabilityTabOrder.size(); ++i)
        if (capabilityTabOrder[i] == quantity)
            m_tabs->setCurrentIndex(int(i));
}

void ProcessCapabilityPanel::setOwnLimits(const PartLimits& limits, double factor)
{
    m_own = {};
    m_isTyped = {};
    for (std::size_t i = 0; i < m_own.size(); ++i) {
        if (!limits.quantities[i])
            continue;
        m_own[i] = *limits.quantities[i];
        for (std::optional<double>* limit : {&m_own[i]->lower, &m_own[i]->upper})
            if (*limit)
                **limit *= factor;
    }
    refresh();
}

std::array<std::optional<ToleranceLimits>, 3> ProcessCapabilityPanel::limits() const
{
    std::array<std::optional<ToleranceLimits>, 3> limits = m_own;
    for (std::size_t i = 0; i < limits.size(); ++i)
        if (m_isTyped[i])
            limits[i] = m_typed[i];
    return limits;
}

ShownUnit ProcessCapabilityPanel::unit() const
{
    double largest = 0;
    const std::size_t which = quantity();
    if (m_picture)
        for (const std::uint32_t row : m_picture->rows)
            if (const double value = m_picture->values->quantities[which][row]; std::isfinite(value)) {
                largest = value;
                break;
            }
    return ControlSeries::unitOf(m_picture ? *m_picture->values : ProcessValues(), which, largest);
}

void ProcessCapabilityPanel::show(std::shared_ptr<const ProcessPicture> picture)
{
    m_picture = std::move(picture);
    refresh();
}

void ProcessCapabilityPanel::fillFields()
{
    const ShownUnit shown = unit();
    const std::optional<ToleranceLimits> limits = this->limits()[quantity()];
    m_lower->setText(fieldText(limits ? limits->lower : std::nullopt, shown.factor));
    m_upper->setText(fieldText(limits ? limits->upper : std::nullopt, shown.factor));
    m_lowerUnit->setText(shown.unit);
    m_upperUnit->setText(shown.unit);
    m_source->setText(m_isTyped[quantity()] ? tr("Typed here; the type keeps its own.")
                      : m_own[quantity()]   ? tr("The type's own tolerance limits.")
                                            : QString());
    m_source->setVisible(!m_source->text().isEmpty());
    m_problem->clear();
    m_problem->hide();
}

void ProcessCapabilityPanel::takeTyped()
{
    const ShownUnit shown = unit();
    const auto number = [&shown](const QLineEdit* field, bool& fine) -> std::optional<double> {
        const QString text = field->text().trimmed();
        if (text.isEmpty())
            return {};
        bool isNumber = false;
        const double value = QLocale().toDouble(text, &isNumber);
        fine = fine && isNumber && std::isfinite(value);
        return value / shown.factor;
    };
    bool fine = true;
    ToleranceLimits typed{number(m_lower, fine), number(m_upper, fine)};
    const bool none = !typed.lower && !typed.upper;
    const std::optional<Error> wrong = none ? std::nullopt : typed.validate();
    m_problem->setText(!fine   ? tr("A limit is a number, or nothing.")
                       : wrong ? wrong->describe()
                               : QString());
    m_problem->setVisible(!m_problem->text().isEmpty());
    if (!fine || wrong)
        return;
    const std::size_t which = quantity();
    const std::optional<ToleranceLimits> before = limits()[which];
    // What nobody has changed comes out as it went in.
    if (fieldText(typed.lower, shown.factor) ==
            fieldText(before ? before->lower : std::nullopt, shown.factor) &&
        fieldText(typed.upper, shown.factor) ==
            fieldText(before ? before->upper : std::nullopt, shown.factor))
        return;
    m_isTyped[which] = true;
    m_typed[which] = none ? std::nullopt : std::optional(typed);
    emit limitsChanged();
    fillFields();
}

void ProcessCapabilityPanel::fillNumbers(const ProcessCapability& capability)
{
    while (QLayoutItem* item = m_numbers->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    int row = 0;
    for (const CapabilityLine& line : CapabilityNumbers::of(capability)) {
        m_numbers->addWidget(makeLabel(line.name, "caption", m_numbersBox), row, 0);
        m_numbers->addWidget(makeLabel(line.value, "strong", m_numbersBox), row, 1, Qt::AlignRight);
        m_numbers->addWidget(makeLabel(line.interval, "caption", m_numbersBox), row++, 2, Qt::AlignRight);
    }
    m_numbersBox->setVisible(row > 0);
}

void ProcessCapabilityPanel::refresh()
{
    fillFields();
    const std::size_t which = quantity();
    const bool there = m_picture && m_picture->capabilities[which].has_value();
    m_histogram->setVisible(there);
    m_numbersBox->setVisible(there);
    if (there) {
        const ProcessCapability& capability = *m_picture->capabilities[which];
        m_histogram->setCapability(capability, unit());
        fillNumbers(capability);
        m_words->setText(CapabilityNumbers::sentences(capability).join(u"\n"_s));
        return;
    }
    m_words->setText(m_picture ? ProcessNames::missing(*m_picture, which) : QString());
    if (m_picture && m_words->text().isEmpty())
        m_words->setText(m_picture->capabilities[which].error().describe());
}

} // namespace gripscope
