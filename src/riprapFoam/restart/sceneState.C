/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneState.H"
#include "allRanks.H"
#include "IStringStream.H"
#include "localIOdictionary.H"
#include "labelIOList.H"
#include "Hasher.H"
#include "OSspecific.H"
#include "DynamicList.H"
#include "timeWriter.H"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

std::size_t Foam::stateListSize = std::size_t(1) << 30;


namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of all words in order. States of any length once began with it, and are still read
static label serialHash(const std::vector<std::int32_t>& words)
{
    return label(Hasher(words.data(), words.size()*sizeof(words[0]), 0));
}


//- Of more than a block that of the blocks' hashes, which threads find at once
static label hashOf(const std::vector<std::int32_t>& words)
{
    const std::size_t block = 1 << 18;
    if (words.size() <= block) return serialHash(words);

    const std::size_t blocks = (words.size() + block - 1)/block;
    std::vector<std::int32_t> hashes(blocks);
    #pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < blocks; ++k)
    {
        const std::size_t from = k*block, n = std::min(block, words.size() - from);
        hashes[k] = std::int32_t(Hasher(&words[from], n*sizeof(words[0]), 0));
    }
    return serialHash(hashes);
}


static bool fits(const std::vector<std::int32_t>& words, label hash)
{
    return hash == hashOf(words) || hash == serialHash(words);
}


//- A file of words, of either class
class wordsReader
:
    public regIOobject
{
public:

    explicit wordsReader(const IOobject& io) : regIOobject(io) {}

    bool writeData(Ostream&) const override { return false; }

    //- The words, and in front of them number and hash. \return whether
    //  these are right
    bool read(std::vector<std::int32_t>& words);
};


bool wordsReader::read(std::vector<std::int32_t>& words)
{
    Istream& is = readStream(word::null);
    bool good = false;
    if (headerClassName() == labelIOList::typeName)
    {
        const labelList all(is);
        if (all.size() >= 2)
        {
            words.assign(all.begin() + 2, all.end());
            good = all[0] == label(words.size()) && fits(words, all[1]);
        }
    }
    else
    {
        const label lists = readLabel(is);
        is.readBegin("words");
        const labelList head(is);
        for (label k = 1; k < lists; ++k)
        {
            const labelList part(is);
            words.insert(words.end(), part.begin(), part.end());
        }
        is.readEnd("words");
        good =
            head.size() == 3
         && std::uint32_t(head[0]) == std::uint32_t(words.size())
         && std::uint32_t(head[1]) == std::uint32_t(uint64_t(words.size()) >> 32)
         && fits(words, head[2]);
    }
    close();
    return good;
}


//- Some words as a list, binary
static void writeList
(
    fileSink& sink,
    const std::vector<std::int32_t>& head,
    const std::int32_t* words,
    std::size_t n
)
{
    const auto bytes = [&](const std::int32_t* from, std::size_t size)
    {
        sink.write(reinterpret_cast<const char*>(from), size*sizeof(*from));
    };
    sink.write('\n' + std::to_string(head.size() + n) + "\n(");
    bytes(head.data(), head.size());
    bytes(words, n);
    sink.write(")");
}


