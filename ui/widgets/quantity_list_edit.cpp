// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/quantity_list_edit.h"

#include <QLocale>
#include <QRegularExpression>

namespace gripscope {

using namespace Qt::StringLiterals;

QuantityListEdit::QuantityListEdit(QWidget* parent) : QLineEdit(parent)
{
    connect(this, &QLineEdit::textChanged, this, [this] {
        if (!m_setting)
            m_si.reset();
    });
}

void QuantityListEdit::setUnit(const ShownUnit& unit)
{
    m_factor = unit.factor;
    m_si.reset();
}

std::optional<std::vector<double>> QuantityListEdit::si() const
{
    if (m_si)
        return m_si;
    // "2,5" is one number where the decimal sign is a comma; "2, 5" are two everywhere.
    const bool commaInNumbers = QLocale().decimalPoint() == u',';
    const QRegularExpression between(commaInNumbers ? u",?[;\\s]+"_s : u"[;,\\s]+"_s);
    std::vector<double> numbers;
    for (const QString& one : text().split(between, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        numbers.push_back(QLocale().toDouble(one, &isNumber) / m_factor);
        if (!isNumber)
            return std::nullopt;
    }
    return numbers;
}

void QuantityListEdit::setSi(const std::vector<double>& numbers)
{
    constexpr int digits = 6;
    QStringList texts;
    for (const double number : numbers)
        texts << QLocale().toString(number * m_factor, 'g', digits);
    m_setting = true;
    m_si = numbers;
    setText(texts.join(u", "_s));
    m_setting = false;
}

} // namespace gripscope
