/*  Model cards: what the program must know of a model stands in its header, beside its formula; a
    family is a table of types.

        struct Hertz : ElasticNormal
        {
            static constexpr const char* word = "hertz";        // in dictionaries, in the log
            static constexpr const char* text = "...";          // one line
            static constexpr Entry entries[] = {...}; // its numbers: names, units, ranges, defaults
            ...
        };
        using NormalLaws = Models<LinearSpring, Hertz>;         // the table line

    From the table follow words and messages, what is read, checked and printed, and the dispatch
    from a word to a type. Several models may share a word, where another choice decides between
    them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace riprap
{

enum class Range {positive, zeroOrPositive, fraction};      // fraction: above 0, at most 1

//- In a line of the log: the value, or only where it was set, or not at all
enum class Shown {always, ifSet, never};

//- Where something is kept in its Owner (by a name of its own, since nvcc puts brackets around a
//  plain pointer to a member and g++ warns)
template<class Owner, class Value>
using Member = Value Owner::*;

//- A number of a model, or a yes or no: where it is kept in its Owner, and what it may be. Without
//  a place of its own it is kept by name (Owner::more), so that a new model changes no struct
template<class Owner>
struct ModelEntry
{
    const char* name;
    const char* unit;
    const char* what;                       // as messages call it
    Member<Owner, double> number = nullptr;
    Member<Owner, bool> yesNo = nullptr;
    Range range = Range::positive;
    double highest = 1e300;
    bool required = true;
    double otherwise = 0;                   // if it is not required
    Shown shown = Shown::always;
    bool perDepth = false;                  // 2D: per metre of depth
    bool calibrated = false;                // may be a calibration by elastic constants
    // what tests take; and where nothing is to be lost, if it decides that (>= 0)
    double typical = 0.5, lossless = -1;

    constexpr ModelEntry(
        const char* n, const char* u, const char* w, Member<Owner, double> to = nullptr)
        : name(n), unit(u), what(w), number(to)
    {}
    constexpr ModelEntry(const char* n, const char* w, Member<Owner, bool> to, bool otherwise)
        : name(n), unit(""), what(w), yesNo(to), required(false), otherwise(otherwise),
          shown(Shown::ifSet)
    {}

    constexpr ModelEntry in(Range r) const { ModelEntry e = *this; e.range = r; return e; }
    constexpr ModelEntry atMost(double v) const { ModelEntry e = *this; e.highest = v; return e; }
    constexpr ModelEntry byDefault(double v) const
    {
        ModelEntry e = *this;
        e.required = false;
        e.otherwise = v;
        return e;
    }
    constexpr ModelEntry show(Shown s) const { ModelEntry e = *this; e.shown = s; return e; }
    constexpr ModelEntry perMetre() const { ModelEntry e = *this; e.perDepth = true; return e; }
    constexpr ModelEntry like(double v) const { ModelEntry e = *this; e.typical = v; return e; }
    constexpr ModelEntry losslessAt(double v) const
    {
        ModelEntry e = *this;
        e.lossless = v;
        return e;
    }
    constexpr ModelEntry orCalibration() const
    {
        ModelEntry e = *this;
        e.calibrated = true;
        return e;
    }

    double value(const Owner& owner) const
    {
        if (yesNo) return owner.*yesNo;
        if (number) return owner.*number;
        const auto found = owner.more.find(name);
        return found == owner.more.end() ? otherwise : found->second;
    }
    void set(Owner& owner, double v) const
    {
        if (yesNo) owner.*yesNo = v != 0;
        else if (number) owner.*number = v;
        else owner.more[name] = v;
    }
    bool allows(double v) const
    {
        const bool above = range == Range::zeroOrPositive ? v >= 0 : v > 0;
        return above && v <= (range == Range::fraction ? 1 : highest) && std::isfinite(v);
    }
    std::string rangeText() const
    {
        if (range == Range::fraction) return "in (0, 1]";
        std::string s = range == Range::positive ? "positive" : "zero or positive";
        if (highest < 1e299)
        {
            s += " and at most " + std::to_string(highest);
            s.erase(s.find_last_not_of('0') + 1);
            if (s.back() == '.') s.pop_back();
        }
        return s;
    }
};

//- Where a model has no numbers
template<class Entry>
struct NoEntries
{
    constexpr const Entry* begin() const { return nullptr; }
    constexpr const Entry* end() const { return nullptr; }
};

template<class M> struct Model { using type = M; };

template<class... M>
struct Models
{
    static constexpr int size = sizeof...(M);

    //- f(Model<M>()) of each, in order
    template<class F> static void each(F f) { (f(Model<M>()), ...); }

    //- f(Model<M>()) of the one at `index`
    template<class F>
    static void at(int index, F f)
    {
        int k = 0;
        const bool found = ((k++ == index && (f(Model<M>()), true)) || ...);
        if (!found)
            throw std::logic_error(
                "no model " + std::to_string(index) + " in a table of " + std::to_string(size));
    }

    //- Index of the first model of this word for which good(Model<M>()); -1: there is none
    template<class Good>
    static int find(const std::string& word, Good good)
    {
        int k = 0, found = -1;
        each([&](auto model)
        {
            if (found < 0 && word == decltype(model)::type::word && good(model)) found = k;
            ++k;
        });
        return found;
    }
    static int find(const std::string& word) { return find(word, [](auto) { return true; }); }
};

//- Of cards: each word once
template<class Card>
std::vector<std::string> wordsOf(const std::vector<Card>& cards)
{
    std::vector<std::string> words;
    for (const Card& c : cards)
        if (std::find(words.begin(), words.end(), c.word) == words.end()) words.push_back(c.word);
    return words;
}

//- (a b c)
inline std::string listOf(const std::vector<std::string>& words)
{
    std::string s;
    for (const std::string& w : words) s += (s.empty() ? "(" : " ") + w;
    return s.empty() ? "()" : s + ")";
}

//- What each model of a table says, without its type: Card(Model<M>()) of each, in order
template<class Card, class Table>
const std::vector<Card>& cardsOf()
{
    static const std::vector<Card> all = []
    {
        std::vector<Card> cards;
        Table::each([&](auto model) { cards.push_back(Card(model)); });
        return cards;
    }();
    return all;
}

//- The word of each model of a table
template<class Table>
std::vector<std::string> wordsOf()
{
    std::vector<std::string> words;
    Table::each([&](auto model) { words.emplace_back(decltype(model)::type::word); });
    return words;
}

//- Place in a table of the model that a word of an entry chooses; std::invalid_argument with the
//  valid ones if there is none
template<class Table>
int choiceOf(const char* entry, const std::string& word)
{
    const int found = Table::find(word);
    if (found >= 0) return found;
    throw std::invalid_argument(std::string("unknown ") + entry + " " + word + "; valid are "
      + listOf(wordsOf<Table>()));
}

//- The card of the model that a word chooses
template<class Card, class Table>
const Card& cardOf(const char* entry, const std::string& word)
{ return cardsOf<Card, Table>()[std::size_t(choiceOf<Table>(entry, word))]; }

} // namespace riprap
