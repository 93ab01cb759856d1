// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/row_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace planewright {

namespace {

/// A piece of a query between blanks, with its place.
struct Piece {
    QString text;  ///< without quotes
    int position = 0;
    int length = 0;
    int operatorAt = -1;  ///< place in text of the first : < > = ! outside quotes
};

bool isOperator(QChar c)
{
    return c == ':' || c == '<' || c == '>' || c == '=' || c == '!';
}

std::vector<Piece> piecesOf(const QString& query)
{
    std::vector<Piece> pieces;
    Piece piece;
    bool quoted = false;
    const auto end = [&](int at) {
        piece.length = at - piece.position;
        if (piece.length > 0)
            pieces.push_back(piece);
        piece = {.text = {}, .position = at + 1};
    };
    for (int at = 0; at < query.size(); ++at) {
        const QChar c = query[at];
        if (c == '"') {
            quoted = !quoted;
        } else if (c.isSpace() && !quoted) {
            end(at);
        } else {
            if (!quoted && piece.operatorAt < 0 && isOperator(c))
                piece.operatorAt = static_cast<int>(piece.text.size());
            piece.text += c;
        }
    }
    end(static_cast<int>(query.size()));
    return pieces;
}

/// True where one of the words of a text begins with another.
bool hasWordThatBeginsWith(const QString& text, const QString& beginning)
{
    for (qsizetype at = text.indexOf(beginning, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(beginning, at + 1, Qt::CaseInsensitive)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber())
            return true;
    }
    return false;
}

QString namesOf(std::span<const FilterKey> keys)
{
    QString names;
    for (const FilterKey& key : keys)
        names += (names.isEmpty() ? "" : ", ") + QString::fromUtf8(key.name);
    return names;
}

}  // namespace

/// Makes a term of a piece.
class FilterReader {
public:
    explicit FilterReader(std::span<const FilterKey> keys) : keys_(keys) {}

    /// Gives what is wrong, or nothing.
    QString read(const Piece& piece, RowFilter::Term& term) const
    {
        if (piece.operatorAt < 0) {
            term.text = piece.text;
            return {};
        }
        const QString name = piece.text.left(piece.operatorAt);
        const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const FilterKey& k) {
            return name.compare(QString::fromUtf8(k.name), Qt::CaseInsensitive) == 0;
        });
        if (key == keys_.end())
            return QStringLiteral("There is no column “%1”. Known: %2.").arg(name, namesOf(keys_));
        term.key = *key;
        const QString rest = piece.text.mid(piece.operatorAt);
        return key->kind == FilterKey::Kind::Number ? readNumber(name, rest, term) : readText(name, rest, term);
    }

private:
    static QString readNumber(const QString& name, const QString& rest, RowFilter::Term& term)
    {
        using enum RowFilter::Comparison;
        static constexpr std::array<std::pair<const char*, RowFilter::Comparison>, 8> kOperators{{{"<=", LessEqual},
                                                                                                  {">=", GreaterEqual},
                                                                                                  {"!=", Unequal},
                                                                                                  {"==", Equal},
                                                                                                  {"<", Less},
                                                                                                  {">", Greater},
                                                                                                  {"=", Equal},
                                                                                                  {":", Equal}}};
        const auto* const found = std::find_if(kOperators.begin(), kOperators.end(), [&](const auto& entry) {
            return rest.startsWith(QLatin1String(entry.first));
        });
        if (found == kOperators.end())
            return QStringLiteral("“%1” is no comparison. Write %2<1 or %2>=1.").arg(rest.left(1), name);
        term.comparison = found->second;
        const QString number = rest.mid(static_cast<qsizetype>(qstrlen(found->first)));
        bool isNumber = false;
        term.number = number.toDouble(&isNumber);
        if (number.isEmpty())
            return QStringLiteral("A number is missing. Write %1%2 and a number.")
                .arg(name, QLatin1String(found->first));
        if (!isNumber || !std::isfinite(term.number))
            return QStringLiteral("“%1” is no number. Write %2%3 and a number, as in 0.5.")
                .arg(number, name, QLatin1String(found->first));
        return {};
    }

    static QString readText(const QString& name, const QString& rest, RowFilter::Term& term)
    {
        if (!rest.startsWith(':') && !rest.startsWith('='))
            return QStringLiteral("“%1” is a text and has no size. Write %1: and a word.").arg(name);
        term.text = rest.mid(1);
        return term.text.isEmpty() ? QStringLiteral("A word is missing. Write %1: and a word.").arg(name) : QString{};
    }

    std::span<const FilterKey> keys_;
};

std::optional<FilterProblem> RowFilter::setQuery(const QString& query, std::span<const FilterKey> keys)
{
    const FilterReader reader(keys);
    std::vector<Term> terms;
    if (query.count('"') % 2 != 0) {
        const int quote = static_cast<int>(query.lastIndexOf('"'));
        return FilterProblem{quote, static_cast<int>(query.size()) - quote, QStringLiteral("A closing \" is missing.")};
    }
    for (const Piece& piece : piecesOf(query)) {
        Term term;
        const QString reason = reader.read(piece, term);
        if (!reason.isEmpty())
            return FilterProblem{piece.position, piece.length, reason};
        terms.push_back(std::move(term));
    }
    terms_ = std::move(terms);
    return std::nullopt;
}

bool RowFilter::holds(const Term& term, double value)
{
    switch (term.comparison) {
        case Comparison::Less:
            return value < term.number;
        case Comparison::LessEqual:
            return value <= term.number;
        case Comparison::Greater:
            return value > term.number;
        case Comparison::GreaterEqual:
            return value >= term.number;
        case Comparison::Equal:
            return value == term.number;
        case Comparison::Unequal:
            return value != term.number;
    }
    return false;
}

bool RowFilter::accepts(const QAbstractItemModel& model, int row, const QModelIndex& parent) const
{
    return std::all_of(terms_.begin(), terms_.end(), [&](const Term& term) {
        if (!term.key)
            return model.index(row, 0, parent).data(kPlainTextRole).toString().contains(term.text, Qt::CaseInsensitive);
        const QVariant value = model.index(row, term.key->column, parent).data(term.key->role);
        if (!value.isValid())
            return false;
        return term.key->kind == FilterKey::Kind::Number ? holds(term, value.toDouble())
                                                         : hasWordThatBeginsWith(value.toString(), term.text);
    });
}

}  // namespace planewright
