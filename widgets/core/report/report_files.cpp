#include "widgets/core/report/report_files.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "engine/io/file.h"
#include "engine/report/html.h"
#include "engine/report/result_json.h"
#include "engine/verify/verify_report.h"
#include "widgets/core/language.h"
#include "widgets/core/report/report_pdf.h"

namespace lathelier {

void writeReport(const QString& path, report::Document document, const Progress& progress)
{
    if (document.created.empty()) document.created = QDateTime::currentDateTime().toString(Qt::ISODate).toStdString();
    verify::quoteVerification(document, progress.part(0, 0.8));
    progress.report(0.8);
    const bool pdf = QFileInfo(path).suffix().compare("pdf", Qt::CaseInsensitive) == 0;
    io::writeFile(path.toStdString(),
                  pdf ? toPdf(document, screenLanguage()) : report::toHtml(document, screenLanguage()));
    const std::string results = report::joinedResults(document.results);
    if (!results.empty()) io::writeFile(resultFile(path).toStdString(), results);
}

QString resultFile(const QString& report)
{
    const QFileInfo info(report);
    return info.dir().filePath(info.completeBaseName() + "_result.json");
}

report::Document partWithoutAnswer(const PanelFacts& facts, const project::PanelState& state,
                                   const std::optional<Error>& error)
{
    report::Section section{facts.title, {}};
    const std::vector<Text> missing = facts.missing ? facts.missing(state) : missingOf(facts.roles)(state);
    for (const Text label : missing)
        section.blocks.push_back(
            report::Paragraph{LT_TEXT("Engine", "No answer: {input} is missing."), {{"input", label}}});
    if (missing.empty() && error)
        section.blocks.push_back(
            report::Paragraph{LT_TEXT("Engine", "No answer: {reason}"), {{"reason", text(*error, screenLanguage())}}});
    if (section.blocks.empty())
        section.blocks.push_back(report::Paragraph{LT_TEXT("Engine", "No answer: the computation was stopped."), {}});
    report::Document document;
    document.title = facts.title;
    document.sections = {std::move(section)};
    return document;
}

report::Document joined(const std::vector<report::Document>& parts, const std::string& title)
{
    if (parts.size() == 1) return parts.front();
    report::Document result;
    result.title = title;
    for (const report::Document& part : parts) {
        result.synthetic = result.synthetic || part.synthetic;
        for (const VerifyPart* verification : part.verification)
            if (std::find(result.verification.begin(), result.verification.end(), verification) ==
                result.verification.end())
                result.verification.push_back(verification);
        result.created = std::max(result.created, part.created);
        result.sections.push_back({part.title, {}});  // heading section, followed by the results
        result.sections.insert(result.sections.end(), part.sections.begin(), part.sections.end());
        result.results.insert(result.results.end(), part.results.begin(), part.results.end());
        for (const InputFile& input : part.inputs)
            if (std::none_of(result.inputs.begin(), result.inputs.end(),
                             [&](const InputFile& known) { return known.path == input.path; }))
                result.inputs.push_back(input);
    }
    return result;
}

}  // namespace lathelier
