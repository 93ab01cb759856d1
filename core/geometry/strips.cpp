// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>

#include "core/geometry/ring_chains.h"

namespace planewright {
namespace {

constexpr int kBridgedRows = 3;       // strips reach over up to two rows in which a part was missed …
constexpr double kBridgedGap = 0.15;  // … or over this gap [m]: below the shortest segment, nothing shows in it …
constexpr int kRowsKept = 32;         // … within so many rows, which bounds the work
constexpr double kShortestOverlap = 1e-3;  // [m]; an overlap or a leftover below it is rounding
constexpr double kSlant = 3.0;             // ends that differ by up to this multiple of the gap are joined slanted
constexpr double kEndNoise = 0.03;         // … or by up to this length [m]
constexpr double kStraightOn = 0.94;       // cosine of 20°: a border that turns by less goes straight on
constexpr double kSameWay = 0.5;           // cosine of 60°: rows that differ by more are not side by side

/// Part of a stretch, from and to as fractions of its length.
struct Piece {
    std::size_t stretch;
    double from;
    double to;
};

/// A row while it waits for neighbours: the pieces that nothing was joined to yet.
struct WaitingRow {
    int number;
    Eigen::Vector2d direction;
    std::vector<Piece> open;
};

/// A piece that is used up, by its place among the open ones.
struct Cut {
    std::size_t piece;
    double from;
    double to;
};

/// The border from the end of one stretch to the end of the next, at the neighbour whose end is nearest.
struct Border {
    double difference = std::numeric_limits<double>::infinity();
    std::size_t strip = 0;
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();

    void offer(const Border& other)
    {
        if (other.difference < difference)
            *this = other;
    }
};

/// Removes cuts from pieces; both in order along the row.
std::vector<Piece> without(const std::vector<Piece>& pieces, const std::vector<Cut>& cuts,
                           const std::vector<Stretch>& stretches)
{
    std::vector<Piece> rest;
    auto cut = cuts.begin();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece piece = pieces[i];
        const double length = (stretches[piece.stretch].end - stretches[piece.stretch].start).norm();
        const auto keep = [&](double from, double to) {
            if ((to - from) * length > kShortestOverlap)
                rest.push_back({piece.stretch, from, to});
        };
        for (; cut != cuts.end() && cut->piece == i; ++cut) {
            keep(piece.from, cut->from);
            piece.from = cut->to;
        }
        keep(piece.from, piece.to);
    }
    return rest;
}

/// Finds the strips row by row and then decides on their ends.
class StripBuilder {
public:
    void add(const Row& row);
    std::vector<PlanarRing> rings() const;

private:
    struct Seen;
    struct Overlap;

    WaitingRow enter(const Row& row);
    void join(WaitingRow& before, WaitingRow& after);
    std::vector<Seen> seenAlong(const std::vector<Piece>& pieces, const Eigen::Vector2d& along) const;
    Eigen::Vector2d pointOf(const Seen& seen, double place) const;
    bool bridges(const WaitingRow& before, const WaitingRow& after, const Overlap& overlap) const;
    Strip::End endOf(const Overlap& overlap, int side);
    bool goesStraightOn(std::size_t strip, int side) const;
    Strip decided(std::size_t strip) const;
    StripCorners cornersOf(const Strip& strip) const;

    Eigen::Vector2d at(std::size_t stretch, double fraction) const
    {
        return stretches_[stretch].start + fraction * (stretches_[stretch].end - stretches_[stretch].start);
    }

    std::vector<Stretch> stretches_;                 // of all rows, each along its row's direction
    std::vector<std::array<Border, 2>> bordersIn_;   // per stretch and side: from the row before
    std::vector<std::array<Border, 2>> bordersOut_;  // per stretch and side: to the row after
    std::vector<Strip> strips_;
    std::deque<WaitingRow> waiting_;
    Eigen::Vector2d lastDirection_ = Eigen::Vector2d::Zero();
};

/// A piece and where its ends lie along a direction [m].
struct StripBuilder::Seen {
    Piece piece;
    double low;
    double high;

