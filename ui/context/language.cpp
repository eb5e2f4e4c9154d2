// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <memory>
#include <vector>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

struct InForce {
    QString code = QStringLiteral("en");
    std::vector<std::unique_ptr<QTranslator>> translators; ///< installed
};

InForce& inForce()
{
    static InForce one;
    return one;
}

} // namespace

bool applyLanguage(const QString& code)
{
    std::vector<std::unique_ptr<QTranslator>> translators;
    if (code != "en"_L1) { // the source is English
        auto own = std::make_unique<QTranslator>();
        if (!own->load(u":/translations/gripscope_%1.qm"_s.arg(code)))
            return false;
        // Standard buttons and dialogs; without that package they stay English.
        auto qt = std::make_unique<QTranslator>();
        if (qt->load(u"qtbase_"_s + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            translators.push_back(std::move(qt));
        translators.push_back(std::move(own));
    }
    inForce().translators.clear(); // uninstalls them
    for (const std::unique_ptr<QTranslator>& one : translators)
        QCoreApplication::installTranslator(one.get());
    inForce().translators = std::move(translators);
    inForce().code = code;
    QLocale locale(code);
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    QLocale::setDefault(locale);
    return true;
}

QString currentLanguage()
{
    return inForce().code;
}

} // namespace gripscope
