/*  The cards of all transfer schemes, and the choice among them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/grid/particles.hpp"
#include "solvers/pic/transfer/picFamilies.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace riprap
{

bool TransferCard::has(const std::string& entry) const
{
    return std::any_of(
        entries.begin(), entries.end(), [&](const TransferEntry& e) { return entry == e.name; });
}

std::vector<TransferCard> transfers()
{
    std::vector<TransferCard> all;
    Transfers::each([&](auto scheme)
    {
        using S = typename decltype(scheme)::type;
        constexpr int memory = S::template Formula<double>::memory;
        static_assert(memory <= mostMemory, "particles remember no more (pic/grid/particles.hpp)");
        TransferCard card{S::word, S::text, {std::begin(S::entries), std::end(S::entries)},
            S::gradient, S::keepsLinear, memory, {}, S::timeStep};
        Splines::each([&](auto spline)
        {
            constexpr int order = decltype(spline)::type::order;
            if (S::template goesWith<order>) card.orders.push_back(order);
        });
        all.push_back(card);
    });
    return all;
}

std::vector<SplineCard> splines()
{
    std::vector<SplineCard> all;
    Splines::each(
        [&](auto spline) {
            all.push_back(SplineCard{decltype(spline)::type::word, decltype(spline)::type::order});
        });
    return all;
}

int transferChoice(const PicConfig& c)
{
    const int choice = Transfers::find(c.transfer);
    if (choice < 0)
        throw std::invalid_argument(
            "unknown transfer " + c.transfer + "; valid are " + listOf(wordsOf(transfers())));
    const std::vector<int> orders = transfers()[choice].orders;
    if (std::find(orders.begin(), orders.end(), c.splineOrder) != orders.end()) return choice;
    std::vector<std::string> valid;
    std::string typed = "of order " + std::to_string(c.splineOrder);
    for (const SplineCard& s : splines())
    {
        if (std::find(orders.begin(), orders.end(), s.order) != orders.end())
            valid.emplace_back(s.word);
        if (s.order == c.splineOrder) typed = s.word;
    }
    throw std::invalid_argument("transfer " + c.transfer + " does not go with splines " + typed
        + "; valid are " + listOf(valid));
}

TransferCard transferOf(const PicConfig& c)
{
    TransferCard card = transfers()[transferChoice(c)];
    for (const TransferEntry& e : card.entries)
        if (!e.yesNo && !e.allows(e.value(c.transferNumbers)))
            throw std::invalid_argument(
                std::string(e.name) + ", " + e.what + ", must be " + e.rangeText());
    const double longest = card.timeStep(c.transferNumbers);
    if (!c.adjustTimeStep && c.fixedTimeStep > longest)
        throw std::invalid_argument(
            "transfer " + c.transfer + " bears steps of " + std::to_string(longest) + " s at most");
    return card;
}

bool keepsGradient(const TransferCard& card, const TransferProperties& numbers)
{ return card.gradient || (card.has("affine") && numbers.affine); }

std::vector<TransferEntry> allTransferEntries()
{
    std::vector<TransferEntry> all;
    for (const TransferCard& card : transfers())
        for (const TransferEntry& e : card.entries)
            if (std::none_of(all.begin(), all.end(),
                    [&](const TransferEntry& other)
                    { return std::string_view(other.name) == e.name; }))
                all.push_back(e);
    return all;
}

} // namespace riprap
