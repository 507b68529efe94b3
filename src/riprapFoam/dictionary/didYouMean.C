/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "didYouMean.H"
#include <algorithm>
#include <cctype>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string lower(std::string text)
{
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}


//- Of words of so many letters: more, and another word is meant
static label allowed(std::size_t letters)
{
    return letters < 3 ? 0 : letters < 5 ? 1 : 2;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::slips(const std::string& a, const std::string& b, bool exchanges)
{
    std::vector<label> before, last(b.size() + 1), now(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        now[0] = label(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            now[j] = std::min(
                std::min(last[j], now[j - 1]) + 1, last[j - 1] + (a[i - 1] != b[j - 1]));
            const bool exchanged = exchanges && i > 1 && j > 1 && a[i - 1] == b[j - 2]
                && a[i - 2] == b[j - 1];
            if (exchanged) now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = last;
        last = now;
    }
    return last[b.size()];
}


std::string Foam::didYouMean(const std::string& typed, const std::vector<std::string>& valid)
{
    std::string nearest;
    label least = labelMax;
    bool alone = false;
    for (const std::string& right : valid)
    {
        // As <number>
        if (right.empty() || right[0] == '<') continue;
        const label off = slips(lower(typed), lower(right));
        if (off > allowed(std::min(typed.size(), right.size())) || off > least || right == nearest)
            continue;
        alone = off < least;
        least = off;
        nearest = right;
    }
    return alone ? "; did you mean " + nearest + "?" : "";
}


// ************************************************************************* //
