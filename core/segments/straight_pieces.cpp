// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/straight_pieces.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

/// How many points beside a division may change sides.
constexpr int kMovablePoints = 6;
/// A point at a border whose squared distance from a line is more variances than these is a stranger to it.
constexpr double kStranger = kClipSigmas * kClipSigmas;
/// Divisions one within the other before a piece is halved instead.
constexpr int kDeepestDivision = 48;
/// Two lines must explain a piece better than one by so much χ²: where points scatter by more than their noise tells,
/// by as many times that scatter, unless χ² gains even more.
constexpr double kDivisionGain = 16.0;
constexpr double kSureGain = 25.0;
/// One variance serves all points of a piece where that at its ends is less than so many times that of its middle.
constexpr double kEvenVariance = 1.5;
/// How many divisions of a piece are tried at first; the gain at one of them is at least this share of the most; and
/// how many are tried one in the other.
constexpr int kDivisionsTried = 8;
constexpr double kGainNearby = 0.6;
constexpr int kDeepestBend = 4;
/// A division is doubtful where its squared deviation is less than so many times the limit.
constexpr double kDoubtful = 4.0;

/// By how much two lines with this sum of squares [m²] must explain a piece better than one to be no chance [m²].
double surelyTwo(const LinePiece& piece, double apart, double wantedGain)
{
    const double scatter = std::max(piece.variance, apart / std::max(1.0, piece.moments.count - 4.0));
    return std::min(wantedGain * scatter, kSureGain * piece.variance);
}

}  // namespace

std::span<LinePiece> StraightPieces::divide(const BeamPoints& points, int shortest, const Parameters& parameters,
                                            SliceTrace* trace, std::vector<TracedPiece>* dropped)
{
    points_ = &points;
    shortest_ = shortest;
    trace_ = trace;
    dropped_ = dropped;
    pieces_.clear();
    for (int first = 0; first < points.count();) {
        const int next = points.nextBreak(first + 1);
        if (next - first >= shortest)
            splitRun(first, next - 1, parameters);
        else
            tellDropped(first, next - 1);
        first = next;
    }
    for (LinePiece& piece : pieces_)
        fitLine(piece, parameters.noise);
    const auto isBent = [&](const LinePiece& piece) { return bendOf(piece, kDeepestBend, parameters.noise) >= 0; };
    const auto bent = std::find_if(pieces_.begin(), pieces_.end(), isBent);
    if (bent == pieces_.end())
        return pieces_;
    straight_.assign(pieces_.begin(), bent);
    for (auto piece = bent; piece != pieces_.end(); ++piece)
        divideBent(*piece, bendOf(*piece, kDeepestBend, parameters.noise), kDeepestBend, parameters.noise);
    return straight_;
}

/// True where a point is so little beyond the limit that it may be a stranger, or the chord's ends are.
bool StraightPieces::isDoubtful(const ChordF& chord, int division, const Parameters& parameters) const
{
    const double u = points_->u(division);
    const double v = points_->v(division);
    const auto normalU = static_cast<double>(-chord.directionV);
    const auto normalV = static_cast<double>(chord.directionU);
    const double deviation =
        normalU * (u - static_cast<double>(chord.u)) + normalV * (v - static_cast<double>(chord.v));
    const double variance = varianceAcross(normalU, normalV, u, v, parameters.noise);
    const double limit =
        std::max(square(parameters.segments.splitDistance), square(parameters.segments.splitSigmas) * variance);
    return square(deviation) < kDoubtful * limit;
}

