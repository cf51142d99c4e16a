#include "run_options.h"

namespace ice_ice_baby {

namespace {

constexpr char kExamples[] = R"(Examples:
  run_scene dam_break --profile
  run_scene container_splash --duration 4 --frames /tmp/frames
  run_scene container_splash --surface /tmp/surface --export /tmp/particles
  run_scene dam_break --quality accurate
  run_scene dam_break --set solver.target_error=0.001
  run_scene freeze_container --preset paper --report report.json
  run_scene dam_break --series series.csv --particles last.csv
  run_scene my_scene.yaml --set solver.substeps=16 --set "gravity_m_s2=[0, 0, -1.62]"
  run_scene iceberg --save run.ckpt --autosave 1        after a kill at any moment, continue with
  run_scene --load run.ckpt --save run.ckpt --autosave 1
Exit code: 0 ran, 1 bad input, 2 became unstable.
)";

}  // namespace

void describeOptions(CLI::App& app, Options& o) {
  app.add_option("scene", o.scene, "name of a scene (see --list) or path of a .yaml file");
  app.add_option("--duration", o.duration_s,
                 "simulated seconds from the start of the scene, also with --load; without it the "
                 "scene's own");
  app.add_option("--quality", o.quality, "fast, balanced or accurate, in place of the scene's");
  app.add_option("--preset", o.preset, "default or paper, in place of the scene's");
  app.add_option("--threads", o.threads, "threads; 0: all of the machine's");
  app.add_option("--precision", o.precision, "float (without it) or double");
  app.add_option("--set", o.overrides,
                 "key=value: any key of config/default.yaml by its dotted name")
      ->allow_extra_args(false);
  app.add_option("--report", o.report, "write a JSON report to this file");
  app.add_option("--series", o.outputs.series,
                 "write the run over time to this file: CSV, a row per frame or sample");
  app.add_option("--particles", o.particles,
                 "write the particles of the last frame to this file: CSV, a row per particle");
  app.add_option(
      "--record", o.outputs.record,
      "write every position of every frame to this file: .npy, float32 (frame, id, xyz)");
  app.add_option("--sample-hz", o.outputs.sample_hz,
                 "samples per simulated second of --series, --record and the metrics of the error; "
                 "without it every frame");
  SequenceFolders& folders = o.outputs.folders;
  app.add_option("--frames", folders.frames,
                 "write PNG pictures into this folder, in place of those of an earlier run");
  app.add_option(
      "--surface", folders.surface,
      "write the surfaces of water and ice into this folder, with an index for ParaView");
  app.add_option("--surface-format", folders.surface_format, "ply or obj (ply)");
  app.add_option("--export", folders.particles,
                 "write the particles into this folder, with an index for ParaView");
  app.add_option("--export-format", folders.particles_format, "vtk or ply (vtk)");
  app.add_option("--frames-hz", o.outputs.frames_hz,
                 "pictures, surfaces and exports per simulated second (30)");
  app.add_option("--save", o.outputs.save,
                 "write a checkpoint to this file at the end, also after Ctrl-C or SIGTERM");
  app.add_option("--autosave", o.outputs.autosave_s,
                 "also write it every so many simulated seconds");
  app.add_option("--load", o.load,
                 "continue from a checkpoint instead of a scene, bit-identically to the run that "
                 "saved it");
  app.add_flag(
      "--wrenches", o.outputs.wrenches,
      "add what water and ice do to each collider, force and torque: to the report the mean of "
      "the last half second, to the series that since the row before");
  app.add_flag("--profile", o.profile, "print what each stage cost");
  app.add_flag("--list", o.list, "print the scenes and what they show");
  app.add_flag("--defaults", o.defaults, "print every key with its default, range and meaning");
  app.footer(kExamples);
}

}  // namespace ice_ice_baby
