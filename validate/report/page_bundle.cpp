#include "validate/report/page_bundle.h"

// Embeds a file as two symbols, its begin and end. The assembler reads it, because compilers take minutes for
// arrays of that length.
// NOLINTBEGIN(bugprone-macro-parentheses): a symbol can't be in parentheses
#define PLUMBLINE_EMBED(symbol, file)                                                                        \
    asm(".section .rodata\n"                                                                                 \
        ".global " #symbol "\n" #symbol ":\n"                                                                \
        ".incbin \"" file "\"\n"                                                                             \
        ".global " #symbol "_end\n" #symbol "_end:\n"                                                        \
        ".previous\n");                                                                                      \
    extern "C" const char symbol[], symbol##_end[]
// NOLINTEND(bugprone-macro-parentheses)

PLUMBLINE_EMBED(plumbline_page_style, PLUMBLINE_PAGE_STYLE);
#ifdef PLUMBLINE_PAGE_SCRIPT
PLUMBLINE_EMBED(plumbline_page_script, PLUMBLINE_PAGE_SCRIPT);
#endif

namespace plumbline::report {

std::string_view pageStyle() {
    return {plumbline_page_style, plumbline_page_style_end};
}

#ifdef PLUMBLINE_PAGE_SCRIPT
std::string_view pageScript() {
    return {plumbline_page_script, plumbline_page_script_end};
}

std::string_view plainReportReason() {
    return {};
}
#else
std::string_view pageScript() {
    return {};
}

std::string_view plainReportReason() {
    return "this program was built without the interactive page: " PLUMBLINE_NO_PAGE_REASON;
}
#endif

} // namespace plumbline::report
