// Texts of options and of studies to values. All throw InputError, which names the option.
#pragma once

#include "scenes/maps/height_map.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

/// A word of `choices`.
std::string parseChoice(const char* option, const std::string& text, const std::vector<std::string>& choices);

/// "a,b" to {"a", "b"}: one each for s and t.
std::pair<std::string, std::string> parsePair(const char* option, const std::string& text,
                                              const char* example);

/// Texts "key=value" of --set to a map. Not without '=', without a key, or with a key given twice.
std::map<std::string, std::string> parseSettings(const std::vector<std::string>& texts);

/// --memory and the like: "268435456", "256M", "2G", "512K" (powers of 1024) to bytes; at least 1M, at most
/// 64T.
uint64_t parseMemorySize(const char* option, const std::string& text);

/// --error-px: a number of pixels from 1e-6 to 1000.
double parseErrorPx(const std::string& text);

/// World units, within the bounds of scene files and above 0.
double parseLength(const char* option, const std::string& text);

/// Repeats of a map along an axis, not 0.
double parseTile(const char* option, const std::string& text);

/// --wrap: "repeat,clamp" along s and t.
std::pair<Wrap, Wrap> parseWraps(const std::string& text);

} // namespace plumbline
