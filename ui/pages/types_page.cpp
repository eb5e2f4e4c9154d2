// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page.h"

namespace gripscope {

using namespace Qt::StringLiterals;

struct TypesPage::Private {};

TypesPage::TypesPage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>())
{
}
TypesPage::~TypesPage() = default;

QString TypesPage::id() const
{
    return u"types"_s;
}
QString TypesPage::title() const
{
    return tr("Types");
}
QString TypesPage::iconName() const
{
    return u"office-chart-scatter"_s;
}

} // namespace gripscope
