// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/form_rows.h"

namespace gripscope {

QFormLayout* makeForm()
{
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    return form;
}

void addFormRow(QFormLayout* form, QLabel* caption, QWidget* field)
{
    caption->setBuddy(field);
    caption->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    field->ensurePolished();
    caption->setMinimumHeight(field->sizeHint().height());
    form->addRow(caption, field);
}

} // namespace gripscope
