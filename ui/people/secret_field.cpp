// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/secret_field.h"

#include <QLineEdit>

namespace gripscope {

QLineEdit* makeSecretField(const QString& name, QWidget* parent)
{
    auto* field = new QLineEdit(parent);
    field->setEchoMode(QLineEdit::Password);
    field->setInputMethodHints(Qt::ImhHiddenText | Qt::ImhSensitiveData | Qt::ImhNoPredictiveText |
                               Qt::ImhNoAutoUppercase);
    field->setContextMenuPolicy(Qt::NoContextMenu);
    field->setMaxLength(Secret::mostCharacters);
    field->setAccessibleName(name);
    return field;
}

Secret takeSecret(QLineEdit& field)
{
    QString text = field.text();
    Secret secret(text);
    field.clear();
    wipe(text);
    return secret;
}

} // namespace gripscope
