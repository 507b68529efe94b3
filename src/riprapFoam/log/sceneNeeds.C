/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneNeeds.H"
#include "moduleLog.H"
#include <algorithm>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- constant/solidProperties, entry groups/tip
static std::string place(const dictionary& dict, const word& entry)
{
    const std::string& name = dict.name();
    std::size_t from = std::string::npos;
    for (const char* folder : {"/constant/", "/system/"})
    {
        const std::size_t at = name.rfind(folder);
        if (at != std::string::npos) from = at + 1;
    }
    const std::string file(from == std::string::npos ? name : name.substr(from));
    const std::size_t slash = file.find('/');
    const std::size_t end = file.find_first_of("./:", slash == std::string::npos ? 0 : slash + 1);
    std::string scope;
    if (end != std::string::npos)
    {
        scope = file.substr(end + 1) + '/';
        std::replace(scope.begin(), scope.end(), '.', '/');
    }
    return file.substr(0, end) + ", entry " + scope + entry;
}


static std::string percent(scalar part, scalar all)
{
    return threeDigits(100*part/all) + " %";
}


static std::string savings(const modelCost& c)
{
    std::string text;
    if (c.seconds > 0 && c.without > 0)
    {
        // Less than the clock's own noise is no saving
        const scalar saved = c.seconds - c.without;
        text += saved > 0.02*c.seconds
          ? percent(saved, c.seconds) + " of a step (" + threeDigits(1e6*saved)
          + " of " + threeDigits(1e6*c.seconds) + " us, measured)"
          : "less than 2 % of a step (measured)";
    }
    if (c.bytes > c.bytesWithout)
    {
        text += (text.empty() ? "" : " and ")
          + bytesText(c.bytes - c.bytesWithout) + " of "
          + bytesText(c.bytes);
    }
    return text.empty() ? "" : "; saves " + text;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sceneNeeds::idle
(
    const dictionary& dict,
    const word& entry,
    const std::string& why
)
{
    if (dict.found(entry, keyType::LITERAL))
    {
        idle_.push_back({place(dict, entry), why});
    }
}


void Foam::sceneNeeds::idle
(
    const dictionary& dict,
    const wordList& entries,
    const std::string& why
)
{
    for (const word& entry : entries)
    {
        idle(dict, entry, why);
    }
}


void Foam::sceneNeeds::on
(
    const dictionary& dict,
    const word& entry,
    const std::string& why,
    const word& instead,
    const modelCost& cost
)
{
    if (!cost.same) return;

    std::string text(why + "; `" + entry + ' ' + instead + "` does the same");
    if (cost.steps)
    {
        text += ", tried for " + std::to_string(cost.steps) + " steps";
    }
    on_.push_back({place(dict, entry), text + savings(cost)});
}


void Foam::sceneNeeds::costly
(
    const dictionary& dict,
    const word& entry,
    const std::string& what
)
{
    costly_.push_back({place(dict, entry), what});
}


void Foam::sceneNeeds::log(Ostream& os) const
{
    const auto put = [&](const char* title, std::vector<item> items)
    {
        if (items.empty()) return;
        std::stable_sort(items.begin(), items.end());
        os  << title << nl;
        for (const item& i : items)
        {
            os  << "    " << i.where.c_str() << ": " << i.why.c_str() << nl;
        }
    };
    put("No effect on this scene", idle_);
    put("On, and without effect on this scene", on_);
    put("On, with an effect below what this scene resolves", costly_);
    if (idle_.empty() && on_.empty() && costly_.empty())
    {
        os  << "Entries and models without effect on this scene: none found" << nl;
    }
    os  << endl;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::threeDigits(scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", double(value));
    return text;
}


const Foam::dictionary& Foam::subDictOf(const dictionary& dict, const char* name)
{
    const dictionary* sub = dict.findDict(name, keyType::LITERAL);
    return sub ? *sub : dictionary::null;
}


// ************************************************************************* //
