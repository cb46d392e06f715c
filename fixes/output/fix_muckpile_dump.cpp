// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/dump: one file per snapshot, rows gathered on rank 0.
// Scope: see the header.
#include "fixes/output/fix_muckpile_dump.h"

#include <comm.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <multisphere.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/periodic_output.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/block_impulses.h"
#include "fixes/interfaces/joint_fragments.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/interfaces/known_blocks.h"
#include "state/packed_rows.h"

namespace muckpile {
namespace {

constexpr std::string_view kHeader =
    "id,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fragment_id,broken_"
    "fraction\n";

const ArgTable& table() {
  static const ArgTable args =
      engine::periodic_output_table("fix muckpile/dump", "between snapshots",
                                    "where blocks_<step>.csv (or .bin) and joints.csv go")
          .word("form", {"csv", "packed"}, "csv",
                "of snapshots: text, or bytes of less than half the size in blocks_<step>.bin");
  return args;
}

/// Each number behind a comma, to so many digits.
template <class Numbers>
void append(std::string& text, const Numbers& numbers, int digits) {
  std::array<char, 32> word{};
  for (const double number : numbers) {
    const auto end =
        std::to_chars(word.begin(), word.end(), number, std::chars_format::general, digits);
    text += ',';
    text.append(word.begin(), end.ptr);
  }
}

void append_row(std::string& text, const BlockRow& row) {
  text += std::to_string(row.id);
  append(text, row.centre, 10);
  append(text, Eigen::Vector4d(row.turn.w(), row.turn.x(), row.turn.y(), row.turn.z()), 9);
  append(text, row.velocity, 7);
  append(text, row.spin, 7);
  text += ',' + std::to_string(row.fragment);
  append(text, std::array{row.broken_share}, 5);
  text += '\n';
}

/// Names of its numbers, a line.
std::string impulses_header() {
  std::string names = "id";
  for (const std::string_view part : kImpulseNames) {
    for (const char* axis : {"_x_N_s", "_y_N_s", "_z_N_s"}) names.append(",").append(part) += axis;
  }
  return names + '\n';
}

void append_row(std::string& text, const ImpulseRow& row) {
  text += std::to_string(row.tag);
  for (const Vec3& part : row.impulse.parts) append(text, part, 10);
  text += '\n';
}

/// The id in the first line of a snapshot, "" if there is none.
std::string run_of(const std::filesystem::path& snapshot) {
  std::ifstream in(snapshot);
  std::array<char, 200> begin{};  // of whatever file has such a name
  in.getline(begin.data(), begin.size());
  return run_id_in(begin.data());
}

}  // namespace

const ArgTable& dump_keywords() { return table(); }

FixMuckpileDump::FixMuckpileDump(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  every_ = static_cast<int>(args.integer("every"));
  nevery = 1;
  folder_ = args.word("directory");
  form_ = args.word("form") == "csv" ? SnapshotForm::csv : SnapshotForm::packed;
  engine::make_output_folder(*lmp, where_, folder_);
}

int FixMuckpileDump::setmask() {
  return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::END_OF_STEP;
}

void FixMuckpileDump::init() {
  blocks_ = engine::find_view<KnownBlocks>(*lmp);
  joints_ = engine::find_view<JointFragments>(*lmp);
  impulses_ = engine::find_view<BlockImpulses>(*lmp);
  if (engine::place_of<BlockImpulses>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/impulse");
  if (blocks_ == nullptr) engine::stop(*lmp, where_ + ": needs create_blocks before the first run");
}

void FixMuckpileDump::setup(int) {
  if (last_ < 0) write();
}

/// Not in setup(): a fix set up after this one may refuse the run. Before the first end of a step,
/// where another such fix may write.
void FixMuckpileDump::initial_integrate(int) { clear_folder(); }

/// Once: removes the snapshots of this run that it takes anew, those of steps after the one it was
/// set up at, and the one of that step in the other form. Those of other runs stay, and are told
/// of.
void FixMuckpileDump::clear_folder() {
  if (cleared_) return;
  cleared_ = true;
  if (comm->me != 0) return;
  std::error_code fault, unheeded;
  int strangers = 0;
  std::filesystem::directory_iterator entry(folder_, fault);
  for (; !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
    const long long step = snapshot_step(entry->path().filename().string());
    if (step < 0) continue;
    const bool other_form = entry->path().filename() != snapshot_name(step, form_);
    if (run_of(entry->path()) != blocks_->run_id())
      ++strangers;
    else if (step > last_ || (step == last_ && other_form)) {
      std::filesystem::remove(entry->path(), unheeded);
      if (step > last_)
        std::filesystem::remove(entry->path().parent_path() / impulses_name(step), unheeded);
    }
  }
  if (strangers == 0) return;
  error->warning(FLERR, (where_ + ": '" + folder_ + "' holds " + std::to_string(strangers) +
                         " snapshots of other runs; muckpile-post refuses to measure a folder with "
                         "files of several runs. Remove them, or choose another folder")
                            .c_str());
}

void FixMuckpileDump::post_run() {
  clear_folder();
  write();
  write_joints();
}

void FixMuckpileDump::end_of_step() {
  if (update->ntimestep % every_ == 0) write();
}

int FixMuckpileDump::modify_param(int narg, char** arg) {
  if (std::strcmp(arg[0], "every") != 0) return 0;
  every_ = engine::read_every(*lmp, engine::name_of_modify(*this), narg, arg);
  return 2;
}

std::string FixMuckpileDump::rows() const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  std::vector<int> fragment;
  std::vector<double> broken(static_cast<std::size_t>(bodies.count()), 0.0);
  if (joints_ != nullptr) {
    fragment = joints_->fragment_ids();
    broken = joints_->broken_share();
  }
  std::string text;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    const BlockRecord& record = blocks_->records()[k];
    if (record.mass == 0.0) continue;  // not made by create_blocks
    const BlockRow row{.id = record.tag,
                       .centre = bodies.centre(b),
                       .turn = Quat(Mat3(bodies.axes(b) * record.start_axes.transpose())),
                       .velocity = bodies.velocity(b),
                       .spin = bodies.spin(b),
                       .fragment = fragment.empty() ? record.tag : fragment[k],
                       .broken_share = broken[k]};
    if (form_ == SnapshotForm::packed)
      pack(row, text);
    else
      append_row(text, row);
  }
  return text;
}

