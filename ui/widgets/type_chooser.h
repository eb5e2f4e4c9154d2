// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"

#include <QComboBox>

namespace gripscope {

/// The type that is expected: chosen from the list, typed (the list narrows to what contains it), or scanned.
/// The item's data is the type's name, empty for "nothing expected".
class TypeChooser : public QComboBox {
    Q_OBJECT
public:
    explicit TypeChooser(QWidget* parent = nullptr);
    void setTypes(const std::vector<TypeRecord>& types); ///< what is chosen stays, if it is among them
    void setExpected(const QString& name); ///< without chosen(); nothing where there is no such type
    [[nodiscard]] QString expected() const { return currentData().toString(); }
    /// Chooses the type with this code or name; otherwise notFound(), and nothing is changed.
    void choose(const QString& codeOrName);

signals:
    void chosen(const QString& name);
    void notFound(const QString& text);

protected:
    void wheelEvent(QWheelEvent* event) override; ///< nothing is chosen by turning a wheel in passing
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int find(const QString& codeOrName) const; ///< below 0: none
    [[nodiscard]] int findTyped(const QString& text) const;  ///< the only one that contains it, too
    void takeTyped();
    void take(int index, const QString& text);
    void showExpected();
    QStringList m_codes; ///< of each item
};

} // namespace gripscope
