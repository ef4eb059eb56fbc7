//! The help of `peel collect`.

/// Of `peel collect -h`.
pub const SHORT: &str = "\
Example: peel collect out/strip-sweep-strip.length-part-*
More: peel collect --help, on files, missing parts, parts that were computed twice";

/// Of `peel collect --help`.
pub const LONG: &str = "\
Examples:
  peel sweep strip.toml --vary strip.length --from \"60 nm\" --to \"120 nm\" --points 40 --part 1/8
  peel collect out/strip-sweep-strip.length-part-*
  peel collect p1 p2 p3 p4 p5 p6 p7 p8 --out whole

Files: sweep.csv, sweep.svg, sweep.png and parameters.toml, the same bit for bit as the undivided sweep writes, but for
the times. The command in parameters.toml is that of the undivided sweep. Without --out the folder is that of the
undivided sweep as well.

Missing parts: what is there is written, the message names what is missing, and the exit status is 3. The folder then
holds collect.partial.json besides. Give the command again with the late parts: it needs no --force, and removes that
file when nothing is missing. A folder in which a part is still being computed may be given; its part counts as missing.

A part that was computed twice: the results have to be equal, bit for bit but for the times, and a remark says so. Of
each value the first folder counts. Different results are refused, with the first difference.

Parts of different sweeps are refused, with the first difference: another scene, key, value, number of parts or version.

Exit status:
  0  done
  1  another error, such as a folder that cannot be written
  2  bad input: no part, parts of different sweeps, or the output folder is not empty and --force is not given
  3  parts are missing, or the computation of values stopped short: what is there is written all the same";
