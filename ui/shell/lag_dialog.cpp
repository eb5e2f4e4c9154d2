// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/pages/calibrate/gripper_step.h"
#include "ui/shell/connect_menu.h"
#include "ui/widgets/controls.h"

#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<LagDialog> lagDialogRow("lag", [](Workbench& bench, QWidget* over) {
    return new LagDialog(bench, over);
});
} // namespace

LagDialog::LagDialog(Workbench& workbench, QWidget* parent) : Dialog(parent)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("lagDialog");
    setManualPage(u"records"_s);
    setWindowTitle(tr("Lag between the channels"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    m_step = new LagStep(workbench, this);
    m_step->guide()->button()->setDefault(true);
    auto* close = makeButton(tr("Close"), {}, "", this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    m_step->guide()->addButton(close);
    column->addWidget(m_step, 1);
    resize(520, 340);
}

void LagDialog::done(int result)
{
    m_step->guide()->leave();
    Dialog::done(result);
}

} // namespace gripscope
