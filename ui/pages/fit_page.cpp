// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page.h"

namespace gripscope {

using namespace Qt::StringLiterals;

struct FitPage::Private {};

FitPage::FitPage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>()) {}
FitPage::~FitPage() = default;

QString FitPage::id() const
{
    return u"fit"_s;
}
QString FitPage::title() const
{
    return tr("Fit");
}
QString FitPage::iconName() const
{
    return u"labplot-xy-fit-curve"_s;
}

} // namespace gripscope