    double fractionAt(double place) const
    {
        return std::clamp(piece.from + (place - low) / (high - low) * (piece.to - piece.from), piece.from, piece.to);
    }
};

/// Two pieces side by side, seen along their common direction.
struct StripBuilder::Overlap {
    Seen before;
    Seen after;
    std::array<double, 2> range{};  ///< what both cover [m]
    std::array<double, 2> gap{};    ///< between them at both ends of the range, signed [m]
    std::array<bool, 2> alone{};    ///< on this side neither meets another piece beyond the range
};

std::vector<StripBuilder::Seen> StripBuilder::seenAlong(const std::vector<Piece>& pieces,
                                                        const Eigen::Vector2d& along) const
{
    std::vector<Seen> seen;
    seen.reserve(pieces.size());
    for (const Piece& piece : pieces)
        seen.push_back({piece, along.dot(at(piece.stretch, piece.from)), along.dot(at(piece.stretch, piece.to))});
    return seen;
}

Eigen::Vector2d StripBuilder::pointOf(const Seen& seen, double place) const
{
    return at(seen.piece.stretch, seen.fractionAt(place));
}

void StripBuilder::add(const Row& row)
{
    WaitingRow next = enter(row);
    while (!waiting_.empty() && next.number - waiting_.front().number > kRowsKept)
        waiting_.pop_front();
    for (auto before = waiting_.rbegin(); before != waiting_.rend() && !next.open.empty(); ++before)
        join(*before, next);
    std::erase_if(waiting_, [](const WaitingRow& r) { return r.open.empty(); });

    // What met no row before is still to meet the rows after, as is all the rest.
    next.open.clear();
    for (std::size_t i = stretches_.size() - row.stretches.size(); i < stretches_.size(); ++i)
        next.open.push_back({i, 0.0, 1.0});
    waiting_.push_back(std::move(next));
}

WaitingRow StripBuilder::enter(const Row& row)
{
    const auto longest =
        std::ranges::max_element(row.stretches, {}, [](const Stretch& s) { return (s.end - s.start).squaredNorm(); });
    Eigen::Vector2d direction = (longest->end - longest->start).normalized();
    if (direction.dot(lastDirection_) < 0.0)
        direction = -direction;
    lastDirection_ = direction;

    const std::size_t first = stretches_.size();
    for (Stretch stretch : row.stretches) {
        if (direction.dot(stretch.end - stretch.start) < 0.0)
            std::swap(stretch.start, stretch.end);
        stretches_.push_back(stretch);
    }
    std::stable_sort(stretches_.begin() + static_cast<std::ptrdiff_t>(first), stretches_.end(),
                     [&](const Stretch& a, const Stretch& b) { return direction.dot(a.start - b.start) < 0.0; });
    bordersIn_.resize(stretches_.size());
    bordersOut_.resize(stretches_.size());

    WaitingRow entered{row.number, direction, {}};
    for (std::size_t i = first; i < stretches_.size(); ++i)
        entered.open.push_back({i, 0.0, 1.0});
    return entered;
}

void StripBuilder::join(WaitingRow& before, WaitingRow& after)
{
    if (before.direction.dot(after.direction) < kSameWay)
        return;
    const Eigen::Vector2d along = (before.direction + after.direction).normalized();
    const Eigen::Vector2d aside{-along.y(), along.x()};
    const std::vector<Seen> beforeSeen = seenAlong(before.open, along);
    const std::vector<Seen> afterSeen = seenAlong(after.open, along);
    std::vector<Cut> cutsBefore;
    std::vector<Cut> cutsAfter;
    for (std::size_t b = 0, a = 0; b < beforeSeen.size() && a < afterSeen.size();) {
        Overlap overlap{beforeSeen[b], afterSeen[a]};
        overlap.range = {std::max(overlap.before.low, overlap.after.low),
                         std::min(overlap.before.high, overlap.after.high)};
        if (overlap.range[1] - overlap.range[0] > kShortestOverlap) {
            for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
                overlap.gap[end] =
                    aside.dot(pointOf(overlap.after, overlap.range[end]) - pointOf(overlap.before, overlap.range[end]));
            // An end that also meets the next stretch of the other row is no counterpart of this stretch's end.
            overlap.alone = {(a == 0 || afterSeen[a - 1].high <= overlap.before.low) &&
                                 (b == 0 || beforeSeen[b - 1].high <= overlap.after.low),
                             (a + 1 == afterSeen.size() || afterSeen[a + 1].low >= overlap.before.high) &&
                                 (b + 1 == beforeSeen.size() || beforeSeen[b + 1].low >= overlap.after.high)};
            if (bridges(before, after, overlap)) {
                const std::array ends{endOf(overlap, 0), endOf(overlap, 1)};
                strips_.push_back({overlap.before.piece.stretch, overlap.after.piece.stretch, ends});
                cutsBefore.push_back({b, ends[0].before, ends[1].before});
                cutsAfter.push_back({a, ends[0].after, ends[1].after});
            }
        }
        if (overlap.before.high < overlap.after.high)
            ++b;
        else
            ++a;
    }
    before.open = without(before.open, cutsBefore, stretches_);
    after.open = without(after.open, cutsAfter, stretches_);
}

bool StripBuilder::bridges(const WaitingRow& before, const WaitingRow& after, const Overlap& overlap) const
{
    return after.number - before.number <= kBridgedRows ||
           std::max(std::abs(overlap.gap[0]), std::abs(overlap.gap[1])) <= kBridgedGap;
}

/// Where the strip about to be made ends on a side, and whether that is certain; notes the border there.
Strip::End StripBuilder::endOf(const Overlap& overlap, int side)
{
    const auto s = static_cast<std::size_t>(side);
    const double whole = side == 0 ? 0.0 : 1.0;
    const double place = overlap.range[s];
    const Strip::End square{overlap.before.fractionAt(place), overlap.after.fractionAt(place), false};
    const Piece& before = overlap.before.piece;
    const Piece& after = overlap.after.piece;
    const bool bothEnd = (side == 0 ? before.from : before.to) == whole && (side == 0 ? after.from : after.to) == whole;
    if (!bothEnd || !overlap.alone[s])
        return square;

    const double difference =
        std::abs(side == 0 ? overlap.before.low - overlap.after.low : overlap.before.high - overlap.after.high);
    const Border border{difference, strips_.size(),
                        (at(after.stretch, whole) - at(before.stretch, whole)).normalized()};
    bordersOut_[before.stretch][s].offer(border);
    bordersIn_[after.stretch][s].offer(border);
    if (difference <= std::max(kSlant * std::abs(overlap.gap[s]), kEndNoise))
        return {whole, whole, false};
    return {square.before, square.after, true};
}

/// True where the border along a strip's stepped end continues the border before or is continued by the one after.
bool StripBuilder::goesStraightOn(std::size_t strip, int side) const
{
    const auto s = static_cast<std::size_t>(side);
    const Border& here = bordersOut_[strips_[strip].before][s];
    if (here.strip != strip || bordersIn_[strips_[strip].after][s].strip != strip)
        return false;
    const Border& incoming = bordersIn_[strips_[strip].before][s];
    const Border& outgoing = bordersOut_[strips_[strip].after][s];
    return here.direction.dot(incoming.direction) > kStraightOn || here.direction.dot(outgoing.direction) > kStraightOn;
}

/// The strip with the decision on its ends taken.
Strip StripBuilder::decided(std::size_t strip) const
{
    Strip s = strips_[strip];
    for (const int side : {0, 1}) {
        Strip::End& end = s.ends[static_cast<std::size_t>(side)];
        if (end.stepped && goesStraightOn(strip, side))
            end.before = end.after = side;
    }
    return s;
}

StripCorners StripBuilder::cornersOf(const Strip& strip) const
{
    return {at(strip.before, strip.ends[0].before), at(strip.before, strip.ends[1].before),
            at(strip.after, strip.ends[0].after), at(strip.after, strip.ends[1].after)};
}

std::vector<PlanarRing> StripBuilder::rings() const
{
    RingChains chains(stretches_.size());
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        const Strip strip = decided(i);
        chains.add(strip, cornersOf(strip));
    }
    return chains.rings();
}

}  // namespace

std::vector<PlanarRing> stripsBetween(const std::vector<Row>& rows)
{
    StripBuilder builder;
    for (const Row& row : rows) {
        if (!row.stretches.empty())
            builder.add(row);
    }
    return builder.rings();
}

}  // namespace planewright
