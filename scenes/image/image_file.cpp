#include "scenes/image/image_file.h"

#include "scenes/core/contains.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"
#include "scenes/image/exr_file.h"
#include "scenes/image/image_module.h"
#include "scenes/image/picture_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <dlfcn.h>

namespace plumbline {
namespace {

struct ImageModule {
    std::filesystem::path file;
    PlumblineReadPicture* readPicture = nullptr;
    PlumblineEncodePng* encodePng = nullptr;
};

/// Address space that its 250 libraries take, measured with OpenImageIO 2.4: 440 MB.
constexpr double kModuleBytes = 512e6;

/// The module is in the program's folder in a build tree, and in lib/plumbline in an installation.
ImageModule loadModule() {
    std::string reason = "not found";
    for (const char* place : {"plumbline_images.so", "../lib/plumbline/plumbline_images.so"}) {
        ImageModule module;
        module.file = (programFolder() / place).lexically_normal();
        std::error_code error;
        if (!std::filesystem::exists(module.file, error)) continue;
        requireAddressSpace("OpenImageIO", kModuleBytes);
        void* handle = dlopen(module.file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            reason = dlerror();
            continue;
        }
        module.readPicture = reinterpret_cast<PlumblineReadPicture*>(dlsym(handle, "plumblineReadPicture"));
        module.encodePng = reinterpret_cast<PlumblineEncodePng*>(dlsym(handle, "plumblineEncodePng"));
        if (module.readPicture && module.encodePng) return module; // stays loaded to the end of the program
        reason = module.file.string() + " is of another version";
    }
    throw MachineError("plumbline_images.so", "can't be loaded: " + reason,
                       "it beside the program or in ../lib/plumbline",
                       "build the target plumbline_images and install libopenimageio2.4 or later");
}

const ImageModule& imageModule() {
    static const ImageModule module = loadModule();
    return module;
}

std::vector<uint8_t> firstBytes(const std::filesystem::path& file, size_t count) {
    InputFile input(file);
    std::vector<uint8_t> bytes(count);
    bytes.resize(input.read({reinterpret_cast<char*>(bytes.data()), count}));
    if (bytes.empty()) throw InputError(file.string(), "is empty", "a picture");
    return bytes;
}

bool beginsWith(const std::vector<uint8_t>& bytes, std::initializer_list<uint8_t> magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

bool hasExrName(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending == ".exr";
}

std::vector<std::string> pictureChannels(const std::filesystem::path& file,
                                         const std::vector<std::string>& names) {
    const auto has = [&](const char* name) { return contains(names, name); };
    std::vector<std::string> chosen;
    if (has("R") && has("G") && has("B")) {
        chosen = {"R", "G", "B"};
    } else if (has("Y") && !has("RY") && !has("BY")) {
        chosen = {"Y"};
    } else if (names.size() == 1) {
        return names;
    } else {
        throw InputError(file.string(), "has the channels " + listOf(names),
                         "R G B, R G B A, Y, Y A, or a single channel");
    }
    if (has("A")) chosen.push_back("A");
    return chosen;
}

Image readExrImage(const std::filesystem::path& file) {
    std::vector<std::string> order;
    const ExrPlanes exr = readExr(
        file, [&](const std::vector<std::string>& names) { return order = pictureChannels(file, names); });
    Image image;
    image.width = exr.width;
    image.height = exr.height;
    image.channels = countOf(order);
    image.values.resize(order.size() * image.texelCount());
    for (size_t c = 0; c < order.size(); ++c) {
        const std::vector<float>& plane = exr.planes.at(order[c]);
        for (size_t pixel = 0; pixel < plane.size(); ++pixel)
            image.values[pixel * order.size() + c] = plane[pixel];
    }
    return image;
}

// Files with more pixels a byte are damaged. Deflate takes at least one bit for 129 bytes, which are up to
// 8256 pixels of one bit each; formats that take less for an even area need hundreds of bytes for their
// headers.
constexpr double kMaxPixelsPerByte = 65536;

/// Collects the pixels that the module reads. Memory is reserved at once but touched only as rows arrive.
struct ImageCollector {
    double fileBytes = 0;
    Image image;
    std::string failure;
    bool outOfMemory = false;

    static bool begin(void* user, int width, int height, int channels, bool integer) {
        auto& self = *static_cast<ImageCollector*>(user);
        self.image.width = width;
        self.image.height = height;
        self.image.channels = channels;
        self.image.integer = integer;
        if (double(width) * height > self.fileBytes * kMaxPixelsPerByte) {
            self.failure = fmt::format("is damaged or truncated ({} x {} pixels in {} bytes)", width, height,
                                       self.fileBytes);
            return false;
        }
        return self.guarded(
            [&] { self.image.values.reserve(self.image.texelCount() * static_cast<size_t>(channels)); });
    }
    static bool values(void* user, const float* values, size_t count) {
        auto& self = *static_cast<ImageCollector*>(user);
        return self.guarded(
            [&] { self.image.values.insert(self.image.values.end(), values, values + count); });
    }
    static void fail(void* user, const char* what) { static_cast<ImageCollector*>(user)->failure = what; }

  private:
    template <class Action>
    bool guarded(const Action& action) {
        try {
            action();
            return true;
        } catch (const std::exception&) { // bad_alloc, length_error
            outOfMemory = true;
            return false;
        }
    }
};

/// A picture's file in memory.
struct PngCollector {
    std::string bytes, failure;

    static void contents(void* user, const uint8_t* bytes, size_t count) {
        auto& self = *static_cast<PngCollector*>(user);
        try {
            self.bytes.assign(reinterpret_cast<const char*>(bytes), count);
        } catch (const std::bad_alloc&) { // no exception crosses the module
            self.failure = kOutOfMemory;
        }
    }
    static void fail(void* user, const char* what) { static_cast<PngCollector*>(user)->failure = what; }
};

/// What the module says of a file, if anything.
void throwFailure(const std::filesystem::path& file, const std::string& failure) {
    if (failure == kOutOfMemory) throw MachineError(file.string(), failure);
    if (!failure.empty()) throw InputError(file.string(), failure);
}

} // namespace

std::filesystem::path imageModuleFile() {
    return imageModule().file;
}

Image readImage(const std::filesystem::path& file) {
    const std::vector<uint8_t> magic = firstBytes(file, 4);
    if (hasExrName(file) || beginsWith(magic, {0x76, 0x2f, 0x31, 0x01})) return readExrImage(file);
    if (beginsWith(magic, {0xff, 0xd8}) || beginsWith(magic, {0x89, 'P'})) checkPictureIsWhole(file);
    ImageCollector collector;
    collector.fileBytes = static_cast<double>(std::filesystem::file_size(file));
    const PlumblinePictureSink sink{&collector, ImageCollector::begin, ImageCollector::values,
                                    ImageCollector::fail};
    imageModule().readPicture(file.c_str(), &sink);
    if (collector.outOfMemory) throw MachineError(file.string(), "not enough memory to read it");
    throwFailure(file, collector.failure);
    return std::move(collector.image);
}

void writePng(const std::filesystem::path& file, int width, int height, const std::vector<uint8_t>& rgb) {
    if (width < 1 || height < 1 || rgb.size() != 3 * areaOf(width, height))
        throw InputError(file.string(),
                         fmt::format("{} bytes for a picture of {} x {}", rgb.size(), width, height),
                         "3 bytes a pixel and at least one pixel");
    PngCollector collector;
    const PlumblineFileSink sink{&collector, PngCollector::contents, PngCollector::fail};
    imageModule().encodePng(width, height, rgb.data(), &sink);
    throwFailure(file, collector.failure);
    replaceFile(file, collector.bytes);
}

} // namespace plumbline
