// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/profile/profile_json.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <valijson/adapters/qtjson_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

// The only file that includes valijson, whose headers take long to compile.

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject schemaDocument()
{
    return QJsonDocument::fromJson(profileSchema()).object();
}

const valijson::Schema& compiledSchema()
{
    static const std::unique_ptr<const valijson::Schema> compiled = [] {
        const QJsonValue document = schemaDocument();
        auto schema = std::make_unique<valijson::Schema>();
        valijson::SchemaParser().populateSchema(valijson::adapters::QtJsonAdapter(document), *schema);
        return schema;
    }();
    return *compiled;
}

/// The steps of valijson's "<root>", "[fields]", "[force]".
QStringList stepsOf(const std::vector<std::string>& context)
{
    QStringList steps;
    for (std::size_t i = 1; i < context.size(); ++i)
        steps << QString::fromStdString(context[i]).mid(1).chopped(1);
    return steps;
}

QString pointerTo(const QStringList& steps)
{
    QString pointer;
    for (const QString& step : steps)
        pointer = jsonPointer(pointer, step);
    return pointer;
}

QJsonObject followReference(const QJsonObject& schema)
{
    static const QJsonObject definitions = schemaDocument()[u"definitions"_s].toObject();
    const QString reference = schema[u"$ref"_s].toString();
    return reference.isEmpty() ? schema : definitions[reference.section(u'/', -1)].toObject();
}

QJsonObject schemaAt(const QStringList& steps)
{
    QJsonObject schema = schemaDocument();
    for (const QString& step : steps) {
        const QJsonObject properties = schema[u"properties"_s].toObject();
        schema = followReference(properties.isEmpty() ? schema[u"items"_s].toObject()
                                                      : properties[step].toObject());
    }
    return schema;
}

QJsonValue valueAt(const QJsonObject& document, const QStringList& steps)
{
    QJsonValue value = document;
    for (const QString& step : steps)
        value = value.isArray() ? value[step.toInt()] : value[step];
    return value;
}

QString inWords(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Array:
        return Words::tr("a list of %1").arg(value.toArray().size());
    case QJsonValue::Object:
        return Words::tr("an object");
    case QJsonValue::Undefined:
        return Words::tr("nothing");
    default:
        break;
    }
    const QString text = QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
    return text.mid(1).chopped(1);
}

/// The name in the quotation marks at the end of one of valijson's sentences.
QString quotedName(const QString& sentence)
{
    return sentence.section(u'\'', -2, -2);
}

ProfileProblem problemOf(const valijson::ValidationResults::Error& error, const QJsonObject& document)
{
    const QStringList steps = stepsOf(error.context);
    const QString sentence = QString::fromStdString(error.description);
    const QJsonObject schema = schemaAt(steps);
    if (sentence.startsWith(u"Missing required property"_s)) {
        const QString name = quotedName(sentence);
        return {pointerTo(steps), Words::tr("no \"%1\"").arg(name),
                schemaAt(steps + QStringList(name))[u"description"_s].toString()};
    }
    if (sentence.startsWith(u"Object contains a property"_s)) {
        const QString name = quotedName(sentence);
        return {jsonPointer(pointerTo(steps), name), Words::tr("the unknown name \"%1\"").arg(name),
                Words::tr("one of %1").arg(schema[u"properties"_s].toObject().keys().join(u", "_s))};
    }
    return {pointerTo(steps), inWords(valueAt(document, steps)), schema[u"description"_s].toString()};
}

/// A sentence that only says that something further in is wrong, which has a sentence of its own.
bool onlyPassesOn(const std::string& sentence)
{
    return sentence.starts_with("Failed to validate against schema associated") ||
           sentence.starts_with("Failed to validate item");
}

} // namespace

QString jsonPointer(const QString& container, const QString& step)
{
    QString escaped = step;
    return container + u'/' + escaped.replace(u'~', u"~0"_s).replace(u'/', u"~1"_s);
}

QByteArray profileSchema()
{
    QFile file(u":/profiles/gripper_profile.schema.json"_s);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<ProfileProblem> checkAgainstSchema(const QJsonObject& document)
{
    const QJsonValue value = document;
    valijson::Validator validator;
    valijson::ValidationResults results;
    std::vector<ProfileProblem> problems;
    if (validator.validate(compiledSchema(), valijson::adapters::QtJsonAdapter(value), &results))
        return problems;
    for (const valijson::ValidationResults::Error& error : results)
        if (!onlyPassesOn(error.description))
            problems.push_back(problemOf(error, document));
    return problems;
}

} // namespace gripscope
