// SPDX-License-Identifier: GPL-2.0-or-later
// The reports behind the sub-commands of muckpile-post: each reads dump/ and writes tables,
// pictures and summary keys. Scope: docs/post lists the files and keys; all throw
// InputError on faulty dumps.
#pragma once

#include "io/result_folder.h"
#include "report/options.h"

namespace muckpile {

// Bench only: profile.csv, profile.png and the pile's keys. Throws NotMeasurable for a bench that
// the measures are not made for, and takes back what an earlier call has left.
void report_profile(const ResultFolder& folder, const MeasureOptions& measure,
                    const SectionOptions& section);
// fragments.csv, sieve.csv, fragments_list.csv, fragments.png and the size keys; boulders.csv for a
// size of boulders.
void report_fragments(const ResultFolder& folder, const MeasureOptions& measure,
                      const FragmentOptions& options = {});
// Crater only: crater.csv, launch.csv, crater.png and the crater's keys. Throws NotMeasurable, as
// report_profile does, for a charge beside the z axis.
void report_crater(const ResultFolder& folder, const MeasureOptions& measure,
                   const SectionOptions& section);
// Heap only: heap.csv, heap.png and the angle of repose.
void report_heap(const ResultFolder& folder, const MeasureOptions& measure,
                 const SectionOptions& section);
// energy.png: the energies of history.csv over time. energy_holes.csv: those of each charge.
void report_energy(const ResultFolder& folder);
// pile3d.png, and pile3d_<number>.png for frames.
void report_picture(const ResultFolder& folder, const PictureOptions& options);
// vtk/blocks_<step>.vtu of every n-th snapshot and the last, vtk/blocks.pvd.
void report_series(const ResultFolder& folder, int every);

// Bench and crater with impulses: momentum.csv, momentum.png. Throws NotMeasurable for other scenes
// and for a run without fix muckpile/impulse.
void report_momentum(const ResultFolder& folder);

// Bench only: movement.csv, movement.png.
void report_movement(const ResultFolder& folder, const MeasureOptions& measure,
                     const MovementOptions& options);
// waves.csv, waves.png, ppv.csv, ppv.png: what the gauges of the run felt. Throws NotMeasurable for
// a run without gauges.
void report_waves(const ResultFolder& folder, const WavesOptions& options = {});
// Bench with a hole table only: rows.csv, face_velocity.csv, face_velocity.png and the keys of the
// rows.
void report_rows(const ResultFolder& folder, const MeasureOptions& measure);
// Bench only: heights.csv, heights.png, backbreak, toe left, volumes.
void report_heights(const ResultFolder& folder, const MeasureOptions& measure);
// section.csv, section.png: rock and heights along any line in plan.
void report_section(const ResultFolder& folder, const MeasureOptions& measure,
                    const LineOptions& line);
// over.csv, over.png: what went over a line in plan.
void report_over(const ResultFolder& folder, const MeasureOptions& measure,
                 const LineOptions& line);
// Bench only: trough.csv, trough.png: the valley between the rock that stands and the pile. Throws
// NotMeasurable for a run that has not come to rest.
void report_trough(const ResultFolder& folder, const MeasureOptions& measure,
                   const TroughOptions& options = {});
// survey.csv, survey.png: the surface of the run at its end against a surveyed one. Throws
// NotMeasurable for a run that has not come to rest.
void report_survey(const ResultFolder& folder, const MeasureOptions& measure,
                   const SurveyOptions& options);
// Bench only: flyrock.csv, what formulas say of fly rock. Throws NotMeasurable for other scenes and
// where the charges are not known.
void report_flyrock(const ResultFolder& folder, const FlyrockOptions& options = {});
// report.html: the page of the run, of what the others have left in the folder.
void report_page(const ResultFolder& folder);

// Keys that every sub-command writes: size of the run, joints, energy, speed, times.
nlohmann::ordered_json common_keys(const ResultFolder& folder);

}  // namespace muckpile
