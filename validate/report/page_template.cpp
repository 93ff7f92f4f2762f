#include "validate/report/page_template.h"

#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/read_file.h"

namespace plumbline::report {

std::string readTemplate(const char* name) {
    const std::filesystem::path file = dataFolder() / "validate" / "report" / "page" / name;
    try {
        return readWholeFile(file);
    } catch (const InputError& error) {
        throw MachineError("the report's template", error.what(), "an undamaged installation");
    }
}

std::string renderTemplate(const char* name, const kainjow::mustache::data& page) {
    kainjow::mustache::mustache layout(readTemplate(name));
    if (!layout.is_valid())
        throw MachineError(std::string("validate/report/page/") + name, layout.error_message(),
                           "a valid template");
    layout.set_custom_escape(
        [](const std::string& text) { return kainjow::mustache::html_escape(printable(text)); });
    return layout.render(page);
}

} // namespace plumbline::report
