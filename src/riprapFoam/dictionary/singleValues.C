/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "singleValues.H"
#include "ITstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool opens(const token& t)
{
    return t == token::BEGIN_LIST || t == token::BEGIN_SQR || t == token::BEGIN_BLOCK;
}


//- Behind the bracket that closes the one at this place
static label behindBrackets(const UList<token>& tokens, label at)
{
    label depth = 0;
    do
    {
        const token& t = tokens[at++];
        depth += opens(t);
        depth -= t == token::END_LIST || t == token::END_SQR || t == token::END_BLOCK;
    }
    while (depth > 0 && at < tokens.size());
    return at;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::isSingleValue(const UList<token>& tokens)
{
    const label n = tokens.size();
    label at = 0;
    if (at < n && tokens[at].isWord()) ++at;
    if (at < n && tokens[at] == token::BEGIN_SQR) at = behindBrackets(tokens, at);
    if (at == n) return true;

    // A list may tell its length before its bracket
    const bool length = tokens[at].isLabel() && at + 1 < n && tokens[at + 1] == token::BEGIN_LIST;
    if (length) ++at;
    return (opens(tokens[at]) ? behindBrackets(tokens, at) : at + 1) == n;
}


void Foam::requireSingleValues(const dictionary& dict, const std::string& of)
{
    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            requireSingleValues(e.dict(), of);
        }
        else if (!isSingleValue(e.stream()))
        {
            FatalIOErrorInFunction(dict)
                << of.c_str() << ": entry " << e.keyword()
                << " holds more than its value" << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