/// Splits a run at the points farthest from its chords, and settles the borders between the pieces.
void StraightPieces::splitRun(int first, int last, const Parameters& parameters)
{
    const auto fixed = static_cast<float>(square(parameters.segments.splitDistance));
    const auto sigmas = static_cast<float>(square(parameters.segments.splitSigmas));
    const auto bearing = static_cast<float>(square(parameters.noise.bearing));
    const DeviationLimits limits{fixed, sigmas, bearing};
    const BeamArrays points = points_->arrays();

    const std::size_t begin = pieces_.size();
    open_.clear();
    open(first, last, 0);
    while (!open_.empty()) {
        const int from = open_.back().first;
        const int to = open_.back().last;
        const int depth = open_.back().depth;
        // Neighbours share their point of division; it belongs to the left one until the border is settled.
        const bool shared = pieces_.size() > begin && pieces_.back().last == from;
        const int start = shared ? from + 1 : from;
        const int count = to - start + 1;
        if (count < shortest_) {
            tellDropped(start, to);
            open_.pop_back();
            continue;
        }
        const ChordF chord = points_->chordOf(from, to);
        const int division = points_->kernels().farthest(points, from + 1, to - 1, chord, limits);
        if (division < 0) {
            LinePiece& piece = addPiece(start, to);
            piece.moments =
                open_.back().momentsFirst == start ? open_.back().moments : points_->momentsOf(start, to, chord);
            open_.pop_back();
            continue;
        }
        open_.pop_back();
        if (depth >= kDeepestDivision) {
            const int middle = (from + to) / 2;
            tellSplit(chord, middle, depth, parameters);
            open(middle, to, depth + 1);
            open(from, middle, depth + 1);
            continue;
        }
        open(division, to, depth + 1);
        open(from, division, depth + 1);
        if (count < 2 * shortest_ || !isDoubtful(chord, division, parameters)) {
            tellSplit(chord, division, depth, parameters);
            continue;
        }
        Open& right = open_[open_.size() - 2];
        Open& left = open_.back();
        left.moments = points_->momentsOf(start, division, chord);
        left.momentsFirst = start;
        right.moments = points_->momentsOf(division + 1, to, chord);
        right.momentsFirst = division + 1;
        LineMoments whole = left.moments;
        whole.add(right.moments);
        const double variance =
            varianceAcross(static_cast<double>(-chord.directionV), static_cast<double>(chord.directionU), whole.u,
                           whole.v, parameters.noise);
        const double apart = axesOf(left.moments).smaller + axesOf(right.moments).smaller;
        if (isOneLine(whole.count, axesOf(whole).smaller, apart, variance)) {
            open_.resize(open_.size() - 2);
            addPiece(start, to).moments = whole;
        } else {
            tellSplit(chord, division, depth, parameters);
        }
    }
    for (std::size_t i = begin + 1; i < pieces_.size(); ++i)
        settleBorder(pieces_[i - 1], pieces_[i], parameters.noise);
}

/// Deviation and limit as the search for the farthest point has them, in floats.
void StraightPieces::tellSplit(const ChordF& chord, int division, int depth, const Parameters& parameters) const
{
    if (trace_ == nullptr)
        return;
    const int beam = points_->beam(division);
    if (depth >= kDeepestDivision) {
        trace_->splits.push_back(
            {beam, {"divisions", static_cast<double>(depth), Comparison::GreaterEqual, kDeepestDivision}});
        return;
    }
    const BeamArrays points = points_->arrays();
    const float normalU = -chord.directionV;
    const float normalV = chord.directionU;
    const float along = normalU * points.u[division] + normalV * points.v[division];
    const float across = normalV * points.u[division] - normalU * points.v[division];
    const float deviation = along - (normalU * chord.u + normalV * chord.v);
    const float variance = along * along * points.relativeVariance[division] +
                           across * across * static_cast<float>(square(parameters.noise.bearing));
    const float limit = std::max(static_cast<float>(square(parameters.segments.splitDistance)),
                                 static_cast<float>(square(parameters.segments.splitSigmas)) * variance);
    trace_->splits.push_back({beam,
                              {"chord_distance", static_cast<double>(std::abs(deviation)), Comparison::Greater,
                               std::sqrt(static_cast<double>(limit))}});
}

/// Gain and limit in variances.
void StraightPieces::tellBend(const LinePiece& piece, int division, const NoiseParameters& noise) const
{
    if (trace_ == nullptr)
        return;
    const double apart =
        lineOf(fewPoints(piece.first, division - 1)).across + lineOf(fewPoints(division, piece.last)).across;
    trace_->splits.push_back({points_->beam(division),
                              {"two_lines_gain", (piece.line.across - apart) / piece.variance, Comparison::Greater,
                               surelyTwo(piece, apart, wantedGain(piece, noise)) / piece.variance}});
}