static void writeLists(fileSink& sink, const std::vector<std::int32_t>& words)
{
    const std::size_t n = words.size();
    const std::int32_t hash = hashOf(words);
    if (n + 2 <= stateListSize)
    {
        writeList(sink, {std::int32_t(n), hash}, words.data(), n);
        return;
    }

    const std::size_t lists = (n + stateListSize - 1)/stateListSize;
    sink.write('\n' + std::to_string(lists + 1) + "\n(");
    writeList
    (
        sink, {std::int32_t(n), std::int32_t(uint64_t(n) >> 32), hash}, nullptr, 0
    );
    for (std::size_t from = 0; from < n; from += stateListSize)
    {
        writeList
        (
            sink, {}, words.data() + from, std::min(stateListSize, n - from)
        );
    }
    sink.write("\n)\n");
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


List<string> exactStrings(const UList<scalar>& values)
{
    // of 24 characters at most, and a blank: a string of a file may have 1024
    constexpr label inOne = 40;
    DynamicList<string> strings;
    for (label first = 0; first < values.size(); first += inOne)
    {
        const label n = min(inOne, values.size() - first);
        strings.append(exact(SubList<scalar>(values, n, first)));
    }
    return List<string>(std::move(strings));
}


//- The numbers in a string
static void appendNumbers
(
    const dictionary& dict,
    const word& entry,
    const string& from,
    DynamicList<scalar>& values
)
{
    std::istringstream text(from);
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
}


scalarList exactList(const dictionary& dict, const word& entry)
{
    DynamicList<scalar> values;
    const Foam::entry* given = dict.findEntry(entry);
    if (!given || !given->isStream()) return scalarList();

    const tokenList& tokens = given->stream();
    label brackets = 0;                 // of lists: more than one where each value has its own
    bool strings = tokens.empty();
    for (const token& t : tokens)
    {
        strings = strings || t.isString();
        brackets += t == token::BEGIN_LIST || t == token::BEGIN_BLOCK;
    }
    if (strings)
    {
        for (const token& t : tokens)
        {
            if (t.isString()) appendNumbers(dict, entry, t.stringToken(), values);
        }
    }
    else if (tokens.size() == 1 && tokens[0].isNumber())
    {
        values.append(dict.get<scalar>(entry));
    }
    else if (brackets > 1)
    {
        for (const vector& v : dict.get<List<vector>>(entry))
        {
            for (const scalar number : v) values.append(number);
        }
    }
    else
    {
        values.append(dict.get<scalarList>(entry));
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
            run.typeHeaderOk<localIOdictionary>(false)
         && state.typeHeaderOk<labelIOList>(false);
    });
    if (!headers)
    {
        damaged(state, "one of its two files is missing or empty");
    }
    return true;
}


dictionary stateDictionary(const IOobject& io)
{
    std::string text;
    if (Pstream::master())
    {
        const localIOdictionary dict(io);
        if (!Pstream::parRun()) return dictionary(dict);
        OStringStream os;
        os.precision(17);
        dict.dictionary::write(os, false);
        text = os.str();
    }
    IStringStream is(textOfMaster(text));
    dictionary dict(is);
    dict.name() = io.objectPath();
    return dict;
}


void writeState(const IOdictionary& dict)
{
    writtenFile file
    (
        dict,
        IOdictionary::typeName,
        IOstream::ASCII,
        IOstream::UNCOMPRESSED
    );
    file.addWritten([&](Ostream& os) { dict.writeData(os); });
    timeWriter::ofRun().put(std::move(file));
}


std::vector<std::int32_t> readStateWords
(
    const Time& time,
    const word& name
)
{
    const IOobject io(stateObject(time, name, IOobject::MUST_READ));
    std::vector<std::int32_t> words;
    bool good = false;
    orDamaged(io, [&]() { good = wordsReader(io).read(words); });

    if (!good)
    {
        damaged(io, "its check sum is wrong");
    }
    return words;
}


void writeStateWords
(
    const Time& time,
    const word& name,
    stateWords&& words
)
{
    const bool one = words.size + 2 <= stateListSize;
    writtenFile file
    (
        stateObject(time, name),
        one ? labelIOList::typeName : word("labelListList"),
        IOstream::BINARY,
        IOstream::UNCOMPRESSED
    );
    file.add
    (
        [words = std::move(words)](fileSink& sink, const listFormat&)
        {
            const std::vector<std::int32_t> all(words.take());
            if (all.size() != words.size)
            {
                throw std::runtime_error("The exact state is not as long as it was said to be");
            }
            writeLists(sink, all);
        }
    );
    timeWriter::ofRun().put(std::move(file));
}

} // End namespace Foam


// ************************************************************************* //
