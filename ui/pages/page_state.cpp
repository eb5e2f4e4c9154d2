// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/page_state.h"

#include "ui/widgets/quantity_box.h"
#include "ui/widgets/quantity_list_edit.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QJsonArray>
#include <QLineEdit>
#include <QSplitter>
#include <QTableView>
#include <QTreeView>

#include <algorithm>
#include <optional>
#include <vector>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr const char* remembered = "gripscopeRemembered";
constexpr int leastWidth = 24, mostColumnWidth = 2000;

QJsonArray toJson(const QList<int>& numbers)
{
    QJsonArray array;
    for (const int number : numbers)
        array.append(number);
    return array;
}

QHeaderView* headerOf(const QWidget& view)
{
    if (const auto* table = qobject_cast<const QTableView*>(&view))
        return table->horizontalHeader();
    if (const auto* tree = qobject_cast<const QTreeView*>(&view))
        return tree->header();
    return nullptr;
}

/// Widths of the columns that a person can pull, those that are hidden by choice, and how the table is
/// sorted.
QJsonObject stateOf(const QHeaderView& header)
{
    QJsonArray widths;
    for (int i = 0; i < header.count(); ++i)
        widths.append(header.sectionResizeMode(i) == QHeaderView::Interactive && !header.isSectionHidden(i)
                          ? header.sectionSize(i)
                          : 0);
    QJsonObject state{{u"widths"_s, widths}};
    if (header.property(remembered).toBool()) {
        QJsonArray hidden;
        for (int i = 0; i < header.count(); ++i)
            hidden.append(header.isSectionHidden(i));
        state.insert(u"hidden"_s, hidden);
    }
    if (header.isSortIndicatorShown()) {
        state.insert(u"sorted"_s, header.sortIndicatorSection());
        state.insert(u"descending"_s, header.sortIndicatorOrder() == Qt::DescendingOrder);
    }
    return state;
}

void restore(QHeaderView& header, const QJsonObject& state, bool withWidths)
{
    const QJsonArray widths = state[u"widths"_s].toArray();
    if (widths.size() != header.count())
        return; // of another version of the table
    const QJsonArray hidden = state[u"hidden"_s].toArray();
    if (header.property(remembered).toBool() && hidden.size() == header.count() && hidden.contains(false))
        for (int i = 0; i < header.count(); ++i)
            header.setSectionHidden(i, hidden[i].toBool());
    for (int i = 0; i < header.count(); ++i) {
        const int width = widths[i].toInt();
        if (withWidths && width > 0 && header.sectionResizeMode(i) == QHeaderView::Interactive)
            header.resizeSection(i, std::clamp(width, leastWidth, mostColumnWidth));
    }
    const int sorted = state[u"sorted"_s].toInt(-1);
    if (header.isSortIndicatorShown() && sorted >= 0 && sorted < header.count())
        header.setSortIndicator(sorted,
                                state[u"descending"_s].toBool() ? Qt::DescendingOrder : Qt::AscendingOrder);
}

QJsonValue choiceOf(const QWidget& widget)
{
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        return box->currentIndex();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->isChecked();
    return {};
}

/// As a click would: what hangs on it follows.
void restoreChoice(QWidget& widget, const QJsonValue& choice)
{
    if (auto* box = qobject_cast<QComboBox*>(&widget)) {
        const int index = choice.toInt(-1);
        if (index < 0 || index >= box->count() || index == box->currentIndex())
            return;
        box->setCurrentIndex(index);
        emit box->activated(index);
    } else if (auto* button = qobject_cast<QAbstractButton*>(&widget)) {
        if (choice.isBool() && choice.toBool() != button->isChecked() && button->isEnabled())
            button->click();
    }
}

/// Calls `visit` for everything below `page` that has a state and a name of its own.
template <typename Visit>
void visitNamed(const QWidget& page, const Visit& visit)
{
    for (QWidget* widget : page.findChildren<QWidget*>())
        if (!widget->objectName().isEmpty() && !widget->objectName().startsWith("qt_"_L1))
            visit(*widget);
}

/// The fields that a person types into, but for those inside of others.
template <typename Field>
QList<Field*> fieldsOf(const QWidget& page)
{
    QList<Field*> fields;
    for (Field* field : page.findChildren<Field*>())
        if (!qobject_cast<QAbstractSpinBox*>(field->parentWidget()) &&
            !qobject_cast<QComboBox*>(field->parentWidget()) && !field->isReadOnly())
            fields << field;
    return fields;
}

