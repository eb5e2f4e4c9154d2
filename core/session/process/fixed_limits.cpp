// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/fixed_limits.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int fixedLimitsVersion = 1;
const std::array<QString, 3> fixedNames{u"m"_s, u"b"_s, u"k"_s};

QJsonArray arrayOf(const Eigen::MatrixXd& numbers)
{
    QJsonArray array;
    for (Eigen::Index i = 0; i < numbers.size(); ++i)
        array.append(numbers(i));
    return array;
}

std::optional<Eigen::VectorXd> numbersOf(const QJsonValue& value, int count)
{
    const QJsonArray array = value.toArray();
    Eigen::VectorXd numbers(count);
    if (array.size() != count)
        return {};
    for (int i = 0; i < count; ++i) {
        if (!array[i].isDouble() || !std::isfinite(array[i].toDouble()))
            return {};
        numbers(i) = array[i].toDouble();
    }
    return numbers;
}

bool takeJoint(const QJsonValue& value, FixedLimits& limits)
{
    if (value.isUndefined())
        return true;
    const auto mean = numbersOf(value[u"mean"], 3);
    const auto covariance = numbersOf(value[u"covariance"], 9);
    const auto behind = numbersOf(value[u"behind"], 2);
    if (!mean || !covariance || !behind || (behind->array() < 0).any())
        return false;
    HotellingReference reference;
    reference.mean = *mean;
    reference.covariance = Eigen::Map<const Eigen::Matrix3d>(covariance->data());
    reference.rows = (*behind)(0);
    reference.degreesOfFreedom = (*behind)(1);
    if (!HotellingChart::of(reference))
        return false;
    limits.joint = reference;
    return true;
}

bool takeQuantities(const QJsonObject& object, FixedLimits& limits)
{
    for (std::size_t i = 0; i < fixedNames.size(); ++i) {
        const QJsonValue value = object.value(fixedNames[i]);
        if (value.isUndefined())
            continue;
        const auto numbers = numbersOf(value, 2);
        if (!numbers || !((*numbers)(1) > 0))
            return false;
        limits.quantities[i] = {(*numbers)(0), (*numbers)(1)};
    }
    return true;
}

} // namespace

QString toText(const FixedLimits& limits)
{
    QJsonObject object{{u"version"_s, fixedLimitsVersion},
                       {u"kind"_s, toString(limits.kind)},
                       {u"rules"_s, toString(limits.rules)},
                       {u"subgroup"_s, limits.subgroup},
                       {u"first"_s, limits.first},
                       {u"last"_s, limits.last},
                       {u"count"_s, limits.count}};
    for (std::size_t i = 0; i < fixedNames.size(); ++i)
        if (const auto& quantity = limits.quantities[i])
            object[fixedNames[i]] = QJsonArray{quantity->centre, quantity->sigma};
    if (limits.joint)
        object[u"joint"_s] =
            QJsonObject{{u"mean"_s, arrayOf(limits.joint->mean)},
                        {u"covariance"_s, arrayOf(limits.joint->covariance)},
                        {u"behind"_s, QJsonArray{limits.joint->rows, limits.joint->degreesOfFreedom}}};
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

std::optional<FixedLimits> fixedLimitsFromText(const QString& text)
{
    const QJsonObject object = QJsonDocument::fromJson(text.toUtf8()).object();
    const auto kind = processKindFromString(object[u"kind"].toString());
    const auto rules = runRulesFromString(object[u"rules"].toString());
    FixedLimits limits;
    limits.subgroup = object[u"subgroup"].toInt();
    constexpr int largestSubgroup = 1000;
    if (object[u"version"].toInt() != fixedLimitsVersion || !kind || !rules || limits.subgroup < 1 ||
        limits.subgroup > largestSubgroup)
        return {};
    limits.kind = *kind;
    limits.rules = *rules;
    limits.first = object[u"first"].toInteger();
    limits.last = object[u"last"].toInteger();
    limits.count = object[u"count"].toInteger();
    if (!takeQuantities(object, limits) || !takeJoint(object.value(u"joint"), limits))
        return {};
    return limits;
}

std::optional<FixedLimits> fixedLimitsOf(const std::optional<ProcessLimitsRecord>& record)
{
    std::optional<FixedLimits> limits = record ? fixedLimitsFromText(record->limits) : std::nullopt;
    if (limits && !record->ofThisLibrary)
        limits->first = limits->last = 0;
    return limits;
}

} // namespace gripscope