/// What the ranks have, one behind the other, on the first of them. Collective.
std::string FixMuckpileDump::of_all_ranks(const std::string& mine) const {
  const int length = static_cast<int>(mine.size());
  std::vector<int> lengths(static_cast<std::size_t>(comm->nprocs)), first(lengths.size(), 0);
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, world);
  std::partial_sum(lengths.begin(), lengths.end() - 1, first.begin() + 1);
  std::string all(comm->me == 0 ? static_cast<std::size_t>(first.back() + lengths.back()) : 0,
                  '\0');
  MPI_Gatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), first.data(), MPI_CHAR, 0,
              world);
  return all;
}

void FixMuckpileDump::write_file(const std::string& name, std::string_view header,
                                 const std::string& mine, const std::string& remark) const {
  std::ostringstream text;
  text.precision(12);
  text << "# step=" << update->ntimestep << " time_s=" << update->get_cur_time() << " " << remark
       << run_mark(blocks_->run_id()) << '\n'
       << header << of_all_ranks(mine);
  engine::write_file(*lmp, where_, folder_ + "/" + name, text.str());
}

void FixMuckpileDump::write() {
  if (last_ == update->ntimestep) return;
  last_ = update->ntimestep;
  const bool packed = form_ == SnapshotForm::packed;
  write_file(snapshot_name(update->ntimestep, form_), packed ? packed_header() : kHeader, rows());
  if (impulses_ != nullptr) write_impulses();
}

/// Rows of one block may be on several ranks.
void FixMuckpileDump::write_impulses() const {
  std::vector<ByteWriter> outgoing(static_cast<std::size_t>(comm->nprocs));
  for (const ImpulseRow& row : impulses_->impulses()) {
    outgoing.front().put(row.tag);
    outgoing.front().put(row.impulse.parts);
  }
  std::vector<ImpulseRow> rows;
  engine::exchange_messages(outgoing, world, [&](ByteReader& in, std::size_t) {
    while (!in.empty()) {
      ImpulseRow& row = rows.emplace_back();
      in.get(row.tag);
      in.get(row.impulse.parts);
    }
  });
  std::string text;
  for (const ImpulseRow& row : added_up(std::move(rows))) append_row(text, row);
  write_file(impulses_name(update->ntimestep), impulses_header(), text);
}

void FixMuckpileDump::write_joints() const {
  if (joints_ == nullptr) return;
  std::string text;
  for (const HoldingJoint& joint : joints_->holding_joints()) {
    text += std::to_string(joint.tag) + ',' + std::to_string(joint.face);
    append(text, std::array{joint.broken_share}, 5);
    text += '\n';
  }
  // So that a file that was cut short is known: what it does not list has broken.
  const auto rows = engine::sum_over_ranks(static_cast<int>(std::ranges::count(text, '\n')), world);
  write_file(kJointsFile, "id,face,broken_share\n", text, "rows=" + std::to_string(rows) + ' ');
}

}  // namespace muckpile
