#include "validate/results/csv_text.h"

#include "scenes/core/printable.h"

namespace plumbline {

std::string csvCell(const std::string& unsafe) {
    std::string text = printable(unsafe);
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + "\"";
}

std::string csvLine(const std::vector<std::string>& texts) {
    std::string line;
    for (size_t i = 0; i < texts.size(); ++i)
        line += (i > 0 ? "," : "") + csvCell(texts[i]);
    return line + "\r\n";
}

} // namespace plumbline
