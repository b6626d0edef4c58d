#include "widgets/core/report_files.h"

#include <QFileInfo>
#include <algorithm>

#include "engine/io/file.h"
#include "engine/report/html.h"
#include "widgets/core/language.h"
#include "widgets/core/report_pdf.h"

namespace lathelier {

void writeReport(const QString& path, const Document& document)
{
    const bool pdf = QFileInfo(path).suffix().compare("pdf", Qt::CaseInsensitive) == 0;
    writeFile(path.toStdString(), pdf ? toPdf(document, screenLanguage()) : toHtml(document, screenLanguage()));
}

Document joined(const std::vector<Document>& parts, const std::string& title)
{
    if (parts.size() == 1) return parts.front();
    Document result;
    result.title = title;
    for (const Document& part : parts) {
        result.synthetic = result.synthetic || part.synthetic;
        result.created = std::max(result.created, part.created);
        result.sections.insert(result.sections.end(), part.sections.begin(), part.sections.end());
        for (const InputFile& input : part.inputs)
            if (std::none_of(result.inputs.begin(), result.inputs.end(),
                             [&](const InputFile& known) { return known.path == input.path; }))
                result.inputs.push_back(input);
    }
    return result;
}

}  // namespace lathelier
