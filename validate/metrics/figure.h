// The result of a metric: a number, or the reason why it is absent.
//
// A figure that can't be computed is absent with its reason, never 0 and never NaN.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace plumbline {

class Figure {
  public:
    Figure() : reason_("not computed") {}
    /// A value that isn't finite becomes absent, so that no result file contains NaN or infinity.
    Figure(double value) { // NOLINT(google-explicit-constructor): a number is a figure
        if (std::isfinite(value))
            value_ = value + 0.0; // -0 becomes 0, whose text has no minus sign
        else
            reason_ = "the result is not finite";
    }
    static Figure absent(std::string reason) {
        Figure figure;
        figure.reason_ = std::move(reason);
        return figure;
    }
    /// part / whole; absent with `reasonIfEmpty` if the whole is 0.
    static Figure ratio(uint64_t part, uint64_t whole, const std::string& reasonIfEmpty) {
        if (whole == 0) return absent(reasonIfEmpty);
        return {static_cast<double>(part) / static_cast<double>(whole)};
    }

    explicit operator bool() const { return value_.has_value(); }
    double operator*() const { return value_.value(); }
    /// Why there is no value; empty if there is one.
    const std::string& reason() const { return reason_; }

    friend bool operator==(const Figure&, const Figure&) = default;

  private:
    std::optional<double> value_;
    std::string reason_;
};

} // namespace plumbline
