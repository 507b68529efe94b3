/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneState.H"
#include "labelIOList.H"
#include "Hasher.H"
#include "OSspecific.H"
#include "DynamicList.H"
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static label hashOf(const std::vector<std::int32_t>& words)
{
    return label(Hasher(words.data(), words.size()*sizeof(words[0]), 0));
}


static void damaged(const IOobject& file, const string& why)
{
    FatalIOErrorInFunction(file.objectPath())
        << "The exact state of the particles is damaged (" << why.c_str()
        << "): remove the folder "
        << file.path() << " to continue from the fields of the cloud"
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

IOobject stateObject
(
    const Time& time,
    const word& name,
    IOobject::readOption read
)
{
    return IOobject
    (
        name,
        time.timeName(),
        "uniform/riprap",
        time,
        read,
        IOobject::NO_WRITE,
        false
    );
}


word exact(scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.17g", double(value));
    return word(text, false);
}


string exact(const UList<scalar>& values)
{
    string text;
    for (const scalar value : values)
    {
        text += (text.empty() ? "" : " ") + exact(value);
    }
    return text;
}


scalarList exactList(const dictionary& dict, const word& entry)
{
    std::istringstream text(dict.getOrDefault<string>(entry, string::null));
    DynamicList<scalar> values;
    std::string one;
    while (text >> one)
    {
        char* end = nullptr;
        values.append(std::strtod(one.c_str(), &end));
        if (*end)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " holds " << one << ", no number"
                << exit(FatalIOError);
        }
    }
    return scalarList(std::move(values));
}


int64_t count(const dictionary& dict, const word& entry)
{
    return int64_t(dict.get<scalar>(entry));
}


void orDamaged(const IOobject& file, const std::function<void()>& read)
{
    string why;
    const bool before = FatalIOError.throwExceptions();
    try
    {
        read();
    }
    catch (const IOerror& e)
    {
        why = e.message();
    }
    FatalIOError.throwExceptions(before);

    if (!why.empty())
    {
        damaged(file, why);
    }
}


bool hasState
(
    const Time& time,
    const word& runFile,
    const word& wordsFile
)
{
    IOobject run(stateObject(time, runFile));
    IOobject state(stateObject(time, wordsFile));

    if (!isFile(run.objectPath()) && !isFile(state.objectPath()))
    {
        return false;
    }

    bool headers = false;
    orDamaged(state, [&]()
    {
        headers =
            run.typeHeaderOk<IOdictionary>(false)
         && state.typeHeaderOk<labelIOList>(false);
    });
    if (!headers)
    {
        damaged(state, "one of its two files is missing or empty");
    }
    return true;
}


void writeState(const IOdictionary& dict)
{
    dict.regIOobject::writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}


std::vector<std::int32_t> readStateWords
(
    const Time& time,
    const word& name
)
{
    const IOobject io(stateObject(time, name, IOobject::MUST_READ));
    labelList all;
    orDamaged(io, [&]() { all = labelIOList(io); });

    std::vector<std::int32_t> words;
    if (all.size() >= 2)
    {
        words.assign(all.begin() + 2, all.end());
    }

    if
    (
        all.size() < 2
     || all[0] != label(words.size())
     || all[1] != hashOf(words)
    )
    {
        damaged(io, "its check sum is wrong");
    }
    return words;
}


void writeStateWords
(
    const Time& time,
    const word& name,
    const std::vector<std::int32_t>& words
)
{
    labelIOList file(stateObject(time, name), label(words.size()) + 2);
    file[0] = words.size();
    file[1] = hashOf(words);
    std::copy(words.begin(), words.end(), file.begin() + 2);

    file.regIOobject::writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}

} // End namespace Foam


// ************************************************************************* //
