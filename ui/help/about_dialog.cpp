// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_windows.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<AboutDialog> aboutDialogRow("about", [](Workbench&, QWidget* over) {
    return new AboutDialog({}, over);
});
} // namespace

AboutDialog::AboutDialog(const QStringList& pageTitles, QWidget* parent) : Dialog(parent)
{
    setWindowTitle(tr("About Gripscope"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 12);
    column->addWidget(makeLabel(tr("Gripscope %1").arg(QStringLiteral(GRIPSCOPE_VERSION)), "title", this));
    auto* what = makeLabel(tr("Squeezes a part for about a second and says which mass, damping and stiffness "
                              "it showed, with honest error "
                              "bars, and which enrolled type it is, or that it is none of them, or that the "
                              "measurement was not good enough. "
                              "Free software under the GNU General Public License, version 3 or later."),
                           "", this);
    what->setWordWrap(true);
    column->addWidget(what);
    column->addWidget(makeRule(this));
    column->addWidget(makeLabel(tr("Keys"), "heading", this));
    auto* keys = new QGridLayout;
    keys->setHorizontalSpacing(24);
    keys->setVerticalSpacing(6); // all of them on the smallest screen
    const auto addKey = [this, keys](const QString& key, const QString& does) {
        const int row = keys->rowCount();
        keys->addWidget(makeLabel(key, "strong", this), row, 0);
        keys->addWidget(makeLabel(does, "", this), row, 1);
    };
    addKey(tr("Esc"), tr("Stop the gripper and disarm it, on every page"));
    addKey(tr("Space"), tr("Squeeze (pages Inspect and Enroll)"));
    for (qsizetype i = 0; i < pageTitles.size(); ++i)
        addKey(tr("Ctrl+%1").arg(i + 1), tr("Page %1").arg(pageTitles[i]));
    addKey(tr("Ctrl+,"), tr("Settings"));
    addKey(tr("F1"), tr("The manual, at the page about this screen"));
    addKey(tr("Ctrl+Shift+A"), tr("Arm the gripper: hold the keys for a second"));
    addKey(tr("F9"), tr("Inspect the gripper: reports, counters, self-test"));
    keys->setColumnStretch(1, 1);
    column->addLayout(keys);
    column->addStretch(1);
    auto* line = new QHBoxLayout;
    QPushButton* close = makeButton(tr("Close"), {}, "primary", this);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    line->addStretch(1);
    line->addWidget(close);
    column->addLayout(line);
    resize(520, layout()->totalHeightForWidth(520));
}

} // namespace gripscope
