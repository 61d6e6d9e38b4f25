//! The text of `lagrange --help`.

/// All commands and options.
pub(crate) const HELP: &str = "\
Declarations of mechanical systems, as `lagrange::system!` takes them, from files.

Usage: lagrange COMMAND FILE [OPTIONS]

Commands:
  check FILE…       list mistakes and warnings
  equations FILE    write the equations of motion, their structure and their cost
  statements FILE   write the declaration in plain statements: no arrays, loops or bodies
  rust FILE         write the code that the macro emits
  c FILE            write a module of C: NAME.h and NAME.c, named for the struct
  fmu FILE          write a unit of the Functional Mock-up Interface 2.0 or 3.0: NAME.fmu
  page FILE         write a page in which the system moves: HTML with sliders, plots and drawing
  kernel FILE       write the equations of motion as C for graphics processors
  simulate FILE     compute a motion, and write its columns or plot them
  film FILE         write the film of a motion: HTML with play, pause and curves
  ensemble FILE     compute many motions with random values, and write their ends
  trade FILE        measure all methods on a motion, and propose one for a wanted error
  linearise FILE    write a linear model at a state or an equilibrium, with its modes
  urdf FILE         write the declaration of a robot that a URDF file describes
  watch COMMAND …   run a command with its options, and again whenever its files change

A file holds a declaration alone, or is Rust with `lagrange::system! { … }`; of several in one
file, FILE#NAME selects that with this name.
A file named `-` is the standard input. Tables are files beside the declaration.

Options:
  -o, --output FILE   write to a file instead of the standard output; for motions, the
                      extension selects the format: csv, parquet, svg or png; for films, html
                      or gif, in the plane svg, in space glb; for modules of C, a folder, or
                      the path of both files without their extensions; for units, a folder or
                      a path; for measurements, a folder
      --json          list mistakes as JSON: an array of objects on the standard output (check);
                      write an object (linearise)
      --latex         write the equations in LaTeX (equations)
      --single        compute in single precision (kernel)
      --until TIME    end of the motion, which starts at 0 (simulate, film, ensemble, trade)
      --every TIME    sample so often, instead of at every step (simulate); time between two
                      pictures, 40 ms by default (film)
      --set A=VALUE   set a parameter, or hold an input at a value; once for each (simulate,
                      film, ensemble, trade, linearise, fmu, page)
      --start A=VALUE start a coordinate, velocity or state here; once for each (simulate,
                      film, ensemble, trade, fmu, page)
      --vary A=B..C   draw a parameter, an input or an entry of the start from a range, for each
                      motion; `--vary A` from its declared range; once for each (ensemble)
      --motions N     number of motions, 100 by default (ensemble)
      --seed N        seed of random values and of noise, 0 by default (simulate, film, ensemble)
      --threads N     number of threads, one for each processor by default (ensemble)
      --error E       wanted error of the state at the end; a table of errors by default (trade)
      --longest TIME  leave out settings finer than one that took so long, 0.2 by default (trade)
      --at A=VALUE    linearise, or search, where an entry of the state has this value instead of
                      that at the start; once for each (linearise)
      --equilibrium   search for an equilibrium there first (linearise)
      --hold A        keep a coordinate or a state in the search; once for each (linearise)
      --trim U        search for the value of an input, too; once for each (linearise)
      --time TIME     time at which to linearise, 0 by default (linearise)
      --method NAME   integrate by `verner` (default), `taylor` for small errors, `radau` for
                      stiff systems, or by `rk4` or `gauss` in equal steps; many contacts by
                      `stepped`, systems with noise by `maruyama` or `stochastic` (simulate, film,
                      ensemble)
      --tolerance E   tolerated error of a step, 1e-9 by default (simulate, film, ensemble)
      --fmi N         version of the interface, 2 by default, or 3 (fmu)
      --sources       leave the compilation to the program that imports the unit (fmu)
      --step TIME     length of equal steps (simulate, film, ensemble)
      --energy        add a column for the energy (simulate), or its curve (film)
      --forces        draw forces and moments (film)
      --events FILE   write the events of the motion to a file, as CSV (simulate, film)
      --name NAME     name the struct (urdf)
      --free          let the base move freely (urdf)
      --inputs        drive each joint by an input (urdf)
      --limits        stop joints at their limits, and inputs at their efforts (urdf)
      --friction      give joints their dry friction (urdf)
      --contacts      let spheres that collide touch the ground (urdf)
      --corners LINK  let corners of boxes and rims of cylinders that a link collides as
                      touch the ground, too; once for each link (urdf)
      --trust-inertia accept moments of inertia that no body has (urdf)
  -h, --help          print this
  -V, --version       print the version

Values are written as defaults in a declaration: `2`, `30 deg`, `pi / 3`, `9.81 [m/s^2]`.

Exit codes: 0, no errors; 1, a file has errors or cannot be read or written; 2, wrong usage;
3, a motion failed before its end, and what it reached is written, or there is no equilibrium or
no linear model.
";
