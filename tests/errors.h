// Catches the exceptions of an action, for tests of error messages.
#pragma once

#include "scenes/core/error.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline {

/// The message of the exception of this type that `action` throws; empty if it throws none.
template <class Error, class Action>
std::string messageOf(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

/// The message of the InputError that `action` must throw.
template <class Action>
std::string inputErrorOf(const Action& action) {
    const std::string message = messageOf<InputError>(action);
    EXPECT_NE(message, "") << "no InputError was thrown";
    EXPECT_EQ(message.find('\n'), std::string::npos) << "an error is one line";
    return message;
}

/// Runs `action`, which may throw InputError; the test fails for any other exception.
template <class Action>
bool worksOrIsRefused(const Action& action) {
    try {
        action();
        return true;
    } catch (const InputError&) {
        return false;
    }
}

} // namespace plumbline
