/*  SlotShares of fields that are on a device: what is sent is put together there by a list of
    slots, and crosses to the host in one copy; what comes goes the same way back.

    put(slot, to) and take(slot, from) are functors for the device; bytes are aligned to the words
    that they are made of.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/hostMemory.hpp"
#include "core/backend/launch.hpp"
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

    //- Slots that are shared from now on
    void set(Context<Backend>& context, const SlotShares& shares)
    {
        set(context, shares.sent(), sent_);
        set(context, shares.received(), received_);
    }

    //- \return bytes sent
    template<class Put, class Take>
    std::int64_t share(Context<Backend>& context, Transport& transport, std::size_t each,
        const Put& put, const Take& take)
    {
        setRoom(context, each, sent_);
        setRoom(context, each, received_);
        const int out = sent_.count(), in = received_.count();
        const std::size_t bytes = out*each;
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
};

} // namespace riprap
