/*  SlotShares of fields that are on a device: what is sent is put together there by a list of
    slots, and crosses to the host in one copy; what comes goes the same way back. Where GPUs reach
    each other (devicePeers.hpp) it does not pass through the host, which waits for nothing.

    put(slot, to) and take(slot, from) are functors for the device; bytes are aligned to the words
    that they are made of.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/hostMemory.hpp"
#include "core/backend/launch.hpp"
#include "core/ranks/devicePeers.hpp"
#include "core/ranks/slotShares.hpp"

namespace riprap
{

//- A word of a record that is shared, and on to the next
template<class T>
HD void putWord(unsigned char*& to, const T& value)
{
#ifdef __CUDA_ARCH__
    *reinterpret_cast<T*>(to) = value;
#else
    std::memcpy(to, &value, sizeof(T));
#endif
    to += sizeof(T);
}

template<class T>
HD void takeWord(const unsigned char*& from, T& value)
{
#ifdef __CUDA_ARCH__
    value = *reinterpret_cast<const T*>(from);
#else
    std::memcpy(&value, from, sizeof(T));
#endif
    from += sizeof(T);
}

template<class Put>
struct PutSlots
{
    static constexpr const char* name = "putShared";
    Put put;
    const int* slots;
    unsigned char* bytes;
    int each;

    HD void operator()(int k) const { put(slots[k], bytes + std::size_t(k)*each); }
};

template<class Take>
struct TakeSlots
{
    static constexpr const char* name = "takeShared";
    Take take;
    const int* slots;
    const unsigned char* bytes;
    int each;

    HD void operator()(int k) const { take(slots[k], bytes + std::size_t(k)*each); }
};

template<class Backend>
class DeviceShares
{
public:

    //- Slots that are shared from now on, with records of up to `most` bytes. All ranks call
    void set(Context<Backend>& context, [[maybe_unused]] Transport& transport,
        DevicePeers<Backend>& peers, const SlotShares& shares, [[maybe_unused]] std::size_t most)
    {
        set(context, shares.sent(), sent_);
        set(context, shares.received(), received_);
        direct_ = peers.there();
        if constexpr (Backend::gpu) if (direct_)
        {
            std::vector<typename PeerChannel<Backend>::Partner> partners(transport.size());
            for (int r = 0; r < transport.size(); ++r) partners[r].rank = r;
            for (const auto& p : sent_.partners) partners[p.first].out = p.second;
            for (const auto& p : received_.partners) partners[p.first].in = p.second;
            partners.erase(std::remove_if(partners.begin(), partners.end(),
                [](const auto& p) { return p.out + p.in == 0; }), partners.end());
            channel_.set(context, peers, transport, partners, most);
        }
    }

    //- \return bytes sent
    template<class Put, class Take>
    std::int64_t share(Context<Backend>& context, Transport& transport, std::size_t each,
        const Put& put, const Take& take)
    {
        const int out = sent_.count(), in = received_.count();
        const std::size_t bytes = out*each;
        if constexpr (Backend::gpu) if (direct_)
        {
            channel_.share(context, each,
                PutSlots<Put>{put, sent_.slots.data(), nullptr, int(each)},
                TakeSlots<Take>{take, received_.slots.data(), nullptr, int(each)});
            return std::int64_t(bytes);
        }
        setRoom(context, each, sent_);
        setRoom(context, each, received_);
        forEach(context, out, PutSlots<Put>{put, sent_.slots.data(), sent_.bytes(), int(each)});
        // waits for what came before, too: its memory is written anew
        if (Backend::gpu && out) context.toHost(sent_.host.data(), sent_.bytes(), bytes);
        else context.synchronise();
        transport.swap(sent_.messages, received_.messages);
        if (Backend::gpu && in)
            toDeviceLater(context, received_.bytes(), received_.host.data(), in*each);
        forEach(context, in,
            TakeSlots<Take>{take, received_.slots.data(), received_.bytes(), int(each)});
        return std::int64_t(bytes);
    }

private:

    //- Of all partners one after the other
    struct Side
    {
        std::vector<std::pair<int, int>> partners;      // rank, slots
        Array<Backend, int> slots;
        Array<Backend, unsigned char> device;
        HostMemory<Backend> host;
        std::vector<RankMessage> messages;

        //- Where kernels see them
        unsigned char* bytes() { return Backend::gpu ? device.data() : host.data(); }
        int count() const
        {
            int n = 0;
            for (const auto& p : partners) n += p.second;
            return n;
        }
    };

    static void set(Context<Backend>& context, const SlotShares::Lists& lists, Side& side)
    {
        std::vector<int> all;
        side.partners.clear();
        for (const auto& of : lists)
        {
            side.partners.emplace_back(of.first, int(of.second.size()));
            all.insert(all.end(), of.second.begin(), of.second.end());
        }
        side.slots.upload(context, all);
    }

    static void setRoom(Context<Backend>& context, std::size_t each, Side& side)
    {
        const std::size_t bytes = side.count()*each;
        if (Backend::gpu) side.device.allocate(context, bytes);
        unsigned char* at = side.host.room(bytes);
        side.messages.clear();
        for (const auto& p : side.partners)
        {
            side.messages.push_back(RankMessage{p.first, at, p.second*each});
            at += side.messages.back().size;
        }
    }

    Side sent_, received_;
    bool direct_ = false;
    PeerChannel<Backend> channel_;
};

} // namespace riprap
