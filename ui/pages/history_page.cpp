// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_page.h"

namespace gripscope {

using namespace Qt::StringLiterals;

struct HistoryPage::Private {};

HistoryPage::HistoryPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
}
HistoryPage::~HistoryPage() = default;

QString HistoryPage::id() const
{
    return u"history"_s;
}
QString HistoryPage::title() const
{
    return tr("History");
}
QString HistoryPage::iconName() const
{
    return u"view-history"_s;
}

} // namespace gripscope
