// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/inspection_widgets.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QLineEdit>
#include <QWheelEvent>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

TypeChooser::TypeChooser(QWidget* parent) : QComboBox(parent)
{
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setAccessibleName(tr("Expected type"));
    setToolTip(tr("Choose a type, type part of its name, or scan its code anywhere on this page"));
    lineEdit()->setAccessibleName(accessibleName());
    lineEdit()->setPlaceholderText(tr("nothing expected"));
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    completer()->setFilterMode(Qt::MatchContains);
    addItem(tr("nothing expected"), QString());
    m_codes << QString();
    connect(this, &QComboBox::activated, this,
            [this](int index) { emit chosen(itemData(index).toString()); });
    connect(lineEdit(), &QLineEdit::returnPressed, this, &TypeChooser::takeTyped);
}

void TypeChooser::setTypes(const std::vector<TypeRecord>& types)
{
    QStringList names, codes{QString()};
    for (const TypeRecord& type : types) {
        names << type.name;
        codes << type.code;
    }
    m_codes = codes;
    QStringList shown;
    for (int i = 1; i < count(); ++i)
        shown << itemData(i).toString();
    if (names == shown)
        return;
    const QString kept = expected();
    const QSignalBlocker quiet(this);
    while (count() > 1)
        removeItem(count() - 1);
    for (const QString& name : names)
        addItem(name, name);
    setExpected(kept);
}

void TypeChooser::setExpected(const QString& name)
{
    setCurrentIndex(name.isEmpty() ? 0 : std::max(0, findData(name)));
}

int TypeChooser::find(const QString& codeOrName) const
{
    const qsizetype coded = codeOrName.isEmpty() ? -1 : m_codes.indexOf(codeOrName);
    if (coded >= 0)
        return static_cast<int>(coded);
    const int exact = findData(codeOrName);
    return exact >= 0 ? exact : findText(codeOrName, Qt::MatchFixedString);
}

int TypeChooser::findTyped(const QString& text) const
{
    if (const int found = find(text); found >= 0 || text.isEmpty())
        return found;
    // What the keys have picked from the narrowed list.
    if (completer()->popup()->isVisible() && completer()->popup()->currentIndex().isValid())
        return findText(completer()->popup()->currentIndex().data().toString());
    int only = -1;
    for (int i = 1; i < count(); ++i) {
        if (!itemText(i).contains(text, Qt::CaseInsensitive))
            continue;
        if (only >= 0)
            return -1;
        only = i;
    }
    return only;
}

void TypeChooser::choose(const QString& codeOrName)
{
    take(find(codeOrName.trimmed()), codeOrName.trimmed());
}

void TypeChooser::takeTyped()
{
    const QString text = lineEdit()->text().trimmed();
    const int index = findTyped(text);
    completer()->popup()->hide();
    take(index, text);
}

void TypeChooser::take(int index, const QString& text)
{
    if (index < 0) {
        showExpected();
        emit notFound(text);
        return;
    }
    setCurrentIndex(index);
    showExpected();
    emit chosen(expected());
}

void TypeChooser::showExpected()
{
    setEditText(itemText(currentIndex()));
}

void TypeChooser::wheelEvent(QWheelEvent* event)
{
    event->ignore();
}

void TypeChooser::focusOutEvent(QFocusEvent* event)
{
    QComboBox::focusOutEvent(event);
    // What was typed and not taken is gone; the list that pops up over the field does not end the typing.
    if (event->reason() != Qt::PopupFocusReason)
        showExpected();
}

} // namespace gripscope
