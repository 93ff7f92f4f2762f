#include "validate/compare/imported_layout.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/frame/frame.h"

#include <fmt/format.h>

#include <array>

namespace plumbline {
namespace {

/// Mitsuba 3's rays start on the near plane (src/sensors/perspective.cpp), so its distances are measured from
/// there; this is the default of near_clip.
constexpr double kMitsubaNearClip = 0.01;

struct KnownChannel {
    FrameLayout layout;
    std::string_view ending; // of whole words: "Depth.Z" matches ViewLayer.Depth.Z
    std::string_view ours;
};

// Blender: the names of the passes in a multilayer file (manual, "Passes"). Combined.A isn't used because it
// is 1 on the background too unless the film is transparent. Mitsuba: <name>.<letters> with the names of the
// manual's examples (src/integrators/aov.cpp). pbrt: GBufferFilm::GetImage (src/pbrt/film.cpp); Ns is the
// shading normal, which is interpolated from the normals of a mesh file.
constexpr std::array kKnownChannels{
    KnownChannel{FrameLayout::Blender, "Depth.Z", "Z"},
    KnownChannel{FrameLayout::Blender, "Normal.X", "N.X"},
    KnownChannel{FrameLayout::Blender, "Normal.Y", "N.Y"},
    KnownChannel{FrameLayout::Blender, "Normal.Z", "N.Z"},
    KnownChannel{FrameLayout::Blender, "Position.X", "P.X"},
    KnownChannel{FrameLayout::Blender, "Position.Y", "P.Y"},
    KnownChannel{FrameLayout::Blender, "Position.Z", "P.Z"},
    KnownChannel{FrameLayout::Blender, "UV.U", "st.S"},
    KnownChannel{FrameLayout::Blender, "UV.V", "st.T"},
    KnownChannel{FrameLayout::Blender, "IndexOB.X", "id"},
    KnownChannel{FrameLayout::Blender, "Combined.R", "R"},
    KnownChannel{FrameLayout::Blender, "Combined.G", "G"},
    KnownChannel{FrameLayout::Blender, "Combined.B", "B"},
    KnownChannel{FrameLayout::Mitsuba, "T", "Z"},
    KnownChannel{FrameLayout::Mitsuba, "nn.X", "N.X"},
    KnownChannel{FrameLayout::Mitsuba, "nn.Y", "N.Y"},
    KnownChannel{FrameLayout::Mitsuba, "nn.Z", "N.Z"},
    KnownChannel{FrameLayout::Mitsuba, "sh_normal.X", "N.X"},
    KnownChannel{FrameLayout::Mitsuba, "sh_normal.Y", "N.Y"},
    KnownChannel{FrameLayout::Mitsuba, "sh_normal.Z", "N.Z"},
    KnownChannel{FrameLayout::Mitsuba, "position.X", "P.X"},
    KnownChannel{FrameLayout::Mitsuba, "position.Y", "P.Y"},
    KnownChannel{FrameLayout::Mitsuba, "position.Z", "P.Z"},
    KnownChannel{FrameLayout::Mitsuba, "pos.X", "P.X"},
    KnownChannel{FrameLayout::Mitsuba, "pos.Y", "P.Y"},
    KnownChannel{FrameLayout::Mitsuba, "pos.Z", "P.Z"},
    KnownChannel{FrameLayout::Mitsuba, "uv.U", "st.S"},
    KnownChannel{FrameLayout::Mitsuba, "uv.V", "st.T"},
    KnownChannel{FrameLayout::Pbrt, "P.X", "P.X"},
    KnownChannel{FrameLayout::Pbrt, "P.Y", "P.Y"},
    KnownChannel{FrameLayout::Pbrt, "P.Z", "P.Z"},
    KnownChannel{FrameLayout::Pbrt, "Ns.X", "N.X"},
    KnownChannel{FrameLayout::Pbrt, "Ns.Y", "N.Y"},
    KnownChannel{FrameLayout::Pbrt, "Ns.Z", "N.Z"},
    KnownChannel{FrameLayout::Pbrt, "u", "st.S"},
    KnownChannel{FrameLayout::Pbrt, "v", "st.T"},
    KnownChannel{FrameLayout::Pbrt, "R", "R"},
    KnownChannel{FrameLayout::Pbrt, "G", "G"},
    KnownChannel{FrameLayout::Pbrt, "B", "B"},
};

bool endsInWords(std::string_view name, std::string_view ending) {
    return name == ending || (name.ends_with(ending) && name[name.size() - ending.size() - 1] == '.');
}

/// Recognizes a renderer by channels that only it writes.
FrameLayout recognize(std::span<const std::string> names) {
    if (contains(names, "dzdx") && contains(names, "Ns.X") && contains(names, "P.X"))
        return FrameLayout::Pbrt;
    for (const std::string& name : names) {
        if (isFrameChannel(name)) continue;
        for (const char* ending : {"Depth.Z", "IndexOB.X", "Position.X", "Combined.R"})
            if (endsInWords(name, ending)) return FrameLayout::Blender;
        if (name.ends_with(".T")) return FrameLayout::Mitsuba;
    }
    return FrameLayout::Own;
}

/// Blender's compositor writes its result in addition to the layers.
bool isComposite(const std::string& name) {
    return name.starts_with("Composite.");
}

bool matches(const KnownChannel& known, const std::string& name) {
    return known.layout == FrameLayout::Pbrt ? name == known.ending : endsInWords(name, known.ending);
}

using ChannelsByOurs = std::map<std::string, ChannelMapping>;

/// `mapped`: channels of ours that --map already assigns.
ChannelsByOurs planKnown(FrameLayout layout, std::span<const std::string> names, const ChannelsByOurs& mapped,
                         const std::string& where) {
    ChannelsByOurs channels;
    for (const std::string& name : names)
        for (const KnownChannel& known : kKnownChannels) {
            const std::string ours(known.ours);
            if (known.layout != layout || !matches(known, name) || isComposite(name) || mapped.contains(ours))
                continue;
            ChannelMapping mapping{name, ours};
            if (layout == FrameLayout::Mitsuba && ours == "Z") mapping.distanceFrom = kMitsubaNearClip;
            const auto [entry, isNew] = channels.emplace(ours, mapping);
            if (!isNew)
                throw InputError(
                    where, fmt::format("both {} and {} could be {}", entry->second.theirs, name, ours),
                    "one of them",
                    fmt::format("for the test frame choose one with --map \"{}={}\"", name, ours));
        }
    return channels;
}

ChannelsByOurs planOwn(std::span<const std::string> names) {
    ChannelsByOurs channels;
    for (const std::string& name : names)
        if (isFrameChannel(name)) channels.emplace(name, ChannelMapping{name, name});
    return channels;
}

ChannelMapping parseMapping(const std::string& text) {
    constexpr const char* kExpected =
        "THEIRS=OURS, where OURS is a channel of a frame, with or without a minus sign, distance or "
        "distance+NEAR";
    const std::string where = fmt::format("--map \"{}\"", text);
    const size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw InputError(where, "is not a pair of channels", kExpected);
    ChannelMapping mapping{text.substr(0, equals), text.substr(equals + 1), true};
    constexpr std::string_view kDistance = "distance";
    if (mapping.ours.starts_with(kDistance)) {
        const std::string plane = mapping.ours.substr(kDistance.size());
        std::optional<double> near = 0;
        if (!plane.empty()) near = plane[0] == '+' ? parseNumber<double>(plane.substr(1)) : std::nullopt;
        if (!near) throw InputError(where, fmt::format("'{}' can't be read", mapping.ours), kExpected);
        mapping.ours = "Z";
        mapping.distanceFrom = near;
        return mapping;
    }
    mapping.negated = mapping.ours.starts_with('-');
    if (mapping.negated) mapping.ours.erase(0, 1);
    channelInfo(mapping.ours, where); // throws if unknown
    return mapping;
}

} // namespace

std::vector<ChannelMapping> parseChannelMap(std::span<const std::string> texts) {
    std::vector<ChannelMapping> mappings;
    for (const std::string& text : texts) {
        mappings.push_back(parseMapping(text));
        for (size_t earlier = 0; earlier + 1 < mappings.size(); ++earlier)
            if (mappings[earlier].ours == mappings.back().ours)
                throw InputError("--map", fmt::format("{} is mapped twice", mappings.back().ours),
                                 "each channel of a frame at most once");
    }
    return mappings;
}

const char* nameOf(FrameLayout layout) {
    switch (layout) {
    case FrameLayout::Own:
        break;
    case FrameLayout::Blender:
        return "a frame of Blender";
    case FrameLayout::Mitsuba:
        return "a frame of Mitsuba's aov integrator";
    case FrameLayout::Pbrt:
        return "a frame of pbrt's gbuffer film";
    }
    return "a frame with the names of the channel table";
}

ChannelPlan planChannels(std::span<const std::string> names, std::span<const ChannelMapping> mappings,
                         const std::string& where) {
    ChannelPlan plan;
    plan.layout = recognize(names);
    for (const ChannelMapping& mapping : mappings) {
        if (!contains(names, mapping.theirs))
            throw InputError(where, fmt::format("has no channel '{}'", mapping.theirs), listOf(names),
                             didYouMean(mapping.theirs, names));
        plan.channels.emplace(mapping.ours, mapping);
    }
    plan.channels.merge(plan.layout == FrameLayout::Own
                            ? planOwn(names)
                            : planKnown(plan.layout, names, plan.channels, where));
    if (plan.channels.empty())
        throw InputError(where, "no channel name is recognized; its channels are " + listOf(names),
                         "Z or P.X P.Y P.Z, A or id, and others of the channel table",
                         "for the test frame --map THEIRS=OURS maps channels");
    return plan;
}

} // namespace plumbline