void StraightPieces::tellDropped(int first, int last) const
{
    if (dropped_ != nullptr)
        dropped_->push_back(tooFew(points_->beam(first), points_->beam(last), last - first + 1,
                                   {"points", 0.0, Comparison::GreaterEqual, static_cast<double>(shortest_)}));
}

/// The deviation is squared, in variances.
void StraightPieces::tellStranger(int point, double deviation) const
{
    if (dropped_ != nullptr)
        dropped_->push_back(
            offTheLine(points_->beam(point), {"line_chi2", deviation, Comparison::LessEqual, kStranger}));
}

void StraightPieces::open(int first, int last, int depth)
{
    Open& added = open_.emplace_back();
    added.first = first;
    added.last = last;
    added.depth = depth;
}

LinePiece& StraightPieces::addPiece(int first, int last)
{
    LinePiece& piece = pieces_.emplace_back();
    piece.first = first;
    piece.last = last;
    return piece;
}

LinePiece StraightPieces::pieceOf(int first, int last) const
{
    LinePiece piece;
    piece.first = first;
    piece.last = last;
    piece.moments = points_->momentsOf(first, last, points_->chordOf(first, last));
    return piece;
}

/// Moments of a handful of points.
LineMoments StraightPieces::fewPoints(int first, int last) const
{
    LineMoments moments;
    const double u = points_->u(first);
    const double v = points_->v(first);
    for (int i = first; i <= last; ++i) {
        const double du = points_->u(i) - u;
        const double dv = points_->v(i) - v;
        moments.u += du;
        moments.v += dv;
        moments.uu += du * du;
        moments.uv += du * dv;
        moments.vv += dv * dv;
    }
    moments.count = last - first + 1;
    const double share = 1.0 / moments.count;
    moments.uu -= share * moments.u * moments.u;
    moments.uv -= share * moments.u * moments.v;
    moments.vv -= share * moments.v * moments.v;
    moments.u = u + share * moments.u;
    moments.v = v + share * moments.v;
    return moments;
}

/// Moves the border between two neighbouring pieces to where their lines say it is; points of no piece between them
/// take part.
void StraightPieces::settleBorder(LinePiece& left, LinePiece& right, const NoiseParameters& noise) const
{
    if (right.first - left.last - 1 > kMovablePoints)
        return;
    const auto movable = [](const LinePiece& piece) { return std::clamp(piece.points() / 3, 1, kMovablePoints); };
    const int low = left.last - movable(left) + 1;
    const int high = right.first + movable(right) - 1;
    LineMoments leftSure = left.moments;
    LineMoments rightSure = right.moments;
    leftSure.remove(fewPoints(low, left.last));
    rightSure.remove(fewPoints(right.first, high));
    // Squared distance of a point from a line, in its variances there; the normal may have any length.
    const auto costOf = [&](const LineMoments& moments) {
        const ScatterAxes axes = axesOf(moments);
        const double normalU = -axes.directionV;
        const double normalV = axes.directionU;
        const double offset = normalU * moments.u + normalV * moments.v;
        const double weight = 1.0 / varianceAcross(normalU, normalV, moments.u, moments.v, noise);
        return [this, normalU, normalV, offset, weight](int i) {
            return square(normalU * points_->u(i) + normalV * points_->v(i) - offset) * weight;
        };
    };
    const auto leftCost = costOf(leftSure);
    const auto rightCost = costOf(rightSure);
    // Of all borders in reach the one with the smallest sum of squares, where a stranger to both counts as a limit.
    double sum = 0.0;
    double best = 0.0;
    int border = low;  // first point of the right piece
    for (int i = low; i <= high; ++i) {
        sum += std::min(leftCost(i), kStranger) - std::min(rightCost(i), kStranger);
        if (sum < best) {
            best = sum;
            border = i + 1;
        }
    }
    const int leftLast = left.last;
    const int rightFirst = right.first;
    left.last = border - 1;
    right.first = border;
    for (; left.last >= low && leftCost(left.last) > kStranger; --left.last)
        tellStranger(left.last, leftCost(left.last));
    for (; right.first <= high && rightCost(right.first) > kStranger; ++right.first)
        tellStranger(right.first, rightCost(right.first));
    if (left.last != leftLast) {
        left.moments = leftSure;
        if (left.last >= low)
            left.moments.add(fewPoints(low, left.last));
    }
    if (right.first != rightFirst) {
        right.moments = rightSure;
        if (right.first <= high)
            right.moments.add(fewPoints(right.first, high));
    }
}

