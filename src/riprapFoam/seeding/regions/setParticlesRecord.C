/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "setParticlesRecord.H"
#include "particleRegions.H"
#include "IOdictionary.H"
#include "localIOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "sceneState.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const word recordName("setParticlesDict");

//- Where the dictionary was read from, among the entries of the record
static const word fileEntry("file");


static IOobject recordObject(const Time& time)
{
    return stateObject(time, recordName, IOobject::MUST_READ);
}


static string textOf(const entry& e)
{
    if (e.isDict()) return "{ .. }";

    OStringStream text;
    text.precision(10);
    const ITstream& tokens = e.stream();
    forAll(tokens, i)
    {
        if (i) text << ' ';
        text << tokens[i];
    }
    return text.str();
}


static bool same(const token& a, const token& b)
{
    if (a.isNumber() && b.isNumber())
    {
        const scalar x = a.number(), y = b.number();
        return mag(x - y) <= 5.001e-6*max(mag(x), mag(y));
    }
    return a == b;
}


static bool same(const entry& a, const entry& b)
{
    if (!a.isStream() || !b.isStream()) return false;

    const ITstream& then = a.stream();
    const ITstream& now = b.stream();
    if (then.size() != now.size()) return false;
    forAll(then, i)
    {
        if (!same(then[i], now[i])) return false;
    }
    return true;
}


static void compare
(
    const dictionary& then,
    const dictionary& now,
    const string& path,
    DynamicList<word>& found
)
{
    const auto add = [&](const word& key, const string& text)
    {
        found.append(word(path + key + ": " + text, false));
    };
    for (const entry& e : then)
    {
        const word& key = e.keyword();
        const entry* other = now.findEntry(key, keyType::LITERAL);
        if (!other)
        {
            add(key, "not there, was " + textOf(e));
        }
        else if (e.isDict() && other->isDict())
        {
            compare(e.dict(), other->dict(), path + key + '/', found);
        }
        else if (!same(e, *other))
        {
            add(key, textOf(*other) + ", was " + textOf(e));
        }
    }
    for (const entry& e : now)
    {
        if (!then.found(e.keyword(), keyType::LITERAL))
        {
            add(e.keyword(), textOf(e) + ", was not there");
        }
    }
}


//- What setParticles reads: lists of dictionaries as dictionaries of them, and
//  no numbers of the user's own, which count where they are used
static dictionary readBySetParticles(const dictionary& dict)
{
    dictionary read;
    for (const char* value : {"spacing", "packing", "overlapTolerance"})
    {
        const entry* e = dict.findEntry(value, keyType::LITERAL);
        if (e) read.add(*e);
    }
    for (const char* list : {"regions", "bonds"})
    {
        if (!dict.found(list, keyType::LITERAL)) continue;
        dictionary all;
        for (const namedDictionary& one : namedDictionaries(dict, list))
        {
            all.add(keyType(one.name), one.dict);
        }
        read.add(list, all);
    }
    return read;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::differences(const dictionary& then, const dictionary& now)
{
    DynamicList<word> found;
    compare(then, now, string::null, found);
    return wordList(std::move(found));
}


void Foam::recordSetParticles(const Time& time, const dictionary& dict)
{
    if (!Pstream::master()) return;
    const IOobject io(recordObject(time));
    mkDir(io.path());
    OFstream os(io.objectPath());
    os.precision(17);
    localIOdictionary
    (
        IOobject
        (
            recordName, io.instance(), io.local(), time,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        )
    ).writeHeader(os);

    const fileName& file = dict.name();
    os.writeEntry(fileEntry, fileName(file.relative(time.globalPath())));
    readBySetParticles(dict).write(os, false);
    IOobject::writeEndDivider(os);
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << io.objectPath() << exit(FatalError);
    }
}


void Foam::requireSetParticles(const Time& time)
{
    const IOobject io(recordObject(time));
    if (!Pstream::master() || !isFile(io.objectPath())) return;

    localIOdictionary then(io);
    const fileName given(then.get<fileName>(fileEntry));
    then.remove(fileEntry);
    const fileName file(given.isAbsolute() ? given : time.globalPath()/given);
    if (!isFile(file)) return;

    const localIOdictionary all
    (
        IOobject(file, time, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    const wordList found(differences(then, readBySetParticles(all)));
    if (found.empty()) return;

    OStringStream text;
    const label shown = min(found.size(), label(5));
    for (label i = 0; i < shown; ++i)
    {
        text << nl << "    " << found[i].c_str();
    }
    if (found.size() > shown)
    {
        text << nl << "    and " << found.size() - shown << " more";
    }
    FatalIOErrorInFunction(all)
        << "The particles of time " << time.timeName() << " were made from"
        << " other entries, which " << io.objectPath() << " holds:"
        << text.str().c_str() << nl << "Run setParticles, or remove that file"
        << " to take the particles as they are" << exit(FatalIOError);
}


// ************************************************************************* //
