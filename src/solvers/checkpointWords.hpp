/*  Bytes of a saved state as words, and their checksum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>
#include <vector>
#include "api/later.hpp"
#include "core/backend/machineMemory.hpp"
#include "core/backend/snapshot.hpp"

namespace riprap
{
namespace detail
{

//- FNV-1a over n words
inline std::uint32_t fnv(const std::uint32_t* words, std::size_t n)
{
    std::uint32_t h = 2166136261u;
    for (std::size_t i = 0; i < n; ++i) h = (h ^ words[i])*16777619u;
    return h;
}

//- Words that are summed by one thread
static constexpr std::size_t checksumBlock = 65536;

//- FNV-1a of eight lanes, each of every eighth word: a register's, where one sum would wait for
//  each product in turn
inline std::uint32_t laneChecksum(const std::int32_t* words, std::size_t n)
{
    constexpr int lanes = 8;
    std::uint32_t h[lanes];
    for (std::uint32_t& lane : h) lane = 2166136261u;
    std::size_t i = 0;
    for (; i + lanes <= n; i += lanes)
        for (int l = 0; l < lanes; ++l) h[l] = (h[l] ^ std::uint32_t(words[i + l]))*16777619u;
    for (; i < n; ++i) h[i%lanes] = (h[i%lanes] ^ std::uint32_t(words[i]))*16777619u;
    return fnv(h, lanes);
}

//- FNV-1a over all n words in order. States of any length once ended with it, and are still read
inline std::int32_t serialChecksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    return std::int32_t(fnv(reinterpret_cast<const std::uint32_t*>(words.data()), n));
}

//- Of the first n words: FNV-1a; of more than a block FNV-1a over the lanes' sums of blocks, which
//  threads find at once. Does not depend on their number
inline std::int32_t checksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    if (n <= checksumBlock) return serialChecksum(words, n);
    const std::ptrdiff_t blocks = (n + checksumBlock - 1)/checksumBlock;
    std::vector<std::uint32_t> sums(blocks);
    #pragma omp parallel for schedule(static)
    for (std::ptrdiff_t b = 0; b < blocks; ++b)
    {
        const std::size_t from = b*checksumBlock;
        sums[b] = laneChecksum(&words[from], std::min(checksumBlock, n - from));
    }
    return std::int32_t(fnv(sums.data(), sums.size()));
}

//- Is the last word the checksum of those before it?
inline bool checksumFits(const std::vector<std::int32_t>& words)
{
    const std::size_t n = words.size() - 1;
    return checksum(words, n) == words.back() || serialChecksum(words, n) == words.back();
}

//- Room for n words in all
inline void reserveWords(std::vector<std::int32_t>& words, std::size_t n)
{
    words.reserve(n);
    if (n > words.size()) touchMemory(words.data() + words.size(), 4*(n - words.size()));
}

inline void appendBytes(std::vector<std::int32_t>& words, const void* data, std::size_t bytes)
{
    const std::size_t at = words.size();
    words.resize(at + (bytes + 3)/4, 0);
    if (bytes) std::memcpy(&words[at], data, bytes);
}

//- The words of a state as they are put together, of the host's memory and the device's. Wanted
//  later, they are kept in pieces until then
template<class Backend>
class StateWords
{
public:

    using Words = std::vector<std::int32_t>;

    StateWords(Context<Backend>& context, bool later, Words&& first)
        : now_(context, later), words_(std::move(first))
    {}

    bool later() const { return now_.keeps(); }
    Snapshot<Backend>& now() { return now_; }

    //- Room for so many in all
    void expect(std::size_t words) { if (!later()) reserveWords(words_, words); }

    //- How many there are
    std::size_t size() const { return before_ + words_.size(); }

    void add(std::int32_t word) { words_.push_back(word); }
    void add(const void* host, std::size_t bytes) { appendBytes(words_, host, bytes); }
    void addZeros(std::size_t words) { words_.resize(words_.size() + words, 0); }

    void addOfDevice(const void* data, std::size_t bytes)
    {
        const std::size_t words = (bytes + 3)/4;
        const ReadBytes read = now_.bytes(data, bytes);
        if (later())
        {
            endPiece();
            pieces_.push_back(Piece{{}, read, words, nullptr});
            before_ += words;
            return;
        }
        const std::size_t at = words_.size();
        words_.resize(at + words, 0);
        if (bytes) read(&words_[at]);
    }

    //- Of the host, written by who asks, at once
    std::int32_t* room(std::size_t words)
    {
        const std::size_t at = words_.size();
        words_.resize(at + words, 0);
        return words_.data() + at;
    }

    //- A state within the state, after its length
    void addState(Later<Words> state)
    {
        add(std::int32_t(std::uint32_t(state.size)));
        addMade(std::move(state));
    }

    //- Words that are made when they are wanted
    void addMade(Later<Words> made)
    {
        if (!later())
        {
            const Words words = made.take();
            words_.insert(words_.end(), words.begin(), words.end());
            return;
        }
        endPiece();
        before_ += made.size;
        pieces_.push_back(Piece{{}, nullptr, 0, std::move(made.take)});
    }

    //- What changes them once they are all there
    void after(std::function<void(Words&)> f) { after_.push_back(std::move(f)); }

    //- With their checksum
    Later<Words> done()
    {
        if (!later())
        {
            finish(words_, after_);
            return knownWords(std::move(words_));
        }
        endPiece();
        const auto kept = std::make_shared<Kept>(Kept{std::move(pieces_), std::move(after_)});
        return {before_ + 1, [kept, all = before_]
        {
            Words words;
            reserveWords(words, all + 1);
            for (Piece& piece : kept->pieces)
            {
                piece.appendTo(words);
                piece = Piece();            // its memory is not needed any more
            }
            finish(words, std::exchange(kept->after, {}));
            return words;
        }};
    }

private:

    using Changes = std::vector<std::function<void(Words&)>>;

    struct Piece
    {
        Words host;
        ReadBytes read;
        std::size_t words = 0;
        std::function<Words()> make;

        void appendTo(Words& all)
        {
            if (!read)
            {
                const Words there = make ? make() : std::move(host);
                all.insert(all.end(), there.begin(), there.end());
                return;
            }
            const std::size_t at = all.size();
            all.resize(at + words, 0);
            if (words) read(&all[at]);
        }
    };

    //- What waits until the words are wanted
    struct Kept
    {
        std::vector<Piece> pieces;
        Changes after;
    };

    static void finish(Words& words, const Changes& after)
    {
        for (const auto& f : after) f(words);
        words.push_back(checksum(words, words.size()));
    }

    void endPiece()
    {
        if (words_.empty()) return;
        before_ += words_.size();
        pieces_.push_back(Piece{std::move(words_), nullptr, 0, nullptr});
        words_ = Words();
    }

    Snapshot<Backend> now_;
    Words words_;
    std::vector<Piece> pieces_;
    Changes after_;
    std::size_t before_ = 0;
};

} // namespace detail
} // namespace riprap
