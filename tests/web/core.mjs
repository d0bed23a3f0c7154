// Answers of the page's module and of the program, preset by preset: digests equal, or how far motions part.
//
// node tests/web/core.mjs MODULE PROGRAM OUT [PRESET...]: MODULE is what wasm-bindgen --target nodejs wrote, PROGRAM the program
// for this machine, OUT a folder for the tables of both. Fails where a motion parts by more than LIMIT.
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

// Largest difference of a displacement [m]. Libraries for sin and exp round the last bit differently, and each hit magnifies
// that. Measured over the presets: 2e-14 m at the most, and 9.5e-12 m after the 40 s of span-as-built; a hundred times that.
const LIMIT = 1e-9;

// Columns of trajectory.csv that are displacements [m].
const LENGTH = /\.[xyz]$/;

const [module, program, out, ...chosen] = process.argv.slice(2);
createRequire(import.meta.url)(resolve(module));
const page = globalThis.girderbench;

/** Rows of a table, each as a map of its columns' numbers. */
function rows(text) {
  const [head, ...lines] = text.trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => new Map(head.map((name, i) => [name, Number(line[i])])));
}

/** Largest difference in the columns of lengths [m]; not a number where the tables differ in shape. */
function parted(a, b) {
  const [left, right] = [rows(a), rows(b)];
  if (left.length !== right.length || left.length === 0) return NaN;
  if (![...left[0].keys()].some((name) => LENGTH.test(name))) return NaN;
  let most = 0;
  left.forEach((row, i) => {
    for (const [name, value] of row) {
      if (LENGTH.test(name)) most = Math.max(most, Math.abs(value - right[i].get(name)));
    }
  });
  return most;
}

let bad = 0;
for (const name of chosen.length ? chosen : page.presets()) {
  const { digest, tables } = page.answer(name);
  const [here, there] = [join(out, "page", name), join(out, "program", name)];
  mkdirSync(here, { recursive: true });
  for (const [file, text] of Object.entries(tables)) writeFileSync(join(here, file), text);
  const native = execFileSync(program, ["run", name, "--digest", "--out", there], { encoding: "utf8" }).trim();
  const difference = parted(tables["trajectory.csv"], readFileSync(join(there, "trajectory.csv"), "utf8"));
  const same = native.split("\n")[0] === digest;
  if (!(same || difference <= LIMIT)) bad += 1;
  console.log(`${name}: digest ${same ? "equal" : `${digest} for ${native}`}, displacements part by ${difference} m at the most`);
}
process.exit(bad ? 1 : 0);
