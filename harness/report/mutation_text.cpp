#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "report/mutation_report.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kColumns = 100;

// Words after a label, broken to the lines' width.
std::string wrapped(const std::string& label, const std::vector<std::string>& words, std::size_t indent) {
  std::string text = label;
  std::size_t column = columnsOf(label);
  for (const std::string& word : words) {
    if (column + 1 + columnsOf(word) > kColumns) {
      text += '\n';
      text.append(indent, ' ');
      column = indent;
    } else {
      text += " ";
      ++column;
    }
    text += word;
    column += columnsOf(word);
  }
  return text + "\n";
}

std::string sentenceOf(const std::string& label, const std::string& words, std::size_t indent) {
  return wrapped(label, split(words, ' '), indent);
}

std::string killText(const MutantRun& run) {
  const std::vector<std::string> killers = killersOf(run);
  const bool is_foretold = std::ranges::find(killers, run.mutant.killed_by) != killers.end();
  const std::string& first = is_foretold ? run.mutant.killed_by : killers.front();
  std::string text = fmt::format("killed   {}\n", run.mutant.name);
  const std::string others = killers.size() > 1 ? fmt::format(" and {} more", killers.size() - 1) : "";
  text += sentenceOf("        ", fmt::format("by {}{}: {}", first, others, cellText(run.said.at(first), 200)),
                     11);
  return is_foretold ? text
                     : text + sentenceOf("        ",
                                         fmt::format("not by {}, as was foretold", run.mutant.killed_by), 11);
}

}  // namespace

std::vector<MutantRun> inOrder(std::vector<MutantRun> runs) {
  std::ranges::stable_sort(runs, [](const MutantRun& a, const MutantRun& b) {
    return std::pair(a.mutant.is_wheat, a.mutant.name) < std::pair(b.mutant.is_wheat, b.mutant.name);
  });
  return runs;
}

std::string mutantText(const MutantRun& run) {
  const Mutant& mutant = run.mutant;
  if (!run.problem.empty()) {
    return fmt::format("ERROR    {}\n{}\n", mutant.name, run.problem);
  }
  const std::vector<std::string> killers = killersOf(run);
  if (!mutant.is_wheat && !killers.empty()) {
    return killText(run);
  }
  if (!mutant.is_wheat) {
    return fmt::format("SURVIVED {}\n", mutant.name) + sentenceOf("        ", mutant.about, 9) +
           sentenceOf("        ",
                      fmt::format("{} checks looked at it, none noticed; foretold was {}", run.noticed.size(),
                                  mutant.killed_by),
                      9);
  }
  if (run.noticed.empty()) {
    return fmt::format("UNTESTED {}\n         no check looks at {}\n", mutant.name,
                       mutant.edit.file.string());
  }
  if (killers.empty()) {
    return fmt::format("passed   {} ({} checks)\n", mutant.name, run.noticed.size());
  }
  std::string text = fmt::format("REJECTED {}\n", mutant.name);
  for (const std::string& check : killers) {
    text += sentenceOf("        ", fmt::format("by {}: {}", check, cellText(run.said.at(check), 200)), 11);
  }
  return text;
}

std::string mutationText(const MutationReport& report) {
  const KillSummary summary = summarise(report.runs, report.suite);
  std::string text = "\nKill matrix, by check:\n";
  for (const auto& [check, mutants] : summary.kills) {
    text += wrapped(fmt::format("  {} {}:", check, mutants.size()), mutants, 6);
  }
  if (report.is_whole) {
    for (const std::vector<std::string>& checks : summary.copies) {
      text += sentenceOf("Notice the very same mutants:", joinNames(checks), 2);
    }
    if (!summary.idle.empty()) {
      text += sentenceOf("Notice no mutant:", joinNames(summary.idle), 2);
    }
    text += fmt::format("{} of {} checks that noticed something are the only ones to notice some mutant\n",
                        summary.needed.size(), summary.kills.size());
  }
  if (!summary.unexpected_killers.empty()) {
    text += sentenceOf("Killed, but not by the check foretold:", joinNames(summary.unexpected_killers), 2);
  }
  if (!summary.survivors.empty()) {
    text += sentenceOf("Survivors:", joinNames(summary.survivors), 2);
  }
  const double share =
      summary.mutants == 0 ? 1.0 : static_cast<double>(summary.killed) / static_cast<double>(summary.mutants);
  return text + fmt::format("\nScore: {} of {} mutants killed ({} %), {} of {} wheats rejected, {:.0f} s\n",
                            summary.killed, summary.mutants, percentText(share, 1), summary.rejected,
                            summary.wheats, report.time_s);
}

}  // namespace ssrkit
