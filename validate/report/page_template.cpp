#include "validate/report/page_template.h"

#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"

#include <fstream>
#include <sstream>

namespace plumbline::report {

std::string readTemplate(const char* name) {
    const std::filesystem::path file = dataFolder() / "validate" / "report" / "page" / name;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        throw MachineError(file.string(), "the report's template can't be read", "an undamaged installation");
    return text.str();
}

std::string renderTemplate(const char* name, const kainjow::mustache::data& page) {
    kainjow::mustache::mustache layout(readTemplate(name));
    if (!layout.is_valid())
        throw MachineError(std::string("validate/report/page/") + name, layout.error_message(),
                           "a valid template");
    return layout.render(page);
}

} // namespace plumbline::report
