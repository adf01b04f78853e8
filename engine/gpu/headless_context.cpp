// Contexts without a window, by EGL. Functions of extensions are asked for by name: libepoxy's EGL
// loader wants a display before it gives any of them.

#include "engine/gpu/context.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace gpu {

namespace {

template <class Function>
Function egl_function(const char* name) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): EGL gives all as one type
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool has_extension(const char* list, std::string_view name) {
    std::string_view rest = list == nullptr ? "" : list;
    while (!rest.empty()) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == name) return true;
        rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    }
    return false;
}

bool software_wanted() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets variables while the engine runs
    const char* wish = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    if (wish == nullptr) return false;
    const std::string_view text = wish;
    return text == "1" || text == "true" || text == "yes";
}

/// A display that may have OpenGL, not initialised yet.
struct Candidate {
    EGLDisplay display = EGL_NO_DISPLAY;
    std::string platform;
};

/// One candidate per EGL device, hardware first.
std::vector<Candidate> device_candidates() {
    const auto query_devices = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_string =
        egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    const auto get_display =
        egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (query_devices == nullptr || query_string == nullptr || get_display == nullptr) return {};

    constexpr EGLint kMostDevices = 32;
    std::array<EGLDeviceEXT, kMostDevices> devices = {};
    EGLint count = 0;
    if (query_devices(kMostDevices, devices.data(), &count) == EGL_FALSE) return {};

    const auto is_software = [&](EGLDeviceEXT device) {
        return has_extension(query_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    };
    auto* const end = devices.begin() + count;
    auto* const first_software = std::stable_partition(
        devices.begin(), end, [&](EGLDeviceEXT device) { return !is_software(device); });
    std::vector<Candidate> candidates;
    for (const auto* device = software_wanted() ? first_software : devices.begin(); device != end;
         ++device) {
        candidates.push_back(
            {get_display(EGL_PLATFORM_DEVICE_EXT, *device, nullptr), "EGL device"});
    }
    return candidates;
}

std::vector<Candidate> all_candidates() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> candidates;
    if (has_extension(client, "EGL_EXT_platform_device")) candidates = device_candidates();
    if (has_extension(client, "EGL_MESA_platform_surfaceless")) {
        const auto get_display =
            egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (get_display != nullptr) {
            candidates.push_back(
                {get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                 "EGL surfaceless"});
        }
    }
    return candidates;
}

EGLConfig any_config(EGLDisplay display) {
    if (has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
        return EGL_NO_CONFIG_KHR;
    }
    constexpr std::array<EGLint, 5> kWanted = {
        EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display, kWanted.data(), &config, 1, &count);
    return config;
}

std::string egl_failure(std::string_view what) {
    return fmt::format("{} failed with EGL error {:#x}", what, eglGetError());
}

/// Makes an OpenGL 4.5 core context current on this thread.
engine::Result<NativeContext>
make_native_context(const Candidate& candidate, const ContextOptions& options) {
    EGLDisplay display = candidate.display;
    if (display == EGL_NO_DISPLAY) return engine::Error{"there is no display"};
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        return engine::Error{egl_failure("eglInitialize")};
    }
    if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
        return engine::Error{"contexts without a surface are not offered"};
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return engine::Error{egl_failure("eglBindAPI")};
    const std::array<EGLint, 9> attributes = {
        EGL_CONTEXT_MAJOR_VERSION,
        4,
        EGL_CONTEXT_MINOR_VERSION,
        5,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_CONTEXT_OPENGL_DEBUG,
        options.debug ? EGL_TRUE : EGL_FALSE,
        EGL_NONE};
    EGLContext context =
        eglCreateContext(display, any_config(display), EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT) return engine::Error{egl_failure("eglCreateContext")};
    // The display stays initialised: EGL keeps one per device and process, and others may use it.
    std::shared_ptr<void> owner(context, [display](EGLContext mine) {
        if (eglGetCurrentContext() == mine) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, mine);
    });
    const auto make_current = [display, context] {
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    };
    if (!make_current()) return engine::Error{egl_failure("eglMakeCurrent")};
    return NativeContext{std::move(owner), make_current, candidate.platform};
}

} // namespace

engine::Result<std::unique_ptr<Context>> make_headless_context(const ContextOptions& options) {
    std::string tried;
    for (const Candidate& candidate : all_candidates()) {
        engine::Result<NativeContext> native = make_native_context(candidate, options);
        if (native) return std::make_unique<Context>(*std::move(native), options);
        tried += fmt::format("; {}: {}", candidate.platform, native.error().message);
    }
    if (tried.empty()) tried = "; EGL offers neither devices nor the surfaceless platform";
    return engine::Error{fmt::format("no OpenGL 4.5 core context without a window{}", tried)};
}

} // namespace gpu
