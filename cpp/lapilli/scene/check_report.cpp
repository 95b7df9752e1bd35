#include <iomanip>

#include "lapilli/core/memory.hpp"
#include "lapilli/scene/check_stages.hpp"
#include "lapilli/scene/emit.hpp"
#include "lapilli/scene/run_text.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

Tree list_of(const std::vector<std::string>& words) {
  Tree::Array array;
  for (const std::string& word : words) {
    array.push_back({word, {}});
  }
  return {std::move(array), {}};
}

/// A member of every note, in their order.
template <class Member>
Tree members_of(const std::vector<Note>& notes, const Member& member) {
  Tree::Array array;
  for (const Note& one : notes) {
    array.push_back({std::string(member(one)), {}});
  }
  return {std::move(array), {}};
}

Tree stages_of(const CheckReport& report) {
  Tree::Array all;
  for (const CheckReport::StageReport& stage : report.stages) {
    all.push_back({Tree::Table{{"name", {}, {stage.name, {}}},
                               {"start", {}, {stage.start, {}}},
                               {"end", {}, {stage.end, {}}},
                               {"points", {}, {stage.points, {}}},
                               {"step", {}, {stage.step, {}}},
                               {"steps", {}, {stage.steps, {}}},
                               {"changes", {}, list_of(stage.changes)}},
                   {}});
  }
  return {std::move(all), {}};
}

std::string listed(const std::vector<std::string>& words) {
  return words.empty() ? "nothing" : joined(words);
}

}  // namespace

std::string text_of(const CheckReport& report) {
  std::string cells;
  for (const Index count : report.cells) {
    cells += (cells.empty() ? "" : " x ") + std::to_string(count);
  }
  constexpr const char* sizes[] = {"length", "area", "volume"};
  constexpr const char* units[] = {" m", " m^2", " m^3"};
  std::string text = report.title.empty() ? "" : report.title + "\n";
  text += message("grid          ", cells, " cells, ", report.nodes, " nodes\n");
  for (const CheckReport::BodyReport& body : report.bodies) {
    text += message("body          ", body.name, ": ", body.points, " points, ",
                    sizes[report.dimension - 1], " ", body.volume, units[report.dimension - 1],
                    body.volume_of_shape ? message(" (shape ", *body.volume_of_shape, ")") : "",
                    ", spacing ", body.spacing, " m\n");
  }
  text += message("models        ", listed(report.modelled), "\n");
  text += message("not modelled  ", listed(report.not_modelled), "\n");
  text += report.step > 0.0
              ? message("step          ", report.step, " s (", report.step_reason, "), limit ",
                        report.hard_limit, " s, ", report.steps, " steps\n")
              : message("step          ", report.step_reason, "\n");
  text += stages_text(report);
  text += message("memory        about ", readable_bytes(report.memory),
                  report.output > 0.0
                      ? message(", and ", readable_bytes(report.output), " of frames on disk")
                      : "",
                  "\n");
  if (report.step > 0.0) {
    text += message("time          about ", readable_time(report.seconds_to_run), ", and ",
                    readable_time(report.seconds_to_build), " to build\n");
  }
  for (const Note& one : report.notes) {
    text += message("note          ", with_code(one), "\n");
  }
  return text;
}

std::string json_of(const CheckReport& report) {
  Tree::Array cells, bodies;
  for (const Index count : report.cells) {
    cells.push_back({count, {}});
  }
  for (const CheckReport::BodyReport& body : report.bodies) {
    bodies.push_back({Tree::Table{{"name", {}, {body.name, {}}},
                                  {"points", {}, {body.points, {}}},
                                  {"volume", {}, {body.volume, {}}},
                                  {"spacing", {}, {body.spacing, {}}}},
                      {}});
    if (body.volume_of_shape) {
      std::get<Tree::Table>(bodies.back().value)
          .push_back({"volume_of_shape", {}, {*body.volume_of_shape, {}}});
    }
  }
  return emit_json(
      {Tree::Table{
           {"title", {}, {report.title, {}}},
           {"dimension", {}, {Index{report.dimension}, {}}},
           {"cells", {}, {std::move(cells), {}}},
           {"nodes", {}, {report.nodes, {}}},
           {"bodies", {}, {std::move(bodies), {}}},
           {"points", {}, {report.points, {}}},
           {"modelled", {}, list_of(report.modelled)},
           {"not_modelled", {}, list_of(report.not_modelled)},
           {"step", {}, {report.step, {}}},
           {"hard_limit", {}, {report.hard_limit, {}}},
           {"step_reason", {}, {report.step_reason, {}}},
           {"steps", {}, {report.steps, {}}},
           {"stages", {}, stages_of(report)},
           {"memory", {}, {report.memory, {}}},
           {"output", {}, {report.output, {}}},
           {"seconds_to_build", {}, {report.seconds_to_build, {}}},
           {"seconds_to_run", {}, {report.seconds_to_run, {}}},
           {"notes", {}, members_of(report.notes, [](const Note& one) { return one.text; })},
           {"note_codes",
            {},
            members_of(report.notes, [](const Note& one) { return one.code.text(); })}},
       {}});
}

}  // namespace lapilli