/// Whether one variance tells how all points of a piece stray: that across the line is about the same all along, while
/// beside the foot of a long wall it is many times that of its middle, and no ranges err together, which is no step.
bool StraightPieces::hasOneVariance(const LinePiece& piece, const NoiseParameters& noise) const
{
    if (noise.systematic > 0.0)
        return false;
    const auto isEven = [&](int i) {
        return varianceAcross(piece.line.normalU(), piece.line.normalV(), points_->u(i), points_->v(i), noise) <
               kEvenVariance * piece.variance;
    };
    return isEven(piece.first) && isEven(piece.last);
}

/// By how many times the scatter two lines must explain a piece better than one.
double StraightPieces::wantedGain(const LinePiece& piece, const NoiseParameters& noise) const
{
    return hasOneVariance(piece, noise) ? kDivisionGain : kSureGain;
}

/// Where two lines explain a piece best: the first point of the second one; −1 where two explain it no better than one.
int StraightPieces::bestDivision(const LinePiece& piece, const NoiseParameters& noise) const
{
    int low = piece.first + shortest_;
    int high = piece.last - shortest_ + 1;
    int division = -1;
    const double wanted = wantedGain(piece, noise);
    double least = piece.line.across - kGainNearby * wanted * piece.variance;
    // Every few points first, then every point around the best.
    for (int step = std::max(1, piece.points() / kDivisionsTried);; step = std::max(1, step / kDivisionsTried * 2)) {
        LineMoments left = fewPoints(piece.first, low - 1);
        for (int border = low; border <= high; border += step) {
            LineMoments right = piece.moments;
            right.remove(left);
            const double across = axesOf(left).smaller + axesOf(right).smaller;
            if (across < least) {
                least = across;
                division = border;
            }
            if (border + step <= high)
                left.add(fewPoints(border, border + step - 1));
        }
        if (step == 1 || division < 0)
            return division >= 0 && piece.line.across - least > surelyTwo(piece, least, wanted) ? division : -1;
        low = std::max(piece.first + shortest_, division - step);
        high = std::min(piece.last - shortest_ + 1, division + step);
    }
}

/// Where a fitted piece is to be divided because two lines explain it much better than one; −1 where it is not.
int StraightPieces::bendOf(const LinePiece& piece, int depth, const NoiseParameters& noise) const
{
    // A step that many points tell is lost in their scatter long before one line explains them badly.
    const double most = piece.variance * largestChi(piece.moments.count);
    const double sure = piece.variance * (piece.moments.count - 2.0 + kSureGain);
    const bool mayBe = depth > 0 && piece.points() >= 2 * shortest_ && piece.line.across > std::min(most, sure) &&
                       (piece.line.across > most || hasOneVariance(piece, noise));
    return mayBe ? bestDivision(piece, noise) : -1;
}

/// Appends a fitted piece to the straight ones, divided at a point (−1: whole) and on: steps and bends that are too
/// small for any point to be far from the chord.
void StraightPieces::divideBent(const LinePiece& piece, int division, int depth, const NoiseParameters& noise)
{
    if (division < 0) {
        straight_.push_back(piece);
        return;
    }
    tellBend(piece, division, noise);
    LinePiece left = pieceOf(piece.first, division - 1);
    LinePiece right = pieceOf(division, piece.last);
    settleBorder(left, right, noise);
    for (LinePiece* part : {&left, &right}) {
        fitLine(*part, noise);
        divideBent(*part, bendOf(*part, depth - 1, noise), depth - 1, noise);
    }
}

}  // namespace planewright
