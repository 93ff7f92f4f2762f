#include "scenes/frame/header_words.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <locale>
#include <optional>

namespace plumbline {

std::string headerText(const Vec3& vector) {
    return fmt::format("{} {} {}", vector.x, vector.y, vector.z);
}

HeaderWords::HeaderWords(const std::string& text) : stream_(text) {
    stream_.imbue(std::locale::classic());
}

std::string HeaderWords::word() {
    std::string next;
    if (!(stream_ >> next)) failed_ = true;
    return next;
}

void HeaderWords::literal(const char* expected) {
    failed_ = word() != expected || failed_;
}

double HeaderWords::number() {
    const std::optional<double> number = parseNumber<double>(word());
    if (!number) failed_ = true;
    return number.value_or(0);
}

int HeaderWords::count(int largest) {
    const double value = number();
    if (!(value >= 1 && value <= largest) || value != std::floor(value)) {
        failed_ = true;
        return 1;
    }
    return static_cast<int>(value);
}

Vec3 HeaderWords::vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}

bool HeaderWords::either(const char* yes, const char* no) {
    const std::string found = word();
    if (found != yes && found != no) failed_ = true;
    return found == yes;
}

bool HeaderWords::ok() {
    std::string rest;
    return !failed_ && !(stream_ >> rest);
}

void refuseHeaderField(const std::string& where, const std::string& key, const std::string& value,
                       const std::string& expected) {
    throw InputError(fmt::format("{}: header field '{}'", where, key),
                     fmt::format("'{}' can't be read", value), expected);
}

} // namespace plumbline
