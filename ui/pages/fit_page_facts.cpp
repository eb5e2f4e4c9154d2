// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_facts.h"

#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QLabel>

namespace gripscope {

using namespace Qt::StringLiterals;

QGridLayout* makeFactGrid()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * metrics::step);
    grid->setVerticalSpacing(metrics::insideControl);
    grid->setColumnStretch(1, 1);
    return grid;
}

void fillFacts(QGridLayout* grid, const std::vector<Fact>& facts)
{
    while (QLayoutItem* item = grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const Fact& fact : facts) {
        const int at = grid->rowCount();
        auto* name = makeLabel(fact.name, "second");
        auto* text = makeLabel(fact.text, fact.number ? "strong" : "");
        text->setWordWrap(!fact.number);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        text->setAccessibleName(u"%1: %2"_s.arg(fact.name, fact.text));
        const Qt::Alignment alignment = fact.number ? Qt::AlignBaseline : Qt::AlignTop;
        grid->addWidget(name, at, 0, alignment);
        grid->addWidget(text, at, 1, alignment);
    }
}

} // namespace gripscope
