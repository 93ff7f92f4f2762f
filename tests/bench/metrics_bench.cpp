#include "tests/bench/metrics_bench.h"

#include "scenes/frame/frame_header.h"
#include "scenes/frame/object_info.h"
#include "validate/compare/compare.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <thread>

namespace plumbline {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kRuns = 9;

/// A ring that covers 40 % of the image in front of a floor that fills the rest of its lower half. `wobble`:
/// the error of its outline in pixels, and the scale of the errors of other channels.
Frame paintedFrame(double wobble, bool isReference) {
    Frame frame(kWidth, kHeight);
    for (const char* name : {"R", "G", "B", "A", "Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S",
                             "st.T", "id", "shadow.sun", "cost.fetches", "cost.iterations"})
        frame.add(name);
    if (isReference) {
        frame.add("uncertain");
        frame.add(uncertainShadowChannel("sun"));
    }
    std::map<std::string, std::span<float>> planes;
    for (const std::string& name : frame.channelNames())
        planes[name] = frame.channel(name);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const size_t i = static_cast<size_t>(y) * kWidth + static_cast<size_t>(x);
            const double u = (x - kWidth / 2) / 520.0, v = (y - kHeight / 2) / 520.0;
            const double angle = std::atan2(v, u), relief = std::sin(40 * angle) * std::sin(angle * 173);
            const double radius = std::hypot(u, v) + (0.01 * relief) * (1 + wobble);
            const bool ring = radius > 0.3 && radius < 1;
            if (!ring && v < 0) continue;
            const auto put = [&](const char* name, double value) {
                planes[name][i] = static_cast<float>(value * (1 + 0.01 * wobble * relief));
            };
            planes["id"][i] = ring ? 1 : 2;
            planes["A"][i] = 1;
            put("Z", 3 - 0.5 * radius);
            put("P.X", u);
            put("P.Y", -v);
            put("P.Z", radius);
            put("N.X", u * relief);
            put("N.Y", v);
            planes["N.Z"][i] = 1;
            put("st.S", angle * 8);
            put("st.T", radius * 3);
            for (const char* color : {"R", "G", "B"})
                put(color, 0.5 + 0.4 * relief);
            planes["shadow.sun"][i] = std::sin(30 * angle + wobble * 0.05) * radius > 0.3 ? 1 : 0;
            planes["cost.fetches"][i] = static_cast<float>(32 + (x ^ y) % 9);
            planes["cost.iterations"][i] = static_cast<float>(8 + (x ^ y) % 5);
            if (isReference && std::abs(radius - 1) < 0.0005) planes["uncertain"][i] = 1;
        }
    return frame;
}

Scene sceneOfBoth() {
    Scene scene;
    scene.camera.width = kWidth;
    scene.camera.height = kHeight;
    Light sun;
    sun.name = "sun";
    sun.toLightWorld = glm::normalize(Vec3(1, 2, 1));
    scene.lights = {sun};
    Relief relief;
    relief.map = std::make_shared<HeightMap>(HeightMap::constant("flat", 0.5f));
    relief.depth = 0.1;
    scene.objects.resize(2);
    scene.objects[0].name = "ring";
    scene.objects[0].relief = relief;
    scene.objects[1].name = "floor";
    return scene;
}

struct Times {
    double wallMs, cpuMs; // medians; CPU time of all threads
};

Times timesOf(const std::function<void()>& run) {
    std::vector<double> wall, cpu;
    for (int i = 0; i <= kRuns; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t startCpu = std::clock();
        run();
        if (i == 0) continue; // warm-up
        wall.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        cpu.push_back(1000.0 * static_cast<double>(std::clock() - startCpu) / CLOCKS_PER_SEC);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(cpu.begin(), cpu.end());
    return {wall[kRuns / 2], cpu[kRuns / 2]};
}

} // namespace

void printMetrics() {
    const Scene scene = sceneOfBoth();
    Frame reference = paintedFrame(0, true);
    const Frame test = paintedFrame(1, false);
    reference.metadata = sceneMetadata(scene);
    const std::vector<ObjectInfo> objects = objectsOf(scene);
    fmt::print("\nmetrics of a pair of {} x {} pixels, two objects\n", kWidth, kHeight);
    for (const unsigned threads : {std::thread::hardware_concurrency(), 1u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const Times times = timesOf([&] { compareFrames(reference, test, objects, scene.camera); });
        fmt::print("{:<44}{:>8.0f} ms   ({:.0f} ms of CPU; {} runs, medians; aim 300 ms on two cores)\n",
                   fmt::format("everything, {} thread(s)", threads), times.wallMs, times.cpuMs, kRuns);
    }
}

} // namespace plumbline