void setText(QLineEdit& field, const QString& text)
{
    if (field.text() == text)
        return;
    field.setText(text);
    emit field.textEdited(text); // as if it had been typed
}

/// What was typed, as the program keeps it: the other window may show it in another unit.
QJsonValue typedIn(const QLineEdit& field)
{
    const auto* list = qobject_cast<const QuantityListEdit*>(&field);
    const std::optional<std::vector<double>> numbers = list ? list->si() : std::nullopt;
    if (!numbers)
        return field.text();
    QJsonArray typed;
    for (const double number : *numbers)
        typed.append(number);
    return typed;
}

void typeInto(QLineEdit& field, const QJsonValue& typed)
{
    auto* list = qobject_cast<QuantityListEdit*>(&field);
    if (!list || !typed.isArray())
        return setText(field, typed.toString());
    std::vector<double> numbers;
    for (const QJsonValue& number : typed.toArray())
        numbers.push_back(number.toDouble());
    list->setSi(numbers);
}

double typedIn(const QDoubleSpinBox& field)
{
    const auto* quantity = qobject_cast<const QuantityBox*>(&field);
    return quantity ? quantity->si() : field.value();
}

void typeInto(QDoubleSpinBox& field, double typed)
{
    if (auto* quantity = qobject_cast<QuantityBox*>(&field))
        quantity->setSi(typed);
    else
        field.setValue(typed);
}

} // namespace

void rememberChoice(QWidget* widget)
{
    widget->setProperty(remembered, true);
}

void rememberColumns(QHeaderView* header)
{
    header->setProperty(remembered, true);
}

QJsonObject arrangementOf(const QWidget& page)
{
    QJsonObject arrangement;
    visitNamed(page, [&arrangement](QWidget& widget) {
        if (const auto* splitter = qobject_cast<const QSplitter*>(&widget))
            arrangement.insert(widget.objectName(), toJson(splitter->sizes()));
        else if (const QHeaderView* header = headerOf(widget))
            arrangement.insert(widget.objectName(), stateOf(*header));
        else if (widget.property(remembered).toBool())
            arrangement.insert(widget.objectName(), choiceOf(widget));
    });
    return arrangement;
}

void restoreArrangement(QWidget& page, const QJsonObject& arrangement, bool withWidths)
{
    visitNamed(page, [&](QWidget& widget) {
        const QJsonValue state = arrangement[widget.objectName()];
        if (state.isUndefined())
            return;
        if (auto* splitter = qobject_cast<QSplitter*>(&widget)) {
            QList<int> sizes;
            for (const QJsonValue& size : state.toArray())
                sizes << size.toInt();
            if (sizes.size() == splitter->count() &&
                std::all_of(sizes.begin(), sizes.end(), [](int size) { return size >= 0 && size <= 10000; }))
                splitter->setSizes(sizes);
        } else if (QHeaderView* header = headerOf(widget)) {
            restore(*header, state.toObject(), withWidths);
        } else if (widget.property(remembered).toBool()) {
            restoreChoice(widget, state);
        }
    });
}

QJsonObject inputOf(const QWidget& page)
{
    QJsonArray texts, numbers;
    for (const QLineEdit* field : fieldsOf<QLineEdit>(page))
        texts.append(typedIn(*field));
    for (const QDoubleSpinBox* field : fieldsOf<QDoubleSpinBox>(page))
        numbers.append(typedIn(*field));
    return {{u"texts"_s, texts}, {u"numbers"_s, numbers}};
}

void restoreInput(QWidget& page, const QJsonObject& input)
{
    const QJsonArray texts = input[u"texts"_s].toArray(), numbers = input[u"numbers"_s].toArray();
    const QList<QLineEdit*> lines = fieldsOf<QLineEdit>(page);
    const QList<QDoubleSpinBox*> boxes = fieldsOf<QDoubleSpinBox>(page);
    if (lines.size() != texts.size() || boxes.size() != numbers.size())
        return; // other fields than those that were typed into
    for (qsizetype i = 0; i < lines.size(); ++i)
        typeInto(*lines[i], texts[i]);
    for (qsizetype i = 0; i < boxes.size(); ++i)
        typeInto(*boxes[i], numbers[i].toDouble());
}

} // namespace gripscope
