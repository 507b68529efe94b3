/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fileSink.H"
#include "Hasher.H"
#include "OSspecific.H"
#include <future>
#include <stdexcept>

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::fileSink::put(const char* data, std::size_t n)
{
    sum_.sum = Hasher(data, n, sum_.sum);
    sum_.bytes += n;
    if (!file_) return;

    file_->stdStream().write(data, n);
    requireGood();
}


//- Whole blocks: another thread adds them up meanwhile, where there is one
void Foam::fileSink::putBlocks(const char* data, std::size_t blocks)
{
    const auto at = [data](std::size_t k) { return data + k*fileSum::block; };
    if (threads_ == 1 || !file_ || blocks < 4)
    {
        for (std::size_t k = 0; k < blocks; ++k) put(at(k), fileSum::block);
        return;
    }
    std::future<unsigned> sum = std::async
    (
        std::launch::async,
        [at, blocks, before = sum_.sum]()
        {
            unsigned all = before;
            for (std::size_t k = 0; k < blocks; ++k)
            {
                all = Hasher(at(k), fileSum::block, all);
            }
            return all;
        }
    );
    for (std::size_t k = 0; k < blocks; ++k)
    {
        file_->stdStream().write(at(k), fileSum::block);
        requireGood();
    }
    sum_.sum = sum.get();
    sum_.bytes += blocks*fileSum::block;
}


void Foam::fileSink::requireGood() const
{
    if (file_->stdStream().good()) return;

    // A disk that is full takes what it can: see what is there
    throw std::runtime_error
    (
        "File " + path_ + " cannot be written: is the disk full? This time is"
        " not whole, earlier ones are"
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fileSink::fileSink
(
    const fileName& path,
    IOstream::compressionType compression,
    int threads
)
:
    path_(path),
    compression_(compression),
    threads_(max(threads, 1)),
    file_(new bytesFile(path, compression))
{
    requireGood();
    block_.reserve(fileSum::block);
    sum_.bytes = 0;
    sum_.foam = true;
}


Foam::fileSink::fileSink(int threads)
:
    compression_(IOstream::UNCOMPRESSED),
    threads_(max(threads, 1))
{
    block_.reserve(fileSum::block);
    sum_.bytes = 0;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fileSink::write(const char* data, std::size_t n)
{
    while (n)
    {
        if (block_.empty() && n >= fileSum::block)
        {
            const std::size_t blocks = n/fileSum::block;
            putBlocks(data, blocks);
            data += blocks*fileSum::block;
            n -= blocks*fileSum::block;
            continue;
        }
        const std::size_t part = std::min(n, fileSum::block - block_.size());
        block_.append(data, part);
        data += part;
        n -= part;
        if (block_.size() == fileSum::block)
        {
            put(block_.data(), block_.size());
            block_.clear();
        }
    }
}


void Foam::fileSink::writeChunks
(
    label n,
    const std::function<void(label, std::vector<char>&)>& f
)
{
    std::vector<std::vector<char>> texts(min(label(threads_), n));
    for (label first = 0; first < n; first += label(texts.size()))
    {
        const label together = min(label(texts.size()), n - first);
        std::vector<std::future<void>> others;
        for (label k = 1; k < together; ++k)
        {
            others.push_back
            (
                std::async
                (
                    std::launch::async,
                    [&f, &texts, first, k]() { f(first + k, texts[k]); }
                )
            );
        }
        f(first, texts[0]);
        for (std::future<void>& other : others)
        {
            other.get();
        }
        for (label k = 0; k < together; ++k)
        {
            write(texts[k].data(), texts[k].size());
        }
    }
}


Foam::fileSum Foam::fileSink::close()
{
    if (block_.size())
    {
        put(block_.data(), block_.size());
        block_.clear();
    }
    if (!file_) return sum_;

    file_->stdStream().flush();
    requireGood();
    if (compression_ == IOstream::COMPRESSED)
    {
        return fileSum();
    }
    const int64_t there = fileSize(path_);
    if (there != sum_.bytes)
    {
        throw std::runtime_error
        (
            "File " + path_ + " was not written to its end, but for "
          + std::to_string(there) + " bytes: is the disk full? This time is"
            " not whole, earlier ones are"
        );
    }
    return sum_;
}


// ************************************************************************* //
