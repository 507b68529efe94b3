/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "didYouMean.H"
#include "listed.H"
#include "macroUse.H"
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A file without its comments; empty if it cannot be read
static std::string textOf(const fileName& file)
{
    std::ifstream in(file);
    const std::string all
    (
        (std::istreambuf_iterator<char>(in)),
        std::istreambuf_iterator<char>()
    );

    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const bool line = all.compare(i, 2, "//") == 0;
        if (line || all.compare(i, 2, "/*") == 0)
        {
            i = all.find(line ? "\n" : "*/", i + 2);
            if (i == std::string::npos) break;
            i += !line;
            text += ' ';
        }
        else
        {
            text += all[i];
        }
    }
    return text;
}


//- How a name occurs in a text: as $name, ${name}, $:name ..., and without $
struct wordUse
{
    bool macro = false;
    bool plain = false;
};


// Is it on a line like #include "name"?
static bool inDirective(const std::string& text, std::size_t at)
{
    const std::size_t line = text.rfind('\n', at) + 1;      // npos + 1: 0
    return text[text.find_first_not_of(" \t", line)] == '#';
}


//- What an entry that the text does not hold has come from; empty: it includes nothing
static std::string includedBy(const std::string& text)
{
    std::string files;
    const std::string directive("#include");
    for (std::size_t at = text.find(directive); at != std::string::npos;
         at = text.find(directive, at + 1))
    {
        const std::size_t begin = text.find('"', at), end = text.find('"', begin + 1);
        if (text.find('\n', at) < begin || end == std::string::npos) continue;
        files += (files.empty() ? "" : " ") + text.substr(begin + 1, end - begin - 1);
    }
    return files.empty() ? "" : "; it stands in a file that is included (" + files + ")";
}


static wordUse useOf(const std::string& name, const std::string& text)
{
    const auto inName = [](char c) { return std::isalnum(c) || c == '_'; };

    wordUse use;
    std::size_t at = 0;
    while ((at = text.find(name, at)) != std::string::npos)
    {
        std::size_t before = at;
        at += name.size();
        if
        (
            (before > 0 && inName(text[before - 1]))
         || (at < text.size() && inName(text[at]))
         || inDirective(text, before)
        )
        {
            continue;
        }

        while (before > 0 && std::strchr("{:.", text[before - 1])) --before;
        const bool macro = before > 0 && text[before - 1] == '$';
        (macro ? use.macro : use.plain) = true;
    }
    return use;
}

//- A slip of the pen, not a name of the user's own
static bool isLike(const word& name, const UList<word>& valid)
{
    for (const word& other : valid)
    {
        if (slips(name, other, false) <= 2) return true;
    }
    return false;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::checkedDictionary::isWord
(
    const word& entry,
    const word& allowed
) const
{
    ITstream& is = dict_.lookup(entry);
    const token first(is);
    if (first.isWord() && first.wordToken() != allowed)
    {
        unknownWord(entry, first.wordToken(), {allowed, "<number>"});
    }
    if (first.isWord())
    {
        // The next entry, where the semicolon is missing
        dict_.checkITstream(is, entry);
    }
    return first.isWord();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::checkedDictionary::found(const word& entry)
{
    if (!known_.found(entry))
    {
        known_.append(entry);
    }
    if (dict_.isDict(entry))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " must be a value, not a dictionary"
            << exit(FatalIOError);
    }
    return dict_.found(entry, keyType::LITERAL);
}


bool Foam::checkedDictionary::either
(
    const word& entry,
    const word& yes,
    const word& no,
    bool otherwise
)
{
    if (!found(entry))
    {
        return otherwise;
    }
    const word typed(dict_.get<word>(entry));
    if (typed != yes && typed != no)
    {
        unknownWord(entry, typed, {yes, no});
    }
    return typed == yes;
}


const Foam::dictionary& Foam::checkedDictionary::subDict(const word& entry)
{
    if (!known_.found(entry))
    {
        known_.append(entry);
    }
    if (!dict_.found(entry, keyType::LITERAL))
    {
        return dictionary::null;
    }
    if (!dict_.isDict(entry))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " must be a dictionary: " << entry
            << " { ... }" << exit(FatalIOError);
    }
    return dict_.subDict(entry);
}


void Foam::checkedDictionary::unknownWord
(
    const word& entry,
    const word& typed,
    const wordList& valid
) const
{
    FatalIOErrorInFunction(dict_)
        << "Entry " << entry << " has the unknown word " << typed
        << "; valid are " << listedFor(typed, valid).c_str() << exit(FatalIOError);
}


void Foam::checkedDictionary::unknownEntry
(
    const word& entry,
    const char* remark
) const
{
    FatalIOErrorInFunction(dict_)
        << "Unknown entry " << entry
        << "; valid are " << listed(known_).c_str() << remark
        << didYouMean(entry, known_).c_str() << exit(FatalIOError);
}


void Foam::checkedDictionary::end() const
{
    for (const entry& e : dict_)
    {
        if (!known_.found(e.keyword())) unknownEntry(e.keyword(), "");
    }
}


void Foam::checkedDictionary::endButMacros(const wordList& elsewhere) const
{
    const std::string text(textOf(dict_.name()));
    DynamicList<word> unused;

    for (const entry& e : dict_)
    {
        const word& name = e.keyword();
        if (known_.found(name)) continue;

        // What the file itself does not hold has come by #include
        const wordUse use(useOf(name, text));
        const bool single = e.isStream() && e.stream().size() == 1;
        const bool number = single && e.stream()[0].isNumber();

        if ((single && use.macro) || (number && !use.plain)) continue;

        if (!number || elsewhere.found(name) || isLike(name, known_))
        {
            const std::string where(use.plain ? "" : includedBy(text));
            unknownEntry(
                name, (", and numbers and words that the file uses as $name" + where).c_str());
        }
        unused.append(name);
    }

    if (unused.size())
    {
        IOWarningInFunction(dict_)
            << "Numbers that nothing uses: " << listed(unused).c_str()
            << " (foamDictionary replaces $name by its value); entries of"
            << " this dictionary are " << listed(known_).c_str() << nl << endl;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::heldForNothing(const fileName& file, const word& entry)
{
    const wordUse use(useOf(entry, textOf(file)));
    return use.plain && !use.macro;
}


// ************************************************************************* //
