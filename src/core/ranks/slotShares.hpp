/*  Slots whose values ranks send each other time and again: own ones that are copies elsewhere, and
    copies of others'. Sender and receiver have them in the same order, so no index travels.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <utility>
#include "core/ranks/transport.hpp"

namespace riprap
{

class SlotShares
{
public:

    using Lists = std::vector<std::pair<int, std::vector<int>>>;    // of a rank

    void clear()
    {
        to_.clear();
        from_.clear();
    }

    //- By rank, which ascends; none: nothing is sent
    void send(int rank, std::vector<int> slots)
    {
        if (!slots.empty()) to_.emplace_back(rank, std::move(slots));
    }
    void receive(int rank, std::vector<int> slots)
    {
        if (!slots.empty()) from_.emplace_back(rank, std::move(slots));
    }

    const Lists& sent() const { return to_; }
    const Lists& received() const { return from_; }

    //- put(slot, to) writes `each` bytes of an own slot; take(slot, from) reads those of a copy.
    //  \return bytes sent
    template<class Put, class Take>
    std::int64_t share(Transport& transport, std::size_t each, const Put& put, const Take& take)
    {
        std::int64_t sent = 0;
        setRoom(to_, each, bytesOut_, out_);
        setRoom(from_, each, bytesIn_, in_);
        for (std::size_t k = 0; k < to_.size(); ++k)
        {
            unsigned char* at = out_[k].bytes;
            for (const int slot : to_[k].second) { put(slot, at); at += each; }
            sent += std::int64_t(out_[k].size);
        }
        transport.swap(out_, in_);
        for (std::size_t k = 0; k < from_.size(); ++k)
        {
            const unsigned char* at = in_[k].bytes;
            for (const int slot : from_[k].second) { take(slot, at); at += each; }
        }
        return sent;
    }

private:

    static void setRoom(const Lists& lists, std::size_t each, std::vector<RankBytes>& bytes,
        std::vector<RankMessage>& messages)
    {
        bytes.resize(lists.size());
        messages.resize(lists.size());
        for (std::size_t k = 0; k < lists.size(); ++k)
        {
            bytes[k].resize(lists[k].second.size()*each);
            messages[k] = RankMessage{lists[k].first, bytes[k].data(), bytes[k].size()};
        }
    }

    Lists to_, from_;
    std::vector<RankBytes> bytesOut_, bytesIn_;
    std::vector<RankMessage> out_, in_;
};

} // namespace riprap
